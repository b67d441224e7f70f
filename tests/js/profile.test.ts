// Quasi-interpolants, scores, metrics and whole profiles through the package, against the golden data.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { ExplineError, fitProfile, looScore, metrics, quasiInterpolate } from "expline";

interface Case {
  p: number;
  k: number;
  knots: number[];
  coeffs: number[];
  loo_rmse: number;
}

interface Golden {
  clouds: Record<string, { pts: [number, number][]; cases: Case[] }>;
  metrics: {
    residuals: number[];
    rmse: number;
    mae: number;
    hausdorff: { A: [number, number][]; B: [number, number][]; directed_A_to_B: number; directed_B_to_A: number };
    jaccard: { P: [number, number][]; C: [number, number][]; J_tol1: number; J_literal_dilated: number };
  };
}

const golden = JSON.parse(readFileSync("tests/golden/tracing/wqisa.json", "utf8")) as Golden;

/** Golden numbers are printed with twelve digits after the point. */
function close(got: number, wanted: number, what: string): void {
  assert.ok(Math.abs(got - wanted) <= 1e-9, `${what}: ${got} instead of ${wanted}`);
}

for (const [name, { pts, cases }] of Object.entries(golden.clouds)) {
  test(`coefficients and scores of cloud ${name} are the golden ones`, () => {
    for (const { p, k, knots, coeffs, loo_rmse } of cases) {
      const options = { degree: p, knots, neighbours: k };
      const found = quasiInterpolate(pts, options);
      assert.equal(found.length, coeffs.length);
      found.forEach((value, q) => close(value, coeffs[q] ?? NaN, `degree ${p}, ${k} neighbours, coefficient ${q}`));
      close(looScore(pts, { ...options, knots: Float64Array.from(knots) }), loo_rmse, `degree ${p}, ${k} neighbours, score`);
    }
  });
}

test("metrics are the golden ones", () => {
  const { residuals, rmse, mae, hausdorff, jaccard } = golden.metrics;
  close(metrics.rmse(residuals), rmse, "rmse");
  close(metrics.mae(Float64Array.from(residuals)), mae, "mae");
  close(metrics.directedHausdorff(hausdorff.A, hausdorff.B), hausdorff.directed_A_to_B, "there");
  close(metrics.directedHausdorff(hausdorff.B, hausdorff.A), hausdorff.directed_B_to_A, "back");
  close(metrics.jaccard(jaccard.P, jaccard.C), jaccard.J_tol1, "Jaccard");
  close(metrics.jaccard(jaccard.P, jaccard.C, { literal: true }), jaccard.J_literal_dilated, "as printed");
});

test("of nothing the metrics are 0, but nothing is near to nothing", () => {
  assert.deepEqual([metrics.rmse([]), metrics.mae([]), metrics.directedHausdorff([], [1, 2])], [0, 0, 0]);
  assert.throws(() => metrics.directedHausdorff([1, 2], []), (error) => error instanceof ExplineError && error.code === "E_TOO_FEW_POINTS" && error.arg === "to");
});

test("a profile becomes tubes that hold all of its points, and a curve near them", () => {
  const { chain, closed } = JSON.parse(readFileSync("tests/golden/tracing/pipeline.json", "utf8")) as { chain: [number, number][]; closed: boolean };
  for (const method of ["mean", "local"] as const) {
    const fit = fitProfile(chain, { closed, method });
    assert.equal(fit.curve.closed, closed);
    assert.ok(fit.tubes.length > 0 && fit.cusps.length > 0);
    const held = fit.tubes.reduce((sum, { count }) => sum + count, 0);
    assert.equal(held, chain.length + fit.tubes.length, "neighbours share a point");
    for (const [x, y] of chain) assert.ok(fit.curve.nearest(x, y).distance < 2, `${method} at (${x}, ${y})`);
    assert.ok(fit.metrics.rmse < 0.7 && fit.metrics.hausdorff < 2, JSON.stringify(fit.metrics));
  }
});

test("what makes no sense is refused", () => {
  const cloud = [[0, 0], [1, 1], [2, 0], [3, 1]] as const;
  const options = { degree: 2, knots: [0, 0, 0, 3, 3, 3], neighbours: 2 };
  for (const [change, code, arg] of [
    [{ degree: 0 }, "E_RANGE", "degree"],
    [{ knots: [0, 0, 3, 3] }, "E_LENGTH", "knots"],
    [{ knots: [0, 0, 1, 2, 3, 3] }, "E_DEGENERATE", "knots"],
    [{ knots: [0, 0, 0, 2, 1, 3, 3, 3] }, "E_DEGENERATE", "knots"],
    [{ knots: [0, 0, 0, 0, 3, 3, 3] }, "E_DEGENERATE", "knots"],
    [{ knots: [0, 0, 0, NaN, 3, 3] }, "E_NOT_FINITE", "knots"],
    [{ neighbours: 5 }, "E_RANGE", "neighbours"],
    [{ knot: 1 }, "E_TYPE", "knot"],
  ] as const) {
    assert.throws(() => quasiInterpolate(cloud, { ...options, ...change } as never), { code, arg }, JSON.stringify(change));
  }
  assert.throws(() => looScore(cloud, { ...options, neighbours: 4 }), { code: "E_RANGE" }, "one more neighbour has to be there");
  assert.throws(() => fitProfile([0, 0]), { code: "E_TOO_FEW_POINTS" });
  assert.throws(() => fitProfile(cloud, { degree: 4 }), { code: "E_RANGE", arg: "degree" });
  assert.throws(() => fitProfile(cloud, { corner: 0 }), { code: "E_RANGE", arg: "corner" });
  assert.throws(() => fitProfile(cloud, { corner: 0.01 }), { code: "E_RANGE", arg: "corner" });
  assert.throws(() => metrics.rmse([0, Infinity]), { code: "E_NOT_FINITE", index: 1 });
  // Their squares, and a million of them, would have no sum.
  assert.throws(() => metrics.rmse([0, 1e308]), { code: "E_RANGE", argument: "residuals[1]" });
  assert.throws(() => metrics.mae([-1.5e308, 1.5e308]), { code: "E_RANGE", argument: "residuals[0]" });
  assert.ok(Math.abs(metrics.rmse([1e150, -1e150]) / 1e150 - 1) < 1e-15);
});
