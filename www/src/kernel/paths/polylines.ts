import type { Contour, CurveDocument } from "../../document/document.ts";
import { translationOf } from "../../document/curve/contours.ts";
import { curveOf } from "../curve/curve-cache.ts";

/** Curves and marks that are nearly dense on the screen, as polylines of few vertices: x and y in turn. */

const polylines = new WeakMap<Contour, { readonly tolerance: number; readonly flat: Float64Array; readonly vertices: Float64Array }>();

/**
 * A polyline nowhere farther from the open contour than `tolerance`, with few vertices. Kept until the tolerance
 * changes.
 */
export function polylineOf(document: CurveDocument, contour: Contour, tolerance: number): Float64Array {
  const known = polylines.get(contour);
  if (known?.tolerance === tolerance) return known.vertices;
  const moved = translationOf(contour);
  if (moved !== undefined) {
    const vertices = shifted(polylineOf(document, moved.from, tolerance), moved.dx, moved.dy);
    polylines.set(contour, { tolerance, flat: vertices, vertices });
    return vertices;
  }
  // What was near enough is so still from farther away: a drawing that is made smaller is flattened once.
  const flat = known !== undefined && known.tolerance < tolerance ? known.flat : (curveOf(document, contour)?.flatten(tolerance / 2) ?? new Float64Array(0));
  const vertices = thinned(flat, tolerance / 2);
  polylines.set(contour, { tolerance, flat, vertices });
  return vertices;
}

export function shifted(points: Float64Array, dx: number, dy: number): Float64Array {
  return points.map((value, i) => value + (i % 2 === 0 ? dx : dy));
}

/**
 * Some of a polyline's vertices, so that those left out are no farther than `tolerance` from what is left: a piece goes
 * on while a line from its first vertex passes that near to all that it leaves out, and while it does not turn back.
 */
export function thinned(points: Float64Array, tolerance: number): Float64Array {
  const count = points.length / 2;
  if (count <= 2) return points;
  const kept = new Float64Array(points.length);
  kept.set(points.subarray(0, 2));
  let length = 2;
  let anchor = 0;
  while (anchor < count - 1) {
    anchor = farthestFrom(points, anchor, tolerance);
    kept.set(points.subarray(2 * anchor, 2 * anchor + 2), length);
    length += 2;
  }
  return kept.slice(0, length);
}

/** The last vertex that a line from `anchor` can reach in sight of all between them. */
function farthestFrom(points: Float64Array, anchor: number, tolerance: number): number {
  const count = points.length / 2;
  const [x, y] = [points[2 * anchor] ?? 0, points[2 * anchor + 1] ?? 0];
  // Directions as angles from the first one; how far the piece has got.
  let [ux, uy, least, most, farthest] = [0, 0, -Infinity, Infinity, 0];
  for (let i = anchor + 1; i < count; i += 1) {
    const [dx, dy] = [(points[2 * i] ?? 0) - x, (points[2 * i + 1] ?? 0) - y];
    const distance = Math.hypot(dx, dy);
    if (distance < farthest) return Math.max(anchor + 1, i - 1);
    farthest = distance;
    // All directions pass this near to the anchor.
    if (distance <= tolerance) continue;
    if (ux === 0 && uy === 0) [ux, uy] = [dx, dy];
    const angle = Math.atan2(ux * dy - uy * dx, ux * dx + uy * dy);
    if (angle < least || angle > most) return Math.max(anchor + 1, i - 1);
    const half = Math.asin(tolerance / distance);
    [least, most] = [Math.max(least, angle - half), Math.min(most, angle + half)];
  }
  return count - 1;
}
