import type { Command } from "../../document/curve/commands.ts";
import { closeDrawn, cornerAt, growContour, startContour } from "../../document/curve/drawing/points.ts";
import { joinEnds } from "../../document/curve/joining.ts";
import { nothingSelected, type Contour, type ControlPoint, type PointRef } from "../../document/document.ts";
import type { EditorState, Rubber } from "../../editor/editor.ts";
import { toScreen, type PagePoint } from "../../editor/pointer/camera.ts";
import { constrained, gridOf, snapPlace } from "../../editor/pointer/snapping.ts";
import { distanceBetween, type PointerSample } from "../../editor/tool.ts";

/** What a press of the pen means: where its point goes, whether it closes the contour, which end it takes up. */

/** The contour that the pen is drawing; it is always the last point that goes on. */
export interface Drawn {
  readonly at: number;
  readonly contour: Contour;
}

export interface Placement {
  readonly command: Command;
  /** The point that a drag then pulls handles out of. */
  readonly ref: PointRef;
  readonly closing: boolean;
}

/** How near to a point means the point, in CSS pixels; a finger is twice as wide. */
const reach = 10;

/** A point behind the last one, or the segment back to the first. */
export function nextPoint(state: EditorState, { at, contour }: Drawn, sample: PointerSample): Placement {
  if (closes(state, contour, sample)) return { command: closeDrawn(at, contour), ref: { contour: at, index: 0 }, closing: true };
  const command = growContour(at, contour, placeOf(state, contour, sample));
  return { command, ref: { contour: at, index: contour.points.length }, closing: false };
}

export function firstPoint(state: EditorState, sample: PointerSample): Placement {
  const { curve } = state;
  return { command: startContour(curve, placeOf(state, null, sample)), ref: { contour: curve.contours.length, index: 0 }, closing: false };
}

/**
 * The segment that a press would make, onto the end of another contour where one is given; null while there is no point
 * for it to begin at.
 */
export function rubberOf(state: EditorState, contour: Contour, sample: PointerSample, end: PathEnd | null): Rubber | null {
  const [first, last] = [contour.points[0], contour.points.at(-1)];
  if (first === undefined || last === undefined) return null;
  const closing = closes(state, contour, sample);
  const to = closing ? first : end === null ? cornerAt(placeOf(state, contour, sample)) : end.first ? end.point : { ...end.point, in: end.point.out };
  // What joins two contours is a cubic.
  const omega = end !== null ? { omega: [0] } : contour.omega === undefined ? {} : { omega: [contour.omega.at(-1) ?? 0] };
  return { contour: { family: "hermite", closed: false, points: [last, to], ...omega }, closing };
}

export interface PathEnd {
  readonly contour: number;
  /** It is the beginning, not the last point. */
  readonly first: boolean;
  readonly point: ControlPoint;
}

/** The open contour with an end under the pointer, which the pen goes on from, or joins to the one that is drawn. */
export function endAt(state: EditorState, sample: PointerSample, drawn: Drawn | null): PathEnd | null {
  if (drawn !== null && closes(state, drawn.contour, sample)) return null;
  for (const [contour, { closed, points, family }] of state.curve.contours.entries()) {
    if (closed || family === "interpolating" || contour === drawn?.at) continue;
    const [first, last] = [points[0], points.at(-1)];
    if (last !== undefined && isAt(state, last, sample)) return { contour, first: false, point: last };
    if (first !== undefined && isAt(state, first, sample)) return { contour, first: true, point: first };
  }
  return null;
}

/** What is drawn and the contour of an end as one; null where no space holds the segments of both. */
export function joinedTo({ curve }: EditorState, { at, contour }: Drawn, end: PathEnd): Command | null {
  const onto = { contour: end.contour, index: end.first ? 0 : (curve.contours[end.contour]?.points.length ?? 1) - 1 };
  // Only what is drawn to the very place has met it already.
  return joinEnds(curve, [{ contour: at, index: contour.points.length - 1 }, onto], 0);
}

function closes(state: EditorState, { points }: Contour, sample: PointerSample): boolean {
  return points.length >= 2 && isAt(state, points[0], sample);
}

function isAt({ view, stage }: EditorState, point: ControlPoint | undefined, { screen, kind }: PointerSample): boolean {
  return point !== undefined && distanceBetween(toScreen(view, stage, point), screen) <= reach * (kind === "touch" ? 2 : 1);
}

/** Shift holds to eight directions from the last point; else the place snaps. */
function placeOf({ curve, settings, view }: EditorState, contour: Contour | null, { page, modifiers }: PointerSample): PagePoint {
  const last = contour?.points.at(-1);
  if (modifiers.shift && last !== undefined) {
    const step = constrained(page.x - last.x, page.y - last.y);
    return { x: last.x + step.dx, y: last.y + step.dy };
  }
  if (!settings.snap || modifiers.mod) return page;
  return snapPlace(curve, nothingSelected, page, view.zoom, gridOf({ curve, settings })).value;
}
