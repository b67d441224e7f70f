/** What can be asked of a fit, checked and written down as the engine reads it. */
import { ExplineError, type Signal, count, flag, inRange, integer, numbers, options as checkOptions, points as checkPoints, word, wrong, wrongLength } from "../core.js";
import { Asked, type Question } from "./fit-engine.js";
import { type Watch, watch } from "../tasks/yielding.js";

/** How far a fit has come. It is no fraction of the work: how many steps there will be is not known before. */
export interface FitProgress {
  /** Steps so far, of the solver or of the search. */
  iteration: number;
  /**
   * The relative duality gap that is certified by now, with `lambda` or `smoothing`: it may rise for a while before it
   * falls. 1 all the time with a tolerance and without any strength, as no λ is involved.
   */
  gap: number;
}

/**
 * How strongly a fit is simplified: one of the three, or none, and the noise of the data decides. λ and `smoothing` are
 * a convex problem with a certified optimum; a tolerance, and the noise, are a search for the fewest knots, which the
 * options about the optimum do not concern.
 *
 * But for λ, the curve also keeps to long straight sides of which the points are only the ends, as in flattened
 * outlines: where a step is more than four times as long as most of the twelve around it, further points are put on it.
 * For a smoothing that is so unless `parameters`, `weights` or `robust` are given; with `robust`, none are put where
 * points are far off all others. Distances are those of the given points.
 *
 * A polygon by its vertices comes back as that polygon: with a tolerance, or without any strength on a closed curve,
 * steps that turn by more than 50° at both ends, and are long beside the tolerance or the noise, are sides as well
 * where most are such (of up to 500 points, with `corners`).
 *
 * Fewer than nine points tell nothing about noise, nor do up to 500 where half turn by the same sharp angle (from 64
 * on, where they are no staircase), or fewer than 64 that noise would have moved by a seventh of a closed drawing:
 * without any strength the curve goes through them.
 */
export interface SparseFitStrength {
  /**
   * The λ of the papers, in the unit of the data, 0 to 1e12: one for each degree, so that a pair of them, as is the
   * default, takes a pair.
   */
  lambda?: number | readonly [number, number] | undefined;
  /**
   * Instead of lambda: 0 … 1, the same meaning for any size of picture, however it is turned, and for any number of
   * points.
   */
  smoothing?: number | undefined;
  /**
   * Instead of lambda, 0 to 1e9: the fewest knots whose curve is nowhere farther than this from a point, in their unit.
   * The curve keeps to the way of the points, too: as a rule it is no farther from it than this and half of their
   * distance from one another. To make a curve simpler, fit its `sampleByLength`: the vertices that `flatten` gives lie
   * far apart where it is nearly straight. Below the noise it is a polyline with the fewest vertices, rounded off where
   * `corners` allows none.
   */
  tolerance?: number | undefined;
}

/** A step after the optimum on the grid is found, with `lambda` or `smoothing`. */
export type FitStep =
  /**
   * Knots that others can stand for go: neither the curve at the points nor the objective changes. Only grids finer
   * than the points have such.
   */
  | "extreme"
  /** Neighbours on the grid that stand for one knot in between are joined. */
  | "merge"
  /** Knots slide between the places of the grid, to the optimum without one. */
  | "slide"
  /** The points are fitted again with the knots kept, without the price that pulls the curve inwards. */
  | "debias"
  /** Knots go, and the others move, while the mean square stays what it was; with "debias". */
  | "prune";

/** What {@link fitSparse} can be told. */
export interface SparseFitOptions extends SparseFitStrength {
  /**
   * 1 to 5; a pair fits the sum of two splines, straight pieces with corners and smooth ones. Default [1, 3]. With a
   * tolerance, or without any strength, a pair means its higher degree: one spline with as smooth or as sharp a knot as
   * each place needs. The curve of a degree above 3 is written as cubics, see `deviation` of the result.
   */
  degree?: number | readonly [number, number] | undefined;
  /**
   * Of a pair of degrees with `smoothing`, 0 to 1: 0 prefers straight pieces, 1 smooth ones. Default 0.5; ignored
   * otherwise.
   */
  mix?: number | undefined;
  /**
   * Places where knots may begin, N, with `lambda` or `smoothing`: 1 to 65,536. Default: the number of points, at most
   * 5000 for degree 1 and 2000 above. Where every λ is 0, more of them than there are points mean the default.
   * Ignored with a tolerance and without any strength.
   */
  gridSize?: number | undefined;
  /**
   * How a jump is measured, with `lambda` or `smoothing`: "l2", the default, does not see how the picture is turned;
   * "l1" treats x and y apart. Ignored with a tolerance and without any strength.
   */
  norm?: "l2" | "l1" | undefined;
  /** Whether the last point is followed by the first. Default true. */
  closed?: boolean | undefined;
  /**
   * Whether sharp corners of the data are kept as they are. Default true: wherever a corner spares a knot. A number is
   * the least turn of a corner, in radians, 0 to π: the curve is smooth where it turns less, for a knot or two more.
   * Ignored with `lambda` and `smoothing`: a pair with degree 1 has corners there, degree 2 and above alone has none.
   */
  corners?: boolean | number | undefined;
  /** Whether points far off the curve count for little: they are named in `outliers`. Default false. */
  robust?: boolean | undefined;
  /** Standard deviation of the noise, in the unit of the points, 0 to 1e9. Default: estimated from them. */
  noise?: number | undefined;
  /**
   * What is made of the optimum, with `lambda` or `smoothing`: "none" leaves it as it is, on its grid; "gridless" joins
   * neighbouring knots and moves them between the places of the grid, to the optimum that no grid limits; "full", the
   * default, also takes the bias out and drops knots that the error allows. Or the steps one by one, in whatever order:
   * they are taken in that of {@link FitStep}. What each of them changed is in `changes`. Ignored with a tolerance and
   * without any strength: there is no optimum then.
   */
  finish?: "none" | "gridless" | "full" | readonly FitStep[] | undefined;
  /**
   * Parameters of the points, one each: none below the one before it, and not all the same. Default: as long as the way
   * between them.
   */
  parameters?: Float64Array | readonly number[] | undefined;
  /**
   * Length of the parameter's period of a closed fit with `parameters`, beyond the last of them; refused without them.
   */
  period?: number | undefined;
  /** How much each point counts, one number from 1e-6 to 1e6 each. Default: all the same. */
  weights?: Float64Array | readonly number[] | undefined;
  /**
   * Relative duality gap at which to stop, 0 to 1, with `lambda` or `smoothing`. Default 1e-6. Ignored with a tolerance
   * and without any strength.
   */
  gap?: number | undefined;
  /**
   * Steps at most, up to 100,000: of the solver with `lambda` or `smoothing`, 400 by default; of the search with a
   * tolerance and without any strength, by default as many as it takes. What was found by then is given, with status
   * "max_iterations".
   */
  maxIterations?: number | undefined;
  /**
   * Milliseconds, 0 or more, after which the best that was found so far is given, with status "deadline". Default:
   * none.
   */
  deadline?: number | undefined;
  /** Ends the work: E_CANCELLED. A synchronous fit looks at it once, before it begins. */
  signal?: Signal | undefined;
  /** Told how far the work is. What it throws ends the fit and reaches the caller as it is. */
  onProgress?: ((progress: FitProgress) => void) | undefined;
}

/** The most points that one fit takes. */
const MAX_SAMPLES = 500_000;
/** The most places where knots may begin. */
const MAX_GRID = 65_536;
const MAX_LAMBDA = 1e12;
const MAX_ITERATIONS = 100_000;

/** The steps, each a bit of what the engine is told. @internal */
export const STEPS = ["extreme", "merge", "slide", "debias", "prune"] as const satisfies readonly FitStep[];
const FINISHES = { none: 0, gridless: 6, full: 30 } as const;
const STRENGTHS = ["lambda", "smoothing", "tolerance"] as const;
const RUNNING = ["signal", "onProgress"] as const;
const NAMES = [
  ...["degree", "mix", "gridSize", "norm", "closed", "corners", "robust", "finish", "noise", "parameters", "period", "weights"] as const,
  ...["gap", "maxIterations", "deadline"] as const,
  ...STRENGTHS,
  ...RUNNING,
] as const;

/** Where in the record of options the noise stands. */
const NOISE = 14;

/** How a run is watched and stopped. @internal */
export type FitWatch = Watch<FitProgress>;

/** A fit as the engine is told of it. @internal */
export interface Order extends FitWatch {
  /** Options in a fixed order, then points, parameters, weights. */
  readonly input: readonly Float64Array[];
  readonly question: Question;
  readonly degrees: readonly number[];
  readonly deadline: number | undefined;
}

/** Who watches work on many contours: of none nothing else looks at the options. @internal */
export function watchOf(op: string, options: unknown): FitWatch {
  return watch(op, checkOptions(op, options, NAMES));
}

/** All checks of a fit's arguments that need no arithmetic. @internal */
export function order(op: string, points: unknown, options: unknown): Order {
  const own = checkOptions(op, options, NAMES);
  const degrees = degreesOf(op, own.degree);
  const given = checkPoints(op, "points", points, MAX_SAMPLES, 2, "maxFitSamples");
  const size = given.length / 2;
  const parameters = perPoint(op, "parameters", own.parameters, size);
  const weights = perPoint(op, "weights", own.weights, size);
  if (own.period !== undefined && own.parameters === undefined) throw wrong("E_TYPE", op, "period", own.period, "given with parameters");
  const optional = (value: unknown, name: string, least: number, most: number): number =>
    value === undefined ? -1 : inRange(op, name, value, least, most);
  const record = Float64Array.of(
    size,
    degrees.length,
    degrees[0] ?? 0,
    degrees[1] ?? 0,
    own.gridSize === undefined ? -1 : count(op, "gridSize", own.gridSize, 1, "maxKnotGrid", MAX_GRID),
    own.norm === undefined || word(op, "norm", own.norm, ["l2", "l1"]) === "l2" ? 0 : 1,
    flag(op, "closed", own.closed, true) ? 1 : 0,
    typeof own.corners === "number" || flag(op, "corners", own.corners, true) ? 1 : 0,
    flag(op, "robust", own.robust, false) ? 1 : 0,
    own.finish === undefined ? FINISHES.full : finishOf(op, own.finish),
    optional(own.gap, "gap", 0, 1),
    own.maxIterations === undefined ? -1 : integer(op, "maxIterations", own.maxIterations, 0, MAX_ITERATIONS),
    optional(own.mix, "mix", 0, 1),
    optional(own.period, "period", 0, Infinity),
    optional(own.noise, "noise", 0, 1e9),
    parameters.length,
    weights.length,
    typeof own.corners === "number" ? inRange(op, "corners", own.corners, 0, Math.PI) : 0,
  );
  return {
    input: [record, given, parameters, weights],
    question: question(op, own, degrees.length),
    degrees,
    deadline: own.deadline === undefined ? undefined : inRange(op, "deadline", own.deadline, 0, Infinity),
    ...watch(op, own),
  };
}

/** Whether the level of noise was given. @internal */
export function knowsNoise({ input: [options] }: Order): boolean {
  return (options?.[NOISE] ?? -1) >= 0;
}

/** The same for a level of noise that was found. @internal */
export function withNoise(job: Order, noise: number): Order {
  const [options = new Float64Array(0), ...rest] = job.input;
  const own = Float64Array.from(options);
  own[NOISE] = noise;
  return { ...job, input: [own, ...rest] };
}

/** A change of a fitter's strength, and who watches. @internal */
export function change(op: string, given: unknown, degrees: number): { question: Question | undefined } & FitWatch {
  const own = checkOptions(op, given, [...STRENGTHS, ...RUNNING]);
  const asked = STRENGTHS.some((name) => own[name] !== undefined);
  return { question: asked ? question(op, own, degrees) : undefined, ...watch(op, own) };
}

function finishOf(op: string, value: unknown): number {
  if (!Array.isArray(value)) return FINISHES[word(op, "finish", value, ["none", "gridless", "full"])];
  const steps = value as readonly unknown[];
  if (steps.length > STEPS.length) throw wrongLength(op, "finish", steps.length, `at most ${STEPS.length}`);
  return Array.from(steps).reduce<number>((bits, step, i) => bits | (1 << STEPS.indexOf(word(op, "finish", step, STEPS, i))), 0);
}

function degreesOf(op: string, value: unknown): readonly number[] {
  if (value === undefined) return [1, 3];
  if (!Array.isArray(value)) return [integer(op, "degree", value, 1, 5)];
  const list = value as readonly unknown[];
  if (list.length !== 2) throw wrongLength(op, "degree", list.length, "2");
  const [first, second] = Array.from(list, (degree, i) => integer(op, "degree", degree, 1, 5, i)) as [number, number];
  if (first >= second) throw wrong("E_RANGE", op, "degree", second, `more than ${first}`, 1);
  return [first, second];
}

function perPoint(op: string, name: string, value: unknown, size: number): Float64Array {
  if (value === undefined) return new Float64Array(0);
  const given = numbers(op, name, value, "maxFitSamples", MAX_SAMPLES);
  if (given.length !== size) throw wrongLength(op, name, given.length, `${size}, one for each point`);
  given.forEach((number, i) => {
    if (!Number.isFinite(number)) throw wrong("E_NOT_FINITE", op, name, number, "a finite number", i);
  });
  return given;
}

function question(op: string, own: { readonly [name in (typeof STRENGTHS)[number]]?: unknown }, degrees: number): Question {
  const [name, more] = STRENGTHS.filter((each) => own[each] !== undefined);
  if (more !== undefined) throw new ExplineError("E_TYPE", op, `${more} and ${String(name)} exclude each other`, { arg: more, argument: more });
  switch (name) {
    case "smoothing":
      return { kind: Asked.Smoothing, first: inRange(op, name, own.smoothing, 0, 1), second: 0, degrees };
    case "tolerance":
      return { kind: Asked.Tolerance, first: inRange(op, name, own.tolerance, 0, 1e9), second: 0, degrees };
    case "lambda":
      return lambdas(op, own.lambda, degrees);
    default:
      return { kind: Asked.Noise, first: 0, second: 0, degrees };
  }
}

function lambdas(op: string, value: unknown, degrees: number): Question {
  const list: readonly unknown[] = Array.isArray(value) ? value : [value];
  const all = Array.from(list, (lambda, i) => inRange(op, "lambda", lambda, 0, MAX_LAMBDA, Array.isArray(value) ? i : undefined));
  if (all.length !== degrees) throw wrongLength(op, "lambda", all.length, degrees === 1 ? "1, as there is one degree" : "2, one for each degree, or one and { degree: 3 }");
  const [first = 0, second = 0] = all;
  if (degrees === 2 && first + second === 0) throw wrong("E_RANGE", op, "lambda", 0, "at least one of them > 0");
  return { kind: Asked.Lambda, first, second, degrees };
}

