import { lengthOf, omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument, type Offset } from "../../document.ts";
import { lengthOfOffset, opposite, scaled, turnAt } from "../offset.ts";

/** Corners of contours, and the arcs that stand in place of corners. */

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A joint that turns by less than this looks smooth, and an arc in its place would not be seen. */
export const leastTurn = Math.PI / 180;
/** The sides of a sharper corner lie on each other. */
export const mostTurn = Math.PI - leastTurn;

export function step(from: Place, to: Place): Offset {
  return { dx: to.x - from.x, dy: to.y - from.y };
}

export function cross(a: Offset, b: Offset): number {
  return a.dx * b.dy - a.dy * b.dx;
}

export function dot(a: Offset, b: Offset): number {
  return a.dx * b.dx + a.dy * b.dy;
}

/** The segments that arrive at a point and leave it; null for the free side of an open end. */
export function segmentsAt(contour: Contour, index: number): readonly [number | null, number | null] {
  const segments = segmentCount(contour);
  const before = contour.closed ? (index + segments - 1) % segments : index - 1;
  return [before < 0 ? null : before, index < segments ? index : null];
}

export function pointsOf(contour: Contour, segment: number): readonly [ControlPoint, ControlPoint] | null {
  const { points } = contour;
  const [from, to] = [points[segment], points[(segment + 1) % points.length]];
  return from === undefined || to === undefined ? null : [from, to];
}

/** By how much a handle may stand off a line, as part of its length: moves and turns leave rounding. */
const offLine = 1e-9;

/** Whether a segment runs straight from one point to the other, so that nothing else is seen of it. */
export function isLine(contour: Contour, segment: number): boolean {
  const ends = pointsOf(contour, segment);
  if (ends === null) return false;
  const chord = step(...ends);
  const square = dot(chord, chord);
  const runsAlong = (handle: Offset): boolean => {
    const along = dot(handle, chord) / square;
    return along >= 0 && along <= 1 && Math.abs(cross(handle, chord)) <= offLine * lengthOfOffset(handle) * Math.sqrt(square);
  };
  return square > 0 && runsAlong(ends[0].out) && runsAlong(opposite(ends[1].in));
}

/** The directions in which a contour comes to a point and leaves it; a handle of no length leaves that to the next. */
export function directionsAt(contour: Contour, index: number): { readonly in: Offset; readonly out: Offset } | null {
  const [before, after] = segmentsAt(contour, index);
  const [arriving, leaving] = [before === null ? null : pointsOf(contour, before), after === null ? null : pointsOf(contour, after)];
  if (arriving === null || leaving === null) return null;
  const [previous, here] = arriving;
  const [, next] = leaving;
  const towards = (handle: Offset, other: ControlPoint, its: Offset): Offset =>
    lengthOfOffset(handle) > 0 ? handle : { dx: other.x + its.dx - here.x, dy: other.y + its.dy - here.y };
  return { in: towards(here.in, previous, previous.out), out: towards(here.out, next, next.in) };
}

/** Whether a point is a corner: inside of a contour with handles, and the direction changes there. */
export function isCorner(contour: Contour, index: number): boolean {
  const directions = contour.family === "hermite" ? directionsAt(contour, index) : null;
  if (directions === null || lengthOfOffset(directions.in) === 0 || lengthOfOffset(directions.out) === 0) return false;
  return turnAt(directions) >= leastTurn;
}

/** An arc in place of a corner. */
export interface CornerArc {
  readonly radius: number;
  /** Where its sides meet. */
  readonly corner: Place;
}

/** How far an arc may be from a circle's that is one to whoever drew it: files have few decimals. */
const likeness = 1e-4;

/** The radius of a segment that is an arc of a circle; null for any other. */
function circleOf(curve: CurveDocument, contour: Contour, segment: number): number | null {
  const ends = pointsOf(contour, segment);
  const angle = omegaOf(curve, contour, segment) * lengthOf(contour, segment);
  if (ends === null || (contour.space ?? curve.space) !== "trigonometric" || !(angle >= leastTurn && angle <= mostTurn)) return null;
  const [{ out }, { in: into }] = ends;
  const chord = step(...ends);
  const radius = lengthOfOffset(chord) / (2 * Math.sin(angle / 2));
  const handle = (radius * angle) / 3;
  if (!(handle > 0)) return null;
  const side = cross(chord, out) < 0 ? -1 : 1;
  const along = scaled(chord, (handle * Math.cos(angle / 2)) / lengthOfOffset(chord));
  const across = scaled({ dx: -chord.dy, dy: chord.dx }, (side * handle * Math.sin(angle / 2)) / lengthOfOffset(chord));
  const off = Math.hypot(out.dx - along.dx - across.dx, out.dy - along.dy - across.dy) + Math.hypot(into.dx + along.dx - across.dx, into.dy + along.dy - across.dy);
  return off <= likeness * handle ? radius : null;
}

/** Where a line from one place meets a line back from another; null unless both go forward. */
function meeting(from: Place, leaving: Offset, to: Place, arriving: Offset): Place | null {
  const between = step(from, to);
  const sine = cross(leaving, arriving);
  const [ahead, behind] = [cross(between, arriving) / sine, cross(leaving, between) / sine];
  return ahead > 0 && behind > 0 && Number.isFinite(ahead) ? { x: from.x + ahead * leaving.dx, y: from.y + ahead * leaving.dy } : null;
}

/**
 * The corner that a segment is the rounding of: it is an arc of a circle between two straight sides that touch it. Of
 * an arc beside another one nobody can tell whether there ever was a corner.
 */
export function arcAt(curve: CurveDocument, contour: Contour, segment: number): CornerArc | null {
  if (contour.family !== "hermite") return null;
  const ends = pointsOf(contour, segment);
  const radius = circleOf(curve, contour, segment);
  if (ends === null || radius === null) return null;
  const [from, to] = ends;
  const [before] = segmentsAt(contour, segment);
  const [, after] = segmentsAt(contour, (segment + 1) % contour.points.length);
  if (before === null || after === null || before === after) return null;
  const side = (neighbour: number, tangent: Offset): Offset | null => {
    const line = isLine(contour, neighbour) ? pointsOf(contour, neighbour) : null;
    if (line === null) return null;
    const direction = step(...line);
    const across = Math.abs(cross(direction, tangent));
    return across <= likeness * lengthOfOffset(direction) * lengthOfOffset(tangent) && dot(direction, tangent) > 0 ? direction : null;
  };
  const [leaving, arriving] = [side(before, from.out), side(after, opposite(to.in))];
  const corner = leaving === null || arriving === null ? null : meeting(from, leaving, to, arriving);
  return corner === null ? null : { radius, corner };
}

/** The arcs that a point is an end of, which stand in place of corners. */
export function arcsAt(curve: CurveDocument, contour: Contour, index: number): { readonly segment: number; readonly radius: number }[] {
  return segmentsAt(contour, index).flatMap((segment) => {
    const arc = segment === null ? null : arcAt(curve, contour, segment);
    return segment === null || arc === null ? [] : [{ segment, radius: arc.radius }];
  });
}
