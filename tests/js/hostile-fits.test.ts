// Hostile inputs for fitting: sections fit and fitHybrid of the catalogue, with the names of this interface.

import assert from "node:assert/strict";

import { type SparseFit, type SparseFitOptions, fitSparse } from "expline";

import { collinear, noisyCircle, star } from "./fit-data.ts";
import { type Case, testCases } from "./hostile.ts";

const CIRCLE = noisyCircle(200, 0.01, 1);
const SQUARE = [0, 0, 1, 0, 1, 1, 0, 1];

/** Hostile values get past the compiler here, as they do in JavaScript. */
const hostile = <T>(value: unknown): T => value as T;

const fit = (points: unknown, options: unknown = {}) => () => fitSparse(hostile(points), hostile<SparseFitOptions>(options));

/** A list of two of which the first is missing. */
function sparse(last: unknown): unknown[] {
  const list = new Array<unknown>(2);
  list[1] = last;
  return list;
}

/** A curve that can be evaluated everywhere, and a status that is one. */
function sound(result: SparseFit): void {
  for (const number of result.curve.sample(64)) assert.ok(Number.isFinite(number));
  assert.ok(["converged", "max_iterations", "stalled", "deadline"].includes(result.status));
  assert.ok(result.gap >= 0 && result.gap <= 1);
}

/** The largest distance of a curve's box from that of the points, by the points' extent. */
function boxExcess({ curve }: SparseFit, points: Float64Array): number {
  const { minX, maxX } = curve.bounds();
  const xs = points.filter((_, i) => i % 2 === 0);
  const [low, high] = [Math.min(...xs), Math.max(...xs)];
  return Math.max(low - minX, maxX - high) / (high - low);
}

const penStill = Float64Array.from({ length: 1000 }, (_, i) => {
  const k = Math.max(0, (i >> 1) - 300);
  return i % 2 === 0 ? k : 20 * Math.sin(k / 30);
});
const backtrack = Float64Array.from({ length: 400 }, (_, i) => (i % 2 === 0 ? 1 - Math.abs(1 - (i >> 1) / 100) : 0));
/** A box of 1e-12 round (1e6, 1e6) is one point: doubles are 1.2e-10 apart there. */
const tinyFar = Float64Array.from(noisyCircle(100, 0.05, 4), (value) => 1e6 + 1e-12 * value);
/** The smallest boxes that hold more than one point. */
const smallFar = [1e-9, 1e-6].map((size) => Float64Array.from(noisyCircle(100, 0.05, 4), (value) => 1e6 + size * value));
/** The largest coordinate there is: what is smooth swings beyond it. */
const withOutlier = Float64Array.from(noisyCircle(100, 0.01, 4), (value, i) => (i === 0 ? 1e9 : value));
/** Every way to ask. */
const STRENGTHS: readonly SparseFitOptions[] = [{}, { smoothing: 0.4 }, { tolerance: 0.1 }, { degree: 3, lambda: 1 }];
const repeated = Float64Array.of(...noisyCircle(100, 0, 1), 1, 0);

const cases: readonly Case[] = [
  { id: "FT-001", what: "no points", run: fit([]), refuses: { code: "E_TOO_FEW_POINTS", arg: "points" } },
  { id: "FT-002", what: "one point", run: fit([1, 1]), refuses: { code: "E_TOO_FEW_POINTS", arg: "points" } },
  { id: "FT-003", what: "two equal points", run: fit([1, 1, 1, 1], { closed: false }), refuses: { code: "E_DEGENERATE", arg: "points" } },
  { id: "FT-004", what: "200 identical points", run: fit(new Float64Array(400).fill(7)), refuses: { code: "E_DEGENERATE", arg: "points" } },
  { id: "FT-007", what: "a pen that is held still", run: fit(penStill, { closed: false, smoothing: 0.4 }), gives: (result: SparseFit) => { sound(result); assert.equal(result.status, "converged"); } },
  { id: "FT-008", what: "a line there and back", run: fit(backtrack, { closed: false }), gives: sound },
  { id: "FT-010", what: "λ = 0 interpolates", run: fit(CIRCLE, { degree: 3, lambda: 0, finish: "none" }), gives: (result: SparseFit) => { sound(result); assert.ok(result.maxError <= 1e-6, `off by ${result.maxError}`); } },
  { id: "FT-011", what: "λ = −1", run: fit(CIRCLE, { degree: 3, lambda: -1 }), refuses: { code: "E_RANGE", arg: "lambda", bound: "[0, 1e12]" } },
  { id: "FT-013", what: "λ = 1e300", run: fit(CIRCLE, { degree: 3, lambda: 1e300 }), refuses: { code: "E_RANGE", arg: "lambda", bound: "1e12" } },
  { id: "FT-014", what: "λ = 1e12, the most: hardly a knot", run: fit(CIRCLE, { degree: 3, lambda: 1e12 }), gives: (result: SparseFit) => { sound(result); assert.ok(result.knots.length <= 4); } },
  { id: "FT-016", what: "no iteration at all", run: fit(CIRCLE, { smoothing: 0.4, maxIterations: 0 }), gives: (result: SparseFit) => { sound(result); assert.equal(result.status, "max_iterations"); assert.equal(result.iterations, 0); } },
  { id: "FT-018", what: "tolerance 0", run: fit(CIRCLE, { tolerance: 0 }), gives: sound },
  { id: "FT-019", what: "tolerance Infinity", run: fit(CIRCLE, { tolerance: Infinity }), refuses: { code: "E_NOT_FINITE", arg: "tolerance" } },
  { id: "FT-021", what: "a deadline of 50 ms for 200,000 points", run: fit(noisyCircle(200_000, 0.01, 2), { smoothing: 0.3, deadline: 50 }), gives: sound },
  { id: "FT-022", what: "a million points", run: fit(new Float64Array(2_000_000)), refuses: { code: "E_LIMIT", arg: "points", limit: "maxFitSamples" } },
  { id: "FT-023", what: "a signal that is aborted already", run: fit(CIRCLE, { signal: AbortSignal.abort() }), refuses: { code: "E_CANCELLED" } },
  { id: "FT-024", what: "an abort during the work", senseless: "of asynchronous fits, which fit-lifecycle.test.ts watches" },
  { id: "FT-025", what: "an outlier at 1e9", run: () => STRENGTHS.map((strength) => fitSparse(withOutlier, strength)), gives: (all: SparseFit[]) => all.forEach(sound) },
  { id: "FT-026", what: "points in a box too small for doubles: FT-004", run: fit(tinyFar), refuses: { code: "E_DEGENERATE", arg: "points" } },
  { id: "FT-026b", what: "points in the smallest boxes of doubles, far away", run: () => smallFar.map((points) => fitSparse(points)), gives: (all: SparseFit[]) => all.forEach((result, i) => { sound(result); assert.ok(boxExcess(result, smallFar[i] as Float64Array) <= 2); }) },
  { id: "FT-030b", what: "a period without parameters, of which it would be one", run: fit(SQUARE, { period: 4 }), refuses: { code: "E_TYPE", arg: "period" } },
  { id: "FT-030", what: "parameters that fall", run: fit(SQUARE, { parameters: [0, 0.5, 0.4, 1], period: 2 }), refuses: { code: "E_DEGENERATE", arg: "parameters", index: 2 } },
  { id: "FT-031", what: "parameters that are all equal", run: fit(SQUARE, { parameters: [0.5, 0.5, 0.5, 0.5] }), refuses: { code: "E_DEGENERATE", arg: "parameters" } },
  { id: "FT-032", what: "a grid beyond the limit", run: fit(CIRCLE, { gridSize: 10_000_000 }), refuses: { code: "E_LIMIT", arg: "gridSize", limit: "maxKnotGrid" } },
  { id: "FT-035", what: "a closed fit whose last point repeats the first", run: fit(repeated), gives: (result: SparseFit) => { sound(result); assert.equal(result.curve.closed, true); } },
  { id: "FT-036", what: "the same twice", senseless: "of asynchronous fits, which fit-lifecycle.test.ts watches" },
  { id: "HY-001", what: "both λ are 0", run: fit(CIRCLE, { lambda: [0, 0] }), refuses: { code: "E_RANGE", arg: "lambda" } },
  { id: "HY-003", what: "λ a factor of 1e16 apart", run: fit(CIRCLE, { lambda: [1e-8, 1e8] }), gives: sound },
  { id: "HY-005", what: "operators that differ by 1e-9", senseless: "components have different degrees, never frequencies" },
  { id: "HY-006", what: "a corner out of range", senseless: "corners are found, not listed" },
  { id: "HY-007", what: "a corner twice", senseless: "corners are found, not listed" },
  { id: "HY-008", what: "every point a corner", run: fit(SQUARE, { degree: 1, tolerance: 1e-9 }), gives: (result: SparseFit) => { sound(result); assert.ok(result.maxError <= 1e-9); } },
  { id: "HY-010", what: "a corner angle of 400°", senseless: "there is no corner angle" },
  { id: "HY-011", what: "a star of 100 cusps", run: fit(star(100, 10)), gives: sound },
  { id: "HY-012", what: "one component stays empty", run: fit(collinear(100), { lambda: [1e-6, 1e6], closed: false, finish: "none" }), gives: (result: SparseFit) => { sound(result); assert.equal(result.parts.length, 2); JSON.stringify(result); } },
  { id: "HY-014", what: "a callback that throws", senseless: "fit-lifecycle.test.ts has it" },
  { id: "LC-033", what: "more bytes than the engine has memory", run: fit(new Float64Array(5e7)), refuses: { code: "E_LIMIT", arg: "points" } },
  { id: "X-01", what: "NaN among the points", run: fit([0, 0, 1, NaN, 2, 2]), refuses: { code: "E_NOT_FINITE", arg: "points", index: 3 } },
  { id: "X-02", what: "an odd number of numbers", run: fit([0, 0, 1]), refuses: { code: "E_LENGTH", arg: "points" } },
  { id: "X-03", what: "points that are text", run: fit("M0 0"), refuses: { code: "E_TYPE", arg: "points" } },
  { id: "X-04", what: "an option that there is not", run: fit(CIRCLE, { smoothness: 1 }), refuses: { code: "E_TYPE", arg: "smoothness" } },
  { id: "X-05", what: "two strengths at once", run: fit(CIRCLE, { lambda: [1, 2], smoothing: 0.5 }), refuses: { code: "E_TYPE", arg: "smoothing" } },
  { id: "X-06", what: "degree 0", run: fit(CIRCLE, { degree: 0 }), refuses: { code: "E_RANGE", arg: "degree" } },
  { id: "X-07", what: "degrees that do not rise", run: fit(CIRCLE, { degree: [3, 1] }), refuses: { code: "E_RANGE", arg: "degree", index: 1 } },
  { id: "X-08", what: "one λ for two degrees", run: fit(CIRCLE, { lambda: 5 }), refuses: { code: "E_LENGTH", arg: "lambda" } },
  { id: "X-08b", what: "a λ that is missing from its list", run: fit(CIRCLE, { lambda: sparse(1) }), refuses: { code: "E_TYPE", arg: "lambda", index: 0 } },
  { id: "X-08c", what: "a degree that is missing from its list", run: fit(CIRCLE, { degree: sparse(3) }), refuses: { code: "E_TYPE", arg: "degree", index: 0 } },
  { id: "X-08d", what: "a step that is missing from its list", run: fit(CIRCLE, { smoothing: 0.4, finish: sparse("slide") }), refuses: { code: "E_TYPE", arg: "finish", index: 0 } },
  { id: "X-09", what: "a weight of 0", run: fit(SQUARE, { weights: [1, 1, 0, 1] }), refuses: { code: "E_RANGE", arg: "weights", index: 2 } },
  { id: "X-10", what: "weights for other points", run: fit(SQUARE, { weights: [1, 1] }), refuses: { code: "E_LENGTH", arg: "weights" } },
  { id: "X-11", what: "a signal that is none", run: fit(SQUARE, { signal: {} }), refuses: { code: "E_TYPE", arg: "signal" } },
  { id: "X-12", what: "a callback that is none", run: fit(SQUARE, { onProgress: 5 }), refuses: { code: "E_TYPE", arg: "onProgress" } },
  { id: "X-13", what: "smoothing beyond 1", run: fit(SQUARE, { smoothing: 1.5 }), refuses: { code: "E_RANGE", arg: "smoothing" } },
  { id: "X-14", what: "coordinates of 1e-12", run: fit(Float64Array.from(CIRCLE, (value) => 1e-12 * value)), gives: sound },
  { id: "X-15", what: "coordinates of 1e9", run: fit(Float64Array.from(CIRCLE, (value) => 9e8 * value)), gives: sound },
  { id: "X-16", what: "two points, open", run: fit([0, 0, 3, 4], { closed: false }), gives: sound },
  { id: "X-17", what: "three points, closed", run: fit([0, 0, 3, 4, 6, 0], { smoothing: 0.5 }), gives: sound },
  { id: "X-18", what: "a grid of one place", run: fit(CIRCLE, { degree: 3, smoothing: 0.4, gridSize: 1 }), gives: sound },
  { id: "X-19", what: "every smoothing there is, of a line", run: () => [0, 0.25, 0.5, 0.75, 1].map((smoothing) => fitSparse(collinear(60), { closed: false, smoothing })), gives: (all: SparseFit[]) => all.forEach(sound) },
];

testCases("fits", cases);
