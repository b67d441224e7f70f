/** Curves through their points, smooth to any order, on which every point acts near by only. */
import { BSplineCurve, bSplineOf } from "./b-spline-curve.js";
import { type MatrixLike, type Root, integer, options as checkOptions, wrong } from "../core.js";
import { type LocalCurve, checkedLocal, refinedAt } from "./local-curve.js";
import { type AnyPointsLike, SplineCurve, imageOf, plain, splineOf } from "./spline-curve.js";
import { SplineData, SplineKind, readSpline } from "./spline-data.js";
import { result } from "./spline-engine.js";

/** What an {@link InterpolatingCurve} is made from. */
export interface InterpolatingCurveOptions {
  /** Points on the curve, at least 3 of a closed curve, 2 of an open one. */
  points: AnyPointsLike;
  /** 2 or 3 coordinates for each point. Default: what the points show; interleaved numbers are of the plane. */
  dimension?: 2 | 3 | undefined;
  /** Whether the last point is joined to the first. Default true. */
  closed?: boolean | undefined;
  /**
   * Roots per unit of the parameter, with their conjugates and opposites. Default: 0 and ±2πi/M of a closed curve of M
   * points, which keep ellipses; four times 0, which keep cubics, of an open one.
   */
  roots?: readonly Root[] | undefined;
}

/** An {@link InterpolatingCurve} as plain data. Fields that a newer version wrote are kept. */
export interface InterpolatingCurveJSON {
  /** What it is. */
  type: "InterpolatingCurve";
  /** Of the format; a file of a newer one is refused. */
  version: 1;
  /** Whether the last point is followed by the first. */
  closed: boolean;
  /** Coordinates of each point. */
  dimension: 2 | 3;
  /** All coordinates of each point in turn. */
  points: number[];
  /** What the curve reproduces. */
  roots: Root[];
  [unknown: string]: unknown;
}

/**
 * A curve through its points, point i at parameter i. With n₀ roots it has n₀ − 2 continuous derivatives, and a point
 * acts on n₀ − 1 segments to each side, on nothing else.
 *
 * It is right to 1e-14 of the points' size, times 1 + Σ|λ|; the ends of an open curve with 0 and large real roots ±a to
 * 1e-16·e^((n₀ − 3)a), which is 2e-11 for 0, 0, ±12, and what `refine` makes of them to a hundred times that.
 */
export class InterpolatingCurve extends SplineCurve {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static override readonly name = "InterpolatingCurve";

  /**
   * A curve through points. The arrays are copied.
   *
   * @throws {ExplineError} for whatever is wrong with the options; nothing is made then.
   */
  constructor(options: InterpolatingCurveOptions) {
    super(options instanceof SplineData ? options : checkedInterpolating("InterpolatingCurve", options));
  }

  /**
   * The same curve as control points of B-splines on the grid 1/(m0·m^(levels − 1)), levels from 1 to 24.
   *
   * `m0`, even, and `m` default to 2; both are at most 1024.
   *
   * @throws {ExplineError} E_RANGE of `levels` outside 1 to 24, E_DEGENERATE of an odd `m0`, E_LIMIT where there would
   *   be more than 4,000,000 points.
   * @example
   * ```js
   * const blob = new InterpolatingCurve({ points: [0, 0, 90, 20, 100, 110, 20, 90] });
   * const fine = blob.refine(2); // four times the control points, near the same curve
   * console.log(fine.points.length / 2, Math.abs(fine.length() - blob.length()) < 1e-9); // → 16 true
   * ```
   */
  refine(levels: number, options?: { m0?: number | undefined; m?: number | undefined }): BSplineCurve {
    const op = "refine";
    const data = splineOf(this, op);
    const { m0 = 2, m = 2 } = checkOptions(op, options, ["m0", "m"]);
    const steps = integer(op, "levels", levels, 1, 24);
    const first = integer(op, "m0", m0, 2, 1024);
    const arity = integer(op, "m", m, 1, 1024);
    return bSplineOf(readSpline(data.ask(op, (kernel, slot) => kernel.refine_spline(slot, steps, first, arity), { m0: first })));
  }

  /** The same curve with room for detail around t; see {@link LocalCurve.refineAt}. */
  refineAt(t: number, options?: { levels?: number | undefined; reach?: number | undefined }): LocalCurve {
    return refinedAt(splineOf(this, "refineAt"), t, options);
  }

  /**
   * The interpolating curve through the points that a B-spline curve has at the integers, and the largest distance
   * between the two: 0 to rounding where nothing was changed since `refine`.
   *
   * @throws {ExplineError} E_TYPE for a curve of another kind; E_DEGENERATE of `step` where the grid is no even part of
   *   a unit from 0 on, or one that no factors to 1024 make.
   */
  static from(curve: BSplineCurve): { curve: InterpolatingCurve; maxError: number } {
    const op = "InterpolatingCurve.from";
    if (!(curve instanceof BSplineCurve)) throw wrong("E_TYPE", op, "curve", curve, BSplineCurve.name);
    const count = splineOf(curve, op, "curve").ask(op, (kernel, slot) => kernel.reduce_spline(slot, 0));
    return { maxError: result(0), curve: interpolatingOf(readSpline(count)) };
  }

  /**
   * The image under an affine map: of a plane curve x′ = a·x + c·y + e, y′ = b·x + d·y + f with the six numbers of
   * SVG's `matrix(a b c d e f)`, of one in space that of a 4 × 4 matrix, 16 numbers column by column, whose last row is
   * 0, 0, 0, 1. Exact to rounding.
   *
   * @throws {ExplineError} E_DEGENERATE of `matrix` for a translation where 0 is not among the roots: no points make
   *   the image then.
   */
  transform(matrix: MatrixLike): InterpolatingCurve {
    return interpolatingOf(imageOf(this, matrix));
  }

  /**
   * The curve as plain data, for files and for `postMessage`, which takes no curve; `fromJSON` is the inverse to the
   * last bit, of up to a million points.
   */
  toJSON(): InterpolatingCurveJSON {
    const data = splineOf(this, "toJSON");
    return { type: "InterpolatingCurve", ...plain(data), ...data.extra };
  }
}

/** Makes a curve of arrays that a check has vouched for. @internal */
export function interpolatingOf(data: SplineData): InterpolatingCurve {
  return new InterpolatingCurve(data as unknown as InterpolatingCurveOptions);
}

/** The arrays of a curve that a caller or a file describes, checked. @internal */
export function checkedInterpolating(op: string, options: unknown): SplineData {
  return checkedLocal(op, options, SplineKind.Interpolating);
}
