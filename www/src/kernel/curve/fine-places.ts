import { InterpolatingCurve, LocalCurve } from "expline/slim";
import { baseCount, type Contour, type ControlPoint, type CurveDocument } from "../../document/document.ts";
import { curveOf } from "./curve-cache.ts";
import { distanceBetween } from "./distance.ts";
import { written } from "./settling.ts";

/** Refined places of interpolating contours: finer control points where the user works, and none elsewhere. */

const levels = 2;

/** The same curve with finer control points around parameter `t`. */
export function refinedAround(document: CurveDocument, contour: Contour, t: number): Contour | null {
  const curve = curveOf(document, contour);
  if (!(curve instanceof InterpolatingCurve || curve instanceof LocalCurve)) return null;
  return written(contour, curve.refineAt(t, { levels, reach: 1 }));
}

/** Without the places that hold any of these points; the finer detail there goes. */
export function withoutPlaces(document: CurveDocument, contour: Contour, indices: readonly number[]): { contour: Contour; moved: number } {
  let from = baseCount(contour);
  const base = contour.points.slice(0, from);
  const kept: ControlPoint[] = [];
  const places = (contour.places ?? []).filter(({ count }) => {
    const start = from;
    from += count;
    const goes = indices.some((index) => index >= start && index < start + count);
    if (!goes) kept.push(...contour.points.slice(start, start + count));
    return !goes;
  });
  const { places: _places, ...rest } = contour;
  const next: Contour = places.length === 0 ? { ...rest, points: base } : { ...rest, points: [...base, ...kept], places };
  return { contour: next, moved: distanceBetween(document, contour, next) };
}
