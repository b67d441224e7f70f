import type { Matrix } from "../matrix.ts";

/** A rectangle along the axes. */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/**
 * A box that holds another and one more, which is moved first; its corners stand for what is in it, as browsers have
 * it.
 */
export function enclosing(all: Box | null, { left, top, right, bottom }: Box, [a, b, c, d, e, f]: Matrix): Box {
  const corners = [[left, top], [right, top], [right, bottom], [left, bottom]] as const;
  const [xs, ys] = [corners.map(([x, y]) => a * x + c * y + e), corners.map(([x, y]) => b * x + d * y + f)];
  if (all !== null) {
    xs.push(all.left, all.right);
    ys.push(all.top, all.bottom);
  }
  return { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) };
}
