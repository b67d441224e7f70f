import { stretchAround } from "../../document/curve/stretch.ts";
import { pointAt, segmentCount, type Contour, type ControlPoint, type CurveDocument, type PointRef } from "../../document/document.ts";
import { samplePoints } from "./samples.ts";

/** How strongly one control point acts along its curve: the generators, where they work. */
export interface Weights {
  /** Places on the curve at uniform parameter, x and y in turn. */
  readonly places: Float64Array;
  /** φ, or φ₁: how far those places go when the point moves by one. */
  readonly point: Float64Array;
  /** φ₂, of its tangent; null where points have none. */
  readonly tangent: Float64Array | null;
  /** Whether the places go round the curve; of a long contour they are those near the point. */
  readonly closed: boolean;
}

/** Curves are linear in their points, so that a step of any size tells the weight; a large one loses no digits. */
const step = 256;

const known = new WeakMap<Contour, { readonly key: string; readonly weights: Weights }>();

export function weightsOf(document: CurveDocument, ref: PointRef): Weights | null {
  const contour = document.contours[ref.contour];
  const point = pointAt(document, ref);
  if (contour === undefined || point === undefined || contour.points.length < 2) return null;
  const key = `${ref.index} ${document.space} ${document.omega}`;
  const last = known.get(contour);
  if (last?.key === key) return last.weights;
  const near = segmentCount(contour) > longest && contour.family === "hermite" ? stretchAround(document, contour, ref.index) : { contour, index: ref.index };
  const weights = measured(document, near.contour, near.index, point);
  known.set(contour, { key, weights });
  return weights;
}

/** Segments up to which the weights are looked for along all of a contour. */
const longest = 1024;

function measured(document: CurveDocument, contour: Contour, index: number, point: ControlPoint): Weights {
  const count = contour.points.length * Math.max(4, Math.min(48, Math.floor(2048 / contour.points.length)));
  const places = samplePoints(document, contour, count);
  const withPoint = (change: Partial<ControlPoint>): Float64Array => {
    const points = contour.points.map((each, i) => (i === index ? { ...each, ...change } : each));
    const moved = samplePoints(document, { ...contour, points }, count);
    return Float64Array.from({ length: count }, (_, i) => ((moved[2 * i] ?? 0) - (places[2 * i] ?? 0)) / step);
  };
  const { in: before, out: after, moved } = point;
  // A handle is drawn at a third of its tangent.
  const tangent = contour.family === "hermite" ? withPoint({ in: { ...before, dx: before.dx - step / 3 }, out: { ...after, dx: after.dx + step / 3 } }) : null;
  return { closed: contour.closed, places, point: withPoint(moved === undefined ? { x: point.x + step } : { moved: { ...moved, dx: moved.dx + step } }), tangent };
}
