import type { AnyCurve } from "../curve-cache.ts";

/** Characters of the path text at the export dialog's defaults. */
export function pathSize(curve: AnyCurve): number {
  return curve.toPathD({ tolerance: 0.02, decimals: 3 }).d.length;
}
