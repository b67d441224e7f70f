/** Hermite exponential curves: points on the curve, with the derivatives that arrive and leave. */
import { affine } from "./affine.js";
import {
  LARGEST,
  MAX_OUTPUT,
  MAX_POINTS,
  type MatrixLike,
  type PointsLike,
  coordinate,
  count as checkCount,
  finite,
  flag,
  inRange,
  integer,
  options as checkOptions,
  points as checkPoints,
  word,
} from "./arguments.js";
import { CurveData, SPACES, type Space, curvesIn } from "./curve-data.js";
import { MeasuredCurve, dataOf as anyDataOf } from "./curve.js";
import { type EllipseOptions, type HermiteCurveOptions, asMany, checked, frame, spaceOf } from "./hermite-arguments.js";
import { type HermiteCurveJSON, curveJSON } from "./hermite-json.js";
import { type Floats, call, copy, peek, result, write } from "./kernel.js";

const CURVE = "HermiteCurve";

/** The arrays of a Hermite curve, and the proof that it is one. */
function dataOf(curve: HermiteCurve, op: string): CurveData {
  return anyDataOf(curve, op, CurveData);
}

/** A curve through its points, with the derivatives there: exact for ellipses, cubics and lines alike. */
export class HermiteCurve extends MeasuredCurve {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static override readonly name = CURVE;

  /**
   * A curve from points and tangents. The arrays are copied.
   *
   * @throws {ExplineError} for whatever is wrong with the options; nothing is made then.
   */
  constructor(options: HermiteCurveOptions) {
    super(options instanceof CurveData ? options : checked(CURVE, options));
  }

  /**
   * An ellipse from `count` points, exact for every count from 2 up.
   *
   * @throws {ExplineError} E_TOO_FEW_POINTS for a `count` below 2, E_LIMIT above 1,000,000; E_RANGE of `radii` that are
   *   not above 0.
   * @example
   * ```js
   * const circle = HermiteCurve.ellipse({ center: [120, 120], radii: [80, 80], count: 2 });
   * console.log((circle.area() / (Math.PI * 80 * 80)).toFixed(14), circle.domain); // → 1.00000000000000 [ 0, 2 ]
   * ```
   */
  static ellipse(options: EllipseOptions & { count: number }): HermiteCurve {
    const op = `${CURVE}.ellipse`;
    const { center, radii, rotation, count } = checkOptions(op, options, ["center", "radii", "rotation", "count"]);
    const [x, y, rx, ry, angle] = frame(op, center, radii, rotation);
    // Too few points are an error of their own, which the kernel has.
    const n = count === 0 || count === 1 ? count : checkCount(op, "count", count, 2, "maxPoints", MAX_POINTS);
    return derived(call(op, (kernel) => kernel.ellipse(x, y, rx, ry, angle, n)));
  }

  /**
   * An open arc of an ellipse: from angle `start` over `sweep`, in radians from the first axis; negative runs
   * backwards.
   *
   * @throws {ExplineError} E_DEGENERATE of a `sweep` of 0, E_RANGE beyond ±2π.
   */
  static arc(options: EllipseOptions & { start: number; sweep: number }): HermiteCurve {
    const op = `${CURVE}.arc`;
    const names = ["center", "radii", "rotation", "start", "sweep"] as const;
    const { center, radii, rotation, start, sweep } = checkOptions(op, options, names);
    const [x, y, rx, ry, angle] = frame(op, center, radii, rotation);
    const from = finite(op, "start", start);
    const over = finite(op, "sweep", sweep);
    return derived(call(op, (kernel) => kernel.arc(x, y, rx, ry, angle, from, over)));
  }

  /**
   * The smooth curve through points: twice continuously differentiable wherever such a curve exists.
   *
   * `closed` defaults to true, `space` to "trigonometric", `omega` to that of the constructor: points that lie evenly
   * on an ellipse then give the ellipse.
   *
   * @throws {ExplineError} E_TOO_FEW_POINTS below two points, E_LIMIT above 1,000,000; E_RANGE of `omega` that the
   *   space does not have.
   * @example
   * ```js
   * const wave = HermiteCurve.through([[0, 0], [10, 8], [20, 0], [30, -8]], { closed: false });
   * console.log(wave.evaluate(1), wave.domain); // → Float64Array(2) [ 10, 8 ] [ 0, 3 ]
   * ```
   */
  static through(
    points: PointsLike,
    options?: { closed?: boolean | undefined; omega?: number | undefined; space?: Space | undefined },
  ): HermiteCurve {
    const op = `${CURVE}.through`;
    const own = checkOptions(op, options, ["closed", "omega", "space"]);
    const given = checkPoints(op, "points", points);
    const closed = flag(op, "closed", own.closed, true) ? 1 : 0;
    // How large it may be is for the kernel to say.
    const omega = own.omega === undefined ? -1 : inRange(op, "omega", own.omega, 0, Infinity) + 0;
    const space = SPACES.indexOf(spaceOf(op, own.space));
    write(op, given);
    return derived(call(op, (kernel) => kernel.through(given.length / 2, closed, omega, space), { omega }));
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
    data.points.set(asMany(data, "points", value));
    data.touch();
  }

  /** dr/dt leaving each point: a copy. Setting them leaves those that arrive as they are. */
  get tangents(): Float64Array {
    return dataOf(this, "tangents").tangents.slice();
  }

  set tangents(value: PointsLike) {
    const data = dataOf(this, "tangents");
    const next = asMany(data, "tangents", value);
    data.separate();
    data.tangents.set(next);
    data.touch();
  }

  /** dr/dt arriving at each point: a copy. Setting them leaves those that leave as they are. */
  get tangentsIn(): Float64Array {
    const { tangents, tangentsIn } = dataOf(this, "tangentsIn");
    return (tangentsIn.length === 0 ? tangents : tangentsIn).slice();
  }

  set tangentsIn(value: PointsLike) {
    const data = dataOf(this, "tangentsIn");
    data.tangentsIn = asMany(data, "tangentsIn", value);
    data.touch();
  }

  /**
   * Moves point i, counted from 0; its tangents stay.
   *
   * @throws {ExplineError} E_RANGE of an `i` that is no point's, and of coordinates beyond ±1e9.
   */
  setPoint(i: number, x: number, y: number): void {
    const op = "setPoint";
    const data = dataOf(this, op);
    const at = 2 * integer(op, "i", i, 0, data.points.length / 2 - 1);
    const place = [coordinate(op, "x", x), coordinate(op, "y", y)];
    data.points.set(place, at);
    data.touch();
  }

  /**
   * Sets dr/dt at point i, per unit of the parameter, on one side or, by default, on both. A cubic's handle is a third
   * of it, times the length of the segment.
   *
   * @throws {ExplineError} E_RANGE of an `i` that is no point's, of numbers beyond ±8e9, and of any other `side`.
   */
  setTangent(i: number, dx: number, dy: number, side: "in" | "out" | "both" = "both"): void {
    const op = "setTangent";
    const data = dataOf(this, op);
    const at = 2 * integer(op, "i", i, 0, data.points.length / 2 - 1);
    const tangent = [coordinate(op, "dx", dx), coordinate(op, "dy", dy)];
    const which = word(op, "side", side, ["in", "out", "both"]);
    if (which !== "both") data.separate();
    if (which !== "in") data.tangents.set(tangent, at);
    if (which !== "out" && data.tangentsIn.length > 0) data.tangentsIn.set(tangent, at);
    data.touch();
  }

  /**
   * The same curve with `arity` segments, by default 2, in place of each; the parameter stays, the end of the domain to
   * a rounding. The shape stays to rounding, which beside a segment of nearly a full turn, ω·length = 2π − ε, is
   * 5e-16/ε of its size; so it does in `insert`.
   *
   * @throws {ExplineError} E_RANGE of an `arity` below 1, and of `points` where the curve goes beyond ±1e9; E_LIMIT
   *   where there would be more than 4,000,000 points.
   */
  refine(arity = 2): HermiteCurve {
    const op = "refine";
    const data = dataOf(this, op);
    const m = checkCount(op, "arity", arity, 1, "maxOutputPoints", MAX_OUTPUT);
    return derived(data.ask(op, (kernel, slot) => kernel.refine(slot, m)));
  }

  /**
   * The same curve with one more point, at parameter t: in segment k it becomes point k + 1. Every place keeps its
   * parameter. Where a point is already, none is added.
   *
   * @throws {ExplineError} E_RANGE of `t` outside the domain of an open curve, and of `points` where the curve is
   *   beyond ±1e9 at t; likewise `split` and `trim`.
   */
  insert(t: number): HermiteCurve {
    const op = "insert";
    const data = dataOf(this, op);
    const at = finite(op, "t", t);
    return derived(data.ask(op, (kernel, slot) => kernel.insert(slot, at)));
  }

  /**
   * The curve without point i: its neighbours' tangents keep their directions and get lengths with which the shape
   * changes nearly as little as it can. `maxError` is by how much it changed, measured at 97 places of each segment and
   * on from there to where it is largest. An end of an open curve goes with its segment.
   *
   * @throws {ExplineError} E_RANGE of an `i` that is no point's; E_TOO_FEW_POINTS where only two points are left.
   * @example
   * ```js
   * const circle = HermiteCurve.ellipse({ center: [0, 0], radii: [80, 80], count: 4 });
   * const { curve, maxError } = circle.insert(0.3).remove(1);
   * console.log(curve.points.length / 2, maxError < 1e-12); // → 4 true
   * ```
   */
  remove(i: number): { curve: HermiteCurve; maxError: number } {
    const op = "remove";
    const data = dataOf(this, op);
    const at = integer(op, "i", i, 0, data.points.length / 2 - 1);
    const count = data.ask(op, (kernel, slot) => kernel.remove(slot, at));
    return { maxError: result(0), curve: derived(count) };
  }

  /**
   * The two parts of an open curve, cut at t, or the curve alone where t is one of its ends; a closed curve gives one,
   * opened at t. Their parameters begin at 0.
   *
   * @throws {ExplineError} E_RANGE of `t` outside the domain of an open curve.
   */
  split(t: number): [HermiteCurve] | [HermiteCurve, HermiteCurve] {
    const op = "split";
    const data = dataOf(this, op);
    const at = finite(op, "t", t);
    return curvesIn(peek(data.ask(op, (kernel, slot) => kernel.split(slot, at)))).map(curveOf) as ReturnType<HermiteCurve["split"]>;
  }

  /**
   * The part from parameter t0 to t1, open. On a closed curve it runs forward from t0 to the next place where t is t1,
   * across the start if need be: all the way round where both are one place, and never further.
   *
   * @throws {ExplineError} E_DEGENERATE of a `t1` that is less than 1e-12 beyond `t0`, on an open curve also before it;
   *   E_RANGE of parameters outside the domain of an open curve.
   */
  trim(t0: number, t1: number): HermiteCurve {
    const op = "trim";
    const data = dataOf(this, op);
    const from = finite(op, "t0", t0);
    const to = finite(op, "t1", t1);
    return derived(data.ask(op, (kernel, slot) => kernel.trim(slot, from, to), { t0: from, t1: to }));
  }

  /** The same curve run backwards. */
  reverse(): HermiteCurve {
    const op = "reverse";
    return derived(dataOf(this, op).ask(op, (kernel, slot) => kernel.reverse(slot)));
  }

  /**
   * The image under x′ = a·x + c·y + e, y′ = b·x + d·y + f, the order of SVG's `matrix(a b c d e f)`; exact to
   * rounding.
   *
   * @throws {ExplineError} E_LENGTH of a `matrix` that has not 6 numbers; E_RANGE of one that takes a point beyond
   *   ±1e9.
   */
  transform(matrix: MatrixLike): HermiteCurve {
    const op = "transform";
    const { points, tangents, tangentsIn, omega, lengths, space, closed, end } = dataOf(this, op);
    const image = affine(op, matrix, 2);
    const turned = (list: Floats): Floats => image(list, 8 * LARGEST, 0);
    const data = new CurveData(image(points), turned(tangents), turned(tangentsIn), omega, lengths, space, closed);
    data.end = end;
    return curveOf(data);
  }

  /**
   * The polygon after `levels` steps of a subdivision scheme, x and y in turn.
   *
   * `arity` defaults to 2; `scheme` "hermite" (the default) has its points on the curve, "scalar" near it. At most 24
   * levels.
   *
   * @throws {ExplineError} E_RANGE of `levels` outside 0 to 24, E_LIMIT where there would be more than 4,000,000
   *   points.
   */
  subdivide(
    levels: number,
    options?: { arity?: number | undefined; scheme?: "hermite" | "scalar" | undefined },
  ): Float64Array {
    const op = "subdivide";
    const data = dataOf(this, op);
    const { arity = 2, scheme = "hermite" } = checkOptions(op, options, ["arity", "scheme"]);
    const steps = integer(op, "levels", levels, 0, 24);
    const m = checkCount(op, "arity", arity, 1, "maxOutputPoints", MAX_OUTPUT);
    const scalar = word(op, "scheme", scheme, ["hermite", "scalar"]) === "scalar" ? 1 : 0;
    return copy(data.ask(op, (kernel, slot) => kernel.subdivide(slot, steps, m, scalar)));
  }

  /** Four generalised Bézier points per segment, eight numbers each; a segment lies in the hull of its four. */
  bezierPoints(): Float64Array {
    const op = "bezierPoints";
    return copy(dataOf(this, op).ask(op, (kernel, slot) => kernel.bezier_points(slot)));
  }

  /**
   * The curve as plain data, for files and for `postMessage`, which takes no curve; `fromJSON` is the inverse to the
   * last bit, of up to a million points.
   */
  toJSON(): HermiteCurveJSON {
    return curveJSON(dataOf(this, "toJSON"));
  }
}

/** Makes a curve of arrays that the kernel or a check has vouched for. @internal */
export function curveOf(data: CurveData): HermiteCurve {
  return new HermiteCurve(data as unknown as HermiteCurveOptions);
}

/** The curve that an engine describes. @internal */
export function curveIn(numbers: Float64Array): HermiteCurve {
  return curveOf(curvesIn(numbers)[0] as CurveData);
}

/** The curve that the kernel left in its output. */
function derived(count: number): HermiteCurve {
  return curveIn(peek(count));
}

/** One number per segment, from the short form. */
function each(data: CurveData, name: "omega" | "lengths"): Float64Array {
  const short = data[name];
  return short.length > 1 ? short.slice() : new Float64Array(data.segments).fill(short[0] ?? 1);
}
