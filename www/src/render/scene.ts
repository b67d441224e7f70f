import type { Contour, CurveDocument } from "../document/document.ts";
import { toScreen, type PagePoint, type ScreenPoint } from "../editor/pointer/camera.ts";
import type { EditorState } from "../editor/editor.ts";
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
  context.setTransform(scale, 0, 0, scale, ratio * (stage.width / 2 - view.x * view.zoom), ratio * (stage.height / 2 - view.y * view.zoom));
  return context;
}

export function onScreen({ state }: Scene, point: PagePoint): ScreenPoint {
  return toScreen(state.view, state.stage, point);
}

const curvePaths = new WeakMap<Float64Array, Path2D>();

/** A path of cubics, eight numbers each; consecutive ones share end points. Kept with its array. */
export function pathOfCubics(cubics: Float64Array, closed: boolean): Path2D {
  const known = curvePaths.get(cubics);
  if (known !== undefined) return known;
  const path = new Path2D();
  for (let i = 0; i + 7 < cubics.length; i += 8) {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0, x3 = 0, y3 = 0] = cubics.subarray(i, i + 8);
    if (i === 0) path.moveTo(x0, y0);
    path.bezierCurveTo(x1, y1, x2, y2, x3, y3);
  }
  if (closed && cubics.length > 0) path.closePath();
  curvePaths.set(cubics, path);
  return path;
}

/** The contour's path, within a twentieth of a pixel at this zoom; the tolerance moves in powers of two, so that zooming seldom makes a new path. */
export function contourPath(scene: Scene, document: CurveDocument, contour: Contour): Path2D {
  return pathOfCubics(cubicsOf(document, contour, toleranceOf(scene)), contour.closed);
}

function toleranceOf({ state }: Scene): number {
  return 0.05 / 2 ** Math.ceil(Math.log2(state.view.zoom));
}

interface Whole {
  readonly tolerance: number;
  readonly all: Path2D;
  readonly closed: Path2D;
}

const wholes = new WeakMap<CurveDocument, Whole>();

/** Every contour in one path, and the closed ones in another: a drawing of thousands is stroked and filled at once, and panning makes nothing new. */
export function documentPaths(scene: Scene, document: CurveDocument): Whole {
  const tolerance = toleranceOf(scene);
  const known = wholes.get(document);
  if (known !== undefined && known.tolerance === tolerance) return known;
  const fresh: Whole = { tolerance, all: new Path2D(), closed: new Path2D() };
  for (const contour of document.contours) {
    const path = contourPath(scene, document, contour);
    fresh.all.addPath(path);
    if (contour.closed) fresh.closed.addPath(path);
  }
  wholes.set(document, fresh);
  return fresh;
}

/** A polygon of interleaved points. */
export function pathOfPoints(points: Float64Array, closed: boolean): Path2D {
  const path = new Path2D();
  for (let i = 0; i + 1 < points.length; i += 2) path.lineTo(points[i] ?? 0, points[i + 1] ?? 0);
  if (closed && points.length > 0) path.closePath();
  return path;
}
