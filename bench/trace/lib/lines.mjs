// Quality of centre lines: distances between what was drawn and the true lines of strokes.

import { Places } from "./places.mjs";
import { pointAt } from "./raster.mjs";
import { readStroked } from "./svg.mjs";

/** Steps of a curve's chords, and of the places on chords, in pixels. */
const CHORDS = 24;
const STEP = 0.2;

export const LINE_COLUMNS = [
  ["mean", "mean", 3],
  ["hausdorff", "haus", 2],
  ["recall", "rec@1px", 3],
  ["precision", "prec@1px", 3],
  ["lines", "lines", 1],
  ["linesTrue", "true lines", 1],
  ["segments", "segs", 1],
  ["bytes", "bytes", 0],
  ["ms", "ms", 1],
];

export const LINE_GOALS = { thin: { mean: 0.08, recall: 0.98, precision: 0.98 }, thick: { mean: 0.15, recall: 0.98, precision: 0.98 } };

/** Places along a polyline [x, y, x, y, …], its end among them. */
function dense(line) {
  const out = [];
  for (let i = 0; i + 3 < line.length; i += 2) {
    const [x, y, toX, toY] = line.slice(i, i + 4);
    const n = Math.max(1, Math.ceil(Math.hypot(toX - x, toY - y) / STEP));
    for (let k = 0; k < n; k++) out.push(x + ((toX - x) * k) / n, y + ((toY - y) * k) / n);
  }
  return out.concat(line.slice(-2));
}

/** A line of Bézier segments as a polyline. */
function polyline(segments) {
  const out = segments[0].slice(0, 2);
  for (const p of segments) {
    const n = p.length === 4 ? 1 : CHORDS;
    for (let k = 1; k <= n; k++) out.push(...pointAt(p, k / n));
  }
  return out;
}

function distances(from, to) {
  const tree = new Places(Float64Array.from(to));
  return Array.from({ length: from.length / 2 }, (_, i) => tree.distance(from[2 * i], from[2 * i + 1]));
}

const mean = (values) => values.reduce((sum, v) => sum + v, 0) / values.length;
const within = (values) => values.filter((v) => v <= 1).length / values.length;

/** Everything measured of one drawing; undefined where there is no line. */
function scoreLines(shape, size, svg) {
  const { lines, segments } = readStroked(svg, size);
  if (lines.length === 0) return undefined;
  const goal = shape.lines.flatMap(dense);
  const traced = lines.flatMap((line) => dense(polyline(line)));
  const [there, back] = [distances(traced, goal), distances(goal, traced)];
  return {
    mean: 0.5 * (mean(there) + mean(back)),
    hausdorff: Math.max(there.reduce((a, b) => Math.max(a, b)), back.reduce((a, b) => Math.max(a, b))),
    recall: within(back),
    precision: within(there),
    lines: lines.length,
    linesTrue: shape.lines.length,
    segments,
    bytes: Buffer.byteLength(svg),
  };
}

/** Means over all shapes of a set in one condition, and the single results. */
export async function measuredLines(set, condition, trace) {
  const scores = [];
  for (const shape of set.shapes) {
    try {
      const { svg, ms } = await trace(set.picture(shape, condition), 1);
      const result = scoreLines(shape, set.size, svg);
      if (result) scores.push({ ...result, ms, id: shape.id });
    } catch {
      // Counted as failed below.
    }
  }
  const row = Object.fromEntries(LINE_COLUMNS.map(([key]) => [key, mean(scores.map((s) => s[key]))]));
  return { scores, row: { ...row, failed: set.shapes.length - scores.length } };
}
