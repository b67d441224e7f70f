/** Hermite exponential curves: points on the curve, with the derivatives that arrive and leave. */
import {
  MAX_EVALUATIONS,
  MAX_OUTPUT,
  type PointsLike,
  coordinate,
  count as checkCount,
  finite,
  flag,
  integer,
  isFloat64Array,
  numbers,
  options as checkOptions,
  output,
  points as checkPoints,
  twoNumbers,
  word,
} from "./arguments.js";
import { CurveData, SPACES, type Space, readCurves } from "./curve-data.js";
import { wrong, wrongLength } from "./error.js";
import { type Floats, call, copy, peek, result, write } from "./kernel.js";

/** What a {@link HermiteCurve} is made from. */
export interface HermiteCurveOptions {
  /** Points on the curve, at least 2. */
  points: PointsLike;
  /** dr/dt leaving each point, per unit of the parameter. */
  tangents: PointsLike;
  /** dr/dt arriving at each point, where it differs: corners, unequal handles. Default: `tangents`. */
  tangentsIn?: PointsLike | undefined;
  /** Whether the last point is joined to the first. Default true. */
  closed?: boolean | undefined;
  /** Default "trigonometric". */
  space?: Space | undefined;
  /**
   * ω in radians per unit of the parameter, one or one per segment. Default 2π/M for a closed trigonometric curve of M points,
   * else 0: cubics. ω·length must be below 2π − 1e-6 in the trigonometric space, at most 1e4 in the hyperbolic one.
   */
  omega?: number | Float64Array | readonly number[] | undefined;
  /** Parameter length of every segment. Default 1 each. */
  lengths?: Float64Array | readonly number[] | undefined;
}

/** An ellipse: where, how large, how turned. */
export interface EllipseOptions {
  /** The centre. */
  center: readonly [number, number];
  /** The two half axes, positive. */
  radii: readonly [number, number];
  /** Angle of the first axis, in radians. Default 0. */
  rotation?: number | undefined;
}

const CURVE = "HermiteCurve";

/** Makes a curve of arrays that the kernel or a file has vouched for. */
export let curveOf: (data: CurveData) => HermiteCurve;

/** The arrays of a curve, and the proof that it is one. */
export let dataOf: (curve: HermiteCurve, op: string) => CurveData;

/** A curve through its points, with the derivatives there: exact for ellipses, cubics and lines alike. */
export class HermiteCurve {
  readonly #data: CurveData;

  static {
    curveOf = (data) => new HermiteCurve(data as unknown as HermiteCurveOptions);
    dataOf = (curve, op) => {
      if (typeof curve !== "object" || curve === null || !(#data in curve)) {
        throw wrong("E_TYPE", op, "this", curve, "a HermiteCurve");
      }
      return curve.#data;
    };
  }

  /**
   * A curve from points and tangents. The arrays are copied.
   *
   * @throws {ExplineError} for whatever is wrong with the options; nothing is made then.
   */
  constructor(options: HermiteCurveOptions) {
    this.#data = options instanceof CurveData ? options : given(options);
  }

  /** An ellipse from `count` points, exact for every count from 2 up: `new HermiteCurve` with nothing to compute. */
  static ellipse(options: EllipseOptions & { count: number }): HermiteCurve {
    const op = `${CURVE}.ellipse`;
    const { center, radii, rotation, count } = checkOptions(op, options, ["center", "radii", "rotation", "count"]);
    const [x, y] = twoNumbers(op, "center", center);
    const [rx, ry] = twoNumbers(op, "radii", radii);
    const angle = rotation === undefined ? 0 : finite(op, "rotation", rotation);
    const n = checkCount(op, "count", count, 0, "maxPoints", 1_000_000);
    return derived(call(op, (kernel) => kernel.ellipse(x, y, rx, ry, angle, n)));
  }

  /** An open arc of an ellipse: from angle `start` over `sweep`, in radians from the first axis; negative runs backwards. */
  static arc(options: EllipseOptions & { start: number; sweep: number }): HermiteCurve {
    const op = `${CURVE}.arc`;
    const names = ["center", "radii", "rotation", "start", "sweep"] as const;
    const { center, radii, rotation, start, sweep } = checkOptions(op, options, names);
    const [x, y] = twoNumbers(op, "center", center);
    const [rx, ry] = twoNumbers(op, "radii", radii);
    const angle = rotation === undefined ? 0 : finite(op, "rotation", rotation);
    const from = finite(op, "start", start);
    const over = finite(op, "sweep", sweep);
    return derived(call(op, (kernel) => kernel.arc(x, y, rx, ry, angle, from, over)));
  }

  /** Whether the last point is joined to the first. */
  get closed(): boolean {
    return dataOf(this, "closed").closed;
  }

  /** First and last parameter. */
  get domain(): readonly [number, number] {
    return [0, dataOf(this, "domain").end];
  }

  /** 2: curves of the plane. */
  get dimension(): 2 {
    return 2;
  }

  /** The space. */
  get space(): Space {
    return dataOf(this, "space").space;
  }

  /** ω of every segment, in radians per unit of the parameter: a copy. */
  get omega(): Float64Array {
    return each(dataOf(this, "omega"), "omega");
  }

  /** Parameter length of every segment: a copy. */
  get lengths(): Float64Array {
    return each(dataOf(this, "lengths"), "lengths");
  }

  /** The points: a copy. Setting them moves all at once; there must be as many as before. */
  get points(): Float64Array {
    return dataOf(this, "points").points.slice();
  }

  set points(value: PointsLike) {
    const data = dataOf(this, "points");
    replace(data, "points", data.points, value);
  }

  /** dr/dt leaving each point: a copy. */
  get tangents(): Float64Array {
    return dataOf(this, "tangents").tangents.slice();
  }

  set tangents(value: PointsLike) {
    const data = dataOf(this, "tangents");
    const arriving = data.tangentsIn;
    if (arriving.length === 0) data.tangentsIn = data.tangents.slice();
    try {
      replace(data, "tangents", data.tangents, value);
    } catch (error) {
      data.tangentsIn = arriving;
      throw error;
    }
  }

  /** dr/dt arriving at each point: a copy. */
  get tangentsIn(): Float64Array {
    const { tangents, tangentsIn } = dataOf(this, "tangentsIn");
    return (tangentsIn.length === 0 ? tangents : tangentsIn).slice();
  }

  set tangentsIn(value: PointsLike) {
    const data = dataOf(this, "tangentsIn");
    const next = data.tangents.slice();
    replace(data, "tangentsIn", next, value);
    data.tangentsIn = next;
  }

  /** Moves point i. */
  setPoint(i: number, x: number, y: number): void {
    const data = dataOf(this, "setPoint");
    const at = 2 * integer("setPoint", "i", i, 0, data.points.length / 2 - 1);
    const place = [coordinate("setPoint", "x", x), coordinate("setPoint", "y", y)];
    data.points.set(place, at);
    data.touch();
  }

  /** Sets dr/dt at point i, on one side or, by default, on both. */
  setTangent(i: number, dx: number, dy: number, side: "in" | "out" | "both" = "both"): void {
    const op = "setTangent";
    const data = dataOf(this, op);
    const at = 2 * integer(op, "i", i, 0, data.points.length / 2 - 1);
    const tangent = [coordinate(op, "dx", dx), coordinate(op, "dy", dy)];
    const which = word(op, "side", side, ["in", "out", "both"]);
    if (which !== "both" && data.tangentsIn.length === 0) data.tangentsIn = data.tangents.slice();
    if (which !== "in") data.tangents.set(tangent, at);
    if (which !== "out" && data.tangentsIn.length > 0) data.tangentsIn.set(tangent, at);
    data.touch();
  }

  /**
   * Points, or derivatives with respect to the parameter (0, 1 or 2), at one or many parameters: x and y in turn.
   *
   * At a point of the curve derivatives are those of the segment that starts there. A closed curve takes any t.
   *
   * @param out where the numbers go, if not into a new array; it may be longer than needed.
   */
  evaluate(t: number | Float64Array | readonly number[], derivative = 0, out?: Float64Array): Float64Array {
    const op = "evaluate";
    const data = dataOf(this, op);
    const order = derivative === 0 ? 0 : integer(op, "derivative", derivative, 0, 2);
    if (typeof t === "number") {
      const slot = data.resident(op);
      const to = out === undefined ? new Float64Array(2) : output(op, out, 2);
      call(op, (kernel) => kernel.evaluate_one(slot, t, order), [t]);
      to[0] = result(0);
      to[1] = result(1);
      return to;
    }
    const given = numbers(op, "t", t, "maxEvalPoints", MAX_EVALUATIONS);
    const to = out === undefined ? undefined : output(op, out, 2 * given.length, isFloat64Array(t) ? t : undefined);
    const slot = data.resident(op);
    write(op, given);
    const count = call(op, (kernel) => kernel.evaluate_many(slot, given.length, order), given);
    if (to === undefined) return copy(count);
    to.set(peek(count));
    return to;
  }

  /**
   * `count` points spread uniformly over the parameter: at i/count of the domain of a closed curve, at i/(count − 1)
   * of an open one; x and y in turn.
   */
  sample(count: number, options?: { out?: Float64Array | undefined }): Float64Array {
    const op = "sample";
    const data = dataOf(this, op);
    const { out } = checkOptions(op, options, ["out"]);
    const n = checkCount(op, "count", count, 1, "maxOutputPoints", MAX_OUTPUT);
    const slot = data.resident(op);
    const to = out === undefined ? new Float64Array(2 * n) : output(op, out, 2 * n);
    for (let first = 0; first < n; first += BLOCK) {
      const length = Math.min(BLOCK, n - first);
      call(op, (kernel) => kernel.sample(slot, n, first, length));
      to.set(peek(2 * length), 2 * first);
    }
    return to;
  }

  /** The same curve with `arity` segments in place of each; the parameter stays. */
  refine(arity = 2): HermiteCurve {
    const op = "refine";
    const data = dataOf(this, op);
    const m = integer(op, "arity", arity, 1, MAX_OUTPUT);
    const slot = data.resident(op);
    return derived(call(op, (kernel) => kernel.refine(slot, m)));
  }

  /** The same curve with one more point, at parameter t. */
  insert(t: number): HermiteCurve {
    const op = "insert";
    const data = dataOf(this, op);
    const at = finite(op, "t", t);
    const slot = data.resident(op);
    return derived(call(op, (kernel) => kernel.insert(slot, at)));
  }

  /** Four generalised Bézier points per segment, eight numbers each; each segment lies in the hull of its four. */
  bezierPoints(): Float64Array {
    const op = "bezierPoints";
    const slot = dataOf(this, op).resident(op);
    return copy(call(op, (kernel) => kernel.bezier_points(slot)));
  }
}

/** Points in one block of a bulk call: 64 kB, which stay in the cache between the kernel and the copy. */
const BLOCK = 4096;

/** The curve that the kernel left in its output. */
function derived(count: number): HermiteCurve {
  const [data] = readCurves(count);
  return curveOf(data as CurveData);
}

/** The arrays of a curve that a caller describes, checked. */
function given(options: unknown): CurveData {
  const names = ["points", "tangents", "tangentsIn", "closed", "space", "omega", "lengths"] as const;
  const own = checkOptions(CURVE, options, names);
  const points = checkPoints(CURVE, "points", own.points);
  const closed = flag(CURVE, "closed", own.closed, true);
  const segments = points.length / 2 - (closed ? 0 : 1);
  const data = new CurveData(
    points,
    sameLength("tangents", checkPoints(CURVE, "tangents", own.tangents), points.length),
    own.tangentsIn === undefined
      ? new Float64Array()
      : sameLength("tangentsIn", checkPoints(CURVE, "tangentsIn", own.tangentsIn), points.length),
    own.omega === undefined ? new Float64Array() : frequencies(own.omega),
    own.lengths === undefined ? new Float64Array() : sameLength("lengths", finites("lengths", own.lengths), segments),
    own.space === undefined ? "trigonometric" : word(CURVE, "space", own.space, SPACES),
    closed,
  );
  data.load(CURVE);
  return data;
}

function sameLength(arg: string, array: Floats, length: number): Floats {
  if (array.length !== length) throw wrongLength(CURVE, arg, array.length, String(length));
  return array;
}

function frequencies(value: unknown): Floats {
  return typeof value === "number" ? Float64Array.of(finite(CURVE, "omega", value)) : finites("omega", value);
}

function finites(arg: string, value: unknown): Floats {
  const array = numbers(CURVE, arg, value, "maxPoints", 1_000_000);
  array.forEach((number, i) => finite(CURVE, arg, number, i));
  return array;
}

/** One number per segment, from the short form. */
function each(data: CurveData, name: "omega" | "lengths"): Float64Array {
  const short = data[name];
  return short.length > 1 ? short.slice() : new Float64Array(data.segments).fill(short[0] ?? 1);
}

/** Overwrites an array of the curve with another one of the same length. */
function replace(data: CurveData, arg: string, array: Floats, value: unknown): void {
  const next = sameLength(arg, checkPoints(CURVE, arg, value), array.length);
  array.set(next);
  data.touch();
}
