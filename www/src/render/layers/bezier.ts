import { partsOf } from "../../document/curve/parts.ts";
import { toPage } from "../../editor/pointer/camera.ts";
import { bezierGhost, magnification, type Ghost } from "../../kernel/curve/overlays/bezier-ghost.ts";
import { isDense, isSeen } from "../outlines.ts";
import { boxAround, inPage, inScreen, onScreen, overlap, pathOfCubics, pathOfPoints, sightOf, type Scene } from "../scene.ts";

type Bounds = ReturnType<typeof sightOf>;

/**
 * The Bézier to compare with. Its circle lies within a hair of the exact one, so its error is drawn magnified and
 * labelled as such; the points and handles that it needs are drawn as they are.
 */
export function drawBezier(scene: Scene): void {
  const { state, palette } = scene;
  if (!state.settings.overlays.bezier && !state.originalOnly) return;
  const sight = sightOf(scene);
  const compared = state.curve.contours.slice(0, mostCompared).flatMap((contour) => {
    const parts = partsOf(state.curve, contour);
    // Of long contours, what can be seen beside the curve.
    const seen = parts.length === 1 ? parts : parts.filter((part) => !isDense(scene, part) && isSeen(state.curve, part, sight));
    return seen.flatMap((part) => bezierGhost(state.curve, part) ?? []);
  });
  const context = inPage(scene);
  const { zoom } = state.view;
  context.strokeStyle = palette.warn;
  context.lineWidth = 1.5 / zoom;
  context.setLineDash([6 / zoom, 5 / zoom]);
  for (const ghost of compared) context.stroke(pathOfCubics(ghost.path, false));
  context.setLineDash([]);
  for (const { magnified, path } of compared.slice(0, mostMagnified)) {
    if (magnified === null) continue;
    drawMagnified(scene, magnified, path);
    const places = tops.map((top) => placeAt(magnified, 2 * Math.floor((magnified.length / 2) * top)));
    label(scene, `4-arc Bézier, error × ${magnification}`, places, path, compared, [...piecesOf(path, 4), ...piecesOf(magnified, 2)]);
  }
  const [first] = compared;
  if (first !== undefined && first.magnified === null && first.error > 1e-4) label(scene, "Bézier with these handles", middlesOf(first.path), first.path, compared, []);
}

/** A comparison is for looking at closely: of very many contours the first serve. */
const mostCompared = 64;
const mostMagnified = 4;

function drawMagnified(scene: Scene, polygon: Float64Array, cubics: Float64Array): void {
  const { state, palette } = scene;
  const page = inPage(scene);
  page.lineWidth = 1.5 / state.view.zoom;
  page.lineCap = "round";
  page.setLineDash([0.01 / state.view.zoom, 4 / state.view.zoom]);
  page.stroke(pathOfPoints(polygon, true));
  page.setLineDash([]);
  page.lineCap = "butt";
  const context = inScreen(scene);
  context.globalAlpha = 0.75;
  context.lineWidth = 1;
  context.fillStyle = palette.warn;
  for (let i = 0; i + 7 < cubics.length; i += 8) {
    const [from, first, second, to] = [0, 2, 4, 6].map((k) => onScreen(scene, placeAt(cubics, i + k)));
    if (from === undefined || first === undefined || second === undefined || to === undefined) continue;
    context.beginPath();
    context.moveTo(from.x, from.y);
    context.lineTo(first.x, first.y);
    context.moveTo(second.x, second.y);
    context.lineTo(to.x, to.y);
    context.stroke();
    for (const end of [first, second]) context.fillRect(end.x - 2, end.y - 2, 4, 4);
    context.strokeRect(from.x - 3.5, from.y - 3.5, 7, 7);
  }
  context.globalAlpha = 1;
}

function placeAt(places: Float64Array, at: number): { x: number; y: number } {
  return { x: places[at] ?? 0, y: places[at + 1] ?? 0 };
}

/** The boxes around so many numbers each: handles of cubics, vertices of a polygon. */
function piecesOf(numbers: Float64Array, each: number): readonly Bounds[] {
  return Array.from({ length: Math.floor(numbers.length / each) }, (_, i) => boxAround(numbers.subarray(each * i, each * (i + 1))));
}

/** Where along the magnified error its waves are highest. */
const tops = [0.8, 0.95, 0.7, 0.55, 0.05, 0.2, 0.45, 0.3];

const mostTried = 12;

/** Half-way along the first cubics. */
function middlesOf(cubics: Float64Array): { x: number; y: number }[] {
  return Array.from({ length: Math.min(mostTried, cubics.length / 8) }, (_, i) => placeAt(halved(cubics.subarray(8 * i, 8 * i + 8))[1], 0));
}

/** A stage as narrow as this has the zoom box beside the curve. */
const narrow = 600;
/** CSS pixels around a label, and beside the place that it is of. */
const [margin, aside] = [6, 8];
/** Points whose handles are kept clear of words; of more, nobody would find a place for any. */
const mostHandled = 16;

/** The boxes around points and their handles, where these are shown. */
function handlesOf({ settings, curve }: Scene["state"]): readonly Bounds[] {
  if (!settings.overlays.handles || curve.contours.reduce((sum, { points }) => sum + points.length, 0) > mostHandled) return [];
  return curve.contours.flatMap(({ points }) => points).map(({ x, y, in: before, out: after }) => boxAround(Float64Array.of(x, y, x + before.dx, y + before.dy, x + after.dx, y + after.dy)));
}

/**
 * Outwards beside one of the places, else inwards, else in the middle, there in two lines, too, where the words lie
 * across no curve, no handle and none of `others`; where there is no such place, the picture is worth more than they.
 */
function label(scene: Scene, text: string, places: readonly { x: number; y: number }[], cubics: Float64Array, compared: readonly Ghost[], others: readonly Bounds[]): void {
  const context = inScreen(scene);
  const { em, font, warn } = scene.palette;
  const { stage, view } = scene.state;
  context.font = font;
  context.fillStyle = warn;
  const box = boxAround(cubics);
  const centre = onScreen(scene, { x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2 });
  const boxes = [...others, ...handlesOf(scene.state)];
  for (const lines of [[text], text.split(", ")]) {
    const wide = Math.max(...lines.map((line) => context.measureText(line).width));
    const more = (lines.length - 1) * 1.25 * em;
    const beside = [[true, true], [true, false], [false, true], [false, false]].flatMap(([outwards, away]) => places.map((place) => {
      const { x, y } = onScreen(scene, place);
      return { x: (x >= centre.x) === outwards ? x + aside : x - aside - wide, y: (y >= centre.y) === away ? y + em + 4 : y - aside };
    }));
    const middle = { x: centre.x - wide / 2, y: centre.y + em / 3 - more / 2 };
    const all = lines.length > 1 ? [middle] : stage.width < narrow ? [middle, ...beside] : [...beside, middle];
    const isFree = ({ x, y }: { x: number; y: number }): boolean => {
      if (x < aside || x + wide > stage.width - aside || y < em + aside || y + more > stage.height - aside) return false;
      const [from, to] = [toPage(view, stage, { x: x - margin, y: y - em }), toPage(view, stage, { x: x + wide + margin, y: y + more + margin })];
      const words = { minX: from.x, minY: from.y, maxX: to.x, maxY: to.y };
      return !boxes.some((each) => overlap(each, words)) && !compared.some(({ path }) => overlap(boxAround(path), words) && crosses(path, words));
    };
    const found = all.find(isFree);
    if (found !== undefined) return lines.forEach((line, i) => context.fillText(line, found.x, found.y + i * 1.25 * em));
  }
}

function crosses(cubics: Float64Array, box: Bounds): boolean {
  for (let i = 0; i + 7 < cubics.length; i += 8) if (runsThrough(cubics.subarray(i, i + 8), box)) return true;
  return false;
}

/**
 * Whether a cubic, which lies within the box around its points, runs through another box, or by it so closely that it
 * seems to.
 */
function runsThrough(cubic: Float64Array, box: Bounds, halvings = 6): boolean {
  return overlap(boxAround(cubic), box) && (halvings === 0 || halved(cubic).some((half) => runsThrough(half, box, halvings - 1)));
}

/** De Casteljau's two halves of a cubic. */
function halved(cubic: Float64Array): readonly [Float64Array, Float64Array] {
  const [left, right] = [new Float64Array(8), Float64Array.from(cubic)];
  for (let k = 0; k < 4; k += 1) {
    left.set(right.subarray(0, 2), 2 * k);
    for (let i = 0; i < 6 - 2 * k; i += 1) right[i] = ((right[i] ?? 0) + (right[i + 2] ?? 0)) / 2;
  }
  return [left, right];
}
