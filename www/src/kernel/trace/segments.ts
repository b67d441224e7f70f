import { lengthOf, segmentCount, type Contour } from "../../document/document.ts";

/** What the segments of an outline are: straight, an arc of an ellipse to the last digits, or anything else. */

export type SegmentKind = "lines" | "arcs" | "curves";

/** Of the segment's size: rounding, not shape. */
const tolerance = 1e-6;

export function segmentsIn(contours: readonly Contour[]): Record<SegmentKind, number> {
  const segments = { lines: 0, arcs: 0, curves: 0 };
  for (const contour of contours) for (const kind of kindsOf(contour)) segments[kind] += 1;
  return segments;
}

function kindsOf(contour: Contour): SegmentKind[] {
  return Array.from({ length: segmentCount(contour) }, (_, i) => kindOf(contour, i));
}

function kindOf(contour: Contour, i: number): SegmentKind {
  const { points } = contour;
  const [from, to] = [points[i], points[(i + 1) % points.length]];
  if (from === undefined || to === undefined) return "curves";
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const size = Math.hypot(dx, dy);
  const off = (handle: { dx: number; dy: number }): number => Math.abs(dx * handle.dy - dy * handle.dx);
  if (size > 0 && off(from.out) + off(to.in) <= tolerance * size * size) return "lines";
  const angle = (contour.omega?.[i] ?? 0) * lengthOf(contour, i);
  if (angle === 0 || (contour.space ?? "trigonometric") !== "trigonometric") return "curves";
  // A drawn handle is a third of the tangent: here both tangents run forward, for an angle as parameter.
  const third = 3 / angle;
  const start = [from.out.dx * third, from.out.dy * third] as const;
  const end = [-to.in.dx * third, -to.in.dy * third] as const;
  const apart = Math.max(...[0, 1].map((axis) => fromArc(start[axis === 0 ? 0 : 1], end[axis === 0 ? 0 : 1], axis === 0 ? dx : dy, angle)));
  return apart <= tolerance * Math.max(size, Math.hypot(...start)) ? "arcs" : "curves";
}

/**
 * How far a·cos + b·sin with these tangents at its ends is from making this step. The tangents give b and a; for half a
 * turn they must be opposite, and any step will do.
 */
function fromArc(start: number, end: number, step: number, angle: number): number {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  if (Math.abs(sin) < 1e-9) return Math.abs(start * cos - end);
  const a = (start * cos - end) / sin;
  return Math.abs(a * (cos - 1) + start * sin - step);
}
