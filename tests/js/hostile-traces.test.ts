// Hostile inputs for tracing: section trace of the catalogue, with the names of this interface.

import assert from "node:assert/strict";

import { type Trace, type TraceOptions, traceImage } from "expline";

import { type Case, testCases } from "./hostile.ts";
import { filled, painted, photoNoise, ring, salt, stripes } from "./trace-data.ts";

/** Hostile values get past the compiler here, as they do in JavaScript. */
const hostile = <T>(value: unknown): T => value as T;

const trace = (image: unknown, options: unknown = {}) => () => traceImage(hostile(image), hostile<TraceOptions>(options));

const bytes = (length: number): Uint8ClampedArray => new Uint8ClampedArray(length);

/** Curves that can be evaluated everywhere, in the picture and a little around it. */
function sound({ contours, width, height, toSvg }: Trace): void {
  for (const { curve, cusps, metrics } of contours) {
    const { minX, minY, maxX, maxY } = curve.bounds();
    assert.ok(minX > -3 && minY > -3 && maxX < width + 3 && maxY < height + 3, `${minX} ${minY} ${maxX} ${maxY}`);
    for (const number of [...curve.sample(16), ...cusps.flat(), ...Object.values(metrics)]) assert.ok(Number.isFinite(number));
  }
  assert.doesNotMatch(toSvg(), /NaN|Infinity|undefined/);
}

/** A trace, or a refusal that says that there are too many contours. */
function boundedTrace(image: unknown, options: TraceOptions = {}): Trace | undefined {
  try {
    return traceImage(hostile(image), options);
  } catch (error) {
    const { code, limit, actual = 0, max = 0 } = error as { code?: string; limit?: string; actual?: number; max?: number };
    assert.equal(code, "E_LIMIT");
    assert.ok(limit === "maxContours" || limit === "maxContourPoints", limit);
    assert.ok(actual > max);
    return undefined;
  }
}

const detached = (): Uint8ClampedArray => {
  const data = bytes(16);
  structuredClone(data.buffer, { transfer: [data.buffer] });
  return data;
};

const NOISE = photoNoise(10, 10, 2);
const RING = ring(32);
const rings = painted(401, 401, (x, y) => (Math.floor(Math.max(Math.abs(x - 200), Math.abs(y - 200)) / 2) % 2 === 0 ? 0 : 255));

const cases: readonly Case[] = [
  { id: "TR-001", what: "no pixel", run: trace({ width: 0, height: 0, data: bytes(0) }), refuses: { code: "E_RANGE", arg: "width", bound: "[1, 16384]" } },
  { id: "TR-002", what: "no column", run: trace({ width: 0, height: 5, data: bytes(0) }), refuses: { code: "E_RANGE", arg: "width" } },
  { id: "TR-003", what: "one black pixel", run: trace(filled(1, 1, [0, 0, 0, 255])), gives: (result: Trace) => { sound(result); assert.ok(result.contours.length <= 1); } },
  { id: "TR-004", what: "a column of 10,000 pixels", run: trace(stripes(1, 10_000), { refine: false }), gives: sound },
  { id: "TR-005", what: "two rows of 10,000 pixels", run: trace(stripes(10_000, 2), { refine: false, maxContours: 2000 }), gives: sound },
  { id: "TR-007", what: "more bytes than pixels", run: trace({ width: 10, height: 10, data: bytes(404) }), refuses: { code: "E_LENGTH", arg: "data", bound: "400" } },
  { id: "TR-008", what: "half a column", run: trace({ width: 10.5, height: 10, data: bytes(420) }), refuses: { code: "E_RANGE", arg: "width", bound: "integer" } },
  { id: "TR-009", what: "a width that is not a number", run: trace({ width: NaN, height: 10, data: bytes(40) }), refuses: { code: "E_NOT_FINITE", arg: "width" } },
  { id: "TR-010", what: "pixels that overflow 32 bits", run: trace({ width: 65_536, height: 65_536, data: bytes(0) }), refuses: { code: "E_RANGE", arg: "width" } },
  { id: "TR-011", what: "a photograph of 24 megapixels", senseless: "in a row: trace-memory.test.ts has it" },
  { id: "TR-011b", what: "noise of 150 × 100", run: () => boundedTrace(photoNoise(150, 100, 1)) ?? 0, gives: (result: Trace | 0) => { if (result !== 0) sound(result); } },
  { id: "TR-013", what: "a checkerboard of a million squares", run: trace(painted(1000, 1000, (x, y) => ((x + y) % 2 === 0 ? 0 : 255)), { blur: 0, speckle: 0 }), refuses: { code: "E_LIMIT", arg: "data" } },
  { id: "TR-015", what: "100 squares in one another", run: trace(rings), gives: (result: Trace) => { sound(result); assert.ok(result.contours.length >= 99, `${result.contours.length}`); } },
  { id: "TR-017", what: "black to the border", run: trace(filled(64, 64, [0, 0, 0, 255])), gives: (result: Trace) => { sound(result); assert.equal(result.contours.length, 1); const { minX, minY, maxX, maxY } = result.contours[0]!.curve.bounds(); for (const [got, wanted] of [[minX, 0], [minY, 0], [maxX, 64], [maxY, 64]] as const) assert.ok(Math.abs(got - wanted) < 0.6, `${got}`); } },
  { id: "TR-020", what: "thresholds of 0 for edges", senseless: "for thresholds of edges, which are found" },
  { id: "TR-021", what: "an upper threshold below the lower one", senseless: "for thresholds of edges, which are found" },
  { id: "TR-022", what: "negative thresholds of edges", senseless: "for thresholds of edges, which are found" },
  { id: "TR-026", what: "shades as floats", run: trace({ width: 2, height: 2, data: new Float32Array(16) }), refuses: { code: "E_TYPE", arg: "data", bound: "Uint8ClampedArray | Uint8Array" } },
  { id: "TR-027", what: "bytes that were transferred away", run: trace({ width: 2, height: 2, data: detached() }), refuses: { code: "E_DETACHED", arg: "data" } },
  { id: "TR-028", what: "a palette of no colours", run: trace(photoNoise(8, 8, 3), { colors: 0 }), refuses: { code: "E_RANGE", arg: "colors", bound: "[2, 64]" } },
  { id: "TR-029", what: "fewer colours than were asked for", run: trace(filled(8, 8, [1, 2, 3, 255]), { colors: 16 }), gives: (result: Trace) => { sound(result); assert.deepEqual(result.layers, [{ color: "#010203" }]); } },
  { id: "TR-030", what: "a diagonal of single pixels", run: trace(painted(100, 100, (x, y) => (x === y ? 0 : 255)), { blur: 0 }), gives: (result: Trace) => { sound(result); assert.equal(result.contours.length, 1); } },
  { id: "TR-031", what: "salt on half of a picture", run: () => boundedTrace(salt(300, 300, 0.5, 4)) ?? 0, gives: (result: Trace | 0) => { if (result !== 0) sound(result); } },
  { id: "TR-032", what: "speckles larger than the picture", run: trace(filled(8, 8, [0, 0, 0, 255]), { speckle: 1000 }), gives: (result: Trace) => assert.equal(result.contours.length, 0) },
  { id: "X-01", what: "no picture", run: trace(null), refuses: { code: "E_TYPE", arg: "image" } },
  { id: "X-02", what: "a picture that is text", run: trace("data:image/png"), refuses: { code: "E_TYPE", arg: "image" } },
  { id: "X-03", what: "a width that is text", run: trace({ ...RING, width: "32" }), refuses: { code: "E_TYPE", arg: "width" } },
  { id: "X-04", what: "a negative height", run: trace({ ...RING, height: -32 }), refuses: { code: "E_RANGE", arg: "height" } },
  { id: "X-05", what: "more pixels than the limit", run: trace({ width: 16_384, height: 16_384, data: bytes(0) }), refuses: { code: "E_LIMIT", limit: "maxPixels" } },
  { id: "X-06", what: "a plain array of bytes", run: trace({ width: 1, height: 1, data: [0, 0, 0, 255] }), refuses: { code: "E_TYPE", arg: "data" } },
  { id: "X-07", what: "something that says that it is an array of bytes", run: trace({ width: 1, height: 1, data: { [Symbol.toStringTag]: "Uint8Array", length: 4 } }), refuses: { code: "E_TYPE", arg: "data" } },
  { id: "X-08", what: "three bytes a pixel", run: trace({ width: 2, height: 2, data: bytes(12) }), refuses: { code: "E_LENGTH", arg: "data" } },
  { id: "X-09", what: "an option that there is not", run: trace(RING, { smooth: 1 }), refuses: { code: "E_TYPE", arg: "smooth" } },
  { id: "X-10", what: "a threshold beyond white", run: trace(RING, { threshold: 256 }), refuses: { code: "E_RANGE", arg: "threshold", bound: "[0, 255]" } },
  { id: "X-11", what: "a threshold that is a word", run: trace(RING, { threshold: "dark" }), refuses: { code: "E_TYPE", arg: "threshold" } },
  { id: "X-12", what: "a blur that is not a number", run: trace(RING, { blur: NaN }), refuses: { code: "E_NOT_FINITE", arg: "blur" } },
  { id: "X-13", what: "a corner of 0", run: trace(RING, { corner: 0 }), refuses: { code: "E_RANGE", arg: "corner", bound: "π" } },
  { id: "X-13, near", what: "a corner of less than 0.05", run: trace(RING, { corner: 0.01 }), refuses: { code: "E_RANGE", arg: "corner", bound: "[0.05, π]" } },
  { id: "X-14", what: "a corner beyond π", run: trace(RING, { corner: 4 }), refuses: { code: "E_RANGE", arg: "corner" } },
  { id: "X-15", what: "a tolerance of 0", run: trace(RING, { tolerance: 0 }), refuses: { code: "E_RANGE", arg: "tolerance" } },
  { id: "X-16", what: "a source that there is not", run: trace(RING, { source: "colour" }), refuses: { code: "E_RANGE", arg: "source" } },
  { id: "X-17", what: "a model that is a number", run: trace(RING, { model: 3 }), refuses: { code: "E_TYPE", arg: "model" } },
  { id: "X-18", what: "invert that is a number", run: trace(RING, { invert: 1 }), refuses: { code: "E_TYPE", arg: "invert" } },
  { id: "X-19", what: "no contour allowed", run: trace(RING, { maxContours: 0 }), refuses: { code: "E_RANGE", arg: "maxContours" } },
  { id: "X-20", what: "a million contours allowed", run: trace(RING, { maxContours: 1e6 }), refuses: { code: "E_LIMIT", limit: "maxContours" } },
  { id: "X-21", what: "a signal that is aborted already", run: trace(RING, { signal: AbortSignal.abort() }), refuses: { code: "E_CANCELLED" } },
  { id: "X-22", what: "a signal that is none", run: trace(RING, { signal: {} }), refuses: { code: "E_TYPE", arg: "signal" } },
  { id: "X-23", what: "a colour that is a word", run: trace(RING, { colors: ["red", "#fff"] }), refuses: { code: "E_RANGE", arg: "colors", index: 0 } },
  { id: "X-24", what: "a colour that is a number", run: trace(RING, { colors: ["#000", 5] }), refuses: { code: "E_TYPE", arg: "colors", index: 1 } },
  { id: "X-25", what: "a list of no colours", run: trace(RING, { colors: [] }), refuses: { code: "E_LENGTH", arg: "colors" } },
  { id: "X-26", what: "65 colours", run: trace(RING, { colors: 65 }), refuses: { code: "E_RANGE", arg: "colors" } },
  { id: "X-27", what: "colours that are text", run: trace(RING, { colors: "#fff" }), refuses: { code: "E_TYPE", arg: "colors" } },
  { id: "X-27a", what: "edges asked for beside colours", run: trace(RING, { colors: 2, source: "edges" }), refuses: { code: "E_RANGE", arg: "source" } },
  { id: "X-27b", what: "a threshold asked for beside colours", run: trace(RING, { colors: 2, threshold: 100 }), refuses: { code: "E_RANGE", arg: "threshold" } },
  { id: "X-27c", what: "light ink asked for beside colours", run: trace(RING, { colors: 2, invert: true }), refuses: { code: "E_RANGE", arg: "invert" } },
  { id: "X-27d", what: "colours beside what is said of ink by default", run: trace(RING, { colors: 2, source: "brightness", threshold: "auto", invert: false }), gives: sound },
  { id: "X-28", what: "a threshold of white, and one of black", run: () => [0, 255].map((threshold) => traceImage(RING, { threshold })), gives: (all: Trace[]) => all.forEach(sound) },
  { id: "X-29", what: "all of it transparent", run: trace(filled(16, 16, [9, 9, 9, 0])), gives: (result: Trace) => assert.equal(result.contours.length, 0) },
  { id: "X-30", what: "the strongest blur, the largest speckle, the widest corner", run: trace(RING, { blur: 10, speckle: 1e9, corner: Math.PI, tolerance: 1000 }), gives: sound },
  { id: "X-31", what: "noise of 10 × 10", run: () => boundedTrace(NOISE) ?? 0, gives: (result: Trace | 0) => { if (result !== 0) sound(result); } },
];

testCases("traces", cases);
