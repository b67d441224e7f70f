import { turnAt } from "../curve/offset.ts";
import type { Contour, ControlPoint } from "../document.ts";

/** Which points of a traced outline are corners: for the tracer to say, but it names places, not points. */

export interface CornerSearch {
  /** How far from a corner that was found its point may be. */
  readonly within: number;
  /** Radians of turning from which on a point is a corner, found or not. */
  readonly least: number;
}

/**
 * The outline with its corners named. Each corner that was found is the point nearest to it. Another point is smooth,
 * though its handles differ by a rounding error: unless they turn as much as a corner was asked to.
 */
export function withFoundCorners(contour: Contour, corners: readonly (readonly [number, number])[], { within, least }: CornerSearch): Contour {
  const found = new Set(corners.map(([x, y]) => nearestPoint(contour.points, x, y, within)));
  const points = contour.points.map((point, i) => {
    const isCorner = found.has(i) || (point.kind === "cusp" && turnAt(point) >= least);
    if (isCorner === (point.kind === "cusp")) return point;
    return { ...point, kind: isCorner ? "cusp" as const : "smooth" as const };
  });
  return { ...contour, points };
}

/** −1: none is near. */
function nearestPoint(points: readonly ControlPoint[], x: number, y: number, within: number): number {
  let [best, least] = [-1, within];
  points.forEach((point, i) => {
    const distance = Math.hypot(point.x - x, point.y - y);
    if (distance <= least) [best, least] = [i, distance];
  });
  return best;
}
