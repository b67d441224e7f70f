/** Sparse curves through noisy points: all at once, in short tasks, or again and again for a slider. */
import { ExplineError, type PointsLike, type Signal, wrong } from "./core.js";
import { type Question, Resident, initFit } from "./fit/fit-engine.js";
import { type FitProgress, type FitWatch, type Order, type SparseFitOptions, type SparseFitStrength, change, knowsNoise, order, watchOf, withNoise } from "./fit/fit-options.js";
import { type SparseFit, readFit } from "./fit/fit-result.js";
import { checkSignal, inOneGo, inTasks } from "./tasks/yielding.js";

export { initFit, initFitSync } from "./fit/fit-engine.js";
export type { FitProgress, FitStep, SparseFitOptions, SparseFitStrength } from "./fit/fit-options.js";
export type { FitChange, FitStatus, SparseFit, SparseKnot } from "./fit/fit-result.js";

declare global {
  // As TypeScript's library has it from 5.2 on: a project without that part of it, or with an older TypeScript, reads
  // the declarations too.
  interface SymbolConstructor {
    readonly dispose: unique symbol;
  }
  interface Disposable {
    [Symbol.dispose](): void;
  }
}

/** Work of one call into the engine, in microseconds or so. */
const BUDGET = 4000;

/** Steps of a run, and whether the deadline ended it; between two of them the caller may wait, stop or be told. */
function* steps(op: string, resident: Resident, { onProgress }: FitWatch, deadline: number | undefined): Generator<void, boolean> {
  const end = deadline === undefined ? Infinity : performance.now() + deadline;
  for (;;) {
    const { done, iteration, gap } = resident.step(op, BUDGET);
    onProgress?.({ iteration, gap });
    if (done) return false;
    if (performance.now() >= end) return true;
    yield;
  }
}

/** A run in one go. */
function run(op: string, resident: Resident, watch: FitWatch, deadline: number | undefined): SparseFit {
  const late = inOneGo(steps(op, resident, watch, deadline));
  return readFit(resident.describe(op), late);
}

/** A run in short tasks. */
async function runAsync(op: string, resident: Resident, watch: FitWatch, deadline: number | undefined): Promise<SparseFit> {
  const late = await inTasks(op, watch.signal, steps(op, resident, watch, deadline));
  return readFit(resident.describe(op), late);
}

function begin(op: string, { input, question }: Order): Resident {
  const resident = new Resident(op, input);
  try {
    resident.ask(op, question);
  } catch (error) {
    resident.close();
    throw error;
  }
  return resident;
}

/**
 * The spline with the fewest knots that follows noisy points: corners stay corners, smooth parts stay smooth, and the
 * optimum comes with a certificate.
 *
 * Of `lambda`, `smoothing` and `tolerance` one says how much to simplify; without any, the noise of the points is
 * estimated and taken out. The result is the same to the last bit wherever and whenever it is computed.
 *
 * @throws {ExplineError} E_TOO_FEW_POINTS below two points, three of a closed curve; an open one with `lambda` or
 *   `smoothing` needs one more than its highest degree, 4 by default; E_DEGENERATE where all are the same, E_LIMIT
 *   above 500,000 points; E_TYPE for two strengths at once.
 * @example
 * ```js
 * const noisy = Array.from({ length: 300 }, (_, i) => [i, 40 * Math.sin(i / 40) + Math.sin(97 * i)]);
 * const { curve, knots, maxError, status } = fitSparse(noisy, { tolerance: 3, closed: false });
 * console.log(curve.closed, knots.length < 15, maxError <= 3, status); // → false true true converged
 * ```
 */
export function fitSparse(points: PointsLike, options?: SparseFitOptions): SparseFit {
  const op = "fitSparse";
  return one(op, order(op, points, options));
}

function one(op: string, job: Order): SparseFit {
  checkSignal(op, job.signal);
  const resident = begin(op, job);
  try {
    return run(op, resident, job, job.deadline);
  } finally {
    resident.close();
  }
}

async function oneAsync(op: string, job: Order): Promise<SparseFit> {
  checkSignal(op, job.signal);
  const resident = begin(op, job);
  try {
    return await runAsync(op, resident, job, job.deadline);
  } finally {
    resident.close();
  }
}

/** What {@link fitSparseAll} can be told: what concerns all contours alike. */
export type SparseFitAllOptions = Omit<SparseFitOptions, "parameters" | "period" | "weights">;

/**
 * {@link fitSparse} for the contours of one drawing. They come from one pen or one picture, so that one level of noise
 * holds for all: unless `noise` is given, the median of what each of them says alone.
 *
 * @throws {ExplineError} as fitSparse does, for the first contour that is wrong, with `argument` "contours[1]", or
 *   "contours[1][5]" where one of its numbers is at fault; E_TYPE where `contours` is no array.
 */
export function fitSparseAll(contours: readonly PointsLike[], options?: SparseFitAllOptions): SparseFit[] {
  const op = "fitSparseAll";
  const { jobs } = orders(op, contours, options);
  return inOneGo(alike(op, jobs)).map((job, i) => named(i, () => one(op, job)));
}

/**
 * {@link fitSparseAll} in short tasks, one contour after the other; `onProgress` and `deadline` are those of each.
 *
 * @throws {ExplineError} as fitSparseAll does, by rejecting; E_CANCELLED when the signal was aborted, within a few
 *   milliseconds.
 */
export async function fitSparseAllAsync(contours: readonly PointsLike[], options?: SparseFitAllOptions): Promise<SparseFit[]> {
  const op = "fitSparseAllAsync";
  const { jobs, signal } = orders(op, contours, options);
  checkSignal(op, signal);
  await initFit();
  const fits: SparseFit[] = [];
  for (const [i, job] of (await inTasks(op, signal, alike(op, jobs))).entries()) {
    const fit = oneAsync(op, job).catch((error: unknown) => {
      throw ofContour(error, i);
    });
    fits.push(await fit);
  }
  return fits;
}

/** What is to be done for each contour; the points are copied. */
function orders(op: string, contours: unknown, options: unknown): { jobs: Order[]; signal: FitWatch["signal"] } {
  if (!Array.isArray(contours)) throw wrong("E_TYPE", op, "contours", contours, "an array of contours");
  const { signal } = watchOf(op, options);
  return { jobs: Array.from(contours, (points, i) => named(i, () => order(op, points, options))), signal };
}

function named<R>(i: number, work: () => R): R {
  try {
    return work();
  } catch (error) {
    throw ofContour(error, i);
  }
}

/** What is wrong with the points of contour i, said of the contour: who calls has no `points`. */
function ofContour(error: unknown, i: number): unknown {
  if (!(error instanceof ExplineError) || error.arg !== "points") return error;
  const { name: _, code, op, argument = "", ...details } = error;
  const contour = `contours[${i}]`;
  const place = (text: string): string => text.replace("points", contour);
  const what = place(error.message.slice(op.length + 2, -code.length - 3));
  return new ExplineError(code, op, what, { ...details, arg: "contours", argument: place(argument) });
}

/** The same with one level of noise: that of the options, or the median of what each contour says alone. */
function* alike(op: string, jobs: readonly Order[]): Generator<void, readonly Order[]> {
  if (jobs.every(knowsNoise)) return jobs;
  const levels: number[] = [];
  for (const [i, job] of jobs.entries()) {
    levels.push(named(i, () => noiseOf(op, job)));
    yield;
  }
  levels.sort((a, b) => a - b);
  return jobs.map((job) => withNoise(job, levels[levels.length >> 1] ?? 0));
}

function noiseOf(op: string, { input }: Order): number {
  const resident = new Resident(op, input);
  try {
    return resident.noise(op);
  } finally {
    resident.close();
  }
}

/**
 * {@link fitSparse} in short tasks on the caller's own thread: a page goes on painting and answering meanwhile. In a
 * worker it lets messages through, so that one of them can abort the signal.
 *
 * @example
 * ```js
 * const points = Array.from({ length: 300 }, (_, i) => [50 * Math.cos(i / 48), 30 * Math.sin(i / 48)]);
 * const { curve } = await fitSparseAsync(points, { tolerance: 0.5, signal: AbortSignal.timeout(10_000) });
 * console.log(curve.closed, curve.points.length / 2 < 8); // → true true
 * ```
 *
 * @throws {ExplineError} as fitSparse does, by rejecting; E_CANCELLED when the signal was aborted, within a few
 *   milliseconds.
 */
export async function fitSparseAsync(points: PointsLike, options?: SparseFitOptions): Promise<SparseFit> {
  const op = "fitSparseAsync";
  const job = order(op, points, options);
  checkSignal(op, job.signal);
  await initFit();
  return oneAsync(op, job);
}

/** What a fitter holds; undefined once it was disposed of. */
interface Held {
  readonly resident: Resident;
  readonly job: Order;
  busy: boolean;
}

/** What a solve can be told: how strongly to simplify, and who watches it. */
type FitterStrength = SparseFitStrength & { signal?: Signal | undefined; onProgress?: ((progress: FitProgress) => void) | undefined };

const FITTER = "SparseFitter";

/** What a fitter holds, and the proof that it is one. */
let stateOf: (fitter: SparseFitter, op: string) => { held: Held | undefined };

/**
 * Fits the same points again and again, for a slider: what was made of the points is kept.
 *
 * A solve gives what {@link fitSparse} does, to the last bit, whatever was solved before. With a `gap` of 1e-3 or more,
 * for what is to be seen at once, a solve by `lambda` or `smoothing` starts where the last one ended instead: its
 * objective agrees with that of {@link fitSparse} within the gap, and what `finish` makes of it may have other knots.
 *
 * @example
 * ```js
 * const points = Array.from({ length: 300 }, (_, i) => [50 * Math.cos(i / 48), 30 * Math.sin(i / 48)]);
 * const fitter = new SparseFitter(points, { degree: 3 });
 * const counts = [0.2, 0.6].map((smoothing) => fitter.solve({ smoothing }).knots.length);
 * fitter.dispose();
 * console.log(counts[1] <= counts[0]); // → true
 * ```
 */
export class SparseFitter {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static readonly name = FITTER;

  readonly #state: { held: Held | undefined };

  static {
    stateOf = (fitter, op) => {
      if (typeof fitter !== "object" || fitter === null || !(#state in fitter)) {
        throw wrong("E_TYPE", op, "this", fitter, FITTER);
      }
      return fitter.#state;
    };
  }

  /** A fitter is no plain object, as a curve is none. @internal */
  get [Symbol.toStringTag](): string {
    return FITTER;
  }

  /**
   * Takes the points in; nothing is solved yet.
   *
   * @throws {ExplineError} as fitSparse does.
   */
  constructor(points: PointsLike, options?: SparseFitOptions) {
    const op = FITTER;
    const job = order(op, points, options);
    this.#state = { held: { resident: new Resident(op, job.input), job, busy: false } };
  }

  /**
   * The fit for another strength; without one, for that of the constructor. So with `signal`, which is looked at once,
   * before the work begins, and `onProgress`.
   *
   * @throws {ExplineError} as {@link fitSparse} does; E_DISPOSED after {@link SparseFitter.dispose}, E_BUSY while
   *   another solve is under way.
   */
  solve(strength?: FitterStrength): SparseFit {
    const op = "solve";
    const held = take(this, op);
    const { question, watch } = asked(op, held.job, strength);
    held.busy = true;
    try {
      held.resident.ask(op, question);
      return run(op, held.resident, watch, held.job.deadline);
    } finally {
      held.busy = false;
    }
  }

  /**
   * The same in short tasks; an abort leaves the fitter as usable as it was.
   *
   * @throws {ExplineError} as {@link SparseFitter.solve} does, by rejecting; E_CANCELLED when the signal was aborted,
   *   within a few milliseconds.
   */
  async solveAsync(strength?: FitterStrength): Promise<SparseFit> {
    const op = "solveAsync";
    const held = take(this, op);
    const { question, watch } = asked(op, held.job, strength);
    held.busy = true;
    try {
      held.resident.ask(op, question);
      return await runAsync(op, held.resident, watch, held.job.deadline);
    } finally {
      held.busy = false;
    }
  }

  /**
   * Gives the memory back, which the collector does not see: it finds forgotten fitters only between tasks, so that a
   * loop that never waits, or only for promises, has to do it. Using the fitter afterwards throws E_DISPOSED; disposing
   * of it again does nothing. While `solveAsync` is under way it is E_BUSY: abort that, and dispose when its promise
   * has settled.
   */
  dispose(): void {
    const op = "dispose";
    const state = stateOf(this, op);
    if (state.held?.busy === true) throw new ExplineError("E_BUSY", op, "the fitter is at work");
    state.held?.resident.close();
    state.held = undefined;
  }

  [Symbol.dispose](): void {
    this.dispose();
  }
}

/** What a solve is asked for, and who watches it: who the fitter was made for, unless the call names others. */
function asked(op: string, job: Order, strength: unknown): { question: Question; watch: FitWatch } {
  const { question = job.question, signal = job.signal, onProgress = job.onProgress } = change(op, strength, job.degrees.length);
  checkSignal(op, signal);
  return { question, watch: { signal, onProgress } };
}

/** What a fitter works with, while it has it and nothing else does. */
function take(fitter: SparseFitter, op: string): Held {
  const { held } = stateOf(fitter, op);
  if (held === undefined) throw new ExplineError("E_DISPOSED", op, "the fitter was disposed of");
  if (held.busy) throw new ExplineError("E_BUSY", op, "the fitter is at work");
  return held;
}
