/** What a fit gives, read from what the engine leaves. */
import type { HermiteCurve } from "../core.js";
import { Sections } from "../tasks/sections.js";
import { type FitStep, STEPS } from "./fit-options.js";

/** A place where the spline's derivative of order `degree` jumps. */
export interface SparseKnot {
  /** Parameter of the curve. */
  t: number;
  /** Where the curve is there. */
  x: number;
  /** Where the curve is there. */
  y: number;
  /**
   * The order of the derivative that jumps: 1 is a corner. As `finish: "none"` and "gridless" leave the optimum, the
   * degree of the component that it belongs to, and two components may have a knot at the same t; of one spline the
   * lowest order that jumps.
   */
  degree: number;
  /** By how much the derivative of that order jumps. */
  jump: [number, number];
}

/** What one step after the optimum changed; "search" is the whole way to the fewest knots where no λ was involved. */
export interface FitChange {
  /** What was done: a step of `finish`, or the search for the fewest knots. */
  step: FitStep | "search";
  /** Knots before and after. */
  knots: [before: number, after: number];
  /** Mean square of the distances at the points' parameters, before and after. */
  qfe: [before: number, after: number];
  /** The relative duality gap to the problem without a grid, where the step certified one. */
  gap?: number;
}

/** How a fit ended; none of these is an error. */
export type FitStatus =
  /** The gap that was asked for is certified. */
  | "converged"
  /** `maxIterations` came first: `gap` or `maxError` says how near the curve is that was found by then. */
  | "max_iterations"
  /**
   * Rounding allows no smaller gap, and `gap` is what is certified; or no curve was found within `tolerance`, and
   * `maxError` says how near this one is; or what was found led beyond ±1e9, and this is the points joined by lines.
   */
  | "stalled"
  /** `deadline` came first. */
  | "deadline";

/**
 * A curve through noisy points with few knots, and what is proved about it. `postMessage` takes no curve: send
 * `{ ...fit, curve: fit.curve.toJSON(), parts: fit.parts.map((part) => part.toJSON()) }`.
 */
export interface SparseFit {
  /**
   * The spline itself, exact up to degree 3. Splines of degree 4 and 5 come as cubics, as a rule within a billionth of
   * the drawing's size; `deviation` is how far, and `coefficients` are the spline's own.
   */
  curve: HermiteCurve;
  /**
   * Each component as a curve of its own, degrees 4 and 5 as cubics; their sum is `curve`, the last one having its
   * place in the plane. Large components that nearly cancel, as uneven `parameters` or `weights` make them, are off by
   * more as cubics than their sum, which `deviation` is about: `coefficients` are exact. Of a closed pair each begins
   * at its own first knot: where `curve` is at t, it is at t less the `t` of the first of `knots` with its degree. Two
   * only of a pair of degrees with `lambda` or `smoothing` whose `finish` leaves the bias in ("none", "gridless"):
   * "full" makes one spline of both, and with a tolerance or without any strength there never are two.
   */
  parts: HermiteCurve[];
  /** B-spline coefficients of each component on its knots, x and y in turn. */
  coefficients: Float64Array[];
  /** Where the components change, in the order of t. */
  knots: SparseKnot[];
  /**
   * The parameter of each point's place on `curve`: nowhere around it is nearer, but for a step where a `gap` of 1e-3
   * or more was enough. Where the curve comes back to itself another part may be nearer; `curve.nearestAll` knows.
   */
  parameters: Float64Array;
  /** What was minimised: `dataTerm` + Σ λ·`regularizer`. */
  objective: number;
  /**
   * Sum of the weighted squares of the distances, of the optimum before it was made shorter; of the points put on long
   * sides, too.
   */
  dataTerm: number;
  /** Σ λ·|jump|. */
  regularizer: number;
  /**
   * The relative duality gap that is certified for the optimum before it was made shorter. 1, the gap to nothing at
   * all, where no λ was involved: with a tolerance or without any strength, `maxError` is what is proved.
   */
  gap: number;
  /**
   * Mean square of the distances between the points and `curve` at the parameters that they were fitted at; `rms` is at
   * `parameters`.
   */
  qfe: number;
  /**
   * No point is farther from the curve than this: proved. Of the curve between points that lie far apart it says
   * nothing.
   */
  maxError: number;
  /**
   * Root of the mean square of the distances between the points and their places, at `parameters`; weighted, where they
   * are, and with `robust` as the fit weighs them.
   */
  rms: number;
  /** How far `curve` may be from the spline: 0 up to degree 3, proved above. `maxError` has it in it. */
  deviation: number;
  /** Steps of the solver, or of the search where no λ was involved. */
  iterations: number;
  /** One for each degree; none where no λ was involved. */
  lambda: number[];
  /** The `smoothing` that means the same λ, where there is one. */
  smoothing?: number;
  /** Standard deviation of the noise, estimated from the points. */
  sigma: number;
  /** Indices of the points whose distance cannot be noise, with `robust`. */
  outliers: number[];
  /** What was done after the optimum was found, step by step. */
  changes: FitChange[];
  /** How it ended: "converged" unless something was in the way. */
  status: FitStatus;
}

const STATUSES: readonly FitStatus[] = ["converged", "max_iterations", "stalled"];

/** Numbers of one knot, and of one change. */
const RECORD = 6;

/** Reads a fit from what the engine says of it. @internal */
export function readFit(numbers: Float64Array, late: boolean): SparseFit {
  const sections = new Sections(numbers);
  const [components = 1, objective = 0, dataTerm = 0, regularizer = 0, gap = 1, qfe = 0, maxError = 0, ...rest] = sections.next();
  const [rms = 0, iterations = 0, status = 0, smoothing = -1, sigma = 0, deviation = 0] = rest;
  const lambda = Array.from(sections.next());
  const curve = sections.curve();
  const parts: HermiteCurve[] = [];
  const coefficients: Float64Array[] = [];
  for (let i = 0; i < components; i += 1) {
    parts.push(sections.curve());
    coefficients.push(sections.next().slice());
  }
  const knots = sections.records(RECORD, knotFrom);
  const parameters = sections.next().slice();
  const outliers = Array.from(sections.next());
  const changes = sections.records(RECORD, changeFrom);
  return {
    ...{ curve, parts, coefficients, knots, parameters, outliers, objective, dataTerm, regularizer, gap, qfe, maxError, rms, deviation, iterations, lambda },
    ...(smoothing < 0 ? {} : { smoothing }),
    sigma,
    changes,
    status: late ? "deadline" : (STATUSES[status] ?? "stalled"),
  };
}

function knotFrom([t = 0, x = 0, y = 0, degree = 0, dx = 0, dy = 0]: Float64Array): SparseKnot {
  return { t, x, y, degree, jump: [dx, dy] };
}

function changeFrom([step = 0, before = 0, after = 0, qfe = 0, now = 0, gap = 0]: Float64Array): FitChange {
  return { step: STEPS[step] ?? "search", knots: [before, after], qfe: [qfe, now], ...(gap < 0 ? {} : { gap }) };
}
