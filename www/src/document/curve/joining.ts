import {
  domainLength, isEnd, lengthOf, samePoint, segmentCount, type Contour, type ControlPoint, type CurveDocument, type PointRef, type Space,
} from "../document.ts";
import { replaceContour, type Command } from "./commands.ts";
import { joined, reversedContour, withClosed, withPinnedOmega } from "./whole/rearranging.ts";
import { kindOf } from "./offset.ts";

/** Two open ends become one contour. */

function endOf(curve: CurveDocument, ref: PointRef): Contour | null {
  const contour = curve.contours[ref.contour];
  return contour?.family === "hermite" && isEnd(curve, ref) ? contour : null;
}

/** The space that holds the segments of both; null where there is none. Cubics belong to each. */
function commonSpace(curve: CurveDocument, a: Contour, b: Contour): Space | null {
  const space = (contour: Contour): Space => (contour.omega?.every((omega) => omega === 0) === true ? "polynomial" : (contour.space ?? curve.space));
  const [one, other] = [space(a), space(b)];
  if (one === "polynomial" || one === other) return other;
  return other === "polynomial" ? one : null;
}

/** One point in place of an end and the start that stands where it does: the handles of both. */
function seam(end: ControlPoint, start: ControlPoint): ControlPoint {
  const handles = { in: end.in, out: start.out };
  return { ...end, ...handles, kind: kindOf(handles) };
}

/**
 * `before` goes on as `after`: at one point where they are no farther than `near` apart, else by a segment between
 * them.
 */
function connected(before: Contour, after: Contour, space: Space, near: number): Contour | null {
  const [end, start] = [before.points.at(-1), after.points[0]];
  if (end === undefined || start === undefined) return null;
  const meet = Math.hypot(end.x - start.x, end.y - start.y) <= near;
  const lengths = (contour: Contour): number[] => Array.from({ length: segmentCount(contour) }, (_, s) => lengthOf(contour, s));
  const between = domainLength(before) / Math.max(1, segmentCount(before));
  const uneven = before.lengths !== undefined || after.lengths !== undefined;
  return {
    ...before,
    space,
    points: meet ? [...before.points.slice(0, -1), seam(end, start), ...after.points.slice(1)] : [...before.points, ...after.points],
    omega: [...(before.omega ?? []), ...(meet ? [] : [0]), ...(after.omega ?? [])],
    ...(uneven ? { lengths: [...lengths(before), ...(meet ? [] : [between]), ...lengths(after)] } : {}),
  };
}

/** A contour whose ends are joined. */
function closedUp(curve: CurveDocument, contour: Contour, near: number): Contour {
  const [first, last] = [contour.points[0], contour.points.at(-1)];
  if (first === undefined || last === undefined || Math.hypot(first.x - last.x, first.y - last.y) > near) return withClosed(curve, contour, true);
  return joined({ ...withPinnedOmega(curve, contour), points: [...contour.points.slice(0, -1), { ...last, x: first.x, y: first.y }] });
}

/**
 * Joins two ends of open Hermite contours, or both ends of one. Ends within `near` become one point, where the first
 * stands; between others comes a segment with the handles that are there. Null where these are no such ends, or where
 * no space holds the segments of both.
 */
export function joinEnds(curve: CurveDocument, [one, other]: readonly [PointRef, PointRef], near: number): Command | null {
  const [a, b] = [endOf(curve, one), endOf(curve, other)];
  if (a === null || b === null || samePoint(one, other)) return null;
  if (a === b) {
    const closed = closedUp(curve, a, near);
    return { name: "Join", apply: (now) => replaceContour(now, one.contour, closed), select: { points: [{ contour: one.contour, index: 0 }], handle: null } };
  }
  const [from, to] = [withPinnedOmega(curve, a), withPinnedOmega(curve, b)];
  const space = commonSpace(curve, from, to);
  if (space === null) return null;
  const whole = connected(one.index === 0 ? reversedContour(from) : from, other.index === 0 ? to : reversedContour(to), space, near);
  if (whole === null) return null;
  const contour = one.contour - (other.contour < one.contour ? 1 : 0);
  return {
    name: "Join",
    apply: (now) => replaceContour(replaceContour(now, one.contour, whole), other.contour),
    select: { points: [{ contour, index: a.points.length - 1 }], handle: null },
  };
}
