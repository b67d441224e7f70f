/** Affine maps. They act on points and displacements alone, which are owned here: the engine has no part in it. */
import { LARGEST, exactly, finite, inRange } from "./arguments.js";
import { ExplineError, degenerate, range } from "./error.js";
import type { Floats } from "./kernel.js";

/**
 * How far the last row of a 4 × 4 matrix may be from 0, 0, 0, 1: products and inverses in single precision are off by
 * as much.
 */
const ROUNDED = 1e-6;

/**
 * The images of interleaved points, within ±`most`; of displacements, with `shift` 0, as no translation moves them.
 * @internal
 */
export type AffineMap = (list: Float64Array, most?: number, shift?: 0 | 1) => Floats;

/**
 * The map of a matrix that a caller gives. What is a sum over functions that do not keep constants, for want of a root
 * 0, cannot be moved: of such `roots` a translation is refused.
 * @internal
 */
export function affine(op: string, value: unknown, dimension: 2 | 3, ...roots: readonly Floats[]): AffineMap {
  const arg = "matrix";
  const rows = 2 * dimension - 2;
  const matrix = exactly(op, arg, value, rows * (dimension + 1));
  const movable = roots.every((list) => list.some((re, i) => i % 2 + Math.abs(re) + Math.abs(list[i + 1] ?? 0) === 0));
  matrix.forEach((entry, i) => {
    const last = i < dimension * rows ? 0 : 1;
    if (i % rows === 3) inRange(op, arg, entry, last - ROUNDED, last + ROUNDED, i);
    else if (finite(op, arg, entry, i) * last !== 0 && !movable) throw degenerate(op, arg, "what has no root 0 cannot be moved", i, entry);
  });
  return (list, most = LARGEST, shift = 1) =>
    list.map((_, i) => {
      const row = i % dimension;
      let sum = 0;
      for (let k = 0; k < dimension; k += 1) sum += (matrix[rows * k + row] ?? 0) * (list[i - row + k] ?? 0);
      sum += shift * (matrix[rows * dimension + row] ?? 0);
      if (Math.abs(sum) <= most) return sum + 0;
      const bound = range(-most, most);
      throw new ExplineError("E_RANGE", op, `${arg} gives ${sum}; expected ${bound}`, { arg, argument: arg, value: sum, bound });
    }) as Floats;
}
