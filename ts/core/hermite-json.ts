/** Hermite curves as plain data. */
import type { CurveData, Space } from "./curve-data.js";
import type { Floats } from "./kernel.js";

/** A `HermiteCurve` as plain data. Fields that a newer version wrote are kept. */
export interface HermiteCurveJSON {
  /** What it is. */
  type: "HermiteCurve";
  /** Of the format; a file of a newer one is refused. */
  version: 1;
  /** Whether the last point is joined to the first. */
  closed: boolean;
  /** The space that its segments are in. */
  space: Space;
  /** Two numbers for each point. */
  points: number[];
  /** Two numbers for each point: the derivative that leaves it. */
  tangents: number[];
  /** Only where they differ from `tangents`. */
  tangentsIn?: number[];
  /** One for all segments, or one for each. */
  omega: number | number[];
  /** Only where they are not all 1; one for all segments, or one for each. */
  lengths?: number | number[];
  [unknown: string]: unknown;
}

/** A curve's arrays as plain data. @internal */
export function curveJSON({ closed, space, points, tangents, tangentsIn, omega, lengths, extra }: CurveData): HermiteCurveJSON {
  return {
    type: "HermiteCurve",
    version: 1,
    closed,
    space,
    points: Array.from(points),
    tangents: Array.from(tangents),
    ...(tangentsIn.every((number, i) => number === tangents[i]) ? {} : { tangentsIn: Array.from(tangentsIn) }),
    omega: short(omega),
    ...(lengths.length === 0 ? {} : { lengths: short(lengths) }),
    ...extra,
  };
}

/** One number for all where one is kept. */
function short(array: Floats): number | number[] {
  return array.length === 1 ? (array[0] ?? 0) : Array.from(array);
}
