import { baseCount, omegaOf, segmentCount, type Contour, type CurveDocument } from "../document.ts";
import type { Root } from "../surface/surface.ts";

/** The roots of an interpolating contour's generator: what it keeps exact, and how smooth it is. */

const zero: Root = { re: 0, im: 0 };

/**
 * Written down, or from space, frequency and order: one 0, or two where the order is even, and pairs of multiples of
 * the frequency.
 */
export function rootsOf(curve: CurveDocument, contour: Contour): readonly Root[] {
  if (contour.roots !== undefined) return contour.roots;
  const order = contour.order ?? 3;
  const omega = (contour.space ?? curve.space) === "polynomial" ? 0 : omegaOf(curve, contour, 0);
  const hyperbolic = (contour.space ?? curve.space) === "hyperbolic";
  const roots: Root[] = order % 2 === 0 ? [zero, zero] : [zero];
  for (let k = 1; roots.length < order; k += 1) {
    const size = k * omega;
    if (hyperbolic || size === 0) roots.push({ re: size, im: 0 }, { re: 0 - size, im: 0 });
    else roots.push({ re: 0, im: size }, { re: 0, im: 0 - size });
  }
  return roots;
}

/** Segments on each side that moving one point of the contour may change. */
export function supportOf(curve: CurveDocument, contour: Contour): number {
  if (contour.family === "hermite") return 1;
  const order = rootsOf(curve, contour).length;
  return contour.grid === undefined ? order - 1 : Math.ceil(order / 2);
}

/** The segments that moving a point changes, in the order of the contour; none twice. */
export function affectedSegments(curve: CurveDocument, contour: Contour, index: number): number[] {
  const { grid } = contour;
  const segments = segmentCount(contour);
  // A refined point stands at a place of the grid that need not be a knot.
  const order = contour.family === "hermite" ? 2 : rootsOf(curve, contour).length;
  const fine = finePlaceOf(contour, index, order);
  const at = fine !== null ? fine.parameter : grid === undefined ? index : (grid.offset + index * grid.step) / grid.step;
  const reach = fine !== null ? (order / 2) * fine.step : grid === undefined ? order - 1 : order / 2;
  const list: number[] = [];
  for (let segment = Math.floor(at - reach + 1e-9); segment < at + reach - 1e-9; segment += 1) {
    const within = contour.closed ? ((segment % segments) + segments) % segments : segment;
    if (within >= 0 && within < segments && !list.includes(within)) list.push(within);
  }
  return list;
}

/** Where a finer control point of a refined place stands; null for any other point. */
export function finePlaceOf(
  contour: Contour,
  index: number,
  order: number,
): { readonly place: number; readonly within: number; readonly parameter: number; readonly step: number } | null {
  let within = index - baseCount(contour);
  if (within < 0) return null;
  for (const [place, { level, first, count }] of (contour.places ?? []).entries()) {
    if (within < count) {
      const step = 0.5 ** level;
      const offset = contour.closed ? (order % 2 === 1 ? 0.5 : 0) : 1 - order / 2;
      return { place, within, step, parameter: (first + within + offset) * step };
    }
    within -= count;
  }
  return null;
}
