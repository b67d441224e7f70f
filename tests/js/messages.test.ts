// What a message says of a mistake that is often made: what was given, by its name, and what would do.

import assert from "node:assert/strict";
import { test } from "node:test";

import { BSplineCurve, ExplineError, ExponentialBSpline, HermiteCurve, HermiteGenerators, InterpolatingCurve, Interpolator, LocalCurve, TensorSurface, fitSparse, fitSparseAll, fitSparseAllAsync, fromJSON, hitTest, parsePath, roots, traceImage } from "expline";

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
  ["patches of a curve that are null", () => new LocalCurve({ points: TRIANGLE, patches: as(null) }), "patches is null; expected an array"],
  ["patches of a surface that are null", () => new TensorSurface({ net: new Array<number>(192).fill(7), u: along, v: along, patches: as(null) }), "patches is null; expected an array"],
  ["a tolerance of a drawing that is null", () => traceImage({ width: 1, height: 1, data: new Uint8Array(1) }).toSvg({ tolerance: as(null) }), "tolerance is null; expected a finite number"],
  ["decimals of a drawing that are null", () => traceImage({ width: 1, height: 1, data: new Uint8Array(1) }).toSvg({ decimals: as(null) }), "decimals is null; expected an integer in [0, 17]"],
  ["an ellipse without a number of points", () => HermiteCurve.ellipse(as({ center: [0, 0], radii: [5, 5] })), "count is undefined; expected an integer in [2, 1000000]"],
  ["two strengths of a fit", () => fitSparse(TRIANGLE, { lambda: [1, 1], smoothing: 0.5 }), "smoothing and lambda exclude each other"],
  ["one λ for the two degrees that are the default", () => fitSparse(TRIANGLE, { lambda: 10 }), "lambda has length 1; expected 2, one for each degree, or one and { degree: 3 }"],
  ["two λ for one degree", () => fitSparse(TRIANGLE, { degree: 1, lambda: [1, 1] }), "lambda has length 2; expected 1, as there is one degree"],
  ["a patch of a surface that has none", () => TensorSurface.sphere(1).patchPoints(0), "patch is 0; there are no patches"],
  ["a patch of a curve that has none", () => new LocalCurve({ points: TRIANGLE }).withoutPatch(0), "k is 0; there are no patches"],
  ["a frequency that is text", () => new HermiteCurve({ points: TRIANGLE, tangents: TRIANGLE, omega: as("x") }), `omega is "x"; expected a number, ${NUMBERS}`],
  ["an interpolator for too few points", () => Interpolator.forEllipse(2), "count is 2; expected an integer in [3, 4294967295]"],
  ["nearest points of no places", () => circle.nearestAll(as("here")), `places is "here"; expected ${NUMBERS}`],
  ["a number that is missing", () => circle.flatten(as(undefined)), "tolerance is undefined; expected a finite number"],
  ["a coordinate that is missing", () => circle.nearest(0, as(undefined)), "y is undefined; expected a finite number with |x| <= 1e9"],
  ["an angle that is text", () => traceImage({ width: 1, height: 1, data: new Uint8Array(1) }, { corner: as("right") }), `corner is "right"; expected a number in [0.05, π]`],
  ["a curve to be made an interpolating one that is missing", () => InterpolatingCurve.from(as(undefined)), "curve is undefined; expected BSplineCurve"],
  ["a union of no lists", () => roots.union(), "lists has 0; expected at least 1"],
  ["a grid of too many vertices", () => TensorSurface.sphere(1).mesh(1e5, 1e5), "rows × cols needs 10000000000; maxOutputPoints is 4000000"],
  ["a factor that is odd", () => new InterpolatingCurve({ points: TRIANGLE }).refine(1, { m0: 3 }), "m0 = 3 has no unique answer: half-integer shifts need an even factor"],
  ["a factor that is no divisor", () => new InterpolatingCurve({ points: TRIANGLE }).refine(1).reduce(4), "m = 4 has no unique answer: it does not divide the number of cells"],
  ["a factor of a filter that is odd", () => new Interpolator([0, 0, 0]).preFilter(3), "m0 = 3 has no unique answer: half-integer shifts need an even factor"],
  ["a root of a curve without its conjugate", () => new InterpolatingCurve({ points: [7, 8, 9, 0, 9, 9], roots: [0, { re: 0, im: 1 }, 0] }), "roots[1] has no unique answer: its conjugate is missing"],
  ["a root of control points without its conjugate", () => new BSplineCurve({ points: [7, 8, 9, 0, 9, 9], roots: [0, { re: 0, im: 1 }, 0] }), "roots[1] has no unique answer: its conjugate is missing"],
  ["a root of a surface without its conjugate", () => new TensorSurface({ net: new Array<number>(192).fill(7), u: along, v: { ...along, roots: [0, { re: 0, im: 1 }, 0] } }), "v.roots[1] has no unique answer: its conjugate is missing"],
  ["a part of a curve that is a point", () => new HermiteCurve({ points: TRIANGLE, tangents: TRIANGLE, closed: false }).trim(1, 1), "t1 = 1 has no unique answer: it must lie beyond t0"],
  ["a part that begins before its curve", () => new HermiteCurve({ points: TRIANGLE, tangents: TRIANGLE, closed: false }).trim(-1, 1), "t0 is -1; expected a number in [0, 2]"],
  ["a part that ends beyond its curve", () => new HermiteCurve({ points: TRIANGLE, tangents: TRIANGLE, closed: false }).trim(1, 9), "t1 is 9; expected a number in [0, 2]"],
  ["an empty list in a union", () => roots.union([0], []), "lists[1] has 0; expected at least 1"],
  ["a list in a union with a root that is too large", () => roots.union([0], [0, 50]), "lists[1][1] is 50; expected a finite number with |x| <= 20"],
  ["a list in a union without a conjugate", () => roots.union([{ re: 0, im: 1 }], [0]), "lists[0][0] has no unique answer: its conjugate is missing"],
  ["lists that together have too many roots", () => roots.union(roots.polynomials(10), roots.harmonics(20, 5)), "lists needs 21; maxRoots is 16"],
  ["roots that leave an interpolator no digits", () => new Interpolator([0, 0, 0, 0, 20, -20, 17.5, -17.5, 20, -20]), "roots has no unique answer: no digits of the interpolator are left"],
  ["roots that have no interpolator", () => new Interpolator([0, 0, { re: 0, im: 8.986818915818128 }, { re: 0, im: -8.986818915818128 }], { beyondPi: true }), "roots has no unique answer: there is no interpolator for these roots"],
  ["an entry of a matrix that is NaN", () => circle.transform([1, 0, 0, NaN, 0, 0]), "matrix[3] is NaN; expected a finite number"],
  ["a tangent that is too long", () => circle.setTangent(0, 9e9, 0), "dx is 9000000000; expected a finite number with |x| <= 8e9"],
  ["a path with a handle too far away to be read", () => new HermiteCurve({ points: [1e9, 0, 0, 0], tangents: [1e9, 0, 0, 0], closed: false }).toPathD(), "handles is 1333333333.3; expected a number in [0, 1e9]"],
] as const) {
  test(`${what}: the message says so`, () => assert.equal(said(call), words));
}

test("generators take one place, a list or an array, as curves do", () => {
  const [spline, pair] = [new ExponentialBSpline([0, 0]), new HermiteGenerators(1)];
  const of = (x: number | number[] | Float64Array): unknown => [spline.evaluate(x), pair.evaluate(x), pair.bernstein(x), pair.greens(x)];
  assert.deepEqual(of(0.25), of(Float64Array.of(0.25)));
  assert.deepEqual(of([0.25, 0.5]), of(Float64Array.of(0.25, 0.5)));
});

test("pairs and triples may be typed arrays, as vectors and matrices of graphics are", () => {
  const pairs = [Float32Array.of(0, 0), Float64Array.of(1, 1), [2, 0], Uint8Array.of(3, 4)];
  const same = [[0, 0], [1, 1], [2, 0], [3, 4]];
  assert.deepEqual(HermiteCurve.through(pairs), HermiteCurve.through(same));
  assert.deepEqual(circle.nearestAll(pairs), circle.nearestAll(same));
  const triples = [Float32Array.of(0, 0, 1), Float32Array.of(1, 1, 1), Float32Array.of(2, 0, 3)];
  assert.deepEqual(new InterpolatingCurve({ points: triples, dimension: 3 }).points, Float64Array.of(0, 0, 1, 1, 1, 1, 2, 0, 3));
  assert.equal(new InterpolatingCurve({ points: triples }).dimension, 3, "triples are in space, in whatever arrays");
  const [center, radii] = [Float32Array.of(1, 2), Float32Array.of(3, 2)];
  assert.deepEqual(HermiteCurve.ellipse({ center, radii, count: 4 }).bounds(), { minX: -2, minY: 0, maxX: 4, maxY: 4 });
  assert.deepEqual(circle.transform(Float32Array.of(1, 0, 0, 1, 2, 3)).bounds(), { minX: -3, minY: -2, maxX: 7, maxY: 8 });
  assert.deepEqual(TensorSurface.ellipsoid(Float32Array.of(1, 2, 3)).toJSON(), TensorSurface.ellipsoid([1, 2, 3]).toJSON());
  assert.throws(() => HermiteCurve.through([[0, 0], Float32Array.of(1)]), { code: "E_TYPE", argument: "points[1]" });
  assert.throws(() => HermiteCurve.through([[0, 0], Float32Array.of(1, NaN)]), { code: "E_NOT_FINITE", argument: "points[1][1]" });
  assert.throws(() => HermiteCurve.through([[0, 0], as<number[]>(new DataView(new ArrayBuffer(16)))]), { code: "E_TYPE", argument: "points[1]" });
});

test("what is as large as coordinates may be is read, kept and written", () => {
  const [wide] = parsePath("M-1e9 0L1e9 0L0 1e9Z");
  assert.ok(wide);
  const kept = fromJSON(wide.toJSON()) as HermiteCurve;
  assert.deepEqual(kept.tangents, wide.tangents);
  assert.deepEqual(parsePath(kept.toPathD({ tolerance: 1 }).d)[0]?.points, wide.points);
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
  ["the second radius of an ellipse", () => HermiteCurve.ellipse({ center: [0, 0], radii: [1, -1], count: 4 }), "radii[1]", 1],
  ["a coordinate of a centre", () => HermiteCurve.arc({ center: [0, 2e9], radii: [1, 1], start: 0, sweep: 1 }), "center[1]", 1],
  ["a half axis that is NaN", () => TensorSurface.ellipsoid([1, NaN, 1]), "radii[1]", 1],
  ["a half axis that is negative", () => TensorSurface.ellipsoid([1, 1, -1]), "radii[2]", 2],
  ["a number of segments that is not whole", () => TensorSurface.sphere(1, [8, 1.5]), "segments[1]", 1],
  ["one of two prices", () => fitSparse(TRIANGLE, { lambda: [1, -1] }), "lambda[1]", 1],
  ["one of two degrees", () => fitSparse(TRIANGLE, { degree: [1, 9] }), "degree[1]", 1],
  ["one of several steps", () => fitSparse(TRIANGLE, { finish: as(["merge", "mend"]) }), "finish[1]", 1],
  ["a point whose handles are shown", () => hitTest([circle, circle], 0, 0, { reach: 1, handles: [[], [3, 4]] }), "handles[1][1]", 1],
  ["the imaginary part of a root", () => new ExponentialBSpline([0, as({ re: 1 })]), "roots[1].im", 1],
  ["a root of one of several lists", () => roots.union([0], [NaN]), "lists[1][0]", 0],
  ["one of several parameters", () => circle.evaluate([0, NaN]), "t[1]", 1],
  ["the only parameter of a list", () => circle.curvature([NaN]), "t[0]", 0],
  ["one of several frequencies", () => new HermiteCurve({ points: TRIANGLE, tangents: TRIANGLE, omega: [1, 1, 9] }), "omega[2]", 2],
  ["the frequency of all segments, on one that is too long for it", () => new HermiteCurve({ points: TRIANGLE, tangents: TRIANGLE, omega: 3, lengths: [1, 1, 9] }), "omega[2]", 2],
  ["one of several places on a surface", () => TensorSurface.sphere(1).normal([0, 0], [0, 9]), "v[1]", 1],
] as const) {
  test(`${what}: the error says which`, () => {
    assert.throws(call, (error) => {
      assert.ok(error instanceof ExplineError);
      assert.deepEqual([error.argument, error.arg, error.index], [argument, argument.split("[")[0], index]);
      return error.message.includes(`: ${argument} `);
    });
  });
}

const line = { points: TRIANGLE, tangents: [9, 9, 9, 9, 9, 9], closed: false };
const still = { ...line, tangents: [0, 0, 0, 0, 0, 0] };

for (const [what, call, argument, code] of [
  ["a parameter that is NaN", () => circle.evaluate(NaN), "t", "E_NOT_FINITE"],
  ["a parameter beyond the end", () => new HermiteCurve(line).evaluate(9), "t", "E_RANGE"],
  ["a parameter of a curvature", () => new HermiteCurve(line).curvature(9), "t", "E_RANGE"],
  ["a parameter where nothing moves", () => new HermiteCurve(still).curvature(0), "t", "E_DEGENERATE"],
  ["a place of generators", () => new HermiteGenerators(1).bernstein(2), "x", "E_RANGE"],
  ["a place of a B-spline", () => new ExponentialBSpline([0, 0]).evaluate(NaN), "x", "E_NOT_FINITE"],
  ["a frequency for all segments", () => new HermiteCurve({ ...line, omega: 9 }), "omega", "E_RANGE"],
  ["a length for all segments", () => new HermiteCurve({ ...line, lengths: -1 }), "lengths", "E_RANGE"],
  ["a frequency to go through points with", () => HermiteCurve.through(TRIANGLE, { omega: 9 }), "omega", "E_RANGE"],
  ["a parameter of a surface that is NaN", () => TensorSurface.sphere(1).evaluate(NaN, 0), "u", "E_NOT_FINITE"],
  ["a parameter beyond the end of a surface", () => TensorSurface.sphere(1).curvature(0, 9), "v", "E_RANGE"],
  ["the one price of one degree", () => fitSparse(TRIANGLE, { degree: 1, lambda: -1 }), "lambda", "E_RANGE"],
] as const) {
  test(`${what}, a number that stands alone: the error gives it no index`, () => {
    assert.throws(call, (error) => {
      assert.ok(error instanceof ExplineError);
      assert.deepEqual([error.code, error.argument, error.arg, error.index], [code, argument, argument, undefined]);
      return error.message.includes(`: ${argument} `);
    });
  });
}

test("what is wrong with a file is named by its place in the JSON, whatever it is of", () => {
  const points = new InterpolatingCurve({ points: [0, 0, 9, 0, 9, 9, 0, 9] });
  const [local, fine] = [points.refineAt(1).toJSON(), points.refine(1).toJSON()];
  const torus = TensorSurface.torus(2, 1).toJSON();
  for (const [file, place] of [
    [{ ...circle.toJSON(), omega: 99 }, "$.omega"],
    [{ ...circle.toJSON(), points: [0, 0, null, 0] }, "$.points[2]"],
    [{ ...points.toJSON(), roots: [0, { re: 0, im: 1 }] }, "$.roots[1]"],
    [{ ...points.toJSON(), roots: [0, { re: 0 }] }, "$.roots[1].im"],
    [{ ...local, patches: [{ ...local.patches[0], level: 99 }] }, "$.patches[0].level"],
    [{ ...fine, domain: [0, null] }, "$.domain[1]"],
    [{ ...fine, step: -1 }, "$.step"],
    [{ ...torus, u: { ...torus.u, count: -1 } }, "$.u.count"],
    [{ ...torus, net: undefined }, "$.net"],
    [{ ...torus, version: 0 }, "$.version"],
    [{ ...torus, note: NaN }, "$.note"],
  ] as const) {
    assert.throws(() => fromJSON(file), (error) => {
      assert.ok(error instanceof ExplineError);
      assert.deepEqual([error.op, error.arg, error.argument, error.path], ["fromJSON", "json", place, place]);
      return error.message.includes(`: ${place} `);
    });
  }
  assert.ok(fromJSON(fine) instanceof BSplineCurve);
});

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
  for (const refined of [() => circle.refine(1e9), () => circle.subdivide(1, { arity: 1e9 })]) {
    assert.throws(refined, { code: "E_LIMIT", argument: "arity", limit: "maxOutputPoints", actual: 1e9 });
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
