import type { Contour, CurveDocument } from "../../document/document.ts";
import { curveOf } from "./curve-cache.ts";

const compared = 600;

/** The largest distance between two contours, at dense samples of both. */
export function distanceBetween(document: CurveDocument, a: Contour, b: Contour): number {
  return Math.max(farthest(document, a, b), farthest(document, b, a));
}

function farthest(document: CurveDocument, from: Contour, to: Contour): number {
  const [curve, other] = [curveOf(document, from), curveOf(document, to)];
  if (curve === null || other === null) return 0;
  const nearest = other.nearestAll(curve.sample(compared));
  let worst = 0;
  for (let i = 3; i < nearest.length; i += 4) worst = Math.max(worst, nearest[i] ?? 0);
  return worst;
}
