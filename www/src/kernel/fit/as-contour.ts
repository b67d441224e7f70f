import { fromJSON, HermiteCurve, type Curve } from "expline/slim";
import type { Contour } from "../../document/document.ts";
import { contourFrom } from "../curve/points/contours.ts";

/**
 * A fitted curve as a contour of the document: the same curve, each polynomial piece one segment. In drawings y points
 * down: where it points up, the curve is turned over.
 */
export function contourFromFit(curve: Curve, up = false): Contour {
  if (!(curve instanceof HermiteCurve)) throw new TypeError("a fit of degree 3 is a Hermite curve");
  return contourFrom(up ? curve.transform([1, 0, 0, -1, 0, 0]) : curve, "trigonometric");
}

/** The same of a fit as it comes from the worker. */
export function contourOfFit(plain: object): Contour {
  const curve = fromJSON(plain);
  if (!(curve instanceof HermiteCurve)) throw new TypeError("a fit of degree 3 is a Hermite curve");
  return contourFromFit(curve);
}
