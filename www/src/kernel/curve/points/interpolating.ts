import type { Contour, CurveDocument } from "../../../document/document.ts";
import { plainPoint } from "../../../document/curve/contours.ts";
import { curveOf } from "../curve-cache.ts";
import { distanceBetween } from "../distance.ts";
import { pointsOf, supported, withoutGrid } from "../interpolating.ts";

/** Interpolating contours with more points or fewer. */

/** `count` points of the same curve at equal parameters, at level 0. */
export function resampledInterpolating(document: CurveDocument, contour: Contour, count: number): Contour {
  const curve = curveOf(document, contour);
  if (curve === null) return contour;
  const [from, to] = curve.domain;
  const segments = contour.closed ? count : count - 1;
  const t = Float64Array.from({ length: count }, (_, i) => (i === segments ? to : from + ((to - from) * i) / segments));
  return supported(document, withoutGrid({ ...contour, points: pointsOf(curve.evaluate(t)) }));
}

/** One more point at parameter `t`, on the curve; the rest of the curve gives way a little. */
export function insertedInterpolating(document: CurveDocument, contour: Contour, t: number): { contour: Contour; index: number; moved: number } | null {
  const curve = curveOf(document, contour);
  const rest = t - Math.floor(t);
  if (curve === null || contour.grid !== undefined || rest < 1e-9 || rest > 1 - 1e-9) return null;
  const [x = 0, y = 0] = curve.evaluate(Float64Array.of(t));
  const index = Math.floor(t) + 1;
  const points = [...contour.points.slice(0, index), plainPoint(x, y), ...contour.points.slice(index)];
  const next = supported(document, { ...contour, points });
  return { contour: next, index, moved: distanceBetween(document, contour, next) };
}

/** Without one of its points. */
export function removedInterpolating(document: CurveDocument, contour: Contour, index: number): { contour: Contour; deviation: number } | null {
  const least = contour.closed ? 3 : 2;
  if (contour.grid !== undefined || contour.points.length <= least) return null;
  const next = supported(document, { ...contour, points: contour.points.filter((_, i) => i !== index) });
  return { contour: next, deviation: distanceBetween(document, contour, next) };
}
