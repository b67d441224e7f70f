import { omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument } from "../../document/document.ts";
import { plainPoint } from "../../document/curve/contours.ts";
import { rootsOf } from "../../document/curve/roots.ts";
import type { Root } from "../../document/surface/surface.ts";
import { curveOf } from "./curve-cache.ts";
import { distanceBetween } from "./distance.ts";
import { placesOf, supported } from "./interpolating.ts";

/** From one family of contours to the other, through the same points. */

/** What is true of a contour in either family. */
function kept({ closed, space, ink }: Contour): Pick<Contour, "closed" | "space" | "ink"> {
  return { closed, ...(space === undefined ? {} : { space }), ...(ink === undefined ? {} : { ink }) };
}

/** Frequencies that differ by less are one: it is the rounding of a sum of angles. */
const sameFrequency = 1e-12;

/** The one frequency of all segments, per point, where a contour has that and another than the drawing; else null. */
function ownFrequency({ omega = [], lengths }: Contour): number | null {
  const [first = 0, ...others] = omega.map((each, i) => each * (lengths?.[i] ?? 1));
  return first > 0 && others.every((each) => Math.abs(each - first) <= sameFrequency) ? first : null;
}

/** The roots that keep such a frequency, where they are not those that the contour has anyway. */
function rootsWith(document: CurveDocument, contour: Contour, frequency: number): Pick<Contour, "roots"> {
  const isHyperbolic = (contour.space ?? document.space) === "hyperbolic";
  const known = frequencyIn(rootsOf(document, contour));
  if ((contour.space ?? document.space) === "polynomial" || (known !== null && Math.abs(known - frequency) <= sameFrequency)) return {};
  const root = (size: number): Root => (isHyperbolic ? { re: size, im: 0 } : { re: 0, im: size });
  return { roots: [{ re: 0, im: 0 }, root(frequency), root(0 - frequency)] };
}

/** Of roots that tangents have, too: 0 and one pair. */
function frequencyIn(roots: readonly Root[]): number | null {
  const [, root] = roots;
  return root === undefined || roots.length !== 3 ? null : Math.abs(root.re) + Math.abs(root.im);
}

/** A contour with tangents as one through the same points; its corners are rounded. */
export function asInterpolating(document: CurveDocument, contour: Contour): { contour: Contour; moved: number } {
  const plain: Contour = { ...kept(contour), family: "interpolating", points: contour.points.map(({ x, y }) => plainPoint(x, y)) };
  const own = ownFrequency(contour);
  const next = supported(document, own === null ? plain : { ...plain, ...rootsWith(document, plain, own) });
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
  const plain: Contour = { ...kept(contour), family: "hermite", points, support: 1 };
  const own = contour.roots === undefined ? null : frequencyIn(contour.roots);
  const isOwn = own !== null && Math.abs(own - omegaOf(document, plain, 0)) > sameFrequency;
  const next: Contour = isOwn ? { ...plain, omega: Array.from({ length: segmentCount(plain) }, () => own) } : plain;
  return { contour: next, moved: distanceBetween(document, contour, next) };
}
