import type { Contour, CurveDocument, View } from "../document/document.ts";
import { toPage, toScreen, zoomDown, type PagePoint, type ScreenPoint } from "../editor/pointer/camera.ts";
import type { EditorState } from "../editor/editor.ts";
import type { Bounds } from "../kernel/curve/samples.ts";
import { cubicsOf } from "../kernel/paths/paths.ts";
import type { Palette } from "./palette.ts";

/** What every layer draws with: the canvas, the state of this frame, and the two coordinate systems. */
export interface Scene {
  readonly context: CanvasRenderingContext2D;
  readonly state: EditorState;
  readonly palette: Palette;
  /** Device pixels per CSS pixel. */
  readonly ratio: number;
  /** The curve as it was when the drag began; the curve itself otherwise. */
  readonly origin: CurveDocument;
  /** The stage has the keyboard focus. */
  readonly focused: boolean;
  /** Where alone something is to be drawn; absent: everywhere. */
  readonly cut?: ScreenBox;
}

/** A rectangle of the stage, in CSS pixels or in those of the device. */
export interface ScreenBox {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Draw in CSS pixels of the stage. */
export function inScreen({ context, ratio }: Scene): CanvasRenderingContext2D {
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return context;
}

/** Draw in document units; line widths are to be divided by the zoom. */
export function inPage({ context, ratio, state }: Scene): CanvasRenderingContext2D {
  const { view, stage } = state;
  const scale = ratio * view.zoom;
  const down = ratio * zoomDown(view);
  context.setTransform(scale, 0, 0, down, ratio * (stage.width / 2) - view.x * scale, ratio * (stage.height / 2) - view.y * down);
  return context;
}

export function onScreen({ state }: Scene, point: PagePoint): ScreenPoint {
  return toScreen(state.view, state.stage, point);
}

/** From so many CSS pixels on, browsers draw less exactly than can be seen. */
export const isFarAway = ({ x, y, zoom }: View): boolean => Math.hypot(x, y) * zoom > 1e5;

const curvePaths = new WeakMap<Float64Array, Path2D>();

/** A path of cubics, eight numbers each; consecutive ones share end points. Kept with its array. */
export function pathOfCubics(cubics: Float64Array, closed: boolean): Path2D {
  const known = curvePaths.get(cubics);
  if (known !== undefined) return known;
  const path = new Path2D();
  if (cubics.length > 0) path.moveTo(cubics[0] ?? 0, cubics[1] ?? 0);
  addCubics(path, cubics);
  if (closed && cubics.length > 0) path.closePath();
  curvePaths.set(cubics, path);
  return path;
}

/** Goes on with cubics from where the path is. */
export function addCubics(path: Path2D, cubics: Float64Array): void {
  for (let i = 0; i + 7 < cubics.length; i += 8) {
    path.bezierCurveTo(cubics[i + 2] ?? 0, cubics[i + 3] ?? 0, cubics[i + 4] ?? 0, cubics[i + 5] ?? 0, cubics[i + 6] ?? 0, cubics[i + 7] ?? 0);
  }
}

/**
 * The contour's path, within a twentieth of a pixel at this zoom; the tolerance moves in powers of two, so that zooming
 * seldom makes a new path.
 */
export function contourPath(scene: Scene, document: CurveDocument, contour: Contour): Path2D {
  return pathOfCubics(cubicsOf(document, contour, toleranceOf(scene)), contour.closed);
}

/** In document units. */
export function toleranceOf({ state }: Scene): number {
  return 0.05 / 2 ** Math.ceil(Math.log2(state.view.zoom));
}

/** A polygon of interleaved points. */
export function pathOfPoints(points: Float64Array, closed: boolean): Path2D {
  const path = new Path2D();
  addVertices(path, points);
  if (closed && points.length > 0) path.closePath();
  return path;
}

export function addVertices(path: Path2D, points: Float64Array): void {
  for (let i = 0; i + 1 < points.length; i += 2) path.lineTo(points[i] ?? 0, points[i + 1] ?? 0);
}

/** What is to be drawn of the document: what is in sight, and a little more all around, for whatever stands out. */
export function sightOf({ state: { view, stage }, cut = { x: 0, y: 0, width: stage.width, height: stage.height } }: Scene): Bounds {
  const from = toPage(view, stage, { x: cut.x - outstanding, y: cut.y - outstanding });
  const to = toPage(view, stage, { x: cut.x + cut.width + outstanding, y: cut.y + cut.height + outstanding });
  return { minX: from.x, minY: from.y, maxX: to.x, maxY: to.y };
}

/** CSS pixels that no mark and no line stands out by. */
const outstanding = 24;

const boxes = new WeakMap<Float64Array, Bounds>();

/** A box around cubics and their handles. */
export function boxAround(cubics: Float64Array): Bounds {
  const known = boxes.get(cubics);
  if (known !== undefined) return known;
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i + 1 < cubics.length; i += 2) {
    const [x, y] = [cubics[i] ?? 0, cubics[i + 1] ?? 0];
    [minX, minY, maxX, maxY] = [Math.min(minX, x), Math.min(minY, y), Math.max(maxX, x), Math.max(maxY, y)];
  }
  const fresh = { minX, minY, maxX, maxY };
  boxes.set(cubics, fresh);
  return fresh;
}

export function overlap(a: Bounds, b: Bounds): boolean {
  return a.maxX >= b.minX && a.minX <= b.maxX && a.maxY >= b.minY && a.minY <= b.maxY;
}
