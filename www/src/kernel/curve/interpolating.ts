import { BSplineCurve, InterpolatingCurve } from "expline/slim";
import { baseCount, type Contour, type ControlPoint, type CurveDocument } from "../../document/document.ts";
import { rootsOf, supportOf } from "../../document/curve/roots.ts";
import type { Root } from "../../document/surface/surface.ts";
import { plainPoint } from "../../document/curve/contours.ts";
import { withClosed } from "../../document/curve/whole/rearranging.ts";
import { curveOf } from "./curve-cache.ts";
import { largestMove, within } from "./samples.ts";

/** Interpolating contours: their levels, and the way to and from tangents. */

export function pointsOf(flat: Float64Array): ControlPoint[] {
  return Array.from({ length: flat.length / 2 }, (_, i) => plainPoint(flat[2 * i] ?? 0, flat[2 * i + 1] ?? 0));
}

/** With the number of segments that each point changes, as it stands in the file. */
export function supported(document: CurveDocument, contour: Contour): Contour {
  return { ...contour, support: supportOf(document, contour) };
}

/** The parameters of level 0's points. */
export function placesOf(contour: Contour): { count: number; t: Float64Array } {
  const count = contour.grid?.count ?? baseCount(contour);
  return { count, t: Float64Array.from({ length: count }, (_, i) => i) };
}

/** At level 0. */
export function withoutGrid({ grid: _grid, roots: _roots, ...contour }: Contour): Contour {
  return contour;
}

/** The same curve on a grid that is finer by so many doublings. */
export function finerInterpolating(document: CurveDocument, contour: Contour, doublings: number): Contour {
  const curve = curveOf(document, contour);
  if (doublings <= 0 || !(curve instanceof InterpolatingCurve || curve instanceof BSplineCurve)) return contour;
  const finer = curve instanceof InterpolatingCurve ? curve.refine(doublings) : curve.refine(2 ** doublings);
  const roots: readonly Root[] = rootsOf(document, contour);
  const next: Contour = {
    ...contour, roots,
    points: pointsOf(finer.points),
    grid: { step: finer.step, offset: finer.offset + 0, count: contour.grid?.count ?? contour.points.length },
  };
  const result = supported(document, next);
  grownFrom.set(result, contour);
  return result;
}

/** What a contour was refined from: without an edit since, the way back is exact. */
const grownFrom = new WeakMap<Contour, Contour>();

/**
 * The contour at a coarser level: as it was, or (edited since) the curve of that level that is nearest to it; at level
 * 0 the one through the same places.
 */
export function coarserInterpolating(document: CurveDocument, contour: Contour, level: number): Contour {
  const step = level === 0 ? undefined : 0.5 ** level;
  for (let known = grownFrom.get(contour); known !== undefined; known = grownFrom.get(known)) if (known.grid?.step === step) return known;
  const curve = curveOf(document, contour);
  if (curve === null) return contour;
  if (level > 0 && curve instanceof BSplineCurve && contour.grid !== undefined) {
    const { curve: coarse } = curve.reduce(Math.round(0.5 ** level / contour.grid.step));
    return supported(document, { ...contour, points: pointsOf(coarse.points), grid: { ...contour.grid, step: coarse.step, offset: coarse.offset + 0 } });
  }
  const base = withoutGrid({ ...contour, points: pointsOf(curve.evaluate(within(curve, placesOf(contour).t))) });
  // The roots that were written down for the grid go, if they are what the base would have by itself.
  const own = rootsOf(document, base);
  const same = contour.roots === undefined || contour.roots.every((root, i) => Math.hypot(root.re - (own[i]?.re ?? NaN), root.im - (own[i]?.im ?? NaN)) <= 1e-12);
  const next = supported(document, same || contour.roots === undefined ? base : { ...base, roots: contour.roots });
  return next;
}

/**
 * A refined contour opened or closed: the grid of an open one ends elsewhere, so it is refined again. And how far the
 * curve is without what was finer.
 */
export function closedRefined(document: CurveDocument, contour: Contour, closed: boolean): { contour: Contour; moved: number } {
  const base = coarserInterpolating(document, contour, 0);
  const doublings = Math.round(-Math.log2(contour.grid?.step ?? 1));
  return { contour: finerInterpolating(document, withClosed(document, base, closed), doublings), moved: largestMove(document, contour, base) };
}
