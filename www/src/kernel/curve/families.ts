import type { Contour, ControlPoint, CurveDocument } from "../../document/document.ts";
import { plainPoint } from "../../document/curve/contours.ts";
import { curveOf } from "./curve-cache.ts";
import { distanceBetween } from "./distance.ts";
import { placesOf, supported } from "./interpolating.ts";

/** From one family of contours to the other, through the same points. */

/** What is true of a contour in either family. */
function kept({ closed, space, ink }: Contour): Pick<Contour, "closed" | "space" | "ink"> {
  return { closed, ...(space === undefined ? {} : { space }), ...(ink === undefined ? {} : { ink }) };
}

/** A contour with tangents as one through the same points; its corners are rounded. */
export function asInterpolating(document: CurveDocument, contour: Contour): { contour: Contour; moved: number } {
  const next = supported(document, { ...kept(contour), family: "interpolating", points: contour.points.map(({ x, y }) => plainPoint(x, y)) });
  return { contour: next, moved: distanceBetween(document, contour, next) };
}

/** An interpolating contour as one with a tangent at each of its points. */
export function asHermite(document: CurveDocument, contour: Contour): { contour: Contour; moved: number } {
  const curve = curveOf(document, contour);
  if (curve === null) return { contour, moved: 0 };
  const { count, t } = placesOf(contour);
  const [places, tangents] = [curve.evaluate(t), curve.evaluate(t, 1)];
  const points = Array.from({ length: count }, (_, i): ControlPoint => {
    const out = { dx: (tangents[2 * i] ?? 0) / 3 + 0, dy: (tangents[2 * i + 1] ?? 0) / 3 + 0 };
    return { x: places[2 * i] ?? 0, y: places[2 * i + 1] ?? 0, kind: "symmetric", in: { dx: 0 - out.dx, dy: 0 - out.dy }, out };
  });
  const next: Contour = { ...kept(contour), family: "hermite", points, support: 1 };
  return { contour: next, moved: distanceBetween(document, contour, next) };
}
