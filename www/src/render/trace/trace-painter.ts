import type { ControlPoint, CurveDocument } from "../../document/document.ts";
import { shownOf } from "../../editor/trace/trace-edits.ts";
import { showsPoints } from "../../editor/trace/trace-hit.ts";
import type { PointOfOutline, TraceViewId } from "../../editor/trace/trace-state.ts";
import { byColor, pointCount, type ShownPicture, type TraceOutcome } from "../../kernel/trace/outcome.ts";
import type { Bounds } from "../../kernel/curve/samples.ts";
import { cubicsOf } from "../../kernel/paths/paths.ts";
import { drawGrid } from "../layers/grid.ts";
import { drawSheet } from "../layers/sheet.ts";
import { drawPoint } from "../markers.ts";
import { documentPaths, type Outlines } from "../outlines.ts";
import { addCubics, boxAround, inPage, inScreen, onScreen, overlap, sightOf, toleranceOf, type Scene } from "../scene.ts";
import { createSmallPoints } from "../small-points.ts";
import type { Painter } from "../stage.ts";
import { createStillLayer } from "./still-layer.ts";

/** Trace's picture, from the paper up: the pixels, the outlines over them, and the points where they change. */

/**
 * Marks nearer to each other than this would hide what they mark, in CSS pixels along the outlines; nearer than the
 * first, they are drawn small.
 */
const [largeApart, smallApart] = [40, 11];

/** So many points are outlines that take no longer than a frame has. */
const mostAtOnce = 1000;

export function createTracePainter(repaint: () => void): Painter {
  const still = createStillLayer(repaint);
  return {
    paint(scene) {
      const { trace, traceView, traceRun, originalOnly, settings } = scene.state;
      const view = originalOnly ? "source" : traceView.view;
      const shown = shownOf(scene.state);
      const { picture } = traceRun;
      const { overlays: { grid }, gridStep } = settings;
      const of = [view, shown, picture, traceView.alpha, trace.kept, trace.settings.mode, grid, gridStep];
      const heavy = shown !== null && pointCount(shown.drawing) > mostAtOnce;
      still.paint(scene, of, heavy, (layer) => drawStill(layer, view, shown));
      if (shown !== null && showsPoints(scene.state)) drawLargePoints(scene, shown.drawing, view === "outline");
    },
  };
}

/** Everything but the points that a pointer or a key may mark. */
function drawStill(scene: Scene, view: TraceViewId, shown: TraceOutcome | null): void {
  const { traceView: { alpha }, traceRun: { picture } } = scene.state;
  drawGrid(scene);
  if (picture !== null && view !== "outline") drawPixels(scene, picture, view === "edges" ? picture.edges : picture.source, view === "result" ? alpha / 100 : 1);
  const size = picture ?? scene.state.trace.kept;
  if (size !== undefined) drawSheet(scene, { x: 0, y: 0, width: size.width, height: size.height });
  if (shown === null || view === "source") return;
  drawOutlines(scene, shown, view === "edges");
  if (showsPoints(scene.state)) drawSmall(scene, shown.drawing, view === "outline");
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

const wholes = new WeakMap<readonly Float64Array[], Outlines>();

/**
 * All outlines in one path, and the closed ones in another: as the worker gave them, or anew where corners were
 * smoothed by hand.
 */
function pathsOf(scene: Scene, { drawing, cubics: found }: TraceOutcome): Outlines {
  if (scene.cut !== undefined) return pathsOfOutlines(scene, drawing, found, sightOf(scene));
  if (found.length === 0) return documentPaths(scene, drawing);
  const known = wholes.get(found);
  if (known !== undefined) return known;
  const paths = pathsOfOutlines(scene, drawing, found, null);
  wholes.set(found, paths);
  return paths;
}

/** Of those that may be in sight; null: of all. */
function pathsOfOutlines(scene: Scene, drawing: CurveDocument, found: readonly Float64Array[], sight: Bounds | null): Outlines {
  const every = drawing.contours.every(({ closed }) => closed);
  const all = new Path2D();
  const paths = { all, closed: every ? all : new Path2D() };
  drawing.contours.forEach((contour, i) => {
    const cubics = found[i] ?? cubicsOf(drawing, contour, toleranceOf(scene));
    if (sight !== null && !overlap(boxAround(cubics), sight)) return;
    addOutline(all, cubics, contour.closed);
    if (contour.closed && !every) addOutline(paths.closed, cubics, true);
  });
  return paths;
}

function addOutline(path: Path2D, cubics: Float64Array, closed: boolean): void {
  path.moveTo(cubics[0] ?? 0, cubics[1] ?? 0);
  addCubics(path, cubics);
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

/**
 * Which points are large: none where they are crowded, all of an outline that is alone, the corners of one over its
 * picture.
 */
function isLarge(scene: Scene, drawing: CurveDocument, all: boolean): (point: ControlPoint) => boolean {
  if (spacingOf(drawing) * scene.state.view.zoom < largeApart) return () => false;
  return ({ kind }) => all || kind === "cusp";
}

function isInSight({ minX, minY, maxX, maxY }: Bounds, { x, y }: ControlPoint): boolean {
  return x >= minX && y >= minY && x <= maxX && y <= maxY;
}

function drawSmall(scene: Scene, drawing: CurveDocument, all: boolean): void {
  if (spacingOf(drawing) * scene.state.view.zoom < smallApart) return;
  const large = isLarge(scene, drawing, all);
  const small = createSmallPoints();
  const sight = sightOf(scene);
  for (const { points } of drawing.contours) {
    for (const point of points) {
      if (!large(point) && isInSight(sight, point)) small.add(onScreen(scene, point), point.kind, false);
    }
  }
  small.draw(inScreen(scene), scene.palette);
}

function drawLargePoints(scene: Scene, drawing: CurveDocument, all: boolean): void {
  const { state: { traceView: { over, chosen }, keyboard }, palette, focused } = scene;
  const context = inScreen(scene);
  const large = isLarge(scene, drawing, all);
  const sight = sightOf(scene);
  drawing.contours.forEach(({ points }, contour) => points.forEach((point, index) => {
    const is = (ref: PointOfOutline | null): boolean => ref !== null && ref.contour === contour && ref.index === index;
    const [hovered, selected] = [is(over), is(chosen)];
    if (!hovered && !selected && !large(point)) return;
    if (isInSight(sight, point)) drawPoint(context, onScreen(scene, point), point.kind, { hovered, selected, focused: selected && focused && keyboard }, palette);
  }));
}
