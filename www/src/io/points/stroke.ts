import { Problem } from "../../document/problem.ts";

/** Points in the order in which they are joined. */
export interface Stroke {
  readonly points: readonly Pair[];
  readonly closed: boolean;
}

export type Pair = readonly [x: number, y: number];

/** What a text of points holds. */
export interface Strokes {
  readonly strokes: readonly Stroke[];
  /** What somebody might not expect of how it was read, in words. */
  readonly notes: readonly string[];
}

export const mostPoints = 100_000;
const mostCoordinate = 1e9;

export function isCoordinate(value: number): boolean {
  return Math.abs(value) <= mostCoordinate;
}

/** Without points that repeat the one before; a last one that repeats the first closes the curve. */
function strokeOf(all: readonly Pair[]): Stroke {
  const points = all.filter(([x, y], i) => i === 0 || all[i - 1]?.[0] !== x || all[i - 1]?.[1] !== y);
  const [first, last] = [points[0], points.at(-1)];
  const closed = points.length > 3 && first !== undefined && last !== undefined && first[0] === last[0] && first[1] === last[1];
  if (closed) points.pop();
  return { points, closed };
}

/** Lists of points as strokes. A list of one point is none, unless all are: then they belong together. */
export function strokesOf(lists: readonly (readonly Pair[])[], notes: readonly string[]): Strokes {
  const each = lists.map(strokeOf);
  const strokes = each.every(({ points }) => points.length >= 2) ? each : [strokeOf(lists.flat())];
  const count = strokes.reduce((sum, { points }) => sum + points.length, 0);
  if (count > mostPoints) throw new Problem("points-big", { most: mostPoints });
  if (count < 2) throw new Problem("points-few", { count });
  return { strokes, notes };
}
