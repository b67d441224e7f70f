/** Exponential B-splines and the interpolators made of them, for any list of roots. */
import { type Floats, type Root, flag, integer, oneOr, options as checkOptions, parameters, rootList, rootNumbers, wrong } from "../core.js";
import { ellipseRoots } from "./roots.js";
import { type SplineKernel, call, copy, result, write } from "./spline-engine.js";

/** The kinds and questions in the kernel's order. */
const enum Kind {
  Spline,
  Interpolator,
  BeyondPi,
}
const enum What {
  Made,
  Values,
  Filter,
  AffineFilter,
  Riesz,
}

/** What a generator is: its roots, two numbers each, and its kind. */
interface Source {
  readonly roots: Floats;
  readonly kind: Kind;
}

/** The most that a grid is refined by at once. */
const MAX_FACTOR = 1024;
const B_SPLINE = "ExponentialBSpline";
const INTERPOLATOR = "Interpolator";

let own: (generator: Exponential, op: string) => Source;

function ask(source: Source, op: string, what: What, argument = 0, places: Floats = new Float64Array(), x?: unknown): Floats {
  write(op, source.roots, places);
  const count = source.roots.length / 2;
  const body = (kernel: SplineKernel): number =>
    kernel.exponential(source.kind, count, what, places.length, argument);
  return copy(call(op, body, { x: oneOr(x, places), m0: argument }));
}

/** What both kinds have. */
abstract class Exponential {
  readonly #source: Source;

  static {
    own = (generator, op) => {
      if (typeof generator !== "object" || generator === null || !(#source in generator)) {
        throw wrong("E_TYPE", op, "this", generator, "a generator of this package");
      }
      return generator.#source;
    };
  }

  /** @internal */
  constructor(source: Source) {
    this.#source = source;
  }

  /** No plain object, as a curve is none. @internal */
  get [Symbol.toStringTag](): string {
    return this.constructor.name;
  }

  /** The roots: a copy. */
  get roots(): Root[] {
    return rootList(own(this, "roots").roots);
  }

  /** The number of roots, n₀. */
  get order(): number {
    return own(this, "order").roots.length / 2;
  }

  /**
   * Values, or those of a derivative of an order up to n₀ − 1, at every x; where a derivative jumps the limit from the
   * right.
   */
  evaluate(x: number | Float64Array | readonly number[], derivative = 0): Float64Array {
    const op = "evaluate";
    const source = own(this, op);
    const places = parameters(op, "x", x);
    const order = integer(op, "derivative", derivative, 0, source.roots.length / 2 - 1);
    return ask(source, op, What.Values, order, places, x);
  }

  /** The largest `lower` and smallest `upper` with lower·‖c‖ ≤ ‖Σ c[k]·g(· − k)‖ ≤ upper·‖c‖; not squared. */
  rieszBounds(): { lower: number; upper: number } {
    ask(own(this, "rieszBounds"), "rieszBounds", What.Riesz);
    return { lower: result(0), upper: result(1) };
  }
}

/** The filter for a factor, called `arg`; one that keeps constants where the options say so. */
function filter(generator: Exponential, op: string, arg: string, factor: unknown, options: unknown): Float64Array {
  const source = own(generator, op);
  const { affine } = checkOptions(op, options, ["affine"]);
  const what = flag(op, "affine", affine, false) ? What.AffineFilter : What.Filter;
  return ask(source, op, what, integer(op, arg, factor, 1, MAX_FACTOR));
}

/**
 * The B-spline β of a list of roots, centred: it vanishes outside [−n₀/2, n₀/2]. A value without state in the engine.
 */
export class ExponentialBSpline extends Exponential {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static override readonly name = B_SPLINE;

  /**
   * The B-spline of these roots.
   *
   * @param roots - closed under conjugation, 1 to 16 of them, real parts up to ±20, imaginary parts up to ±10. Values
   *   and derivatives are right to 1e-15 of their largest for real parts up to 96 divided by the number of roots; a few
   *   larger ones among many others lose digits, and all of them in cases as 14 times 0 and ±20, which are refused.
   * @throws {ExplineError} E_DEGENERATE naming the root whose conjugate is missing; E_LIMIT for more than 16, E_RANGE
   *   for one that is too large.
   */
  constructor(roots: readonly Root[]) {
    const source = { roots: rootNumbers(B_SPLINE, roots), kind: Kind.Spline };
    ask(source, B_SPLINE, What.Made);
    super(source);
  }

  /**
   * The taps h of β⁺(t/m) = Σ h[k]·β⁺(t − k) with the fine roots α/m on the right, k = 0 … n₀(m − 1). With `affine`
   * those of B-splines that are divided by their integrals: translating control points then translates the finer ones.
   *
   * @throws {ExplineError} E_RANGE of an `m` outside 1 to 1024.
   */
  refinementFilter(m: number, options?: { affine?: boolean | undefined }): Float64Array {
    return filter(this, "refinementFilter", "m", m, options);
  }
}

/** The interpolator φ of a list of roots: compactly supported, φ(k) = δ[k]. A value without state in the engine. */
export class Interpolator extends Exponential {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static override readonly name = INTERPOLATOR;

  readonly #lambda: Floats;
  /** Condition of the linear system for λ; above 1e6 digits are lost. */
  readonly condition: number;
  /** How much an error in the points can grow on the curve: max Σ|φ(t − k)|. */
  readonly lebesgue: number;

  /**
   * The interpolator of these roots.
   *
   * @param roots - closed under conjugation and negation, 3 to 16 of them, real parts up to ±20, imaginary parts below
   *   π, or, where it exists, up to 10 with `beyondPi`.
   * @throws {ExplineError} E_DEGENERATE where there is no interpolator, naming the root where one is at fault, and
   *   where none of its digits are left: of large real roots among many others, and of imaginary parts within some
   *   1e-12 of π.
   */
  constructor(roots: readonly Root[], options?: { beyondPi?: boolean | undefined }) {
    const op = INTERPOLATOR;
    const { beyondPi } = checkOptions(op, options, ["beyondPi"]);
    const kind = flag(op, "beyondPi", beyondPi, false) ? Kind.BeyondPi : Kind.Interpolator;
    const source = { roots: rootNumbers(op, roots), kind };
    const lambda = ask(source, op, What.Made);
    super(source);
    this.#lambda = lambda;
    this.condition = result(0);
    this.lebesgue = result(1);
  }

  /** The interpolator that keeps ellipses of `count` ≥ 3 points: roots 0, ±2πi/count. */
  static forEllipse(count: number): Interpolator {
    return new Interpolator(ellipseRoots(`${INTERPOLATOR}.forEllipse`, count));
  }

  /** λ[0] … λ[n₀ − 2] of φ = λ[0]·β + Σ λ[n]·(β(· − n/2) + β(· + n/2)): a copy. */
  get lambda(): Float64Array {
    own(this, "lambda");
    return this.#lambda.slice();
  }

  /** n₀ − 1: φ vanishes for |x| ≥ support. */
  get support(): number {
    return own(this, "support").roots.length / 2 - 1;
  }

  /**
   * The taps g of φ⁺(t/m0) = Σ g[k]·β⁺(t − k) with the fine roots α/m0 on the right, m0 even. With `affine` those for
   * B-splines that are divided by their integrals.
   *
   * @throws {ExplineError} E_RANGE of an `m0` outside 2 to 1024, E_DEGENERATE of an odd one.
   */
  preFilter(m0: number, options?: { affine?: boolean | undefined }): Float64Array {
    return filter(this, "preFilter", "m0", m0, options);
  }
}
