// Points at equal distances along a curve.

import assert from "node:assert/strict";
import { test } from "node:test";

import { HermiteCurve } from "expline";

/** The default tolerance is 1e-9 of the curve's size; positions on the curve are twice as uncertain at the most. */
const RELATIVE = 2e-9;

test("points evenly spread over a circle lie at equal angles, whatever its control points are", () => {
  const [radius, count] = [5, 8];
  const circle = HermiteCurve.ellipse({ center: [1, 2], radii: [radius, radius], count: 3 });
  const points = circle.sampleByLength(count);
  assert.equal(points.length, 2 * count);
  const chord = 2 * radius * Math.sin(Math.PI / count);
  for (let i = 0; i < count; i++) {
    const j = (i + 1) % count;
    const [x = 0, y = 0, u = 0, v = 0] = [points[2 * i], points[2 * i + 1], points[2 * j], points[2 * j + 1]];
    assert.ok(Math.abs(Math.hypot(x - 1, y - 2) - radius) <= RELATIVE * radius, `point ${i} is off the circle`);
    assert.ok(Math.abs(Math.hypot(u - x, v - y) - chord) <= RELATIVE * 2 * radius, `step ${i} is not the others'`);
  }
});

test("an open line with a speed that varies is cut into equal parts, ends included", () => {
  // The speed is 20 at the ends and 5 in the middle.
  const line = new HermiteCurve({ points: [0, 0, 10, 0], tangents: [20, 0, 20, 0], closed: false });
  const points = line.sampleByLength(5);
  for (const [i, expected] of [0, 2.5, 5, 7.5, 10].entries()) {
    assert.ok(Math.abs((points[2 * i] ?? Number.NaN) - expected) <= RELATIVE * 10, `point ${i} is at ${points[2 * i]}`);
  }
});

test("what was prepared for one sampling serves the next, and is forgotten with the curve it was made for", () => {
  const make = (): HermiteCurve => HermiteCurve.ellipse({ center: [1, 2], radii: [5, 3], count: 3 });
  const curve = make();
  const first = curve.sampleByLength(50);
  assert.deepEqual(curve.sampleByLength(50), first);
  const rough = curve.sampleByLength(50, { tolerance: 0.1 });
  assert.deepEqual(make().sampleByLength(50, { tolerance: 0.1 }), rough);
  assert.deepEqual(curve.sampleByLength(50), first);
  curve.setPoint(1, 7, 7);
  const edited = make();
  edited.setPoint(1, 7, 7);
  assert.deepEqual(curve.sampleByLength(50), edited.sampleByLength(50));
});
