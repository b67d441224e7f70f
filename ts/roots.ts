/** Lists of roots: what an exponential spline is made of, and what it keeps exact. */
import { finite, integer } from "./arguments.js";
import { overLimit, wrong } from "./error.js";
import type { Kernel } from "./engine.js";
import { type Floats, call, copy, write } from "./kernel.js";

/** One root: the spline keeps e^(re·t)·cos(im·t) and e^(re·t)·sin(im·t). A number is a real root. */
export type Root = number | { readonly re: number; readonly im: number };

/** The most roots of one list. */
const MAX_ROOTS = 16;

/** A copy of a list of roots, two numbers each; what they may be is for the kernel to say. @internal */
export function rootNumbers(op: string, value: unknown, arg = "roots"): Floats {
  if (!Array.isArray(value)) throw wrong("E_TYPE", op, arg, value, "an array of numbers or { re, im }");
  const list = value as readonly unknown[];
  if (list.length > MAX_ROOTS) throw overLimit(op, arg, "maxRoots", MAX_ROOTS, list.length);
  const numbers = new Float64Array(2 * list.length);
  for (let i = 0; i < list.length; i += 1) {
    const root = list[i];
    const isPair = typeof root === "object" && root !== null && !Array.isArray(root);
    if (typeof root !== "number" && !isPair) throw wrong("E_TYPE", op, arg, root, "a number or { re, im }", i);
    const { re, im } = isPair ? (root as { re?: unknown; im?: unknown }) : { re: root, im: 0 };
    numbers[2 * i] = finite(op, arg, re, i) + 0;
    numbers[2 * i + 1] = finite(op, arg, im, i) + 0;
  }
  return numbers;
}

/** Roots as they are handed out: real ones as numbers. @internal */
export function rootList(numbers: Float64Array): Root[] {
  const list: Root[] = [];
  for (let i = 0; i + 1 < numbers.length; i += 2) {
    const [re = 0, im = 0] = [numbers[i], numbers[i + 1]];
    list.push(im === 0 ? re : { re, im });
  }
  return list;
}

function listed(op: string, body: (kernel: Kernel) => number): Root[] {
  return rootList(copy(call(op, body)));
}

/** Lists of roots by what they keep exact, for {@link Interpolator}, `InterpolatingCurve` and their like. */
export const roots = {
  /** Polynomials up to a degree: 0, degree + 1 times. 3 gives cubics. */
  polynomials(degree: number): Root[] {
    const n = integer("polynomials", "degree", degree, 0, MAX_ROOTS - 1);
    return listed("polynomials", (kernel) => kernel.roots_keeping(0, n, 0, 0));
  },

  /** Ellipses that are given by `count` points, at least 3. */
  ellipse(count: number): Root[] {
    const n = integer("ellipse", "count", count, 0, 0xffffffff);
    return listed("ellipse", (kernel) => kernel.roots_keeping(1, n, 1, 0));
  },

  /** Closed curves of `count` points whose coordinates are trigonometric polynomials up to order k. */
  harmonics(count: number, k: number): Root[] {
    const n = integer("harmonics", "count", count, 0, 0xffffffff);
    const order = integer("harmonics", "k", k, 0, MAX_ROOTS);
    return listed("harmonics", (kernel) => kernel.roots_keeping(1, n, order, 0));
  },

  /** Hyperbolas and catenaries that grow by e^rate from point to point. */
  hyperbola(rate: number): Root[] {
    const growth = finite("hyperbola", "rate", rate);
    return listed("hyperbola", (kernel) => kernel.roots_keeping(2, 0, 0, growth));
  },

  /** What each list keeps, the union keeps. */
  union(...lists: readonly (readonly Root[])[]): Root[] {
    const op = "union";
    let all: Floats | undefined;
    for (const list of lists) {
      const next = rootNumbers(op, list);
      const first: Floats = all ?? next;
      write(op, first, next);
      all = copy(call(op, (kernel) => kernel.roots_union(first.length / 2, next.length / 2)));
    }
    return rootList(all ?? rootNumbers(op, undefined));
  },
} as const;
