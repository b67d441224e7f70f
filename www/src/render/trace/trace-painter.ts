import type { CurveDocument } from "../../document/document.ts";
import { shownOf } from "../../editor/trace/trace-edits.ts";
import { showsPoints } from "../../editor/trace/trace-hit.ts";
import { byColor, type ShownPicture, type TraceOutcome } from "../../kernel/trace/outcome.ts";
import { drawGrid } from "../layers/grid.ts";
import { addSmallPoint, drawPoint, drawSmallPoints } from "../markers.ts";
import { documentPaths, inPage, inScreen, onScreen, type Scene } from "../scene.ts";
import type { Painter } from "../stage.ts";

/** Trace's picture, from the paper up: the pixels, the outlines over them, and the points where they change. */

/** Marks nearer to each other than this would hide what they mark, in CSS pixels along the outlines; nearer than the first, they are drawn small. */
const [largeApart, smallApart] = [40, 11];

export function createTracePainter(): Painter {
  return {
    paint(scene) {
      const { traceView, traceRun, originalOnly } = scene.state;
      const view = originalOnly ? "source" : traceView.view;
      const { picture } = traceRun;
      drawGrid(scene);
      if (picture !== null && view !== "outline") {
        drawPixels(scene, picture, view === "edges" ? picture.edges : picture.source, view === "result" ? traceView.alpha / 100 : 1);
      }
      drawFrame(scene);
      const shown = shownOf(scene.state);
      if (shown === null || view === "source") return;
      drawOutlines(scene, shown, view === "edges");
      if (showsPoints(scene.state)) drawPoints(scene, shown.drawing, view === "outline");
    },
  };
}

function drawPixels(scene: Scene, { width, height }: ShownPicture, pixels: ImageBitmap, alpha: number): void {
  // A bitmap that was closed since has no size.
  if (alpha === 0 || pixels.width === 0) return;
  const context = inPage(scene);
  context.globalAlpha = alpha;
  // From twice their size on, pixels are seen as what they are.
  context.imageSmoothingEnabled = (scene.state.view.zoom * width) / pixels.width < 2;
  context.imageSmoothingQuality = "high";
  context.drawImage(pixels, 0, 0, width, height);
  context.globalAlpha = 1;
}

/** Where the picture ends. */
function drawFrame(scene: Scene): void {
  const { state, palette } = scene;
  const size = state.traceRun.picture ?? state.trace.kept;
  if (size === undefined) return;
  const context = inPage(scene);
  context.strokeStyle = palette.line;
  context.lineWidth = 1 / state.view.zoom;
  context.globalAlpha = 0.6;
  context.strokeRect(0, 0, size.width, size.height);
  context.globalAlpha = 1;
}

interface Paths {
  readonly all: Path2D;
  readonly closed: Path2D;
}

const wholes = new WeakMap<readonly Float64Array[], Paths>();

/** All outlines in one path, and the closed ones in another: as the worker gave them, or anew where corners were smoothed by hand. */
function pathsOf(scene: Scene, { drawing, cubics: found }: TraceOutcome): Paths {
  if (found.length === 0) return documentPaths(scene, drawing);
  const known = wholes.get(found);
  if (known !== undefined) return known;
  const every = drawing.contours.every(({ closed }) => closed);
  const all = new Path2D();
  const paths = { all, closed: every ? all : new Path2D() };
  found.forEach((cubics, i) => {
    const closed = drawing.contours[i]?.closed === true;
    addCubics(all, cubics, closed);
    if (closed && !every) addCubics(paths.closed, cubics, true);
  });
  wholes.set(found, paths);
  return paths;
}

function addCubics(path: Path2D, cubics: Float64Array, closed: boolean): void {
  path.moveTo(cubics[0] ?? 0, cubics[1] ?? 0);
  for (let i = 0; i + 7 < cubics.length; i += 8) {
    path.bezierCurveTo(cubics[i + 2] ?? 0, cubics[i + 3] ?? 0, cubics[i + 4] ?? 0, cubics[i + 5] ?? 0, cubics[i + 6] ?? 0, cubics[i + 7] ?? 0);
  }
  if (closed) path.closePath();
}

function drawOutlines(scene: Scene, shown: TraceOutcome, thin: boolean): void {
  const { state, palette } = scene;
  const context = inPage(scene);
  const { all: path, closed } = pathsOf(scene, shown);
  const alone = state.traceView.view === "outline";
  const inColor = !thin && !alone && shown.colors.length > 0;
  context.lineJoin = "round";
  if (inColor) drawColors(scene, shown);
  // A stroke that closes encloses paper, not ink.
  else if (!thin && state.trace.settings.mode !== "lines") {
    context.fillStyle = palette.point;
    context.globalAlpha = alone ? 0.08 : 0.16;
    context.fill(closed, "evenodd");
    context.globalAlpha = 1;
  }
  if (!thin && !alone) drawRim(scene, path, inColor ? 3 : 4, inColor ? 0.35 : 0.7 * (state.traceView.alpha / 100));
  context.strokeStyle = thin ? palette.cusp : palette.curve;
  context.lineWidth = (thin || inColor ? 1.25 : 2) / state.view.zoom;
  context.stroke(path);
}

/** A rim of paper keeps a line in sight over dark pixels: as strongly as they are seen. */
function drawRim(scene: Scene, path: Path2D, width: number, strength: number): void {
  const context = inPage(scene);
  context.strokeStyle = scene.palette.canvas;
  context.lineWidth = width / scene.state.view.zoom;
  context.globalAlpha = strength;
  context.stroke(path);
  context.globalAlpha = 1;
}

/** Layer on layer, as a file of them looks. */
function drawColors(scene: Scene, shown: TraceOutcome): void {
  const context = inPage(scene);
  for (const { color, drawing: layer } of layersOf(shown)) {
    context.fillStyle = color;
    context.fill(documentPaths(scene, layer).closed, "evenodd");
  }
}

const layered = new WeakMap<TraceOutcome, ReturnType<typeof byColor>>();

/** The same drawings for the same outlines, so that their paths are made once. */
function layersOf(shown: TraceOutcome): ReturnType<typeof byColor> {
  const known = layered.get(shown);
  if (known !== undefined) return known;
  const fresh = byColor(shown);
  layered.set(shown, fresh);
  return fresh;
}

const spacings = new WeakMap<CurveDocument, number>();

/** The mean way from point to point along the outlines, in pixels of the picture. */
function spacingOf(drawing: CurveDocument): number {
  const known = spacings.get(drawing);
  if (known !== undefined) return known;
  let [way, count] = [0, 0];
  for (const { points } of drawing.contours) {
    points.forEach(({ x, y }, i) => {
      const next = points[(i + 1) % points.length];
      if (next !== undefined) way += Math.hypot(next.x - x, next.y - y);
    });
    count += points.length;
  }
  const fresh = count === 0 ? Infinity : way / count;
  spacings.set(drawing, fresh);
  return fresh;
}

function drawPoints(scene: Scene, drawing: CurveDocument, all: boolean): void {
  const { state, palette, focused } = scene;
  const { stage, traceView } = state;
  const context = inScreen(scene);
  const apart = spacingOf(drawing) * state.view.zoom;
  const crowded = apart < largeApart;
  const small = { discs: new Path2D(), diamonds: new Path2D() };
  const late: (() => void)[] = [];
  drawing.contours.forEach(({ points }, contour) => points.forEach((point, index) => {
    const at = onScreen(scene, point);
    if (at.x < -24 || at.y < -24 || at.x > stage.width + 24 || at.y > stage.height + 24) return;
    const is = (ref: { contour: number; index: number } | null): boolean => ref !== null && ref.contour === contour && ref.index === index;
    const marker = { hovered: is(traceView.over), selected: is(traceView.chosen), focused: is(traceView.chosen) && focused && state.keyboard };
    const marked = marker.hovered || marker.selected;
    if (marked || (!crowded && (all || point.kind === "cusp"))) late.push(() => drawPoint(context, at, point.kind, marker, palette));
    else if (apart >= smallApart) addSmallPoint(small, at, point.kind, false);
  }));
  drawSmallPoints(context, small, palette);
  for (const draw of late) draw();
}
