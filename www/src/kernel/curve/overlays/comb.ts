import { HermiteCurve, type Curve } from "expline/slim";
import { lengthOf, segmentCount, type Contour, type CurveDocument } from "../../../document/document.ts";
import { curveOf } from "../curve-cache.ts";
import { within } from "../samples.ts";

/** What explains a curve: its control polygon and its comb. */

const nothing = new Float64Array(0);

/** The generalised Bézier points, four per segment; the control points of a curve that has no others. */
export function bezierPolygon(document: CurveDocument, contour: Contour): Float64Array {
  const curve = curveOf(document, contour);
  if (curve === null) return nothing;
  const points = polygons.get(curve) ?? (curve instanceof HermiteCurve ? curve.bezierPoints() : curve.points);
  polygons.set(curve, points);
  return points;
}

const polygons = new WeakMap<Curve, Float64Array>();

/** Curve points, tangents and curvature, `perSegment` of each for every segment: what a comb is drawn from. */
export interface Comb {
  readonly points: Float64Array;
  readonly tangents: Float64Array;
  readonly curvature: Float64Array;
}

/** Just inside the ends of a segment: on a point two curvatures may meet. */
const inset = 1e-6;

export function combOf(document: CurveDocument, contour: Contour, perSegment: number): Comb | null {
  const curve = curveOf(document, contour);
  if (curve === null) return null;
  const segments = segmentCount(contour);
  const places = new Float64Array(segments * perSegment);
  let start = 0;
  for (let segment = 0; segment < segments; segment += 1) {
    const length = lengthOf(contour, segment);
    for (let i = 0; i < perSegment; i += 1) {
      places[segment * perSegment + i] = start + length * (inset + (1 - 2 * inset) * (i / (perSegment - 1)));
    }
    start += length;
  }
  const t = within(curve, places);
  return { points: curve.evaluate(t), tangents: curve.evaluate(t, 1), curvature: curve.curvature(t) };
}
