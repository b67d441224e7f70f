/** Checks of what callers hand in, before anything crosses the boundary. */
import { ExplineError, overLimit, range, shown, tagOf, typedArray, wrong, wrongLength } from "./error.js";
import type { OwnFloats } from "./host.js";

/** The largest coordinate, radius or parameter length, in the user's unit. */
export const LARGEST = 1e9;
/** The most points one curve may have. */
export const MAX_POINTS = 1_000_000;
/** The most parameters in one call. */
export const MAX_EVALUATIONS = 4_000_000;
/** The most points that one call may return. */
export const MAX_OUTPUT = 4_000_000;

/**
 * Points as they may be given: interleaved, as pairs, in arrays or typed arrays of any kind, or as objects with x and
 * y.
 */
export type PointsLike =
  | Float64Array
  | readonly number[]
  | readonly ArrayLike<number>[]
  | readonly { readonly x: number; readonly y: number }[];

/**
 * Points in space as they may be given: interleaved, as triples, in arrays or typed arrays of any kind, or as objects
 * with x, y and z.
 */
export type SpacePointsLike =
  | Float64Array
  | readonly number[]
  | readonly ArrayLike<number>[]
  | readonly { readonly x: number; readonly y: number; readonly z: number }[];

/**
 * An affine map: of the plane six numbers a, b, c, d, e, f in the order of SVG's `matrix(a b c d e f)`; of space the 16
 * of a 4 × 4 matrix, column by column, as WebGL, three.js (`Matrix4.elements`) and `DOMMatrix.toFloat64Array()` have
 * them.
 */
export type MatrixLike = readonly number[] | Float32Array | Float64Array;

/** Points as kept: two or three numbers each in an array that nobody else holds. */
export type Coordinates = OwnFloats;

const lengthOf = Object.getOwnPropertyDescriptor(typedArray, "length")?.get;
const { indexOf: search } = typedArray as Float64Array;

/** Whether it really is a Float64Array, of whichever realm, and not something that says so. */
export function isFloat64Array(value: unknown): value is Float64Array {
  return tagOf(value) === "Float64Array";
}

/**
 * The true length, whatever a subclass says; refuses an array whose buffer has gone, or has become too short for it.
 */
export function lengthOfArray(op: string, arg: string, value: Float64Array | Float32Array | Uint8Array | Uint8ClampedArray): number {
  const length = lengthOf?.call(value) as number;
  if (length === 0 && isLost(value)) {
    throw new ExplineError("E_DETACHED", op, `${arg} lies on a buffer that was transferred or resized`, {
      arg,
      argument: arg,
    });
  }
  return length;
}

/**
 * Tells an array that has nothing to lie on from an honest one of length 0: all but a few methods refuse the former.
 */
function isLost(value: unknown): boolean {
  try {
    search.call(value as Float64Array, 0);
    return false;
  } catch {
    return true;
  }
}

/** A finite number in a range. `argument` says where it stands, if not at `index`. */
export function inRange(op: string, arg: string, value: unknown, least: number, most: number, index?: number, argument?: string): number {
  if (isNumber(value) && value >= least && value <= most) return value;
  throw wrong(codeOf(value), op, arg, value, range(least, most), index, argument);
}

const isNumber = Number.isFinite as (value: unknown) => value is number;

/** What is wrong with something that should be a number in a range. */
function codeOf(value: unknown): "E_TYPE" | "E_RANGE" | "E_NOT_FINITE" {
  return typeof value !== "number" ? "E_TYPE" : isNumber(value) ? "E_RANGE" : "E_NOT_FINITE";
}

/** A finite number. */
export function finite(op: string, arg: string, value: unknown, index?: number, argument?: string): number {
  return inRange(op, arg, value, -Infinity, Infinity, index, argument);
}

/** A finite number within ±1e9, of a tangent within ±8e9. */
export function coordinate(op: string, arg: string, value: unknown, index?: number, argument?: string): number {
  const most = /^(tan|d)/.test(arg) ? 8 * LARGEST : LARGEST;
  return inRange(op, arg, value, -most, most, index, argument) + 0;
}

/** A whole number in a range. */
export function integer(op: string, arg: string, value: unknown, least: number, most: number, index?: number): number {
  if (Number.isInteger(value) && (value as number) >= least && (value as number) <= most) return value as number;
  throw wrong(codeOf(value), op, arg, value, `an integer in [${least}, ${most}]`, index);
}

/** The number of a patch. */
export function patchNumber(op: string, arg: string, value: unknown, patches: number): number {
  if (patches > 0) return integer(op, arg, value, 0, patches - 1);
  const bound = "there are no patches";
  throw new ExplineError("E_RANGE", op, `${arg} is ${finite(op, arg, value)}; ${bound}`, { arg, argument: arg, bound });
}

/** A count of things to be returned: a whole number from `least`, with a limit of its own. */
export function count(op: string, arg: string, value: unknown, least: number, limit: string, max: number): number {
  if (Number.isSafeInteger(value) && (value as number) > max) throw overLimit(op, arg, limit, max, value as number);
  return integer(op, arg, value, least, max);
}

/** A tolerance: positive and finite. */
export function tolerance(op: string, value: unknown): number {
  const given = finite(op, "tolerance", value);
  if (!(given > 0)) throw wrong("E_RANGE", op, "tolerance", given, "> 0");
  return given;
}

/** True or false, or the default where nothing is given. */
export function flag(op: string, arg: string, value: unknown, byDefault: boolean): boolean {
  if (value === undefined) return byDefault;
  if (typeof value !== "boolean") throw wrong("E_TYPE", op, arg, value, "boolean");
  return value;
}

/** One of a few words. */
export function word<W extends string>(op: string, arg: string, value: unknown, words: readonly W[], index?: number): W {
  const found = words.find((w) => w === value);
  if (found === undefined) {
    const code = typeof value === "string" ? "E_RANGE" : "E_TYPE";
    throw wrong(code, op, arg, value, `one of ${words.join(", ")}`, index);
  }
  return found;
}

/** What an object says it is, of whichever realm: "ArrayBuffer", "URL"; "Object" of a plain one. */
export function classOf(value: unknown): string {
  return {}.toString.call(value).slice(8, -1);
}

/**
 * The own properties of an options object, read once; a name that is not known is an error, and so is an object inside
 * that is missing.
 */
export function options<K extends string>(
  op: string,
  value: unknown,
  names: readonly K[],
  arg = "options",
): { readonly [name in K]?: unknown } {
  const own = Object.create(null) as { [name in K]?: unknown };
  if (value === undefined && arg === "options") return own;
  // A URL, a signal or a buffer in place of options has nothing of its own to be refused by.
  if (!/^(Module|Object)$/.test(classOf(value))) throw wrong("E_TYPE", op, arg, value, "a plain object");
  for (const name of Object.keys(value as object)) {
    const known = names.find((n) => n === name);
    if (known === undefined) {
      const inside = arg === "options" ? "" : `${arg}.`;
      const argument = inside + name.slice(0, 40);
      const what = `${inside || "option "}${shown(name)} is not known; expected ${names.join(", ")}`;
      throw new ExplineError("E_TYPE", op, what, { arg: argument, argument, bound: names.join(", ") });
    }
    own[known] = (value as Record<string, unknown>)[name];
  }
  return own;
}

/**
 * A copy of the numbers of a Float64Array or of an array of numbers; finite or not is not looked at. `or` says what
 * else the caller takes; the limit is on things of `each` numbers.
 */
export function numbers(op: string, arg: string, value: unknown, limit: string, max: number, or = "", each = 1): Coordinates {
  if (isFloat64Array(value)) {
    const length = lengthOfArray(op, arg, value);
    if (length > each * max) throw overLimit(op, arg, limit, max, Math.ceil(length / each));
    return new Float64Array(value);
  }
  if (!Array.isArray(value)) throw wrong("E_TYPE", op, arg, value, `${or}Float64Array or an array of numbers`);
  const list = value as readonly unknown[];
  const length = honestLength(op, arg, list, limit, max, (item) => typeof item === "number", each);
  const copy = new Float64Array(length);
  for (let i = 0; i < length; i += 1) {
    const item = list[i];
    if (typeof item !== "number") throw wrong("E_TYPE", op, arg, item, "number", i);
    copy[i] = item;
  }
  return copy;
}

/** One parameter or many. */
export function parameters(op: string, arg: string, value: unknown): Coordinates {
  return typeof value === "number" ? Float64Array.of(value) : numbers(op, arg, value, "maxEvalPoints", MAX_EVALUATIONS, "a number, ");
}

/**
 * What a message is about: the number that stands alone and has no index, or the list that was made of what was given.
 */
export function oneOr(value: unknown, list: Coordinates): number | Coordinates {
  return typeof value === "number" ? value : list;
}

/**
 * The length of an array; one that is too long for the limit must at least have something at its end. What a proxy says
 * instead of a length becomes one.
 */
function honestLength(
  op: string,
  arg: string,
  list: readonly unknown[],
  limit: string,
  max: number,
  fits: (item: unknown) => boolean,
  each = 1,
): number {
  const length = list.length >>> 0;
  if (length > each * max) {
    if (!fits(list[length - 1])) throw wrong("E_TYPE", op, arg, list[length - 1], "number", length - 1);
    throw overLimit(op, arg, limit, max, Math.ceil(length / each));
  }
  return length;
}

/** A copy of points or vectors, `dimension` numbers each, every one of them finite and within ±1e9. */
export function points(op: string, arg: string, value: unknown, max: number = MAX_POINTS, dimension: 2 | 3 = 2, limit = "maxPoints"): Coordinates {
  if (Array.isArray(value) && value.length > 0 && typeof value[0] === "object" && value[0] !== null) {
    const list = value as readonly unknown[];
    const length = honestLength(op, arg, list, limit, max, (item) => typeof item === "object" && item !== null);
    const copy = new Float64Array(dimension * length);
    for (let i = 0; i < length; i += 1) copy.set(one(op, arg, list[i], i, dimension), dimension * i);
    return copy;
  }
  const copy = numbers(op, arg, value, limit, max, "", dimension);
  if (copy.length % dimension !== 0) {
    const bound = dimension === 2 ? "an even number, two for each point" : "a multiple of 3, three for each point";
    throw wrongLength(op, arg, copy.length, bound);
  }
  return coordinates(op, arg, copy);
}

const AXES = ["x", "y", "z"] as const;

function one(op: string, arg: string, item: unknown, i: number, dimension: 2 | 3): number[] {
  const isArray = Array.isArray(item) || ArrayBuffer.isView(item);
  if (typeof item !== "object" || item === null || (isArray && (item as unknown[]).length !== dimension)) {
    throw wrong("E_TYPE", op, arg, item, dimension === 2 ? "a pair of numbers" : "three numbers", i);
  }
  return AXES.slice(0, dimension).map((axis, k) => {
    const value: unknown = isArray ? (item as unknown[])[k] : (item as Record<string, unknown>)[axis];
    // The name is made only where something is wrong: there may be a million points.
    if (typeof value === "number" && Math.abs(value) <= LARGEST) return value + 0;
    return coordinate(op, arg, value, dimension * i + k, `${arg}[${i}]${isArray ? `[${k}]` : `.${axis}`}`);
  });
}

/** Refuses the first number that is not a coordinate; turns −0 into 0, so that JSON can carry every number. */
export function coordinates(op: string, arg: string, array: Coordinates): Coordinates {
  for (let i = 0; i < array.length; i += 1) {
    const value = array[i] ?? 0;
    if (!(Math.abs(value) <= LARGEST)) coordinate(op, arg, value, i);
    array[i] = value + 0;
  }
  return array;
}

/** So many numbers, finite or not; few, which may be in single precision, as vectors and matrices of graphics are. */
export function exactly(op: string, arg: string, value: unknown, needed: number): Coordinates {
  const single = tagOf(value) === "Float32Array" && lengthOf?.call(value) === needed;
  const given = numbers(op, arg, single ? new Float64Array(value as Float32Array) : value, "maxPoints", MAX_POINTS);
  if (given.length !== needed) throw wrongLength(op, arg, given.length, String(needed));
  return given;
}

/** Two coordinates. */
export function twoNumbers(op: string, arg: string, value: unknown): [number, number] {
  const [x = 0, y = 0] = coordinates(op, arg, exactly(op, arg, value, 2));
  return [x, y];
}

/** Refuses a result array that is too small, has gone, or overlaps an input. */
export function output(op: string, value: unknown, needed: number, input?: Float64Array): Float64Array {
  if (!isFloat64Array(value)) throw wrong("E_TYPE", op, "out", value, "Float64Array");
  const length = lengthOfArray(op, "out", value);
  if (length < needed) throw wrongLength(op, "out", length, `>= ${needed}`);
  if (
    input !== undefined &&
    value.buffer === input.buffer &&
    value.byteOffset < input.byteOffset + input.byteLength &&
    input.byteOffset < value.byteOffset + 8 * needed
  ) {
    throw wrong("E_TYPE", op, "out", value, "an array that does not overlap the input");
  }
  return value;
}

/** Text of a limited size. */
export function text(op: string, arg: string, value: unknown, limit: string, max: number): string {
  if (typeof value !== "string") throw wrong("E_TYPE", op, arg, value, "string");
  if (value.length > max) throw overLimit(op, arg, limit, max, value.length);
  return value;
}
