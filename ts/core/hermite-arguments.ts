/** What a Hermite curve is made from, and the checks of it. */
import {
  MAX_POINTS,
  type PointsLike,
  finite,
  flag,
  numbers,
  options as checkOptions,
  points as checkPoints,
  twoNumbers,
  word,
} from "./arguments.js";
import { CurveData, SPACES, type Space } from "./curve-data.js";
import { wrongLength } from "./error.js";
import type { Floats } from "./kernel.js";

/** What a `HermiteCurve` is made from. */
export interface HermiteCurveOptions {
  /** Points on the curve, 2 to 1,000,000; coordinates within ±1e9. */
  points: PointsLike;
  /** dr/dt leaving each point, per unit of the parameter; within ±8e9. */
  tangents: PointsLike;
  /** dr/dt arriving at each point, where it differs: corners, unequal handles. Default: `tangents`. */
  tangentsIn?: PointsLike | undefined;
  /** Whether the last point is joined to the first. Default true. */
  closed?: boolean | undefined;
  /** Default "trigonometric". */
  space?: Space | undefined;
  /**
   * ω in radians per unit of the parameter, one or one per segment. Default 2π/M for a closed trigonometric curve of M
   * points, else 0: cubics. ω·length must be below 2π − 1e-6 in the trigonometric space, at most 1e4 in the hyperbolic
   * one.
   */
  omega?: number | Float64Array | readonly number[] | undefined;
  /** Parameter length, one for all segments or one per segment. Default 1. */
  lengths?: number | Float64Array | readonly number[] | undefined;
}

/** An ellipse: where, how large, how turned. */
export interface EllipseOptions {
  /** The centre. */
  center: readonly [number, number] | Float32Array | Float64Array;
  /** The two half axes, above 0 and at most 1e9. */
  radii: readonly [number, number] | Float32Array | Float64Array;
  /** Angle of the first axis, in radians. Default 0. */
  rotation?: number | undefined;
}

/** Centre, half axes and angle of an ellipse. @internal */
export function frame(op: string, center: unknown, radii: unknown, rotation: unknown = 0): [number, number, number, number, number] {
  const angle = finite(op, "rotation", rotation);
  return [...twoNumbers(op, "center", center), ...twoNumbers(op, "radii", radii), angle];
}

/** The arrays of a curve that a caller or a file describes, checked. @internal */
export function checked(op: string, options: unknown): CurveData {
  const names = ["points", "tangents", "tangentsIn", "closed", "space", "omega", "lengths"] as const;
  const own = checkOptions(op, options, names);
  const points = checkPoints(op, "points", own.points);
  const closed = flag(op, "closed", own.closed, true);
  const segments = points.length / 2 - (closed ? 0 : 1);
  const data = new CurveData(
    points,
    sameLength(op, "tangents", checkPoints(op, "tangents", own.tangents), points.length),
    own.tangentsIn === undefined
      ? new Float64Array()
      : sameLength(op, "tangentsIn", checkPoints(op, "tangentsIn", own.tangentsIn), points.length),
    perSegment(op, "omega", own.omega, segments),
    perSegment(op, "lengths", own.lengths, segments),
    spaceOf(op, own.space),
    closed,
  );
  data.load(op);
  data.lengths = shortest(data.lengths);
  return data;
}

/**
 * Equal lengths as the engine gives them: one for all, and none where all are 1. The same curve is then the same data.
 */
function shortest(lengths: Floats): Floats {
  const [first] = lengths;
  return lengths.every((length) => length === first) ? lengths.slice(0, first === 1 ? 0 : 1) : lengths;
}

/** The space that is meant; the first one where none is named. @internal */
export function spaceOf(op: string, value: unknown = SPACES[0]): Space {
  return word(op, "space", value, SPACES);
}

function sameLength(op: string, arg: string, array: Floats, length: number): Floats {
  if (array.length !== length) throw wrongLength(op, arg, array.length, String(length));
  return array;
}

/** As many points, or tangents, as a curve has. @internal */
export function asMany(data: CurveData, arg: string, value: unknown): Floats {
  return sameLength(arg, arg, checkPoints(arg, arg, value), data.points.length);
}

/**
 * One number for all segments, or one for each, or nothing; finite and not −0, and the rest is for the kernel to say.
 */
function perSegment(op: string, arg: string, value: unknown, segments: number): Floats {
  if (value === undefined) return new Float64Array();
  if (typeof value === "number") return Float64Array.of(finite(op, arg, value) + 0);
  // Fewer than two points have no segments: what is wrong with them is said by the kernel.
  const array = sameLength(op, arg, numbers(op, arg, value, "maxPoints", MAX_POINTS, "a number, "), Math.max(segments, 0));
  return array.map((number, i) => finite(op, arg, number, i) + 0);
}
