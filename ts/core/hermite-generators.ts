/** The cardinal Hermite exponential splines φ₁ and φ₂. */
import { MAX_EVALUATIONS, finite, integer, oneOr, parameters, word } from "./arguments.js";
import { SPACES, type Space } from "./curve-data.js";
import { wrong } from "./error.js";
import type { Kernel } from "./engine.js";
import { type Floats, call, copy, result, write } from "./kernel.js";

const GENERATORS = "HermiteGenerators";

/** The two numbers that generators are, and the proof that they are generators. */
let own: (generators: HermiteGenerators, op: string) => { omega: number; space: number };

/**
 * The pair φ₁, φ₂ that interpolates values and first derivatives at the integers: r(t) = Σ
 * r(n)·φ₁(t − n) + r′(n)·φ₂(t − n).
 *
 * A value without state in the engine; every method may be called at any time.
 */
export class HermiteGenerators {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static readonly name = GENERATORS;

  readonly #omega: number;
  readonly #space: number;

  static {
    own = (generators, op) => {
      if (typeof generators !== "object" || generators === null || !(#omega in generators)) {
        throw wrong("E_TYPE", op, "this", generators, GENERATORS);
      }
      return { omega: generators.#omega, space: generators.#space };
    };
  }

  /**
   * The generators for `omega` radians per unit: below 2π − 1e-6 in the trigonometric space, which is the default, at
   * most 1e4 in the others; 0 is the cubic case.
   *
   * @throws {ExplineError} E_RANGE of any other `omega`.
   */
  constructor(omega: number, space: Space = "trigonometric") {
    this.#omega = finite(GENERATORS, "omega", omega);
    this.#space = SPACES.indexOf(word(GENERATORS, "space", space, SPACES));
    run(this, GENERATORS, (kernel, w, s) => kernel.generators(w, s));
  }

  /** No plain object, as a curve is none. @internal */
  get [Symbol.toStringTag](): string {
    return GENERATORS;
  }

  /** ω in radians per unit. */
  get omega(): number {
    return own(this, "omega").omega;
  }

  /** The space. */
  get space(): Space {
    return SPACES[own(this, "space").space] ?? "trigonometric";
  }

  /** φ₁ and φ₂, or their derivative of order 1 or 2, at every x; at a knot the limit from the right. */
  evaluate(x: number | Float64Array | readonly number[], derivative: 0 | 1 | 2 = 0): { phi1: Float64Array; phi2: Float64Array } {
    const order = integer("evaluate", "derivative", derivative, 0, 2);
    const both = at(this, "evaluate", x, (kernel, w, s, count) => kernel.generators_evaluate(w, s, count, order));
    return { phi1: both.slice(0, both.length / 2), phi2: both.slice(both.length / 2) };
  }

  /**
   * The four functions of the Bernstein basis, or their derivative of order 1 or 2, at every x in [0, 1]: four numbers
   * each.
   */
  bernstein(x: number | Float64Array | readonly number[], derivative: 0 | 1 | 2 = 0): Float64Array {
    const order = integer("bernstein", "derivative", derivative, 0, 2);
    return at(this, "bernstein", x, (kernel, w, s, count) => kernel.generators_bernstein(w, s, count, order));
  }

  /**
   * The refinement masks H[n], n = −(arity − 1) … arity − 1, from the grid of step arity^−level to the next: four
   * numbers each, row by row, acting on columns (value, derivative).
   *
   * @throws {ExplineError} E_RANGE of an `arity` below 2, and of a `level` outside 0 to 24.
   */
  mask(arity: number, level: number): Float64Array {
    const m = integer("mask", "arity", arity, 2, MAX_EVALUATIONS);
    const j = integer("mask", "level", level, 0, 24);
    return copy(run(this, "mask", (kernel, w, s) => kernel.generators_mask(w, s, m, j)));
  }

  /** a = ⟨φ₁, φ₁(·−1)⟩, b = ‖φ₁‖², c = ⟨φ₁, φ₂(·−1)⟩, d = ⟨φ₂, φ₂(·−1)⟩, e = ‖φ₂‖². */
  gram(): { a: number; b: number; c: number; d: number; e: number } {
    run(this, "gram", (kernel, w, s) => kernel.generators_gram(w, s));
    return { a: result(0), b: result(1), c: result(2), d: result(3), e: result(4) };
  }

  /**
   * The largest `lower` and smallest `upper` with lower·‖a‖ ≤ ‖r‖ ≤ upper·‖a‖ for values and derivatives a; not
   * squared.
   */
  rieszBounds(): { lower: number; upper: number } {
    run(this, "rieszBounds", (kernel, w, s) => kernel.generators_gram(w, s));
    return { lower: result(5), upper: result(6) };
  }

  /**
   * The two Green's functions ρ₁ and ρ₂ at every x.
   *
   * @throws {ExplineError} E_RANGE of an x beyond 1e9/ω, in the hyperbolic space beyond 700/ω, and beyond 1e100.
   */
  greens(x: number | Float64Array | readonly number[]): { rho1: Float64Array; rho2: Float64Array } {
    const both = at(this, "greens", x, (kernel, w, s, count) => kernel.generators_greens(w, s, count));
    return { rho1: both.slice(0, both.length / 2), rho2: both.slice(both.length / 2) };
  }
}

/** Calls the kernel with the generators' own numbers. */
function run(
  generators: HermiteGenerators,
  op: string,
  body: (kernel: Kernel, omega: number, space: number) => number,
  x?: number | Floats,
): number {
  const { omega, space } = own(generators, op);
  return call(op, (kernel) => body(kernel, omega, space), x);
}

/** What the generators are at one place or many. */
function at(
  generators: HermiteGenerators,
  op: string,
  x: unknown,
  body: (kernel: Kernel, omega: number, space: number, count: number) => number,
): Floats {
  const places = parameters(op, "x", x);
  write(op, places);
  return copy(run(generators, op, (...own) => body(...own, places.length), oneOr(x, places)));
}
