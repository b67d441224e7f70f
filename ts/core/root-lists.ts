/** Lists of roots as callers give them and as they are handed out. */
import { finite } from "./arguments.js";
import { overLimit, wrong } from "./error.js";
import type { Floats } from "./kernel.js";

/** One root: the spline keeps e^(re·t)·cos(im·t) and e^(re·t)·sin(im·t). A number is a real root. */
export type Root = number | { readonly re: number; readonly im: number };

/** The most roots of one list. */
export const MAX_ROOTS = 16;

/** A copy of a list of roots, two numbers each; what they may be is for the kernel to say. @internal */
export function rootNumbers(op: string, value: unknown, arg = "roots"): Floats {
  if (!Array.isArray(value)) throw wrong("E_TYPE", op, arg, value, "an array of numbers or { re, im }");
  const list = value as readonly unknown[];
  const length = list.length >>> 0;
  if (length > MAX_ROOTS) throw overLimit(op, arg, "maxRoots", MAX_ROOTS, length);
  const numbers = new Float64Array(2 * length);
  for (let i = 0; i < length; i += 1) {
    const root = list[i];
    const isPair = typeof root === "object" && root !== null && !Array.isArray(root);
    if (typeof root !== "number" && !isPair) throw wrong("E_TYPE", op, arg, root, "a number or { re, im }", i);
    const { re, im } = isPair ? (root as { re?: unknown; im?: unknown }) : { re: root, im: 0 };
    const place = `${arg}[${i}]`;
    numbers[2 * i] = finite(op, arg, re, i, isPair ? `${place}.re` : place) + 0;
    numbers[2 * i + 1] = finite(op, arg, im, i, `${place}.im`) + 0;
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
