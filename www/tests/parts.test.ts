import assert from "node:assert/strict";
import { test } from "node:test";
import { InterpolatingCurve } from "expline/slim";
import { movePoints } from "../src/document/curve/commands.ts";
import { plainPoint } from "../src/document/curve/contours.ts";
import { partsOf } from "../src/document/curve/parts.ts";
import { segmentCount, type Contour, type CurveDocument } from "../src/document/document.ts";
import { measureCurve, measureUntil } from "../src/kernel/curve/measuring/measure.ts";
import { healed } from "../src/kernel/curve/points/contours.ts";
import { boundsOf, nearestOn } from "../src/kernel/curve/samples.ts";
import { curveOf } from "../src/kernel/curve/curve-cache.ts";
import { splineOf, splineShape } from "../src/kernel/curve/spline-shape.ts";
import { cubicsOf } from "../src/kernel/paths/paths.ts";
import { polylineOf, thinned } from "../src/kernel/paths/polylines.ts";
import { createSmallPoints } from "../src/render/small-points.ts";
import { longContour } from "./harness.ts";

/** Long contours are looked at part by part. What comes of it is compared with the whole curve. */

function drawingOf(contour: Contour): CurveDocument {
  return { space: "trigonometric", omega: "auto", level: 0, contours: [contour] };
}

const contour = longContour(5000);
const curve = drawingOf(contour);
const whole = () => {
  const found = curveOf(curve, contour);
  assert.ok(found);
  return found;
};

function changedParts(before: readonly Contour[], after: readonly Contour[]): number {
  const known = new Set(before);
  return after.filter((part) => !known.has(part)).length;
}

test("the cubics of a contour's parts, one behind the other, are those of the whole to the last bit", () => {
  const joined = partsOf(curve, contour).flatMap((part) => Array.from(cubicsOf(curve, part, 0.05)));
  assert.deepEqual(joined, Array.from(cubicsOf(curve, contour, 0.05)));
});

test("moving a point renews its part alone, a point less one or two, and undoing either none", () => {
  const parts = partsOf(curve, contour);
  assert.equal(parts.reduce((sum, part) => sum + segmentCount(part), 0), 5000);
  const [moved] = movePoints({ points: [{ contour: 0, index: 2222 }], handle: null }, 3, 4).apply(curve).contours;
  assert.ok(moved);
  assert.equal(changedParts(parts, partsOf(drawingOf(moved), moved)), 1);
  const less = healed(curve, contour, 2222)?.contour;
  assert.ok(less);
  assert.ok(changedParts(parts, partsOf(drawingOf(less), less)) <= 2);
  assert.equal(changedParts(parts, partsOf(curve, contour)), 0);
});

test("a document of another frequency or space has other parts", () => {
  const parts = partsOf(curve, contour);
  for (const other of [{ ...curve, omega: 0.3 }, { ...curve, space: "hyperbolic" as const, omega: 0.3 }]) {
    assert.equal(changedParts(parts, partsOf(other, contour)), partsOf(other, contour).length);
  }
});

test("length, area, box and nearest place of a long contour are the whole curve's", () => {
  const { length, area } = measureCurve(curve);
  assert.ok(Math.abs(length - whole().length()) <= 1e-9 * length);
  assert.ok(Math.abs(area - whole().area()) <= 1e-12 * 500 ** 2 * partsOf(curve, contour).length);
  const box = boundsOf(curve, contour);
  const exact = whole().bounds();
  for (const side of ["minX", "minY", "maxX", "maxY"] as const) assert.ok(Math.abs((box?.[side] ?? NaN) - exact[side]) <= 1e-12 * 650, side);
  for (let i = 0; i < 40; i += 1) {
    const [x, y] = [140 + ((i * 97) % 521), 40 + ((i * 61) % 519)];
    const [found, nearest] = [nearestOn(curve, contour, x, y, 1e6), whole().nearest(x, y)];
    assert.ok(found && Math.abs(found.distance - nearest.distance) <= 1e-9);
    const [px = NaN, py = NaN] = whole().evaluate(found.t);
    assert.ok(Math.hypot(px - found.x, py - found.y) <= 1e-9);
  }
});

test("a drawing is measured a part at a time, and after an edit the changed part only", () => {
  const fresh = longContour(5000);
  const document = drawingOf({ ...fresh, points: fresh.points.map((point) => ({ ...point, y: point.y + 1 })) });
  const rounds = (drawing: CurveDocument): number => {
    for (let count = 1; ; count += 1) {
      let looks = 0;
      if (measureUntil(drawing, () => (looks += 1) > 1)) return count;
    }
  };
  assert.equal(rounds(document), partsOf(document, document.contours[0] as Contour).length);
  const edited = movePoints({ points: [{ contour: 0, index: 77 }], handle: null }, 1, 0).apply(document);
  assert.equal(rounds(edited), 1);
});

test("a long interpolating contour is not measured while anybody waits; its numbers are there later, a worker or none", async () => {
  const points = longContour(4001).points.map(({ x, y }) => plainPoint(x, y));
  const document = drawingOf({ family: "interpolating", closed: true, points, support: 2 });
  let looks = 0;
  const spent = (): boolean => (looks += 1) > 1000;
  assert.equal(measureUntil(document, spent), false);
  assert.equal(looks, 0);
  // There are no workers in Node.
  while (!measureUntil(document, spent)) await new Promise((resolve) => setTimeout(resolve));
  const flat = Float64Array.from(points.flatMap(({ x, y }) => [x, y]));
  const [curve, shape] = [new InterpolatingCurve({ points: flat, closed: true }), splineOf(structuredClone(splineShape(document, document.contours[0] as Contour)))];
  const { length, area, bytes } = measureCurve(document);
  for (const each of [curve, shape]) {
    assert.deepEqual([length, area], [each.length(), each.area()]);
    assert.equal(bytes, each.toPathD({ tolerance: 0.02, decimals: 3 }).d.length);
  }
});

function distanceTo(polyline: Float64Array, x: number, y: number): number {
  let least = Infinity;
  for (let i = 0; i + 3 < polyline.length; i += 2) {
    const [ax = 0, ay = 0, bx = 0, by = 0] = polyline.subarray(i, i + 4);
    const size = (bx - ax) ** 2 + (by - ay) ** 2;
    const t = size === 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / size));
    least = Math.min(least, Math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay)));
  }
  return least;
}

test("a thinned polyline keeps its ends and passes every vertex within the tolerance, also where it turns back", () => {
  const turning = Float64Array.from({ length: 2000 }, (_, i) => (i % 2 === 0 ? 40 * Math.sin(i / 90) : 25 * Math.sin(i / 37)));
  const back = Float64Array.from([0, 0, 10, 0, 3, 0, 12, 0.01, 12, 0.02, -4, 0, 0, 0, 0, 0, 5, 5]);
  for (const points of [turning, back]) {
    for (const tolerance of [0, 0.01, 0.3]) {
      const few = thinned(points, tolerance);
      assert.deepEqual([few.slice(0, 2), few.slice(-2)], [points.slice(0, 2), points.slice(-2)]);
      for (let i = 0; i < points.length; i += 2) assert.ok(distanceTo(few, points[i] ?? NaN, points[i + 1] ?? NaN) <= tolerance + 1e-12);
    }
  }
  assert.ok(thinned(turning, 0.3).length < turning.length / 4);
});

test("a part as a polyline is within the tolerance of the curve, at another zoom as well, and moves with it", () => {
  const [part] = partsOf(curve, contour);
  assert.ok(part);
  const dense = curveOf(curve, part)?.sample(20_000) ?? new Float64Array(0);
  for (const tolerance of [0.02, 0.2, 0.05]) {
    const line = polylineOf(curve, part, tolerance);
    for (let i = 0; i < dense.length; i += 14) assert.ok(distanceTo(line, dense[i] ?? NaN, dense[i + 1] ?? NaN) <= tolerance);
  }
  const all = { points: contour.points.map((_, index) => ({ contour: 0, index })), handle: null };
  const moved = movePoints(all, 10, -20).apply(curve);
  const [other] = partsOf(moved, moved.contours[0] as Contour);
  assert.ok(other);
  assert.deepEqual(polylineOf(moved, other, 0.05), polylineOf(curve, part, 0.05).map((value, i) => value + (i % 2 === 0 ? 10 : -20)));
});

test("of points that run into one another few places are drawn, of points that stand apart every one", () => {
  const path = (): Path2D => ({ moveTo() {}, lineTo() {}, arc() {} }) as unknown as Path2D;
  const [crowded, apart] = [createSmallPoints(path), createSmallPoints(path)];
  for (let i = 0; i < 10_000; i += 1) crowded.add({ x: 300 + 200 * Math.cos(i / 1591.5), y: 300 + 200 * Math.sin(i / 1591.5) }, i % 10 === 0 ? "cusp" : "smooth", false);
  for (let i = 0; i < 100; i += 1) apart.add({ x: 7 * i, y: 0 }, i % 10 === 0 ? "cusp" : "smooth", i % 7 === 0);
  // A line that misses no place of a circle by more than 0.1 has a vertex every 12 units; of the cusps one to a pixel
  // may stay.
  assert.ok(crowded.drawn < 1000 + 4 * Math.PI * 200 / 12, `${crowded.drawn}`);
  assert.equal(apart.drawn, 100);
});
