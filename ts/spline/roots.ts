/** Lists of roots: what an exponential spline is made of, and what it keeps exact. */
import { ExplineError, type Floats, MAX_ROOTS, type Root, finite, integer, rootList, rootNumbers, tooFewPoints } from "../core.js";
import { type SplineKernel, call, copy, write } from "./spline-engine.js";

function made(op: string, body: (kernel: SplineKernel) => number): Root[] {
  return rootList(copy(call(op, body)));
}

/**
 * What is wrong with list i, said of it, and of all lists where together they have too many roots: the engine knows of
 * one at a time.
 */
function ofList(error: unknown, i: number): unknown {
  if (!(error instanceof ExplineError)) return error;
  const { name, message, stack, code, op, fatal, argument = "", ...fields } = error;
  const list = code === "E_LIMIT" ? "lists" : `lists[${i}]`;
  const named = (text: string): string => text.replace("roots", list);
  const what = named(message.slice(op.length + 2, -code.length - 3));
  return new ExplineError(code, op, what, { ...fields, arg: "lists", argument: named(argument), fatal });
}

/** {@link roots.ellipse}, for whoever asks. @internal */
export function ellipseRoots(op: string, count: unknown): Root[] {
  const n = integer(op, "count", count, 3, 0xffffffff);
  return made(op, (kernel) => kernel.roots_keeping(1, n, 1, 0));
}

/** Lists of roots by what they keep exact, for {@link Interpolator}, `InterpolatingCurve` and their like. */
export const roots = {
  /** Polynomials up to a degree of 0 to 15: 0, degree + 1 times. 3 gives cubics. */
  polynomials(degree: number): Root[] {
    const n = integer("polynomials", "degree", degree, 0, MAX_ROOTS - 1);
    return made("polynomials", (kernel) => kernel.roots_keeping(0, n, 0, 0));
  },

  /** Ellipses that are given by `count` points, at least 3. */
  ellipse(count: number): Root[] {
    return ellipseRoots("ellipse", count);
  },

  /**
   * Closed curves of `count` points, at least 2k + 1, whose coordinates are trigonometric polynomials up to order k, 0
   * to 7.
   */
  harmonics(count: number, k: number): Root[] {
    const n = integer("harmonics", "count", count, 0, 0xffffffff);
    const order = integer("harmonics", "k", k, 0, MAX_ROOTS);
    return made("harmonics", (kernel) => kernel.roots_keeping(1, n, order, 0));
  },

  /** Hyperbolas and catenaries that grow by e^rate from point to point; rates up to ±20. */
  hyperbola(rate: number): Root[] {
    const growth = finite("hyperbola", "rate", rate);
    return made("hyperbola", (kernel) => kernel.roots_keeping(2, 0, 0, growth));
  },

  /** What each list keeps, the union keeps. */
  union(...lists: readonly (readonly Root[])[]): Root[] {
    const op = "union";
    if (lists.length === 0) throw tooFewPoints(op, "lists", 0, 1);
    const given = lists.map((list, i) => rootNumbers(op, list, `lists[${i}]`));
    const [first = new Float64Array()] = given;
    const union = (all: Floats, next: Floats, i: number): Floats => {
      write(op, all, next);
      try {
        return copy(call(op, (kernel) => kernel.roots_union(all.length / 2, next.length / 2)));
      } catch (error) {
        throw ofList(error, i);
      }
    };
    return rootList(given.reduce(union, first));
  },
} as const;
