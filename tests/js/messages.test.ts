// What a message says of a mistake that is often made: what was given, by its name, and what would do.

import assert from "node:assert/strict";
import { test } from "node:test";

import { ExplineError, ExponentialBSpline, HermiteCurve, HermiteGenerators, Interpolator, LocalCurve, TensorSurface, fitSparse, fitSparseAll, fitSparseAllAsync, roots, traceImage } from "expline";

const circle = HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 4 });
const along = { roots: roots.ellipse(8), count: 8, closed: true };

/** What a call is refused with, in words, without its name and code. */
function said(call: () => unknown): string {
  try {
    call();
  } catch (error) {
    assert.ok(error instanceof ExplineError);
    assert.notEqual(error.argument, undefined);
    return error.message.replace(/^[\w.]+: | \[\w+\]$/g, "");
  }
  assert.fail("nothing was wrong");
}

const TRIANGLE = [0, 0, 9, 0, 9, 9];

/** Something of a type that the declarations would have refused. */
const as = <T>(value: unknown): T => value as T;

const NUMBERS = "Float64Array or an array of numbers";

for (const [what, call, words] of [
  ["a parameter that is text", () => circle.evaluate(as("0.5")), `t is "0.5"; expected a number, ${NUMBERS}`],
  ["a parameter that is missing", () => circle.curvature(as(undefined)), `t is undefined; expected a number, ${NUMBERS}`],
  ["a place of a generator that is text", () => new ExponentialBSpline([0, 0]).evaluate(as("1")), `x is "1"; expected a number, ${NUMBERS}`],
  ["a parameter of a surface that is null", () => TensorSurface.sphere(1).evaluate(as(null), 0), `u is null; expected a number, ${NUMBERS}`],
  ["a curve behind a proxy", () => new Proxy(circle, {}).length(), "this is an object; expected a curve of this package, no proxy"],
  ["points in single precision", () => fitSparse(as(new Float32Array(8))), `points is of type Float32Array; expected ${NUMBERS}`],
  ["points as bytes", () => HermiteCurve.through(as(new Uint8Array(8))), `points is of type Uint8Array; expected ${NUMBERS}`],
  ["points as an object", () => HermiteCurve.through(as({ x: 1 })), `points is an object; expected ${NUMBERS}`],
  ["a picture in single precision", () => traceImage({ width: 1, height: 1, data: as(new Float32Array(4)) }), "data is of type Float32Array; expected Uint8ClampedArray | Uint8Array"],
  ["a surface without a number of points", () => new TensorSurface({ net: [], u: as({ ...along, count: undefined }), v: along }), "u.count is undefined; expected an integer in [0, 4194304]"],
  ["an ellipse without a number of points", () => HermiteCurve.ellipse(as({ center: [0, 0], radii: [5, 5] })), "count is undefined; expected an integer in [2, 1000000]"],
  ["two strengths of a fit", () => fitSparse(TRIANGLE, { lambda: [1, 1], smoothing: 0.5 }), "smoothing and lambda exclude each other"],
  ["a patch of a surface that has none", () => TensorSurface.sphere(1).patchPoints(0), "patch is 0; there are no patches"],
  ["a patch of a curve that has none", () => new LocalCurve({ points: TRIANGLE }).withoutPatch(0), "k is 0; there are no patches"],
  ["a frequency that is text", () => new HermiteCurve({ points: TRIANGLE, tangents: TRIANGLE, omega: as("x") }), `omega is "x"; expected a number, ${NUMBERS}`],
  ["an interpolator for too few points", () => Interpolator.forEllipse(2), "count is 2; expected an integer in [3, 4294967295]"],
  ["nearest points of no places", () => circle.nearestAll(as("here")), `places is "here"; expected ${NUMBERS}`],
] as const) {
  test(`${what}: the message says so`, () => assert.equal(said(call), words));
}

test("generators take one place, a list or an array, as curves do", () => {
  const [spline, pair] = [new ExponentialBSpline([0, 0]), new HermiteGenerators(1)];
  const of = (x: number | number[] | Float64Array): unknown => [spline.evaluate(x), pair.evaluate(x), pair.bernstein(x), pair.greens(x)];
  assert.deepEqual(of(0.25), of(Float64Array.of(0.25)));
  assert.deepEqual(of([0.25, 0.5]), of(Float64Array.of(0.25, 0.5)));
});

for (const [what, call, argument, index] of [
  ["a point that is no pair", () => HermiteCurve.through(as([[0, 0], [1], [2, 2]])), "points[1]", 1],
  ["a coordinate of a pair that is text", () => HermiteCurve.through(as([[0, 0], [1, "x"]])), "points[1][1]", 3],
  ["a coordinate of a pair that is NaN", () => HermiteCurve.through([[0, 0], [NaN, 1]]), "points[1][0]", 2],
  ["a coordinate of an object that is missing", () => HermiteCurve.through(as([{ x: 0, y: 0 }, { x: 1 }])), "points[1].y", 3],
  ["one of interleaved numbers", () => HermiteCurve.through([0, 0, 1, Infinity]), "points[3]", 3],
  ["one of several contours, too short", () => fitSparseAll([TRIANGLE, [1, 1]]), "contours[1]", undefined],
  ["one of several contours, all in one place", () => fitSparseAll([TRIANGLE, [1, 1, 1, 1, 1, 1]], { noise: 1 }), "contours[1]", undefined],
  ["one of several contours, no list", () => fitSparseAll(as([TRIANGLE, 5])), "contours[1]", undefined],
  ["a number of one of several contours", () => fitSparseAll([TRIANGLE, [1, 1, 2, NaN]]), "contours[1][3]", 3],
  ["a coordinate of a pair of one of several contours", () => fitSparseAll([TRIANGLE, [[1, 1], [2, NaN]]]), "contours[1][1][1]", 3],
] as const) {
  test(`${what}: the error says which`, () => {
    assert.throws(call, (error) => {
      assert.ok(error instanceof ExplineError);
      assert.deepEqual([error.argument, error.arg, error.index], [argument, argument.split("[")[0], index]);
      return error.message.includes(`: ${argument} `);
    });
  });
}

test("contours that are fitted in short tasks are named as well", async () => {
  const one = { code: "E_DEGENERATE", op: "fitSparseAllAsync", argument: "contours[1]" };
  await assert.rejects(fitSparseAllAsync([TRIANGLE, [1, 1, 1, 1, 1, 1]], { noise: 1 }), one);
  await assert.rejects(fitSparseAllAsync([TRIANGLE, [1, 1, 1, 1, 1, 1]]), one);
});

test("too many points are counted as points, however they are given", () => {
  const most = { code: "E_LIMIT", limit: "maxFitSamples", max: 500_000, actual: 600_000 };
  for (const points of [new Float64Array(1_200_000), new Array<number>(1_200_000).fill(0), new Array<number[]>(600_000).fill([0, 0])]) {
    assert.throws(() => fitSparse(points), most);
  }
});

test("how few points a fit takes is what its documentation says", () => {
  const least = (options: object): number => [1, 2, 3, 4, 5, 6, 7].find((count) => {
    const points = Float64Array.from({ length: 2 * count }, (_, i) => ((i * i) % 7) + i);
    try {
      return fitSparse(points, options).knots.length >= 0;
    } catch (error) {
      assert.equal((error as ExplineError).code, "E_TOO_FEW_POINTS");
      return false;
    }
  }) ?? 0;
  for (const strength of [{}, { tolerance: 0.1 }]) assert.deepEqual([least({ ...strength, closed: false }), least({ ...strength, closed: true })], [2, 3]);
  for (const [degree, needed] of [[undefined, 4], [1, 2], [2, 3], [5, 6], [[1, 2], 3]] as const) {
    const lambda = typeof degree === "number" ? 1 : [1, 1];
    for (const strength of [{ smoothing: 0.5 }, { lambda }]) {
      assert.deepEqual([least({ ...strength, degree, closed: false }), least({ ...strength, degree, closed: true })], [needed, 3], JSON.stringify({ ...strength, degree }));
    }
  }
});
