import { maxCoordinate, SvgFileError } from "./limits.ts";

/** x' = a·x + c·y + e, y' = b·x + d·y + f: the order of SVG's `matrix()`. */
export type Matrix = readonly [a: number, b: number, c: number, d: number, e: number, f: number];

export const identity: Matrix = [1, 0, 0, 1, 0, 0];

/** `outer` after `inner`. Entries past the engine's largest coordinate are an error, not infinity. */
export function multiply(outer: Matrix, inner: Matrix): Matrix {
  const [a, b, c, d, e, f] = outer;
  const [g, h, i, j, k, l] = inner;
  const product: Matrix = [a * g + c * h, b * g + d * h, a * i + c * j, b * i + d * j, a * k + c * l + e, b * k + d * l + f];
  if (!product.every((entry) => Math.abs(entry) <= maxCoordinate)) {
    throw new SvgFileError("E_RANGE", "svg: a transform leaves |x| <= 1e9");
  }
  return product;
}

export function translate(x: number, y: number): Matrix {
  return [1, 0, 0, 1, x, y];
}

export function scale(x: number, y: number): Matrix {
  return [x, 0, 0, y, 0, 0];
}

function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}

function rotate(degrees: number, x = 0, y = 0): Matrix {
  // Right angles are exact, so that a quarter turn does not leave 6e-17 in the drawing.
  const quarter = ((degrees % 360) + 360) % 360;
  const exact = ({ 0: [1, 0], 90: [0, 1], 180: [-1, 0], 270: [0, -1] } as Record<number, [number, number]>)[quarter];
  const [cos, sin] = exact ?? [Math.cos(radians(degrees)), Math.sin(radians(degrees))];
  return [cos, sin, -sin, cos, x - cos * x + sin * y, y - sin * x - cos * y];
}

type Builder = (v: readonly number[]) => Matrix | null;

function taking(counts: readonly number[], build: (v: readonly number[]) => Matrix): Builder {
  return (v) => (counts.includes(v.length) ? build(v) : null);
}

const builders: ReadonlyMap<string, Builder> = new Map([
  ["matrix", taking([6], ([a = 1, b = 0, c = 0, d = 1, e = 0, f = 0]) => [a, b, c, d, e, f])],
  ["translate", taking([1, 2], ([x = 0, y = 0]) => translate(x, y))],
  ["scale", taking([1, 2], ([x = 1, y = x]) => scale(x, y))],
  ["rotate", taking([1, 3], ([angle = 0, x, y]) => rotate(angle, x, y))],
  ["skewX", taking([1], ([angle = 0]) => [1, 0, Math.tan(radians(angle)), 1, 0, 0])],
  ["skewY", taking([1], ([angle = 0]) => [1, Math.tan(radians(angle)), 0, 1, 0, 0])],
]);

const number = /[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?/giu;
const list = /^\s*(?:[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?\s*,?\s*)*$/iu;

/** The numbers of a list as SVG writes them; null when anything else stands between them. */
export function numbersOf(text: string): number[] | null {
  return list.test(text) ? (text.match(number) ?? []).map(Number) : null;
}

/** The value of a `transform` attribute; null when it is not one. */
export function parseTransform(text: string): Matrix | null {
  let result = identity;
  let rest = text;
  for (;;) {
    rest = rest.replace(/^[\s,]+/u, "");
    if (rest === "") return result;
    const call = /^([a-zA-Z]+)\s*\(([^()]*)\)/u.exec(rest);
    const values = numbersOf(call?.[2] ?? "x");
    const step = values === null ? null : (builders.get(call?.[1] ?? "")?.(values) ?? null);
    if (call === null || step === null) return null;
    result = multiply(result, step);
    rest = rest.slice(call[0].length);
  }
}
