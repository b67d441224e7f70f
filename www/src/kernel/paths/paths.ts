import { translationOf } from "../../document/curve/contours.ts";
import type { Contour, CurveDocument, Space } from "../../document/document.ts";
import { curveOf } from "../curve/curve-cache.ts";
import { shifted } from "./polylines.ts";

/** Curves as cubic Béziers and as path text, within a tolerance in document units. */

const cubics = new WeakMap<Contour, { space: Space; omega: number | "auto"; tolerance: number; path: Float64Array }>();

/**
 * Eight numbers per cubic; an empty array while the contour has fewer than two points. Kept until the contour or the
 * tolerance changes.
 */
export function cubicsOf(document: CurveDocument, contour: Contour, tolerance: number): Float64Array {
  const known = cubics.get(contour);
  if (known !== undefined && known.tolerance === tolerance && known.space === spaceOf(document, contour) && known.omega === document.omega) return known.path;
  const path = movedAlong(document, contour, tolerance) ?? curveOf(document, contour)?.toCubics(tolerance).path ?? new Float64Array(0);
  cubics.set(contour, { space: spaceOf(document, contour), omega: document.omega, tolerance, path });
  return path;
}

function spaceOf(document: CurveDocument, contour: Contour): Space {
  return contour.space ?? document.space;
}

/**
 * A contour that was moved as a whole has the cubics of the old one, moved along: a drawing of thousands follows the
 * pointer.
 */
function movedAlong(document: CurveDocument, contour: Contour, tolerance: number): Float64Array | null {
  const moved = translationOf(contour);
  if (moved === undefined) return null;
  const from = cubicsOf(document, moved.from, tolerance);
  return shifted(from, moved.dx, moved.dy);
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
