import { locate } from "../../document/curve/contours.ts";
import { paintLayers } from "../../document/paint-layers.ts";
import { lineStyle, noInk, setDashes } from "../../document/painted.ts";
import { partsOf } from "../../document/curve/parts.ts";
import { pointAt, segmentCount } from "../../document/document.ts";
import { affectedSegments } from "../../document/curve/roots.ts";
import { bezierGhost, magnification } from "../../kernel/curve/overlays/bezier-ghost.ts";
import { segmentPolygon } from "../../kernel/curve/samples.ts";
import { documentPaths, isDense, isSeen, partPath } from "../outlines.ts";
import { inPage, inScreen, onScreen, pathOfCubics, pathOfPoints, sightOf, type Scene } from "../scene.ts";
import { drawSheet } from "./grid.ts";

/** The drawing itself on its sheet, what it was before the drag, and the Bézier to compare with. */

export function drawArtboard(scene: Scene): void {
  const { artboard } = scene.state.curve;
  if (artboard !== undefined) drawSheet(scene, artboard);
}

/** Characters of a colour through which nothing shows. */
const solid = "#rrggbb".length;

export function drawFill(scene: Scene): void {
  const { state } = scene;
  const { filling = "evenodd" } = state.curve;
  if (!state.settings.overlays.fill || state.originalOnly) return;
  const context = inPage(scene);
  for (const { ink, line, drawing } of paintLayers(state.curve)) {
    const { all, closed } = documentPaths(scene, drawing);
    if (ink !== noInk && filling !== "none") paint(scene, context, ink, () => context.fill(closed, filling));
    if (line === undefined) continue;
    Object.assign(context, lineStyle(line));
    setDashes(context, line, state.view.zoom);
    // All at once, as in files: where two of them meet, no more of what is below is hidden.
    paint(scene, context, line.color, () => context.stroke(all));
    context.setLineDash([]);
  }
  Object.assign(context, { globalAlpha: 1, lineCap: "butt" });
}

function paint({ palette }: Scene, context: CanvasRenderingContext2D, color: string | undefined, draw: () => void): void {
  const inColor = (of: string, opacity: number): void => {
    Object.assign(context, { fillStyle: of, strokeStyle: of, globalAlpha: opacity });
    draw();
  };
  // What lies below is not seen, and lines and points are over any colour.
  if (color?.length === solid) inColor(palette.canvas, 1);
  inColor(color ?? palette.point, color === undefined ? 0.08 : 0.5);
}

/** Dotted: the curve as it was when the drag began. */
export function drawBefore(scene: Scene): void {
  const { state, palette, origin } = scene;
  if (origin === state.curve || state.drag === null) return;
  const context = inPage(scene);
  const { zoom } = state.view;
  context.strokeStyle = palette.original;
  context.lineWidth = 1.5 / zoom;
  context.lineCap = "round";
  context.setLineDash([0.01 / zoom, 4 / zoom]);
  const contours = new Set(state.curve.contours);
  const changed = origin.contours.filter((contour) => !contours.has(contour));
  const kept = new Set(state.curve.contours.flatMap((contour) => partsOf(state.curve, contour)));
  for (const contour of changed) {
    for (const part of partsOf(origin, contour)) if (!kept.has(part)) context.stroke(partPath(scene, origin, part));
  }
  context.setLineDash([]);
  context.lineCap = "butt";
}

/**
 * The Bézier's circle lies within a hair of the exact one, so its error is drawn magnified and labelled as such; the
 * points and handles that it needs are drawn as they are.
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
  for (const ghost of compared.slice(0, mostMagnified)) {
    if (ghost.magnified !== null) drawMagnified(scene, ghost.magnified, ghost.path);
  }
  const [first] = compared;
  if (first !== undefined && first.magnified === null && first.error > 1e-4) labelHandles(scene, first.path);
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
    const [from, first, second, to] = [0, 2, 4, 6].map((k) => onScreen(scene, { x: cubics[i + k] ?? 0, y: cubics[i + k + 1] ?? 0 }));
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
  label(scene, polygon);
}

/** Half-way along the first cubic. */
function labelHandles(scene: Scene, cubics: Float64Array): void {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0, x3 = 0, y3 = 0] = cubics.subarray(0, 8);
  const place = onScreen(scene, { x: (x0 + 3 * x1 + 3 * x2 + x3) / 8, y: (y0 + 3 * y1 + 3 * y2 + y3) / 8 });
  const context = inScreen(scene);
  context.font = scene.palette.font;
  context.fillStyle = scene.palette.warn;
  const text = "Bézier with these handles";
  const left = Math.max(8, Math.min(scene.state.stage.width - context.measureText(text).width - 8, place.x + 10));
  context.fillText(text, left, place.y - 8);
}

/** A stage as narrow as this has the zoom box beside the curve. */
const narrow = 600;

/** At the highest of the waves that show the error; in the middle where there is no room beside them. */
function label(scene: Scene, polygon: Float64Array): void {
  const at = 2 * Math.floor((polygon.length / 2) * 0.8);
  const centre = onScreen(
    scene,
    { x: ((polygon[0] ?? 0) + (polygon[polygon.length / 2] ?? 0)) / 2, y: ((polygon[1] ?? 0) + (polygon[polygon.length / 2 + 1] ?? 0)) / 2 },
  );
  const place = onScreen(scene, { x: polygon[at] ?? 0, y: polygon[at + 1] ?? 0 });
  const context = inScreen(scene);
  const { em, font, warn } = scene.palette;
  context.font = font;
  context.fillStyle = warn;
  const text = `4-arc Bézier, error × ${magnification}`;
  const wide = context.measureText(text).width;
  if (scene.state.stage.width < narrow) return context.fillText(text, centre.x - wide / 2, centre.y + em / 3);
  const beside = place.x >= centre.x ? place.x + 8 : place.x - 8 - wide;
  const left = Math.max(8, Math.min(scene.state.stage.width - wide - 8, beside));
  context.fillText(text, left, place.y + (place.y >= centre.y ? em + 4 : -8));
}

const sidesPerSegment = 48;
const mostSpans = 24;

/** What a press would move, and what a drag is changing: the rest of the curve stays where it is. */
function spansToShow({ state }: Scene): { contour: number; segment: number }[] {
  const { curve, drag, hover, selection } = state;
  const spans = new Map<string, { contour: number; segment: number }>();
  const add = (contour: number, segment: number): void => {
    const shape = curve.contours[contour];
    if (shape === undefined) return;
    const segments = segmentCount(shape);
    const index = shape.closed ? (segment + segments) % segments : segment;
    if (index >= 0 && index < segments) spans.set(`${contour}:${index}`, { contour, segment: index });
  };
  if (drag !== null) {
    for (const ref of selection.points.slice(0, mostSpans / 2)) {
      const shape = curve.contours[ref.contour];
      if (shape?.family === "interpolating") {
        for (const segment of affectedSegments(curve, shape, ref.index)) add(ref.contour, segment);
        continue;
      }
      if (selection.handle?.side !== "out") add(ref.contour, ref.index - 1);
      if (selection.handle?.side !== "in") add(ref.contour, ref.index);
    }
    // A linked handle shapes both sides.
    if (selection.handle !== null && pointAt(curve, selection.handle)?.kind !== "cusp") {
      add(selection.handle.contour, selection.handle.index - 1);
      add(selection.handle.contour, selection.handle.index);
    }
  } else if (hover.kind === "curve" && state.tool === "select") {
    const shape = curve.contours[hover.contour];
    if (shape !== undefined) add(hover.contour, locate(shape, hover.t).segment);
  }
  return [...spans.values()];
}

export function drawSpans(scene: Scene): void {
  const { state, palette } = scene;
  if (state.originalOnly) return;
  const spans = spansToShow(scene);
  if (spans.length === 0) return;
  const context = inPage(scene);
  context.strokeStyle = palette.point;
  context.lineWidth = 7 / state.view.zoom;
  context.lineJoin = "round";
  context.globalAlpha = 0.22;
  for (const { contour, segment } of spans) {
    const shape = state.curve.contours[contour];
    if (shape !== undefined) context.stroke(pathOfPoints(segmentPolygon(state.curve, shape, segment, sidesPerSegment), false));
  }
  context.globalAlpha = 1;
}

export function drawCurves(scene: Scene): void {
  const { state, palette } = scene;
  if (state.originalOnly) return;
  const context = inPage(scene);
  context.strokeStyle = palette.curve;
  context.lineWidth = 2 / state.view.zoom;
  context.lineJoin = "round";
  for (const line of documentPaths(scene, state.curve).lines) context.stroke(line);
}
