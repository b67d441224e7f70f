// The certified optima of the sparse problems, through the JavaScript interface.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { HermiteCurve, type SparseFitOptions, fitSparse, fitSparseAll, fitSparseAllAsync } from "expline";

import { noisyCircle } from "./fit-data.ts";

/** What is promised of the objective; the reference is good to 1e-9 where a conic solver made it. */
const OBJECTIVE = 1e-7;
const QFE = 1e-3;
/** Relative gap asked for and certified: one degree, two degrees. */
const GAP = 1e-8;
const HYBRID_GAP = 1e-6;
/** Distance of the curve from the reference, in the unit of the points, whose outlines are some hundreds across. */
const CURVE = 1e-3;

interface GridCase {
  name: string;
  source: string;
  closed: boolean;
  norm: "l1" | "l2";
  degrees: number[];
  lambdas: number[];
  grid: number[];
  objective: number;
  qfe: number;
  knots: number[][];
  curve_t: number[];
  curve_xy: number[];
  loose: number[][];
}
interface Golden {
  sets: Record<string, number[]>;
  cases: GridCase[];
}

const golden = JSON.parse(readFileSync("tests/golden/sparse/grid.json", "utf8")) as Golden;

/** One number for one degree, a pair for two. */
function each(values: readonly number[]): number | [number, number] {
  const [first = 0, second] = values;
  return second === undefined ? first : [first, second];
}

for (const c of golden.cases) {
  test(`${c.name}: objective, error, knots and curve of the certified optimum`, (t) => {
    const points = Float64Array.from(golden.sets[c.source] ?? []);
    const asked = c.degrees.length > 1 ? HYBRID_GAP : GAP;
    const [gridSize] = c.grid;
    assert.ok(gridSize !== undefined && c.grid.every((size) => size === gridSize), "one grid for all degrees");
    const fit = fitSparse(points, {
      ...{ degree: each(c.degrees), lambda: each(c.lambdas), gridSize, closed: c.closed, norm: c.norm },
      ...{ gap: asked / 2, finish: "none" },
    });
    assert.equal(fit.status, "converged");
    assert.ok(fit.gap <= asked, `certified gap ${fit.gap}`);
    const off = Math.abs(fit.objective / c.objective - 1);
    assert.ok(off <= OBJECTIVE, `objective off by ${off}`);
    assert.ok(Math.abs(fit.qfe / c.qfe - 1) <= QFE, `QFE ${fit.qfe} for ${c.qfe}`);
    assert.deepEqual(fit.lambda, c.lambdas);

    t.diagnostic(`${c.name}: objective off by ${off.toExponential(0)}, gap ${fit.gap.toExponential(0)}, ${fit.iterations} iterations`);
    // Where a conic solver made the reference, its knots and its curve are not exact.
    if (c.loose.length > 0) return;
    // The parameter of a closed curve counts from its first knot, that of the data from the first point.
    const first = c.closed ? Math.min(...c.knots.flat()) : 0;
    c.degrees.forEach((degree, i) => {
      const found = fit.knots.filter((knot) => knot.degree === degree).map(({ t: at }) => at + first);
      const expected = [...(c.knots[i] ?? [])].sort((x, y) => x - y);
      assert.equal(found.length, expected.length, `${found.length} knots of degree ${degree} for ${expected.length}`);
      found.forEach((at, k) => assert.ok(Math.abs(at - (expected[k] ?? Infinity)) < 1e-6, `knot ${at} for ${expected[k]}`));
    });
    c.curve_t.forEach((at, i) => {
      const [x = 0, y = 0] = fit.curve.evaluate(at - first);
      const distance = Math.hypot(x - (c.curve_xy[2 * i] ?? 0), y - (c.curve_xy[2 * i + 1] ?? 0));
      assert.ok(distance <= CURVE, `the curve is ${distance} off at ${at}`);
    });
  });
}

interface ContinuousCase {
  name: string;
  source: string;
  closed: boolean;
  degree: number;
  lam: number;
  upper: number;
  knots: number[];
}

test("knots that slide reach the optimum without a grid", (t) => {
  const cases = JSON.parse(readFileSync("tests/golden/sparse/continuous.json", "utf8")) as ContinuousCase[];
  for (const c of cases) {
    const points = Float64Array.from(golden.sets[c.source] ?? []);
    const fit = fitSparse(points, { degree: c.degree, lambda: c.lam, closed: c.closed, gap: 1e-7, finish: "gridless" });
    assert.ok(fit.gap <= 1e-4, `${c.name}: certified gap ${fit.gap}`);
    assert.ok(fit.objective <= c.upper * (1 + 1e-4), `${c.name}: objective ${fit.objective} for ${c.upper}`);
    assert.ok(Math.abs(fit.knots.length - c.knots.length) <= 1, `${c.name}: ${fit.knots.length} knots for ${c.knots.length}`);
    t.diagnostic(`${c.name}: ${fit.knots.length} knots, gap ${fit.gap.toExponential(0)}`);
  }
});

test("a curve that was made shorter carries the certificate of the optimum that it was made from", () => {
  for (const c of golden.cases.filter(({ norm }) => norm === "l2")) {
    const points = Float64Array.from(golden.sets[c.source] ?? []);
    const options = { degree: each(c.degrees), lambda: each(c.lambdas), gridSize: c.grid[0] ?? 1, closed: c.closed, gap: 1e-7 };
    const fit = fitSparse(points, { ...options, finish: "full" });
    assert.ok(fit.gap <= 1e-7, `${c.name}: certified gap ${fit.gap}`);
    assert.ok(Math.abs(fit.objective / c.objective - 1) <= 2e-7, `${c.name}: objective ${fit.objective} for ${c.objective}`);
    assert.ok(Math.abs((fit.dataTerm + fit.regularizer) / fit.objective - 1) <= 1e-12, `${c.name}: the objective's two terms`);
  }
});

test("what comes after the optimum can be named step by step, and every step says what it changed", () => {
  const points = Float64Array.from(golden.sets["smooth400_snr45"] ?? []);
  const options = { degree: 3, lambda: 5000 };
  const plain = fitSparse(points, { ...options, finish: "none" });
  assert.deepEqual(plain.changes, []);
  assert.deepEqual(fitSparse(points, { ...options, finish: [] }).knots, plain.knots);
  const full = fitSparse(points, { ...options, finish: "full" });
  assert.deepEqual(full.changes.map(({ step }) => step), ["merge", "slide", "debias", "prune"]);
  assert.deepEqual(fitSparse(points, { ...options, finish: ["prune", "debias", "merge", "slide"] }).changes, full.changes);
  assert.deepEqual(fitSparse(points, { ...options, finish: "gridless" }).changes, full.changes.slice(0, 2));
  assert.equal(full.changes[0]?.knots[0], plain.knots.length);
  assert.equal(full.changes[3]?.knots[1], full.knots.length);
  assert.ok((full.changes[1]?.gap ?? 1) <= 1e-4, "the gap to the problem without a grid");
  const extreme = fitSparse(points, { ...options, finish: ["extreme"] });
  assert.deepEqual(extreme.changes.map(({ step, knots }) => [step, ...knots]), [["extreme", plain.knots.length, plain.knots.length]]);
  assert.equal(fitSparse(points, { degree: 3, tolerance: 8 }).changes[0]?.step, "search");
  assert.throws(() => fitSparse(points, { finish: ["slide", "bend" as never] }), { code: "E_RANGE", arg: "finish" });
  assert.throws(() => fitSparse(points, { finish: Array.from({ length: 6 }, () => "merge" as const) }), { code: "E_LENGTH", arg: "finish" });
});

test("options about the optimum change nothing of a search for the fewest knots, and those about the search nothing of an optimum", () => {
  const points = noisyCircle(200, 0.01, 3);
  const said = (options: SparseFitOptions): string => JSON.stringify({ ...fitSparse(points, options), curve: fitSparse(points, options).curve.toJSON() });
  const ofOptimum: SparseFitOptions[] = [{ finish: "none" }, { norm: "l1" }, { gridSize: 20 }, { gap: 1e-2 }, { mix: 0 }, { degree: 3 }];
  for (const search of [{}, { tolerance: 0.05 }]) {
    for (const idle of ofOptimum) assert.equal(said({ ...search, ...idle }), said(search), JSON.stringify({ ...search, ...idle }));
    assert.equal(fitSparse(points, search).parts.length, 1);
  }
  for (const strength of [{ smoothing: 0.4 }, { lambda: [1, 1] as const }]) {
    for (const idle of [{ corners: false }, { corners: 1 }]) assert.equal(said({ ...strength, ...idle }), said(strength), JSON.stringify({ ...strength, ...idle }));
    assert.equal(fitSparse(points, strength).parts.length, 1);
    assert.equal(fitSparse(points, { ...strength, finish: "gridless" }).parts.length, 2);
  }
  assert.equal(said({ lambda: [1, 1], mix: 0 }), said({ lambda: [1, 1] }));
});

test("contours of one drawing are fitted with one level of noise", () => {
  const contours = [noisyCircle(300, 0.01, 1), noisyCircle(200, 0.01, 2), noisyCircle(250, 0.05, 3)];
  const fits = fitSparseAll(contours, { degree: 3 });
  const alone = contours.map((points) => fitSparse(points, { degree: 3 }).sigma).sort((a, b) => a - b);
  assert.deepEqual(fits.map(({ sigma }) => sigma), [alone[1], alone[1], alone[1]]);
  const given = fitSparseAll(contours, { degree: 3, noise: 0.02 });
  given.forEach((fit, i) => assert.deepEqual(fit.knots, fitSparse(contours[i] ?? [], { degree: 3, noise: 0.02 }).knots));
  assert.deepEqual(fitSparseAll([]), []);
  assert.throws(() => fitSparseAll(7 as never), { code: "E_TYPE", arg: "contours" });
});

test("several contours in short tasks give the same fits, from the points as they were", async () => {
  const contours = [noisyCircle(120, 0.01, 1), noisyCircle(90, 0.03, 2)];
  const expected = fitSparseAll(contours, { degree: 3 });
  const steps: number[] = [];
  const running = fitSparseAllAsync(contours, { degree: 3, onProgress: ({ iteration }) => steps.push(iteration) });
  contours[0]?.fill(0);
  contours.pop();
  assert.deepEqual(
    (await running).map(({ knots, sigma }) => ({ knots, sigma })),
    expected.map(({ knots, sigma }) => ({ knots, sigma })),
  );
  assert.ok(steps.length >= 2, "progress of both");
  const ended = new AbortController();
  ended.abort();
  await assert.rejects(fitSparseAllAsync([noisyCircle(90, 0.03, 2)], { signal: ended.signal }), { code: "E_CANCELLED" });
  assert.deepEqual(await fitSparseAllAsync([]), []);
});

test("corners turn by no less than is asked for, and the tolerance is kept", () => {
  const wave = Float64Array.from({ length: 240 }, (_, i) => {
    const k = i >> 1;
    return Math.round(i % 2 === 0 ? 6 * k : 90 * Math.sin((6 * k) / 80) + 1.2 * Math.sin(37 * k * k));
  });
  const least = 0.5;
  const fit = fitSparse(wave, { tolerance: 2, closed: false, corners: least });
  assert.ok(fit.maxError <= 2, `within ${fit.maxError}`);
  assert.ok(fit.curve instanceof HermiteCurve);
  const { tangents, tangentsIn } = fit.curve;
  const at = (list: Float64Array, i: number): number => Math.atan2(list[2 * i + 1] ?? 0, list[2 * i] ?? 0);
  for (let i = 1; i + 1 < tangents.length / 2; i++) {
    const turn = Math.abs(((at(tangents, i) - at(tangentsIn, i) + 9 * Math.PI) % (2 * Math.PI)) - Math.PI);
    assert.ok(turn < 1e-6 || turn >= least, `a corner of ${turn}`);
  }
  assert.throws(() => fitSparse(wave, { tolerance: 2, corners: 4 }), { code: "E_RANGE" });
});

test("a search ends after maxIterations and says so, and enough of them change nothing", () => {
  const points = noisyCircle(200, 0.01, 3);
  for (const search of [{}, { tolerance: 0.05 }]) {
    const whole = fitSparse(points, search);
    for (const maxIterations of [0, 1, whole.iterations - 1]) {
      const early = fitSparse(points, { ...search, maxIterations });
      assert.deepEqual([early.status, early.iterations], ["max_iterations", maxIterations]);
      assert.ok(early.maxError > 0 && Number.isFinite(early.maxError));
    }
    const same = fitSparse(points, { ...search, maxIterations: whole.iterations });
    assert.deepEqual([same.status, same.knots], [whole.status, whole.knots]);
  }
});

test("a stroke without knots is one segment between its two ends", () => {
  const line = Array.from({ length: 30 }, (_, i): [number, number] => [3 * i, 40 + 4 * i]);
  const bow = Array.from({ length: 50 }, (_, i): [number, number] => [i, i * i * 0.01]);
  for (const options of [{ tolerance: 0.01 }, { degree: 2 }, { degree: 5 }, { degree: 1, lambda: 1e4 }] satisfies SparseFitOptions[]) {
    const { curve, knots } = fitSparse(line, { ...options, closed: false });
    assert.equal(knots.length, 0);
    assert.equal(curve.toPathD({ decimals: 1 }).d, "M0 40 87 156", JSON.stringify(options));
  }
  const { curve, knots, maxError } = fitSparse(bow, { tolerance: 0.01, closed: false });
  assert.equal(knots.length, 0);
  assert.equal(curve.points.length, 4);
  assert.ok(maxError < 1e-6);
});

test("the parts of a pair of degrees have the curve for their sum; closed ones count from their own first knots", () => {
  const place = (i: number): [number, number] => {
    const a = (2 * Math.PI * i) / 60;
    return [90 + Math.cos(a) + 0.3 * Math.abs(Math.sin(1.5 * a + 0.4)), 0.6 * Math.sin(a) + 0.1 * Math.cos(4 * a)];
  };
  const points = Array.from({ length: 60 }, (_, i) => place(i));
  for (const closed of [true, false]) {
    for (const [finish, lambda] of [["none", [0.001, 0.1]], ["gridless", [0.02, 0.02]], ["none", [1e3, 0.01]], ["none", [0.01, 1e3]]] as const) {
      const { curve, parts, knots } = fitSparse(points, { closed, finish, lambda });
      const first = [1, 3].map((degree) => (closed ? (knots.find((knot) => knot.degree === degree)?.t ?? 0) : 0));
      const [, end] = curve.domain;
      assert.equal(parts.length, 2);
      for (let i = 0; i <= 100; i += 1) {
        const t = (i * end) / 100;
        const at = parts.map((part, k) => part.evaluate(closed ? t - (first[k] ?? NaN) : Math.min(t, part.domain[1])));
        const off = Math.hypot(...curve.evaluate(t).map((x, axis) => x - at.reduce((sum, place) => sum + (place[axis] ?? NaN), 0)));
        assert.ok(off < 1e-11, `${off} at ${t}, ${finish}, ${lambda.join()}, ${closed}`);
      }
    }
  }
});
