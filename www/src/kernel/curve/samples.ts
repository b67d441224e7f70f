import { BSplineCurve, HermiteCurve, InterpolatingCurve, type Curve } from "expline/slim";
import { translationOf } from "../../document/curve/contours.ts";
import { partAt, partsOf } from "../../document/curve/parts.ts";
import { domainLength, lengthOf, segmentCount, type Contour, type CurveDocument } from "../../document/document.ts";
import { curveOf } from "./curve-cache.ts";

/** Points of curves, for drawing, hit-testing and for testers. */

const nothing = new Float64Array(0);

/** `count` points at uniform parameter: closed i/count of the way round, open i/(count − 1). */
export function samplePoints(document: CurveDocument, contour: Contour, count: number): Float64Array {
  return curveOf(document, contour)?.sample(count) ?? nothing;
}

/** The polygon after so many subdivision steps. */
export function subdivided(document: CurveDocument, contour: Contour, steps: number): Float64Array {
  const curve = curveOf(document, contour);
  if (curve === null) return nothing;
  if (steps === 0) return curve.points;
  if (curve instanceof HermiteCurve) return curve.subdivide(steps);
  if (curve instanceof InterpolatingCurve) return curve.refine(steps).points;
  // Refined places have no one grid: what subdivision would come to is the curve itself.
  return curve instanceof BSplineCurve ? curve.refine(2 ** steps).points : curve.sample(segmentCount(contour) * 2 ** steps);
}

/** Parameters as far as an open curve has them: of a file its grid may end early, and the sum of lengths is rounded. */
export function within({ closed, domain: [start, end] }: Curve, t: Float64Array): Float64Array {
  return closed ? t : t.map((each) => Math.min(end, Math.max(start, each)));
}

/** One segment as a polygon of `count` sides; with the curve's own points at its ends. */
export function segmentPolygon(document: CurveDocument, contour: Contour, segment: number, count: number): Float64Array {
  const own = partAt(document, contour, segment);
  const curve = curveOf(document, own.part);
  if (curve === null) return nothing;
  let start = 0;
  for (let before = 0; before < own.segment; before += 1) start += lengthOf(own.part, before);
  const length = lengthOf(contour, segment);
  return curve.evaluate(within(curve, Float64Array.from({ length: count + 1 }, (_, i) => start + (length * i) / count)));
}

export interface Nearest {
  readonly t: number;
  readonly x: number;
  readonly y: number;
  readonly distance: number;
}

/** The nearest point of the contour, or null when there is no curve within `reach`. */
export function nearestOn(document: CurveDocument, contour: Contour, x: number, y: number, reach: number): Nearest | null {
  const parts = partsOf(document, contour);
  let best: Nearest | null = null;
  let [least, start] = [reach, 0];
  for (const part of parts) {
    const found = nearestWithin(document, part, x, y, least);
    // Of several as near, the one that the curve reaches first.
    if (found !== null && (best === null || found.distance < least)) [best, least] = [{ ...found, t: start + found.t }, found.distance];
    if (parts.length > 1) start += domainLength(part);
  }
  return best;
}

function nearestWithin(document: CurveDocument, part: Contour, x: number, y: number, reach: number): Nearest | null {
  const box = boundsOf(document, part);
  const found = box === null || isOutside(box, x, y, reach) ? undefined : curveOf(document, part)?.nearest(x, y);
  return found === undefined || found.distance > reach ? null : found;
}

function isOutside({ minX, minY, maxX, maxY }: Bounds, x: number, y: number, reach: number): boolean {
  return x < minX - reach || x > maxX + reach || y < minY - reach || y > maxY + reach;
}

export interface Bounds {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

const boxes = new WeakMap<object, Bounds>();

export function boundsOf(document: CurveDocument, contour: Contour): Bounds | null {
  const parts = partsOf(document, contour);
  return parts.length > 1 ? parts.reduce((box: Bounds | null, part) => union(box, boundsOf(document, part)), null) : ownBounds(document, contour);
}

function ownBounds(document: CurveDocument, contour: Contour): Bounds | null {
  const moved = translationOf(contour);
  if (moved !== undefined) return shifted(ownBounds(document, moved.from), moved);
  const curve = curveOf(document, contour);
  if (curve === null) return null;
  const known = boxes.get(curve);
  if (known !== undefined) return known;
  const fresh = curve.bounds();
  boxes.set(curve, fresh);
  return fresh;
}

function shifted(box: Bounds | null, { dx, dy }: { readonly dx: number; readonly dy: number }): Bounds | null {
  return box && { minX: box.minX + dx, minY: box.minY + dy, maxX: box.maxX + dx, maxY: box.maxY + dy };
}

function union(a: Bounds | null, b: Bounds | null): Bounds | null {
  if (a === null || b === null) return a ?? b;
  return { minX: Math.min(a.minX, b.minX), minY: Math.min(a.minY, b.minY), maxX: Math.max(a.maxX, b.maxX), maxY: Math.max(a.maxY, b.maxY) };
}

/** The box around all of them; null where there is none. */
export function around(boxes: readonly (Bounds | null)[]): Bounds | null {
  return boxes.reduce(union, null);
}

/** The box around every curve and lone point of the drawing; null when there is nothing. */
export function documentBounds(document: CurveDocument): Bounds | null {
  let box: Bounds | null = null;
  for (const contour of document.contours) {
    const point = contour.points[0];
    const own = boundsOf(document, contour) ?? (point === undefined ? null : { minX: point.x, minY: point.y, maxX: point.x, maxY: point.y });
    box = union(box, own);
  }
  return box;
}

/**
 * Points at uniform parameters, from 0 on where the curve is closed: the grid of a refined one may begin before or
 * after that.
 */
function fromZero(document: CurveDocument, contour: Contour, count: number): Float64Array {
  const curve = curveOf(document, contour);
  if (curve === null) return nothing;
  const [start, end] = curve.domain;
  return curve.closed && start !== 0 ? curve.evaluate(Float64Array.from({ length: count }, (_, i) => (i * (end - start)) / count)) : curve.sample(count);
}

/** The largest distance between two contours at `count` uniform parameters, each on its own scale. */
export function largestMove(document: CurveDocument, before: Contour, after: Contour, count = 512): number {
  const a = fromZero(document, before, count);
  const b = fromZero(document, after, count);
  let worst = 0;
  for (let i = 0; i + 1 < Math.min(a.length, b.length); i += 2) {
    worst = Math.max(worst, Math.hypot((a[i] ?? 0) - (b[i] ?? 0), (a[i + 1] ?? 0) - (b[i + 1] ?? 0)));
  }
  return worst;
}
