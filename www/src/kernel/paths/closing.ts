import { joined } from "../../document/curve/whole/rearranging.ts";
import { kindOf } from "../../document/curve/offset.ts";
import { closedByChord } from "../../document/curve/parts.ts";
import type { Contour, ControlPoint } from "../../document/document.ts";

/** Outlines that are closed where they are filled, though their path data do not say so: one logo in ten has some. */

/**
 * Files are written with few decimals: ends nearer to each other than this, of the path's size, were meant to be one.
 */
const nearly = 2e-4;

/** How near ends are that are one. */
export function nearIn(contours: readonly Contour[]): number {
  const points = contours.flatMap((contour) => contour.points);
  const reach = (of: (point: ControlPoint) => number): number =>
    points.reduce((most, point) => Math.max(most, of(point)), -Infinity) - points.reduce((least, point) => Math.min(least, of(point)), Infinity);
  return nearly * Math.hypot(reach(({ x }) => x), reach(({ y }) => y));
}

/** The contour closed at one point where its ends lie nearly on each other; else as it was. */
export function joinedNearly(contour: Contour, near: number): Contour {
  const [first, last] = [contour.points[0], contour.points.at(-1)];
  if (contour.closed || first === undefined || last === undefined) return contour;
  if (Math.hypot(first.x - last.x, first.y - last.y) > near) return contour;
  const met = joined({ ...contour, points: [...contour.points.slice(0, -1), { ...last, x: first.x, y: first.y }] });
  return met.closed ? met : contour;
}

/**
 * The contour closed as a filled one is seen: by a straight line between its ends. A line of two points encloses
 * nothing.
 */
export function closedByLine(contour: Contour): Contour {
  if (contour.closed || isLine(contour)) return contour;
  const whole = closedByChord(contour);
  const last = whole.points.length - 1;
  return { ...whole, points: whole.points.map((point, i) => (i === 0 || i === last ? { ...point, kind: kindOf(point) } : point)) };
}

function isLine({ points }: Contour): boolean {
  const [first, last] = [points[0], points[1]];
  if (first === undefined || last === undefined || points.length > 2) return points.length < 2;
  const [dx, dy] = [last.x - first.x, last.y - first.y];
  const across = (handle: { readonly dx: number; readonly dy: number }): number => Math.abs(handle.dx * dy - handle.dy * dx);
  return Math.max(across(first.out), across(last.in)) <= 1e-9 * (dx * dx + dy * dy);
}
