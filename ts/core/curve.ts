/** What can be asked of every curve: points, lengths, areas, distances, and its outline as an SVG path. */
import {
  MAX_EVALUATIONS,
  MAX_OUTPUT,
  type MatrixLike,
  type PointsLike,
  type SpacePointsLike,
  coordinate,
  count as checkCount,
  finite,
  flag,
  integer,
  isFloat64Array,
  oneOr,
  options as checkOptions,
  output,
  parameters,
  points as checkPoints,
  tolerance as checkTolerance,
} from "./arguments.js";
import type { Bounds, Curve, Ellipse, Nearest, PathOptions } from "./contract.js";
import { HeldCurve } from "./curve-data.js";
import { ExplineError, degenerate, wrong } from "./error.js";
import type { CurveKernel } from "./engine.js";
import type { PathObject } from "./host.js";
import { outputText, result } from "./kernel.js";

/**
 * Points in one block of a bulk call: 128 kB, which stay in the second cache; shorter copies wait for memory more
 * often.
 */
const BLOCK = 8192;
/**
 * Of so many points as take megabytes anyway, 2 MB at a time: long copies wait for memory less than the cache is worth.
 */
const LONG = 2 ** 18;
const LONG_BLOCK = 2 ** 17;
/** Stands for "the kernel's default" where a tolerance is expected. */
const BY_DEFAULT = 0;

/** The arrays of a curve, and the proof that it is one, of the kind that is asked for. @internal */
export let dataOf: <D extends HeldCurve = HeldCurve>(curve: MeasuredCurve, op: string, kind?: Kind<D>, arg?: string) => D;

type Kind<D extends HeldCurve> = abstract new (...parts: never[]) => D;

/** A curve of any kind, in the plane or in space. */
export abstract class MeasuredCurve implements Curve {
  readonly #data: HeldCurve;

  static {
    dataOf = <D extends HeldCurve>(curve: MeasuredCurve, op: string, kind?: Kind<D>, arg = "this"): D => {
      if (typeof curve !== "object" || curve === null || !(#data in curve) || !(curve.#data instanceof (kind ?? HeldCurve))) {
        throw wrong("E_TYPE", op, arg, curve, "a curve of this package, no proxy");
      }
      return curve.#data as D;
    };
  }

  /** @internal */
  constructor(data: HeldCurve) {
    this.#data = data;
  }

  /**
   * A curve is no plain object, and says so: Vue wraps those in proxies, through which private fields cannot be
   * reached. Consoles show it.
   * @internal
   */
  get [Symbol.toStringTag](): string {
    return this.constructor.name;
  }

  /** Whether the last point is joined to the first. */
  get closed(): boolean {
    return dataOf(this, "closed").closed;
  }

  /** First and last parameter. */
  get domain(): readonly [number, number] {
    const { start, end } = dataOf(this, "domain");
    return [start, end];
  }

  /** 2 for a curve of the plane, 3 in space. */
  get dimension(): 2 | 3 {
    return dataOf(this, "dimension").dimension;
  }

  /**
   * Points, or derivatives with respect to the parameter, at one or many parameters: all coordinates in turn.
   *
   * Hermite curves have derivatives to order 2, others to one less than they have roots, but at least 2. Where a
   * derivative jumps it is that of the segment that starts there. A closed curve takes any t.
   *
   * @param out - where the numbers go, if not into a new array; it may be longer than needed.
   * @throws {ExplineError} E_RANGE of `t` outside the domain of an open curve, of `derivative` above the highest order;
   *   E_LENGTH of an `out` that is too short.
   * @example
   * ```js
   * const circle = HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 2 });
   * const [x, y] = circle.evaluate(0.5); // a point
   * const places = circle.evaluate([0, 0.5, 1]); // three points: x0, y0, x1, y1, x2, y2
   * const [dx, dy] = circle.evaluate(0.5, 1); // the tangent there
   * console.log(Math.hypot(x, y).toFixed(12), places.length); // → 5.000000000000 6
   * console.log((x * dx + y * dy).toFixed(12)); // → 0.000000000000
   * ```
   */
  evaluate(t: number | Float64Array | readonly number[], derivative = 0, out?: Float64Array): Float64Array {
    const op = "evaluate";
    const data = dataOf(this, op);
    const each = data.dimension;
    const order = derivative === 0 ? 0 : integer(op, "derivative", derivative, 0, data.orders);
    if (typeof t === "number") {
      const slot = data.resident(op);
      const to = out === undefined ? new Float64Array(each) : output(op, out, each);
      data.door.call(op, (kernel) => kernel.evaluate_one(slot, t, order), t);
      to[0] = data.door.result(0);
      to[1] = data.door.result(1);
      if (each === 3) to[2] = data.door.result(2);
      return to;
    }
    const given = parameters(op, "t", t);
    const to = out === undefined ? undefined : output(op, out, each * given.length, isFloat64Array(t) ? t : undefined);
    const count = data.ask(op, (kernel, slot) => kernel.evaluate_many(slot, given.length, order), given, [given]);
    if (to === undefined) return data.door.copy(count);
    to.set(data.door.peek(count));
    return to;
  }

  /**
   * `count` points spread uniformly over the parameter: at i/count of the domain of a closed curve, at i/(count − 1)
   * of an open one; all coordinates in turn. With `tangents` each point is followed by its derivative: x, y, dx/dt,
   * dy/dt.
   *
   * `out` is where the numbers go, if not into a new array; it may be longer than needed.
   *
   * @throws {ExplineError} E_RANGE of a `count` below 1, E_LIMIT above 4,000,000; E_LENGTH of an `out` that is too
   *   short.
   */
  sample(
    count: number,
    options?: { out?: Float64Array | undefined; tangents?: boolean | undefined },
  ): Float64Array {
    const op = "sample";
    const data = dataOf(this, op);
    const { out, tangents } = checkOptions(op, options, ["out", "tangents"]);
    const n = checkCount(op, "count", count, 1, "maxOutputPoints", MAX_OUTPUT);
    const both = flag(op, "tangents", tangents, false) ? 1 : 0;
    const each = data.dimension * (1 + both);
    const all = out === undefined ? new Float64Array(each * n) : output(op, out, each * n);
    const slot = data.resident(op);
    const block = n < LONG ? BLOCK : LONG_BLOCK;
    for (let at = 0; at < each * n; ) {
      // As many as the kernel likes to make at a time.
      const first = at / each;
      const numbers = data.door.call(op, (kernel) => kernel.sample(slot, n, first, Math.min(block, n - first), both));
      all.set(data.door.peek(numbers), at);
      at += numbers;
    }
    return all;
  }

  /**
   * `count` points at equal distances along the curve, all coordinates in turn; a closed one does not repeat its start.
   * `tolerance` is that of the lengths, in the user's unit; default 1e-9 of the curve's size.
   *
   * @throws {ExplineError} E_RANGE of a `count` below 1 or a `tolerance` that is not above 0, E_LIMIT of a `count`
   *   above 4,000,000.
   */
  sampleByLength(count: number, options?: { tolerance?: number | undefined }): Float64Array {
    const op = "sampleByLength";
    const data = dataOf(this, op);
    const { tolerance } = checkOptions(op, options, ["tolerance"]);
    const within = orDefault(op, tolerance);
    const n = checkCount(op, "count", count, 1, "maxOutputPoints", MAX_OUTPUT);
    return data.door.copy(data.ask(op, (kernel, slot) => kernel.sample_by_length(slot, n, within)));
  }

  /**
   * The length of the curve, to a tolerance in the user's unit; default 1e-9 of its size.
   *
   * @throws {ExplineError} E_RANGE of a `tolerance` that is not above 0.
   */
  length(tolerance?: number): number {
    const op = "length";
    const within = orDefault(op, tolerance);
    return measure(dataOf(this, op), op, (kernel, slot) => kernel.length(slot, within));
  }

  /**
   * The parameter up to which the curve has the given length: from 0 to its own, of a closed curve no more than one
   * round. `tolerance` is that of the length, in the user's unit; default 1e-9 of the curve's size.
   *
   * @throws {ExplineError} E_RANGE of a `length` below 0 or above the curve's own, by more than the tolerance.
   */
  parameterAtLength(length: number, tolerance?: number): number {
    const op = "parameterAtLength";
    const along = finite(op, "length", length);
    const within = orDefault(op, tolerance);
    return measure(dataOf(this, op), op, (kernel, slot) => kernel.parameter_at_length(slot, along, within));
  }

  /**
   * The signed area of a closed curve, positive where it turns from the x axis towards the y axis.
   *
   * @throws {ExplineError} E_DEGENERATE for an open curve, or one in space.
   */
  area(): number {
    return measure(dataOf(this, "area"), "area", (kernel, slot) => kernel.area(slot));
  }

  /**
   * The centre of gravity of the area of a closed curve.
   *
   * @throws {ExplineError} E_DEGENERATE for an open curve, one in space, or one whose area is 0.
   */
  centroid(): { x: number; y: number } {
    const data = dataOf(this, "centroid");
    const x = measure(data, "centroid", (kernel, slot) => kernel.centroid(slot));
    return { x, y: data.door.result(1) };
  }

  /** The smallest rectangle, in space the smallest box, around the curve itself, not around its handles. */
  bounds(): Bounds {
    const data = dataOf(this, "bounds");
    const { result } = data.door;
    const minX = measure(data, "bounds", (kernel, slot) => kernel.bounds(slot));
    const plane = { minX, minY: result(1), maxX: result(2), maxY: result(3) };
    return data.dimension === 2 ? plane : { ...plane, minZ: result(4), maxZ: result(5) };
  }

  /**
   * The point of the curve that is nearest to (x, y), in space to (x, y, z); of several the one that the curve reaches
   * first. No point is nearer by more than 2e-13 of the curve's size.
   *
   * @throws {ExplineError} E_RANGE of a coordinate beyond ±1e9; E_TYPE where a curve in space is asked without `z`.
   * @example
   * ```js
   * const circle = HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 4 });
   * const { t, x, y, distance } = circle.nearest(0, 8);
   * console.log(t.toFixed(3), x.toFixed(3), y.toFixed(3), distance.toFixed(3)); // → 1.000 0.000 5.000 3.000
   * ```
   */
  nearest(x: number, y: number, z?: number): Nearest {
    const op = "nearest";
    const toX = coordinate(op, "x", x);
    const toY = coordinate(op, "y", y);
    const data = dataOf(this, op);
    const { result } = data.door;
    const toZ = data.dimension === 3 ? coordinate(op, "z", z) : 0;
    const t = measure(data, op, (kernel, slot) => kernel.nearest(slot, toX, toY, toZ));
    const found = { t, x: result(1), y: result(2), distance: result(3) };
    return data.dimension === 2 ? found : { ...found, z: result(3), distance: result(4) };
  }

  /** The nearest point to each of many places: t, x, y, in space z, and distance in turn. */
  nearestAll(places: PointsLike | SpacePointsLike): Float64Array {
    const op = "nearestAll";
    const data = dataOf(this, op);
    const given = checkPoints(op, "places", places, MAX_EVALUATIONS / 2, data.dimension, "maxEvalPoints");
    const count = given.length / data.dimension;
    return data.door.copy(data.ask(op, (kernel, slot) => kernel.nearest_many(slot, count), given, [given]));
  }

  /**
   * The signed curvature at one or many parameters, in 1 per unit; positive where the curve turns from the x axis
   * towards the y axis; without a sign in space.
   *
   * @throws {ExplineError} E_DEGENERATE where the speed is zero; `partial` then holds the values, with 0 at such
   *   places. E_RANGE of `t` outside the domain of an open curve.
   */
  curvature(t: number | Float64Array | readonly number[]): Float64Array {
    const op = "curvature";
    const data = dataOf(this, op);
    const given = parameters(op, "t", t);
    const values = data.door.copy(data.ask(op, (kernel, slot) => kernel.curvature(slot, given.length), oneOr(t, given), [given]));
    const still = data.door.result(0);
    if (still >= 0) throw degenerate(op, "t", "the speed is zero there", typeof t === "number" ? undefined : still, undefined, values);
    return values;
  }

  /**
   * A polyline that is nowhere farther from the curve than `tolerance`: all coordinates in turn; a closed one does not
   * repeat its start. A tolerance below 1e-9 of the curve's extent, or 1e-15 of its largest coordinate, counts as that.
   *
   * @throws {ExplineError} E_RANGE of a `tolerance` that is not above 0; E_LIMIT where it would take more than
   *   4,000,000 points.
   */
  flatten(tolerance: number): Float64Array {
    const op = "flatten";
    const data = dataOf(this, op);
    const within = checkTolerance(op, tolerance);
    return data.door.copy(data.ask(op, (kernel, slot) => kernel.flatten(slot, within)));
  }

  /**
   * Cubic Béziers within `tolerance`, eight numbers each (twelve in space), as few as it takes; `maxError` is a proved
   * bound of the distance. A tolerance below 1e-9 of the curve's extent, or 1e-15 of its largest coordinate, counts as
   * that.
   *
   * @throws {ExplineError} E_RANGE of a `tolerance` that is not above 0; E_LIMIT where it would take more than
   *   4,000,000 points.
   */
  toCubics(tolerance: number): { path: Float64Array; maxError: number } {
    const op = "toCubics";
    const data = dataOf(this, op);
    const within = checkTolerance(op, tolerance);
    const path = data.door.copy(data.ask(op, (kernel, slot) => kernel.to_cubics(slot, within)));
    return { path, maxError: data.door.result(0) };
  }

  /**
   * The curve as SVG path data: lines and, by default, arcs as they are, all else as cubics; `maxError` is the distance
   * that results.
   *
   * @throws {ExplineError} E_DEGENERATE for a curve in space; E_RANGE of a `tolerance` that is not above 0, of
   *   `decimals` outside 0 to 17, and of a curve whose path would have a Bézier point beyond ±1e9.
   * @example
   * ```js
   * const circle = HermiteCurve.ellipse({ center: [10, 10], radii: [8, 8], count: 4 });
   * console.log(circle.toPathD().d); // → M18 10A8 8 0 0 1 2 10 8 8 0 0 1 18 10Z
   * ```
   */
  toPathD(options?: PathOptions): { d: string; maxError: number } {
    const op = "toPathD";
    const curve = dataOf(this, op);
    const { tolerance, decimals, arcs, relative } = checkOptions(op, options, ["tolerance", "decimals", "arcs", "relative"]);
    const within = orDefault(op, tolerance);
    const digits = decimals === undefined ? -1 : integer(op, "decimals", decimals, 0, 17);
    const flags = (flag(op, "arcs", arcs, true) ? 1 : 0) + (flag(op, "relative", relative, false) ? 2 : 0);
    const { data, near, rest } = curve.outline(op, within);
    const d = outputText(data.ask(op, (kernel, slot) => kernel.to_path(slot, rest, digits, flags)));
    return { d, maxError: near + result(0) };
  }

  /**
   * The curve as a `Path2D`, in browsers.
   *
   * @throws {ExplineError} E_UNSUPPORTED where there is no `Path2D`.
   */
  toPath2D(options?: PathOptions): PathObject {
    const { d } = this.toPathD(options);
    if (typeof Path2D !== "function") {
      throw new ExplineError("E_UNSUPPORTED", "toPath2D", "there is no Path2D in this environment");
    }
    return new Path2D(d);
  }

  /**
   * The one ellipse, or the arc of one, that all segments are arcs of, each within `tolerance` (default 1e-9 of its
   * size); undefined where they are not. Only trigonometric segments can be: no cubic is an arc, however near one it
   * runs, and of interpolating and B-spline curves those whose roots are 0, at most twice, and ±iω.
   *
   * @throws {ExplineError} E_RANGE of a `tolerance` that is not above 0.
   */
  asEllipse(tolerance?: number): Ellipse | undefined {
    const op = "asEllipse";
    const within = orDefault(op, tolerance);
    const data = dataOf(this, op).exactly(op);
    if (data === undefined) return undefined;
    if (data.ask(op, (kernel, slot) => kernel.as_ellipse(slot, within)) === 0) return undefined;
    return {
      center: [result(0), result(1)],
      radii: [result(2), result(3)],
      rotation: result(4),
      start: result(5),
      sweep: result(6),
    };
  }

  /** The image under an affine map: six numbers in the plane, 16 in space. */
  abstract transform(matrix: MatrixLike): MeasuredCurve;

  /** The curve as plain data, for files and other threads; `fromJSON` is the inverse to the last bit. */
  abstract toJSON(): object;
}

/** One number that the kernel leaves in its record, where more may follow. */
function measure(data: HeldCurve, op: string, body: (kernel: CurveKernel, slot: number) => number): number {
  data.ask(op, body);
  return data.door.result(0);
}

function orDefault(op: string, tolerance: unknown): number {
  return tolerance === undefined ? BY_DEFAULT : checkTolerance(op, tolerance);
}

/** Curves as one path, with relative commands where they are shorter. @internal */
export function pathsOf(op: string, curves: readonly MeasuredCurve[], tolerance: number, decimals: number): string {
  return curves
    .map((curve, i) => {
      const { data, rest } = dataOf(curve, op).outline(op, tolerance);
      return outputText(data.ask(op, (kernel, slot) => kernel.to_path(slot, rest, decimals, i === 0 ? 3 : 7)));
    })
    .join("");
}
