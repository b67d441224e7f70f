/** B-spline curves of any roots: control points near the curve, as many as are wanted. */
import { type MatrixLike, type Root, exactly, finite, flag, integer, options as checkOptions, rootNumbers } from "../core.js";
import { type AnyPointsLike, SplineCurve, anyPoints, imageOf, plain, splineOf } from "./spline-curve.js";
import { SplineData, SplineKind, readSpline } from "./spline-data.js";
import { result } from "./spline-engine.js";

/** What a {@link BSplineCurve} is made from. */
export interface BSplineCurveOptions {
  /** Control points, at least 3 of a closed curve, as many as there are roots of an open one. */
  points: AnyPointsLike;
  /** 2 or 3 coordinates for each point. Default: what the points show; interleaved numbers are of the plane. */
  dimension?: 2 | 3 | undefined;
  /** Whether the last point is joined to the first. Default true. */
  closed?: boolean | undefined;
  /** Roots per unit of the parameter. */
  roots: readonly Root[];
  /** From one control point to the next, in units of the parameter, 1e-12 to 1e9. Default 1. */
  step?: number | undefined;
  /**
   * The parameter of control point 0. Default 0. A parameter that is large beside the step tells no places apart: 1e9
   * is rounded to 1e-7.
   */
  offset?: number | undefined;
  /**
   * Both ends of the parameter, within 1e-12 of what step and offset say. Default: just that; but a curve that was
   * refined keeps its `domain` to the last bit, which no rounded step can.
   */
  domain?: readonly [number, number] | undefined;
}

/** A {@link BSplineCurve} as plain data. Fields that a newer version wrote are kept. */
export interface BSplineCurveJSON {
  /** What it is. */
  type: "BSplineCurve";
  /** Of the format; a file of a newer one is refused. */
  version: 1;
  /** Whether the last point is followed by the first. */
  closed: boolean;
  /** Coordinates of each point. */
  dimension: 2 | 3;
  /** All coordinates of each point in turn. */
  points: number[];
  /** Per unit of the parameter. */
  roots: Root[];
  /** From one control point to the next, in units of the parameter. */
  step: number;
  /** The parameter of the first control point. */
  offset: number;
  /** Both ends of the parameter. Files of before 0.2 have none. */
  domain?: [number, number];
  [unknown: string]: unknown;
}

/**
 * A curve that weighs its control points by exponential B-splines, each divided by its integral: they lie near the
 * curve, and the finer the grid the nearer.
 */
export class BSplineCurve extends SplineCurve {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static override readonly name = "BSplineCurve";

  /**
   * A curve from control points. The arrays are copied.
   *
   * @throws {ExplineError} for whatever is wrong with the options; nothing is made then.
   */
  constructor(options: BSplineCurveOptions) {
    super(options instanceof SplineData ? options : checkedBSpline("BSplineCurve", options));
  }

  /** From one control point to the next, in units of the parameter. */
  get step(): number {
    return splineOf(this, "step").step;
  }

  /** The parameter of control point 0. */
  get offset(): number {
    return splineOf(this, "offset").offset;
  }

  /**
   * The same curve with m times the control points, by default twice, m from 1 to 1024; same `domain`.
   *
   * @throws {ExplineError} E_RANGE of any other m, E_LIMIT where there would be more than 4,000,000 points.
   */
  refine(m = 2): BSplineCurve {
    const op = "refine";
    const data = splineOf(this, op);
    const arity = integer(op, "m", m, 1, 1024);
    return bSplineOf(readSpline(data.ask(op, (kernel, slot) => kernel.refine_spline(slot, 1, 2, arity))));
  }

  /**
   * The curve on the grid that is coarser by m, by default 2, whose refinement has the control points nearest to these,
   * and the largest distance between the two, parameter by parameter, to about 3e-3 of itself: 0 to rounding where
   * nothing was changed since `refine(m)`.
   *
   * @throws {ExplineError} E_DEGENERATE of an m that does not divide the number of cells, E_RANGE of one outside 1
   *   to 1024.
   */
  reduce(m = 2): { curve: BSplineCurve; maxError: number } {
    const op = "reduce";
    const data = splineOf(this, op);
    const arity = integer(op, "m", m, 1, 1024);
    const count = data.ask(op, (kernel, slot) => kernel.reduce_spline(slot, arity), { m: arity });
    return { maxError: result(0), curve: bSplineOf(readSpline(count)) };
  }

  /**
   * The image under an affine map: of a plane curve x′ = a·x + c·y + e, y′ = b·x + d·y + f with the six numbers of
   * SVG's `matrix(a b c d e f)`, of one in space that of a 4 × 4 matrix, 16 numbers column by column, whose last row is
   * 0, 0, 0, 1. Exact to rounding.
   *
   * @throws {ExplineError} E_DEGENERATE of `matrix` for a translation where 0 is not among the roots: no points make
   *   the image then.
   */
  transform(matrix: MatrixLike): BSplineCurve {
    return bSplineOf(imageOf(this, matrix));
  }

  /**
   * The curve as plain data, for files and for `postMessage`, which takes no curve; `fromJSON` is the inverse to the
   * last bit, of up to a million points.
   */
  toJSON(): BSplineCurveJSON {
    const data = splineOf(this, "toJSON");
    const { step, offset, start, end, extra } = data;
    return { type: "BSplineCurve", ...plain(data), step, offset, domain: [start, end], ...extra };
  }
}

/** Makes a curve of arrays that the kernel or a check has vouched for. @internal */
export function bSplineOf(data: SplineData): BSplineCurve {
  return new BSplineCurve(data as unknown as BSplineCurveOptions);
}

/** The arrays of a curve that a caller or a file describes, checked. @internal */
export function checkedBSpline(op: string, options: unknown): SplineData {
  const { step = 1, offset = 0, ...own } = checkOptions(op, options, ["points", "dimension", "closed", "roots", "step", "offset", "domain"]);
  const { points, dimension } = anyPoints(op, own.points, own.dimension);
  const data = new SplineData(
    SplineKind.BSpline,
    points,
    dimension,
    flag(op, "closed", own.closed, true),
    rootNumbers(op, own.roots),
    finite(op, "step", step),
    finite(op, "offset", offset) + 0,
  );
  if (own.domain !== undefined) {
    const [start, end] = exactly(op, "domain", own.domain, 2);
    data.start = finite(op, "domain", start, 0) + 0;
    data.end = finite(op, "domain", end, 1) + 0;
  }
  data.load(op);
  return data;
}
