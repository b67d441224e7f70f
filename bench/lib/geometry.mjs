// Rows about the whole curve: bounds, length, nearest point, polyline, cubics.

import { SEGMENTS, coordinate, lengthBetween, queries, trueDistances } from "./curve.mjs";
import { here } from "./harness.mjs";
import { paper } from "./peers.mjs";

/** A distance that is larger than the true one by more than this is a miss: 1e-6 of a pixel. */
const MISS = 1e-6;
const TOLERANCE = 0.1;
const FINE_TOLERANCE = 0.001;
const LENGTH_TOLERANCE = 1e-9;
const CUBIC_TOLERANCE = 1e-3;

const off = (value, truth) => `off ${Math.abs(value - truth).toExponential(1)}`;

function bounds({ curve, kurbo, native, beziers, path }) {
  let box;
  const sum = (b) => b.minX + b.minY + b.maxX + b.maxY;
  const truth = () => sum(curve.bounds());
  const row = (name, action, note) => ({ name, measure: here(action), units: 1, note });
  return {
    unit: "call",
    contestants: [
      row("expline, wasm", () => (box = curve.bounds()), () => off(sum(box), native.answer("kurbo:bounds"))),
      { name: "expline, native", measure: native.measure("expline:bounds"), units: 1, note: () => "" },
      { name: "kurbo, native", measure: native.measure("kurbo:bounds"), units: 1, note: () => "" },
      row("kurbo, wasm", () => kurbo.bounds(), () => off([...kurbo.numbers(4)].reduce((a, b) => a + b), truth())),
      row("bezier-js", () => {
        box = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
        for (const b of beziers) {
          b._bbox = undefined;
          const { x, y } = b.bbox();
          box = {
            minX: Math.min(box.minX, x.min),
            minY: Math.min(box.minY, y.min),
            maxX: Math.max(box.maxX, x.max),
            maxY: Math.max(box.maxY, y.max),
          };
        }
      }, () => off(sum(box), truth())),
      row("paper", () => {
        path._bounds = undefined;
        const b = path.bounds;
        box = { minX: b.left, minY: b.top, maxX: b.right, maxY: b.bottom };
      }, () => off(sum(box), truth())),
    ],
    targets: [],
  };
}

function length({ curve, kurbo, native, beziers, path, interpolator }) {
  let value;
  const row = (name, action, note) => ({ name, measure: here(() => (value = action())), units: 1, note: note ?? (() => off(value, truth)) });
  const truth = lengthBetween(0, SEGMENTS);
  const nativeRow = (name) => ({ measure: native.measure(name), units: 1, note: () => off(native.answer(name), truth) });
  return {
    unit: "call",
    contestants: [
      row("expline, wasm", () => curve.length(LENGTH_TOLERANCE)),
      { name: "expline, native", ...nativeRow("expline:length") },
      { name: "kurbo, native", ...nativeRow("kurbo:length") },
      row("kurbo, wasm", () => kurbo.length(LENGTH_TOLERANCE)),
      row("kurbo, wasm, 1e-6 asked for", () => kurbo.length(1e-6)),
      row("bezier-js", () => beziers.reduce((sum, b) => sum + b.length(), 0)),
      row("paper", () => {
        for (const c of path.curves) c._length = undefined;
        path._length = undefined;
        return path.length;
      }),
      row("curve-interpolator", () => {
        interpolator.reset();
        return interpolator.length;
      }),
    ],
    targets: [["kurbo, wasm", 1]],
  };
}

function nearest({ curve, kurbo, native, beziers, path, interpolator }) {
  const count = queries.length / 2;
  const truth = trueDistances(count);
  const found = new Float64Array(count);
  const misses = (asked) => {
    let missed = 0;
    let worst = 0;
    for (let i = 0; i < asked; i++) {
      const error = Math.abs(found[i] - truth[i]);
      worst = Math.max(worst, error);
      if (error > MISS) missed += 1;
    }
    return `${missed} of ${asked} missed, worst ${worst.toExponential(1)}`;
  };
  /** Slow libraries answer fewer queries a round; the same ones each time. */
  const row = (name, asked, distance) => ({
    name,
    units: asked,
    measure: here(() => {
      for (let i = 0; i < asked; i++) found[i] = distance(queries[2 * i], queries[2 * i + 1]);
    }),
    note: () => misses(asked),
  });
  const nativeRow = (name) => ({ measure: native.measure(name), units: count, note: () => "" });
  const all = {
    name: "expline, wasm",
    units: count,
    measure: here(() => {
      const all = curve.nearestAll(queries);
      for (let i = 0; i < count; i++) found[i] = all[4 * i + 3];
    }),
    note: () => misses(count),
  };
  return {
    unit: "query",
    contestants: [
      all,
      row("expline, wasm, one call each", count, (x, y) => curve.nearest(x, y).distance),
      { name: "expline, native", ...nativeRow("expline:nearest") },
      { name: "kurbo, native", ...nativeRow("kurbo:nearest") },
      { name: "kurbo, native, boxes first", ...nativeRow("kurbo:nearest-pruned") },
      row("kurbo, wasm", count, (x, y) => kurbo.nearest(x, y, 1e-6)),
      row("curve-interpolator", 2000, (x, y) => interpolator.getNearestPosition([x, y]).distance),
      row("bezier-js", 500, (x, y) => Math.min(...beziers.map((b) => b.project({ x, y }).d))),
      row("paper", 200, (x, y) => path.getNearestLocation(new paper.Point(x, y)).distance),
    ],
    targets: [["kurbo, wasm", 7], ["paper", 300]],
  };
}

/** The largest distance from the curve to a polyline, over dense places of the curve. */
function polylineDeviation(numbers) {
  const n = numbers.length / 2;
  let worst = 0;
  for (let i = 0; i < SEGMENTS * 400; i++) {
    const [x, y] = [coordinate(i / 400, 0), coordinate(i / 400, 1)];
    let best = Number.POSITIVE_INFINITY;
    for (let k = 0; k < n; k++) {
      const j = (k + 1) % n;
      const [ax, ay] = [numbers[2 * k], numbers[2 * k + 1]];
      const [dx, dy] = [numbers[2 * j] - ax, numbers[2 * j + 1] - ay];
      const size = dx * dx + dy * dy;
      const t = size > 0 ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / size)) : 0;
      best = Math.min(best, (ax + t * dx - x) ** 2 + (ay + t * dy - y) ** 2);
    }
    worst = Math.max(worst, best);
  }
  return `${n} points, off ${Math.sqrt(worst).toFixed(5)}`;
}

function flatten({ curve, kurbo, native, path }) {
  const all = polylines({ curve, kurbo, path }, TOLERANCE);
  const natively = (name, operation) => ({ name, measure: native.measure(operation), units: 1, note: () => `${native.answer(operation)} points` });
  all.contestants.splice(1, 0, natively("expline, native", "expline:flatten"), natively("kurbo, native", "kurbo:flatten"));
  return { ...all, targets: [["kurbo, wasm", 8]] };
}

/** A polyline that is good enough to be cut or milled. */
const flattenFinely = (peers) => polylines(peers, FINE_TOLERANCE);

function polylines({ curve, kurbo, path }, tolerance) {
  let polyline;
  let count;
  let flat;
  const row = (name, action, note) => ({ name, measure: here(action), units: 1, note });
  return {
    unit: "call",
    contestants: [
      row("expline, wasm", () => (polyline = curve.flatten(tolerance)), () => polylineDeviation(polyline)),
      row("kurbo, wasm", () => (count = kurbo.flatten(tolerance)), () => polylineDeviation(kurbo.numbers(2 * count))),
      row("paper", () => {
        flat = path.clone({ insert: false });
        flat.flatten(tolerance);
      }, () => polylineDeviation(Float64Array.from(flat.segments.flatMap((s) => [s.point.x, s.point.y])))),
    ],
    targets: [],
  };
}

/** A polyline of an exponential curve, which nobody else has: beside that of cubics through the same points. */
function flattenExponential({ curve, exponential }) {
  let polyline;
  const row = (name, from) => ({ name, measure: here(() => (polyline = from.flatten(TOLERANCE))), units: 1, note: () => `${polyline.length / 2} points` });
  return { unit: "call", contestants: [row("expline, wasm", exponential), row("cubics through the same points", curve)], targets: [] };
}

/** An exponential curve as cubics. kurbo fits whatever it can ask for points; it looks for an error, ours is proved. */
function toCubics({ exponential, native }) {
  let result;
  const kurbo = (name, operation) => ({ name, measure: native.measure(operation), units: 1, note: () => `${native.answer(operation)} cubics` });
  return {
    unit: "call",
    contestants: [
      {
        name: "expline, wasm",
        units: 1,
        measure: here(() => (result = exponential.toCubics(CUBIC_TOLERANCE))),
        note: () => `${result.path.length / 8} cubics, off at most ${result.maxError.toExponential(1)}`,
      },
      { name: "expline, native", measure: native.measure("expline:cubics"), units: 1, note: () => `${native.answer("expline:cubics")} cubics` },
      kurbo("kurbo, native", "kurbo:cubics"),
      kurbo("kurbo, native, fewest", "kurbo:cubics-fewest"),
    ],
    targets: [],
  };
}

/** Titles and what makes the contestants. */
export const geometryRows = [
  ["bounds", bounds],
  ["length, 1e-9 asked for", length],
  ["nearest point, 10 000 queries", nearest],
  ["polyline within 0.1", flatten],
  ["polyline within 0.001", flattenFinely],
  ["polyline within 0.1 of an exponential curve (ω = π/2)", flattenExponential],
  ["cubics within 1e-3 of an exponential curve (ω = π/2)", toCubics],
];
