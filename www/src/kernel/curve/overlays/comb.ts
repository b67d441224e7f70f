import { ExplineError, HermiteCurve, type Curve } from "expline/slim";
import { partsOf } from "../../../document/curve/parts.ts";
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

/** What a comb is drawn from, `perSegment` teeth for every segment. */
export interface Teeth {
  readonly perSegment: number;
  /** Points of the curve, x and y in turn. */
  readonly feet: Float64Array;
  /** Unit vectors at right angles to it, towards a positive curvature's teeth; NaN where the curve has no direction. */
  readonly across: Float64Array;
  readonly curvature: Float64Array;
}

/** Just inside the ends of a segment: on a point two curvatures may meet. */
const inset = 1e-6;

/** Places in every `every`th segment. */
function placesIn(curve: Curve, contour: Contour, perSegment: number, every = 1): Float64Array {
  const segments = segmentCount(contour);
  const places = new Float64Array(Math.ceil(segments / every) * perSegment);
  let [start, filled] = [0, 0];
  for (let segment = 0; segment < segments; segment += 1) {
    const length = lengthOf(contour, segment);
    for (let i = 0; segment % every === 0 && i < perSegment; i += 1) {
      places[filled++] = start + length * (inset + (1 - 2 * inset) * (i / (perSegment - 1)));
    }
    start += length;
  }
  return within(curve, places);
}

/** NaN where there is none, as in a segment without extent: the others keep theirs. */
function curvatureOf(curve: Curve, places: Float64Array): Float64Array {
  try {
    return curve.curvature(places);
  } catch (error) {
    if (!(error instanceof ExplineError) || error.code !== "E_DEGENERATE") throw error;
    if (places.length <= 1) return places.map(() => NaN);
    const half = places.length >> 1;
    const all = new Float64Array(places.length);
    all.set(curvatureOf(curve, places.subarray(0, half)));
    all.set(curvatureOf(curve, places.subarray(half)), half);
    return all;
  }
}

const known = new WeakMap<Curve, Teeth>();

/** Of a contour or a part of one; kept with its curve. */
export function teethOf(document: CurveDocument, contour: Contour, perSegment: number): Teeth | null {
  const curve = curveOf(document, contour);
  if (curve === null) return null;
  const last = known.get(curve);
  if (last?.perSegment === perSegment) return last;
  const places = placesIn(curve, contour, perSegment);
  const tangents = curve.evaluate(places, 1);
  const across = new Float64Array(tangents.length);
  for (let i = 0; i < tangents.length; i += 2) {
    const [dx = 0, dy = 0] = [tangents[i], tangents[i + 1]];
    const speed = Math.hypot(dx, dy);
    [across[i], across[i + 1]] = [dy / speed, -dx / speed];
  }
  const fresh = { perSegment, feet: curve.evaluate(places), across, curvature: curvatureOf(curve, places) };
  known.set(curve, fresh);
  return fresh;
}

/** Places that tell how curved a segment is, and segments that tell it of a contour. */
const [looksPerSegment, mostLookedAt] = [8, 1024];
const looks = new WeakMap<Curve, { readonly every: number; readonly bends: Float64Array }>();

/**
 * How curved a contour is, at many places of many of its segments; of one point more or less a long contour looks at
 * that part again.
 */
export function bendsOf(document: CurveDocument, contour: Contour): Float64Array[] {
  const every = 2 ** Math.max(0, Math.ceil(Math.log2(segmentCount(contour) / mostLookedAt)));
  return partsOf(document, contour).flatMap((part) => {
    const curve = curveOf(document, part);
    if (curve === null) return [];
    const last = looks.get(curve);
    if (last?.every === every) return [last.bends];
    const bends = curvatureOf(curve, placesIn(curve, part, looksPerSegment, every)).map(Math.abs);
    looks.set(curve, { every, bends });
    return [bends];
  });
}
