import type { Contour, CurveDocument } from "../document/document.ts";
import { curveOf } from "./curve-cache.ts";

/** Curves as cubic Béziers and as path text, within a tolerance in document units. */

const cubics = new WeakMap<Contour, { curve: object; tolerance: number; path: Float64Array }>();

/** Eight numbers per cubic; an empty array while the contour has fewer than two points. Kept until the contour or the tolerance changes. */
export function cubicsOf(document: CurveDocument, contour: Contour, tolerance: number): Float64Array {
  const curve = curveOf(document, contour);
  if (curve === null) return new Float64Array(0);
  const known = cubics.get(contour);
  if (known !== undefined && known.curve === curve && known.tolerance === tolerance) return known.path;
  const { path } = curve.toCubics(tolerance);
  cubics.set(contour, { curve, tolerance, path });
  return path;
}

export interface PathOptions {
  readonly tolerance?: number;
  readonly decimals?: number;
  readonly arcs?: boolean;
}

/** One contour's path text and the measured deviation from the curve. */
export function contourPathD(document: CurveDocument, contour: Contour, options: PathOptions): { d: string; deviation: number } {
  const curve = curveOf(document, contour);
  if (curve === null) return { d: "", deviation: 0 };
  const { d, maxError } = curve.toPathD(options);
  return { d, deviation: maxError };
}

/** The whole drawing's path text and its largest deviation. */
export function documentPathD(document: CurveDocument, options: PathOptions): { d: string; deviation: number } {
  const parts = document.contours.map((contour) => contourPathD(document, contour, options));
  return { d: parts.map((part) => part.d).join(""), deviation: Math.max(0, ...parts.map((part) => part.deviation)) };
}
