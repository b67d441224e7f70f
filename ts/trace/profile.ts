/**
 * The tools of the weighted quasi-interpolant: splines of clouds, what they miss, and the whole way from a profile's
 * points to its curve.
 */
import { type HermiteCurve, MAX_POINTS, type PointsLike, finite, flag, inRange, integer, numbers, options as checkOptions, points as checkPoints, tooFewPoints, word } from "../core.js";
import { Sections } from "../tasks/sections.js";
import { door } from "./trace-engine.js";
import { LEAST_CORNER } from "./trace-options.js";
import type { TraceMetrics } from "./trace-result.js";

/** Which quasi-interpolant. */
export interface QuasiInterpolantOptions {
  /** 1 to 9. */
  degree: number;
  /** Knots that do not fall, the first and the last `degree` + 1 times. */
  knots: Float64Array | readonly number[];
  /**
   * How many of the nearest points a coefficient is the mean of: 1 to as many as there are, one less for {@link
   * looScore}.
   */
  neighbours: number;
}

/** How {@link fitProfile} follows a profile. */
export interface ProfileOptions {
  /** Whether the last point is followed by the first. Default true. */
  closed?: boolean | undefined;
  /** 1 to 3. Default 2. */
  degree?: number | undefined;
  /** The least turning of a cusp, in radians, 0.05 … π. Default 35°; as printed 40°. */
  corner?: number | undefined;
  /**
   * "local", the default, takes coefficients from splines fitted nearby, on knots where they are needed; "mean" is the
   * method as it was published.
   */
  method?: "local" | "mean" | undefined;
}

/** A part of a profile that is a graph over its chord, and the spline that was chosen for it. */
export interface ProfileTube {
  /** Index of its first point, where the profile begins at `fitProfile`'s own start. */
  first: number;
  /** How many points it has. */
  count: number;
  /** Knots inside. */
  knots: number;
  /** Of how many points a coefficient was made, at most; 0 for a line through too few points. */
  neighbours: number;
}

/** A profile's curve. */
export interface ProfileFit {
  /** Smooth but for its cusps; closed as it was asked for. */
  curve: HermiteCurve;
  /** Where the tangent jumps. */
  cusps: [number, number][];
  /** Its parts, in their order. */
  tubes: ProfileTube[];
  /** How far the points are from the curve, in their own unit. */
  metrics: TraceMetrics;
}

const MAX_KNOTS = 1_000_000;

const { call, copy, peek, result, write } = door;

/** Writes a cloud and its knots; how many of both, the degree and the neighbours. */
function cloud(op: string, points: unknown, options: unknown): readonly [number, number, number, number] {
  const given = checkPoints(op, "points", points);
  const own = checkOptions(op, options, ["degree", "knots", "neighbours"]);
  const degree = integer(op, "degree", own.degree, 1, 9);
  const knots = numbers(op, "knots", own.knots, "maxKnots", MAX_KNOTS);
  knots.forEach((knot, i) => finite(op, "knots", knot, i));
  const neighbours = integer(op, "neighbours", own.neighbours, 1, MAX_POINTS);
  write(op, given, knots);
  return [given.length / 2, knots.length, degree, neighbours];
}

/**
 * The coefficients of the weighted quasi-interpolant of points (x, y): each is the mean of the ordinates nearest to its
 * knots' mean.
 *
 * @throws {ExplineError} E_DEGENERATE for knots that fall or whose ends are too few, E_LENGTH for fewer knots than
 *   twice `degree` + 1, E_RANGE for more neighbours than points.
 */
export function quasiInterpolate(points: PointsLike, options: QuasiInterpolantOptions): Float64Array {
  const op = "quasiInterpolate";
  const given = cloud(op, points, options);
  return copy(call(op, (kernel) => kernel.quasi_interpolate(...given)));
}

/**
 * Root of the mean square error of predicting each point from all the others, in the unit of y: exact, without fitting
 * anything twice.
 *
 * @throws {ExplineError} as {@link quasiInterpolate} does, and E_RANGE where there are no more points than neighbours.
 */
export function looScore(points: PointsLike, options: QuasiInterpolantOptions): number {
  const op = "looScore";
  const given = cloud(op, points, options);
  call(op, (kernel) => kernel.loo_score(...given));
  return result(0);
}

/**
 * The whole method on the points of one profile, in their order: cusps, tubes, a spline for each with its own knots and
 * neighbours, joined at cusps and smooth elsewhere.
 *
 * Points are expected in pixels, about one apart, as edges have them: how far corners are rounded and what is noise is
 * known in pixels. Scale others: a circle of 150 points is off by a thousandth of its radius at 10, by a third at 1.
 *
 * @throws {ExplineError} E_TOO_FEW_POINTS below two points.
 */
export function fitProfile(points: PointsLike, options?: ProfileOptions): ProfileFit {
  const op = "fitProfile";
  const given = checkPoints(op, "points", points);
  const own = checkOptions(op, options, ["closed", "degree", "corner", "method"]);
  const closed = flag(op, "closed", own.closed, true) ? 1 : 0;
  const degree = own.degree === undefined ? 2 : integer(op, "degree", own.degree, 1, 3);
  const corner = own.corner === undefined ? 0 : inRange(op, "corner", own.corner, LEAST_CORNER, Math.PI);
  const printed = own.method !== undefined && word(op, "method", own.method, ["local", "mean"]) === "mean" ? 1 : 0;
  write(op, given);
  const count = call(op, (kernel) => kernel.follow_profile(given.length / 2, closed, degree, printed, corner), given);
  return readProfile(peek(count));
}

function readProfile(output: Float64Array): ProfileFit {
  const sections = new Sections(output);
  const curve = sections.curve();
  const cusps = sections.places();
  const [rmse = 0, mae = 0, max = 0, hausdorff = 0, jaccard = 0] = sections.next();
  const tubes = sections.records(4, ([first = 0, count = 0, knots = 0, neighbours = 0]): ProfileTube => ({ first, count, knots, neighbours }));
  return { curve, cusps, tubes, metrics: { rmse, mae, max, hausdorff, jaccard } };
}

function residual(op: string, residuals: unknown, which: 0 | 1): number {
  const given = numbers(op, "residuals", residuals, "maxPoints", MAX_POINTS);
  // The squares of a million have a sum.
  given.forEach((value, i) => inRange(op, "residuals", value, -1e150, 1e150, i));
  write(op, given);
  call(op, (kernel) => kernel.residuals(given.length));
  return result(which);
}

function comparison(op: string, from: unknown, to: unknown, which: 0 | 1 | 2): number {
  const [first, second] = [checkPoints(op, "from", from), checkPoints(op, "to", to)];
  if (which === 0 && first.length > 0 && second.length === 0) throw tooFewPoints(op, "to", 0, 1);
  write(op, first, second);
  call(op, (kernel) => kernel.compare(first.length / 2, second.length / 2));
  return result(which);
}

/** The metrics of the paper. */
export const metrics = {
  /**
   * Root of the mean square; 0 where there is nothing.
   *
   * @throws {ExplineError} E_RANGE of `residuals` beyond ±1e150, whose squares would have no sum; likewise `mae`.
   */
  rmse: (residuals: Float64Array | readonly number[]): number => residual("rmse", residuals, 0),
  /** Mean of the absolute values; 0 where there is nothing. */
  mae: (residuals: Float64Array | readonly number[]): number => residual("mae", residuals, 1),
  /**
   * The largest distance of a point of `from` from its nearest one of `to`, which has one at least; 0 where there is
   * nothing to be near.
   */
  directedHausdorff: (from: PointsLike, to: PointsLike): number => comparison("directedHausdorff", from, to, 0),
  /**
   * Of the pixels that hold points of a profile and of a curve, the share of those that are next to one of the other
   * side: 1 is best. With `literal` as printed, the intersection over the union of the profile with the curve's pixels
   * and their neighbours: a third at best. Nothing and nothing are alike: 1.
   */
  jaccard: (profile: PointsLike, curve: PointsLike, options?: { literal?: boolean | undefined }): number => {
    const { literal } = checkOptions("jaccard", options, ["literal"]);
    return comparison("jaccard", profile, curve, flag("jaccard", "literal", literal, false) ? 2 : 1);
  },
} as const;
