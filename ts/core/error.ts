/** What can go wrong, as one class with stable codes. */

/** The stable code of a failure, the only thing to switch on; adding one is a minor version, never less. */
export type ErrorCode =
  /** Wrong JavaScript type, wrong `this`, unknown option. */
  | "E_TYPE"
  /** A number is NaN or infinite. */
  | "E_NOT_FINITE"
  /** A number is outside its documented range. */
  | "E_RANGE"
  /** An array has the wrong length. */
  | "E_LENGTH"
  /** Fewer points than the operation needs. */
  | "E_TOO_FEW_POINTS"
  /** Well formed, but there is no unique answer. */
  | "E_DEGENERATE"
  /** A limit on the size of inputs or outputs; `limit`, `max` and `actual` say which. */
  | "E_LIMIT"
  /** The allocator refused. */
  | "E_MEMORY"
  /** SVG path data that cannot be read; `index` is the offset of the first character that makes no sense. */
  | "E_PARSE_SVG"
  /** JSON text that cannot be read; `index` is the offset. */
  | "E_PARSE_JSON"
  /** Readable JSON with the wrong content; `path` says where. */
  | "E_SCHEMA"
  /** Made by a newer version, or not available in this environment. */
  | "E_UNSUPPORTED"
  /** The buffer of an array was transferred or resized away. */
  | "E_DETACHED"
  /** The engine could not be started; `reason` is one of csp, network, mime, compile, version, memory, unsupported. */
  | "E_INIT"
  /**
   * `expline/slim` was used before `init`, or other work than curves before its own: `initSpline`, `initSurface`,
   * `initFit`, `initTrace`. The curves of fits and traces need `init`, too.
   */
  | "E_NOT_READY"
  /** The caller's AbortSignal ended the work; `cause` is the signal's reason. */
  | "E_CANCELLED"
  /** An object was used after `dispose`. */
  | "E_DISPOSED"
  /**
   * An object was used while it is at work: from inside its own progress callback, or before its promise has settled.
   */
  | "E_BUSY"
  /** The engine stopped: a fault of ours. It is replaced at the next call, and nothing is lost. */
  | "E_INTERNAL";

/** The fields of an {@link ExplineError} beside its code and message. */
export interface ErrorDetails {
  /**
   * The argument at fault, with the position where there is one: `points[17]`, of pairs and objects `points[8][1]`,
   * `points[8].y`.
   */
  readonly argument?: string;
  /** The argument's bare name: `points`. */
  readonly arg?: string;
  /** Position in the array (interleaved numbers are counted singly), or offset in the text. */
  readonly index?: number;
  /** Place in a JSON value: `$.points[2]`. */
  readonly path?: string;
  /** The bad value: a number, or a short piece of text. */
  readonly value?: unknown;
  /** What is allowed: `|x| <= 1e9`. */
  readonly bound?: string;
  /** Name of the limit: `maxPoints`. */
  readonly limit?: string;
  /** The limit's value. */
  readonly max?: number;
  /** What the call would have needed. */
  readonly actual?: number;
  /** Which kind of failure within the code: `csp`, `duplicate-key`. */
  readonly reason?: string;
  /** What could be done before the failure: the curves of a path up to its mistake. */
  readonly partial?: unknown;
  /** Options that would let the call through: `{ speckle: 12 }`. */
  readonly offer?: Readonly<Record<string, number>>;
  /** True when the engine's instance died of it and was replaced. */
  readonly fatal?: boolean;
  /** The error that caused this one. */
  readonly cause?: unknown;
}

/** The same, where something may be unknown. @internal */
export type Details = { readonly [name in keyof ErrorDetails]: ErrorDetails[name] | undefined };

declare const nobody: unique symbol;
/** Nothing is of this type, but a class whose constructor asks for it is still one that tests can name. */
interface Nobodys {
  readonly [nobody]: never;
}

const NAME = "ExplineError";

/** What is known of it: whatever there is, is an own field. */
export interface ExplineError extends ErrorDetails {
  /**
   * Said here: `Error` has it, too, but in libraries before ES2022. The error that caused this one: the signal's reason
   * of E_CANCELLED.
   */
  readonly cause?: unknown;
}

/** Every failure of this package: a clear message for people, stable fields for programs. */
export class ExplineError extends Error {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static override readonly name = NAME;

  /** "ExplineError", also where `instanceof` cannot tell: across frames and copies of the package. */
  override readonly name = NAME;
  /** What kind of failure. */
  readonly code: ErrorCode;
  /** The operation that failed: `evaluate`, `parsePath`. */
  readonly op: string;
  /** True when the engine's instance died of it and was replaced. */
  readonly fatal: boolean;

  /** Errors are made by the package alone: no one else has what it takes. */
  constructor(none: Nobodys);
  /** @internal */
  constructor(code: ErrorCode, op: string, what: string, details?: Details);
  constructor(given: ErrorCode | Nobodys, op = "", what = "", details: Details = {}) {
    const code = given as ErrorCode;
    const { cause, fatal = false, ...rest } = details;
    super(`${op}: ${what} [${code}]`, cause === undefined ? undefined : { cause });
    this.code = code;
    this.op = op;
    this.fatal = fatal;
    // Defined, not assigned: a setter that a page has put on Object.prototype must not see them.
    for (const [name, value] of Object.entries(rest)) if (value !== undefined) Object.defineProperty(this, name, { value, enumerable: true });
  }
}

/** @internal */
export const typedArray: object = Object.getPrototypeOf(Float64Array.prototype) as object;
const ownTag = Object.getOwnPropertyDescriptor(typedArray, Symbol.toStringTag)?.get;

/** What a typed array is, of whichever realm and whatever it says; undefined for anything else. @internal */
export function tagOf(value: unknown): unknown {
  return ownTag?.call(value);
}

/** A value in at most 40 characters, never an object's insides. */
export function shown(value: unknown): string {
  switch (typeof value) {
    case "number":
    case "boolean":
    case "undefined":
      return String(value);
    case "bigint":
      return "a bigint";
    case "string":
      return JSON.stringify(value.length > 36 ? `${value.slice(0, 35)}…` : value);
    case "object":
      return value === null ? "null" : Array.isArray(value) ? "an array" : typed(value);
    default:
      return `a ${typeof value}`;
  }
}

function typed(value: object): string {
  const tag = tagOf(value);
  return tag === undefined ? "an object" : `of type ${tag as string}`;
}

/** The details and the name of an argument, or of one place in it. */
function place(at: string, index?: number, argument = index === undefined ? at : `${at}[${index}]`): Details & { argument: string } {
  return { arg: at.replace(/\W.*/, ""), index, argument };
}

/** `argument is value; expected bound`. */
export function wrong(
  code: "E_TYPE" | "E_NOT_FINITE" | "E_RANGE",
  op: string,
  arg: string,
  value: unknown,
  bound: string,
  index?: number,
  argument?: string,
): ExplineError {
  const at = place(arg, index, argument);
  const kept = typeof value === "string" ? value.slice(0, 40) : typeof value === "number" ? value : undefined;
  const what = `${at.argument} is ${shown(value)}; expected ${bound}`;
  return new ExplineError(code, op, what, { ...at, value: kept, bound });
}

/** The least number above 0 that the engine asks for. */
const LEAST = 2 ** -1022;

/** What lies between two numbers, in words. */
export function range(least: number, most: number): string {
  if (least === -most) return most === Infinity ? "a finite number" : `a finite number with |x| <= ${power(most)}`;
  if (least === -Infinity) return `a number <= ${power(most)}`;
  if (most >= Number.MAX_VALUE) return least === LEAST ? "a number > 0" : `a number >= ${power(least)}`;
  if (least === LEAST) return `a number in (0, ${power(most)}]`;
  return `a number in [${power(least)}, ${power(most)}]`;
}

/** 1e9 rather than 1000000000, π rather than its digits. */
function power(value: number): string {
  if (value === Math.PI) return "π";
  return String(value).replace(/^(\d)0{6,}$/, (digits, first: string) => `${first}e${digits.length - 1}`);
}

/** `argument has 3 numbers; expected 8`. */
export function wrongLength(op: string, arg: string, actual: number, bound: string): ExplineError {
  return new ExplineError("E_LENGTH", op, `${arg} has length ${actual}; expected ${bound}`, {
    ...place(arg),
    actual,
    bound,
  });
}

/** A limit would be exceeded. */
export function overLimit(op: string, arg: string, limit: string, max: number, actual: number): ExplineError {
  const what = `${arg} needs ${actual}; ${limit} is ${max}`;
  return new ExplineError("E_LIMIT", op, what, { ...place(arg), limit, max, actual });
}

/** No unique answer; `value` is the number that has none, where it is one. */
export function degenerate(op: string, arg: string, why: string, index?: number, value?: number, partial?: unknown): ExplineError {
  const at = place(arg, index);
  const what = value === undefined ? at.argument : `${at.argument} = ${value}`;
  return new ExplineError("E_DEGENERATE", op, `${what} has no unique answer: ${why}`, {
    ...at,
    value,
    bound: why,
    partial,
  });
}

/** Fewer points, or roots, than the operation needs. */
export function tooFewPoints(op: string, arg: string, actual: number, least: number): ExplineError {
  const things = arg === "points" ? `${actual} ${actual === 1 ? "point" : "points"}` : String(actual);
  const what = `${arg} ${arg.endsWith("count") ? "is" : "has"} ${things}; expected at least ${least}`;
  return new ExplineError("E_TOO_FEW_POINTS", op, what, { ...place(arg), actual, bound: `>= ${least}` });
}
