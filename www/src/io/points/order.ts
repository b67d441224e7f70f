import type { Pair } from "./stroke.ts";

/** Rows in no order, as tables sorted by something else have them. */

/** Fewer rows may lie in any order by intent. */
const leastRows = 8;
/** Part of the rows at which x turns round; of rows in no order it turns at two thirds. */
const turning = 0.4;
/** Part of the rows that have an x of their own at least, in a function. */
const distinct = 0.9;
/** So many times as long is the way through rows in no order. */
const longer = 4;

/**
 * The rows from left to right where they are a function of x whose rows lie in no order; null where they are as they
 * should be.
 */
export function sortedRows(points: readonly Pair[]): readonly Pair[] | null {
  if (points.length < leastRows || turns(points) < turning * points.length) return null;
  if (new Set(points.map(([x]) => x)).size < distinct * points.length) return null;
  const sorted = [...points].sort(([a], [b]) => a - b);
  return longer * lengthOf(sorted) < lengthOf(points) ? sorted : null;
}

function turns(points: readonly Pair[]): number {
  const xs = points.map(([x]) => x);
  return xs.filter((x, i) => i > 0 && i + 1 < xs.length && (x - (xs[i - 1] ?? 0)) * ((xs[i + 1] ?? 0) - x) < 0).length;
}

function lengthOf(points: readonly Pair[]): number {
  return points.reduce((sum, [x, y], i) => {
    const [px, py] = points[i - 1] ?? [x, y];
    return sum + Math.hypot(x - px, y - py);
  }, 0);
}
