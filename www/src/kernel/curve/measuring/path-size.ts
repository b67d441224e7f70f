import type { Curve } from "expline/slim";
import { decimalsIn } from "../../../document/unit.ts";
import type { AnyCurve } from "../curve-cache.ts";

/** Characters of the path text at the export dialog's defaults, in a drawing with this unit. */
export function pathSize(curve: AnyCurve | Curve, unit = 1): number {
  return curve.toPathD({ tolerance: 0.02 * unit, decimals: decimalsIn(unit, 3) }).d.length;
}
