import { isSelected, samePoint, type CurveDocument, type HandleRef, type PointRef, type Selection, type Side } from "../../document/document.ts";
import { nearestOn } from "../../kernel/curve/samples.ts";
import { toPage, toScreen, type ScreenPoint } from "./camera.ts";
import type { EditorState, Target } from "../state.ts";

/** What is under a place of the screen. Distances are in CSS pixels whatever the zoom. */

export const reachOf = { mouse: 10, pen: 12, touch: 22 } as const;
const curveReachOf = { mouse: 6, pen: 8, touch: 14 } as const;

export type PointerKind = keyof typeof reachOf;

const sides: readonly Side[] = ["in", "out"];

/** Whether a side of a point has a segment to shape: the free ends of an open contour have not. */
export function hasSide(curve: CurveDocument, ref: PointRef, side: Side): boolean {
  const contour = curve.contours[ref.contour];
  if (contour === undefined || contour.family === "interpolating") return false;
  if (contour.closed) return true;
  return side === "in" ? ref.index > 0 : ref.index < contour.points.length - 1;
}

/**
 * The points whose handles show: the chosen ones and their neighbours; all of a small drawing while nothing is chosen.
 */
function pointsWithHandles(curve: CurveDocument, selection: Selection, most = 4): PointRef[] {
  const total = curve.contours.reduce((sum, contour) => sum + contour.points.length, 0);
  if (selection.points.length === 0) {
    if (total > most) return [];
    return curve.contours.flatMap((contour, c) => contour.points.map((_, index) => ({ contour: c, index })));
  }
  // A choice of everything would draw every handle there is: a thicket that hides the curve.
  if (selection.points.length > 64) return [];
  const shown: PointRef[] = [];
  const add = (ref: PointRef): void => {
    if (!shown.some((other) => samePoint(other, ref))) shown.push(ref);
  };
  for (const ref of selection.points) {
    const contour = curve.contours[ref.contour];
    if (contour === undefined) continue;
    const count = contour.points.length;
    add(ref);
    for (const step of [-1, 1]) {
      const index = contour.closed ? (ref.index + step + count) % count : ref.index + step;
      if (index >= 0 && index < count) add({ contour: ref.contour, index });
    }
  }
  return shown;
}

/** The handles on the stage: those that show, have a segment, and have not been drawn into their point. */
export function shownHandles(state: EditorState): HandleRef[] {
  if (!state.settings.overlays.handles || state.mode !== "curve") return [];
  // The pen is about to give the free end its segment: its handle shows what that will leave along.
  const shows = (ref: PointRef, side: Side): boolean =>
    hasSide(state.curve, ref, side) || (state.tool === "pen" && state.curve.contours[ref.contour]?.family === "hermite");
  return pointsWithHandles(state.curve, state.selection).flatMap((ref) =>
    sides.filter((side) => shows(ref, side) && !isRetracted(state.curve, ref, side)).map((side) => ({ ...ref, side })),
  );
}

function isRetracted(curve: CurveDocument, ref: PointRef, side: Side): boolean {
  const point = curve.contours[ref.contour]?.points[ref.index];
  return point === undefined || (point[side].dx === 0 && point[side].dy === 0);
}

interface Found<T> {
  readonly what: T;
  readonly distance: number;
}

function nearer<T>(best: Found<T> | null, what: T, distance: number, reach: number): Found<T> | null {
  return distance <= reach && (best === null || distance < best.distance) ? { what, distance } : best;
}

/** Chosen handles, then points, then other handles, then the curve. */
export function hitTest(state: EditorState, at: ScreenPoint, kind: PointerKind): Target {
  if (state.mode !== "curve") return { kind: "empty" };
  const reach = reachOf[kind];
  const handles = shownHandles(state);
  const chosen = nearestHandle(state, handles.filter((handle) => isSelected(state.selection, handle)), at, reach);
  const point = nearestPoint(state, at, reach);
  const curve = nearestCurve(state, at, curveReachOf[kind]);
  // A finger covers several markers: the nearest wins, whatever its kind. A mouse right on a point means the point,
  // however short its handles are.
  const means = point !== null && chosen !== null && point.distance < chosen.distance && (kind === "touch" || point.distance <= 5);
  const preferred = means ? null : chosen;
  // Right on the curve, a handle that merely passes near must not take the press.
  const handle = preferred ?? (point === null ? nearestHandle(state, handles, at, reach) : null);
  if (handle !== null && !(curve !== null && point === null && curve.distance < 3 && handle.distance > 5)) {
    return { kind: "handle", handle: handle.what };
  }
  if (point !== null) return { kind: "point", point: point.what };
  return curve?.what ?? { kind: "empty" };
}

function nearestHandle(state: EditorState, handles: readonly HandleRef[], at: ScreenPoint, reach: number): Found<HandleRef> | null {
  let best: Found<HandleRef> | null = null;
  for (const handle of handles) {
    const point = state.curve.contours[handle.contour]?.points[handle.index];
    if (point === undefined) continue;
    const offset = point[handle.side];
    const screen = toScreen(state.view, state.stage, { x: point.x + offset.dx, y: point.y + offset.dy });
    best = nearer(best, handle, Math.hypot(screen.x - at.x, screen.y - at.y), reach);
  }
  return best;
}

/** Closer together than this points are at one place, where what is chosen comes first: it was chosen to be moved. */
const samePlace = 0.5;

function nearestPoint(state: EditorState, at: ScreenPoint, reach: number): Found<PointRef> | null {
  let best: Found<PointRef> | null = null;
  const page = toPage(state.view, state.stage, at);
  // A little more than the reach, for what rounding takes away.
  const near = (1.01 * reach) / state.view.zoom;
  state.curve.contours.forEach(({ points }, contour) => points.forEach((point, index) => {
    if (Math.abs(point.x - page.x) > near || Math.abs(point.y - page.y) > near) return;
    const screen = toScreen(state.view, state.stage, point);
    const distance = Math.hypot(screen.x - at.x, screen.y - at.y);
    const isFirst = isSelected(state.selection, { contour, index });
    best = nearer(best, { contour, index }, isFirst ? Math.max(0, distance - samePlace) : distance, reach);
  }));
  return best;
}

function nearestCurve(state: EditorState, at: ScreenPoint, reach: number): Found<Target> | null {
  const page = toPage(state.view, state.stage, at);
  let best: Found<Target> | null = null;
  state.curve.contours.forEach((contour, c) => {
    const found = nearestOn(state.curve, contour, page.x, page.y, reach / state.view.zoom);
    if (found === null) return;
    best = nearer<Target>(best, { kind: "curve", contour: c, t: found.t, x: found.x, y: found.y }, found.distance * state.view.zoom, reach);
  });
  return best;
}

export function sameTarget(a: Target, b: Target): boolean {
  if (a.kind === "point" && b.kind === "point") return samePoint(a.point, b.point);
  if (a.kind === "handle" && b.kind === "handle") return samePoint(a.handle, b.handle) && a.handle.side === b.handle.side;
  if (a.kind === "curve" && b.kind === "curve") return a.contour === b.contour && a.t === b.t;
  if (a.kind === "grip" && b.kind === "grip") return a.grip === b.grip;
  return a.kind === "empty" && b.kind === "empty";
}
