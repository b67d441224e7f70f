// Quality of closed outlines: one table for each condition, every tracer a row.

import { sizeOf } from "./pictures.mjs";
import { score, summary, truth } from "./score.mjs";

/** Columns: key, heading, digits, and whether larger or smaller is better; for the turning it is 1. */
export const COLUMNS = [
  ["mean", "mean", 3, "small"],
  ["hausdorff", "haus", 2, "small"],
  ["p99", "p99", 2, "small"],
  ["iou", "iou", 4, "large"],
  ["angle", "ang", 2, "small"],
  ["wiggle", "wig", 2, "one"],
  ["segments", "seg_r", 2, "small"],
  ["recall", "c_rec", 3, "large"],
  ["precision", "c_prec", 3, "large"],
  ["cornerError", "c_err", 2, "small"],
  ["kinks", "g1", 2, "small"],
  ["bytes", "bytes", 0, "small"],
  ["ms", "ms", 1, "small"],
];

export const LEGEND = `mean, haus, p99: distances between outline and truth both ways, in pixels (mean, Hausdorff, 99th percentile). iou: area in common. ang: tangent error in
degrees away from corners. wig: total turning against the truth's. seg_r: segments against the truth's. c_rec, c_prec, c_err: corners of 30° and more (recall, precision,
distance). g1: tangent breaks per picture that are not in the truth. bytes: size of the drawing. ms: median time from pixels in memory to the drawing's text.`;

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;

/**
 * Scores of every contestant on every shape of a set in one condition: [{ name, row, scores }]; `keep` is shown every
 * drawing.
 */
export async function measured(set, condition, contestants, keep = () => {}) {
  const results = contestants.map(([name]) => ({ name, scores: [], times: [] }));
  for (const shape of set.shapes) {
    const goal = truth(shape, sizeOf(condition));
    const picture = set.picture(shape, condition);
    for (const [i, [, trace]] of contestants.entries()) {
      let drawn;
      try {
        drawn = await trace(picture, 1);
      } catch {
        results[i].scores.push(undefined);
        continue;
      }
      keep(results[i].name, shape, drawn);
      results[i].times.push(drawn.ms);
      const result = score(goal, drawn.svg);
      results[i].scores.push(result && { ...result, id: shape.id });
    }
  }
  return results.map(({ name, scores, times }) => ({ name, scores, row: { ...summary(scores), ms: median(times) } }));
}

/** A table in Markdown; recorded rows have gaps where nothing was recorded. */
export function table(title, rows) {
  const head = ["tracer", "failed", ...COLUMNS.map(([, heading]) => heading)];
  const cell = (row, key, digits) => (row[key] === undefined ? "–" : row[key].toFixed(digits));
  const cells = rows.map(({ name, row }) => [name, row.failed ?? "–", ...COLUMNS.map(([key, , digits]) => cell(row, key, digits))]);
  return `### ${title}\n\n| ${head.join(" | ")} |\n|${"---|".repeat(head.length)}\n${cells.map((c) => `| ${c.join(" | ")} |`).join("\n")}\n`;
}

/** Where no tracer should be better. */
const COMPARED = ["mean", "hausdorff", "iou", "angle", "recall", "precision", "kinks"];

/** The columns in which a row is behind another, as text. */
export function behind(ours, others) {
  const out = [];
  for (const [key, heading, digits, better] of COLUMNS) {
    if (!COMPARED.includes(key)) continue;
    const cost = (value) => (better === "large" ? -value : value);
    for (const { name, row } of others) {
      if (row[key] === undefined || cost(row[key]) >= cost(ours[key])) continue;
      out.push(`${heading} ${ours[key].toFixed(digits)}, ${name} ${row[key].toFixed(digits)}`);
    }
  }
  return out;
}
