import type { Contour, CurveDocument } from "../../document/document.ts";
import type { Pair } from "../../document/fit/fit.ts";
import { curveOf } from "../curve/curve-cache.ts";

/** Points of a curve are this far apart, as a part of the drawing's size, at least so many and at most so many. */
const step = 1 / 300;
const [fewest, most] = [60, 6000];

/** Contours as strokes of points: as they were given where they came as points, else evenly along each. */
export function strokesFrom(drawing: CurveDocument, contours: readonly Contour[], arePoints: boolean): Pair[][] {
  if (arePoints) return contours.map(({ points }) => points.map(({ x, y }): Pair => [x, y]));
  const curves = contours.flatMap((contour) => curveOf(drawing, contour) ?? []);
  const boxes = curves.map((curve) => curve.bounds());
  const size = Math.max(...boxes.map(({ minX, minY, maxX, maxY }) => Math.hypot(maxX - minX, maxY - minY)), 1e-9);
  return curves.map((curve) => {
    const count = Math.round(Math.min(most, Math.max(fewest, curve.length() / (step * size))));
    const places = curve.sampleByLength(count);
    return Array.from({ length: count }, (_, i): Pair => [places[2 * i] ?? 0, places[2 * i + 1] ?? 0]);
  });
}
