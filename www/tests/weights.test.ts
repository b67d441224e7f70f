import assert from "node:assert/strict";
import { test } from "node:test";
import { weightsOf } from "../src/kernel/curve/weights.ts";
import { Hand } from "./harness.ts";

test("the weights of all points together are 1 everywhere, and each is 1 at its own place if the curve goes through it", () => {
  for (const sample of ["circle-8", "blob-16"]) {
    const { curve } = new Hand(sample);
    const points = curve.contours[0]?.points ?? [];
    const all = points.map((_, index) => weightsOf(curve, { contour: 0, index })?.point ?? new Float64Array(0));
    const perPoint = (all[0]?.length ?? 0) / points.length;
    for (let i = 0; i < perPoint * points.length; i += 1) {
      const sum = all.reduce((total, weights) => total + (weights[i] ?? 0), 0);
      assert.ok(Math.abs(sum - 1) < 1e-9, `${sample} at ${i}: ${sum}`);
    }
    all.forEach((weights, k) => all.forEach((_, other) => {
      const own = weights[other * perPoint] ?? NaN;
      assert.ok(Math.abs(own - (k === other ? 1 : 0)) < 1e-9, `${sample}: point ${k} at ${other}: ${own}`);
    }));
  }
});

test("a tangent weighs nothing at any point, and moves places where its point's weight is neither 0 nor 1", () => {
  const { curve } = new Hand("circle-8");
  const { tangent, point } = weightsOf(curve, { contour: 0, index: 3 }) ?? {};
  assert.ok(tangent != null && point !== undefined);
  const perPoint = point.length / 8;
  for (let k = 0; k < 8; k += 1) assert.ok(Math.abs(tangent[k * perPoint] ?? NaN) < 1e-9);
  tangent.forEach((weight, i) => assert.equal(Math.abs(weight) > 1e-9, Math.abs(point[i] ?? 0) > 1e-9 && Math.abs((point[i] ?? 0) - 1) > 1e-9, `at ${i}`));
});
