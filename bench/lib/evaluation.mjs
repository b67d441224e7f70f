// Rows about points: many, few, with tangents, evenly by length.

import { SEGMENTS, coordinate, evenPlaces } from "./curve.mjs";
import { evaluator, hornerEvaluator, tangentEvaluator } from "./handwritten.mjs";
import { here } from "./harness.mjs";

const MANY = 1_000_000;
const FEW = 1024;
const BY_LENGTH = 1000;

/** Largest distance of interleaved points from the curve's points at the same parameters. */
function deviation(out, stride = 2) {
  const count = out.length / stride;
  let worst = 0;
  for (let i = 0; i < count; i += 7) {
    const t = (i * SEGMENTS) / count;
    worst = Math.max(worst, Math.abs(out[stride * i] - coordinate(t, 0)), Math.abs(out[stride * i + 1] - coordinate(t, 1)));
  }
  return `off ${worst.toExponential(1)}`;
}

/** Every point through a library's own call, one by one, into a typed array. */
function pointwise(count, out, pointAt) {
  const each = count / SEGMENTS;
  return () => {
    let o = 0;
    for (let s = 0; s < SEGMENTS; s++) {
      for (let k = 0; k < each; k++) {
        const p = pointAt(s, k / each);
        out[o] = p.x;
        out[o + 1] = p.y;
        o += 2;
      }
    }
  };
}

function evaluation(count, peers, targets) {
  const { curve, kurbo, native, beziers, path, interpolator } = peers;
  const out = new Float64Array(2 * count);
  const row = (name, action, note = () => deviation(out)) => ({ name, measure: here(action), units: count, note });
  const table = evaluator(count);
  const horner = hornerEvaluator(count);
  const curves = path.curves;
  const place = [0, 0];
  const operation = count === MANY ? "evaluate" : "evaluate-few";
  const contestants = [
    row("expline, wasm", () => curve.sample(count, { out })),
    { name: "expline, native", measure: native.measure(`expline:${operation}`), units: count, note: () => "" },
    row("hand-written JS, table", () => table(out)),
    row("hand-written JS, Horner", () => horner(out)),
    { name: "kurbo, native", measure: native.measure(`kurbo:${operation}`), units: count, note: () => "" },
    row("kurbo, wasm", () => kurbo.evaluate(count), () => deviation(kurbo.numbers(2 * count))),
    row("bezier-js", pointwise(count, out, (s, t) => beziers[s].get(t))),
    row("paper", pointwise(count, out, (s, t) => curves[s].getPointAtTime(t))),
    row("curve-interpolator", pointwise(count, out, (s, t) => {
      interpolator.getPointAtTime((s + t) / SEGMENTS, place);
      return { x: place[0], y: place[1] };
    })),
  ];
  return { unit: "point", contestants, targets };
}

function tangentsRow({ curve, kurbo, native, beziers, path }) {
  const out = new Float64Array(4 * MANY);
  const both = tangentEvaluator(MANY);
  const each = MANY / SEGMENTS;
  const curves = path.curves;
  const one = (pair) => () => {
    let o = 0;
    for (let s = 0; s < SEGMENTS; s++) {
      for (let k = 0; k < each; k++, o += 4) {
        const [p, v] = pair(s, k / each);
        out[o] = p.x;
        out[o + 1] = p.y;
        out[o + 2] = v.x;
        out[o + 3] = v.y;
      }
    }
  };
  const row = (name, action, note) => ({ name, measure: here(action), units: MANY, note });
  return {
    unit: "point",
    contestants: [
      row("expline, wasm", () => curve.sample(MANY, { out, tangents: true }), () => deviation(out, 4)),
      row("hand-written JS, table", () => both(out), () => deviation(out, 4)),
      { name: "kurbo, native", measure: native.measure("kurbo:tangents"), units: MANY, note: () => "" },
      row("kurbo, wasm", () => kurbo.evaluate_with_tangents(MANY), () => deviation(kurbo.numbers(4 * MANY), 4)),
      row("bezier-js", one((s, t) => [beziers[s].get(t), beziers[s].derivative(t)]), () => deviation(out, 4)),
      row("paper", one((s, t) => [curves[s].getPointAtTime(t), curves[s].getTangentAtTime(t)]), () => deviation(out, 4)),
    ],
    targets: [],
  };
}

/** The largest distance from the places where points evenly spread by arc length truly are. */
function misplaced(at) {
  const truth = evenPlaces(BY_LENGTH);
  let worst = 0;
  for (let i = 0; i < BY_LENGTH; i++) {
    const [x, y] = at(i);
    worst = Math.max(worst, Math.hypot(x - truth[2 * i], y - truth[2 * i + 1]));
  }
  return `off ${worst.toExponential(1)}`;
}

function byLength({ curve, native, path, interpolator }) {
  let even;
  let pairs;
  let placed;
  const row = (name, action, note) => ({ name, measure: here(action), units: BY_LENGTH, note });
  return {
    unit: "point",
    contestants: [
      row("expline, wasm", () => (even = curve.sampleByLength(BY_LENGTH)), () => misplaced((i) => [even[2 * i], even[2 * i + 1]])),
      { name: "expline, native", measure: native.measure("expline:by-length"), units: BY_LENGTH, note: () => "" },
      row("curve-interpolator", () => (pairs = interpolator.getPoints(BY_LENGTH)), () => misplaced((i) => pairs[i])),
      row("paper", () => {
        const length = path.length;
        placed = Array.from({ length: BY_LENGTH }, (_, i) => path.getPointAt((i * length) / BY_LENGTH));
      }, () => misplaced((i) => [placed[i].x, placed[i].y])),
    ],
    targets: [["curve-interpolator", 8]],
  };
}

const MANY_TARGETS = [["hand-written JS, table", 2.3], ["kurbo, native", 4], ["bezier-js", 20], ["paper", 28]];
const FEW_TARGETS = [["hand-written JS, table", 2.4]];

/** Titles and what makes the contestants. */
export const evaluationRows = [
  ["evaluate 1 000 000 points", (peers) => evaluation(MANY, peers, MANY_TARGETS)],
  ["evaluate 16 × 64 points, the call included", (peers) => evaluation(FEW, peers, FEW_TARGETS)],
  ["point and tangent, 1 000 000", tangentsRow],
  ["1000 points evenly by arc length", byLength],
];
