/** Curves as plain data, and back, from data that need not be friendly. */
import {
  type ErrorCode,
  type ErrorDetails,
  ExplineError,
  type HermiteCurve,
  type HermiteCurveJSON,
  checked,
  curveOf,
  options as checkOptions,
  overLimit,
  shown,
  wrong,
} from "./core.js";
import { scan } from "./json/json-text.js";
import {
  type BSplineCurve,
  type BSplineCurveJSON,
  type InterpolatingCurve,
  type InterpolatingCurveJSON,
  type LocalCurve,
  type LocalCurveJSON,
  bSplineOf,
  checkedBSpline,
  checkedInterpolating,
  checkedLocal,
  interpolatingOf,
  localOf,
} from "./spline.js";
import { type TensorSurface, type TensorSurfaceJSON, checkedSurface, surfaceOf } from "./surface.js";

/** Something in the data that was not understood, but kept. */
export interface JSONWarning {
  /** The stable code. */
  code: "W_UNKNOWN_FIELD";
  /** `$.name`. */
  path: string;
}

/** How a file is read. */
export interface ReadOptions {
  /** Hears of everything that was not understood, but kept. */
  onWarning?: ((warning: JSONWarning) => void) | undefined;
}

const OP = "fromJSON";
/** The longest JSON text, in characters. */
const MAX_TEXT = 64 << 20;
/** The most brackets inside one another. */
const MAX_DEPTH = 64;
const VERSION = 1;

/** One kind of object: what a file of it must have and may have, and how it is made of that. */
interface Kind {
  readonly required: readonly string[];
  readonly optional: readonly string[];
  readonly make: (options: unknown, extra: Readonly<Record<string, unknown>> | undefined) => Readable;
}

/** What a file can be of. */
type Readable = HermiteCurve | InterpolatingCurve | LocalCurve | BSplineCurve | TensorSurface;

/** Every kind, by the `type` of its file. */
const KINDS: Readonly<Record<string, Kind>> = {
  HermiteCurve: {
    required: ["closed", "space", "points", "tangents", "omega"],
    optional: ["tangentsIn", "lengths"],
    make: (options, extra) => curveOf(withExtra(checked(OP, options), extra)),
  },
  InterpolatingCurve: {
    required: ["closed", "dimension", "points", "roots"],
    optional: [],
    make: (options, extra) => interpolatingOf(withExtra(checkedInterpolating(OP, options), extra)),
  },
  LocalCurve: {
    required: ["closed", "dimension", "points", "roots", "patches"],
    optional: [],
    make: (options, extra) => localOf(withExtra(checkedLocal(OP, options), extra)),
  },
  BSplineCurve: {
    required: ["closed", "dimension", "points", "roots", "step", "offset"],
    optional: ["domain"],
    make: (options, extra) => bSplineOf(withExtra(checkedBSpline(OP, options), extra)),
  },
  TensorSurface: {
    required: ["net", "u", "v"],
    optional: ["patches"],
    make: (options, extra) => surfaceOf(withExtra(checkedSurface(OP, options), extra)),
  },
};

function withExtra<D extends { extra: Readonly<Record<string, unknown>> | undefined }>(data: D, extra: D["extra"]): D {
  data.extra = extra;
  return data;
}

/**
 * The curve or surface that `toJSON` described, to the last bit: from its object, or from JSON text.
 *
 * Only own properties count. Fields that are not known are kept for the next `toJSON`; `onWarning` hears of them.
 *
 * @throws {ExplineError} E_PARSE_JSON for text that is not JSON, E_SCHEMA with `path` for other content, E_UNSUPPORTED
 *   for a newer version, E_LIMIT, and the codes of the constructor with `path`.
 */
export function fromJSON<V>(value: V & (0 extends 1 & V ? unknown : never), options?: ReadOptions): Readable;
/** The Hermite curve that `toJSON` described, to the last bit. */
export function fromJSON(value: HermiteCurveJSON, options?: ReadOptions): HermiteCurve;
/** The interpolating curve that `toJSON` described, to the last bit. */
export function fromJSON(value: InterpolatingCurveJSON, options?: ReadOptions): InterpolatingCurve;
/** The curve with patches of detail that `toJSON` described, to the last bit. */
export function fromJSON(value: LocalCurveJSON, options?: ReadOptions): LocalCurve;
/** The B-spline curve that `toJSON` described, to the last bit. */
export function fromJSON(value: BSplineCurveJSON, options?: ReadOptions): BSplineCurve;
/** The surface that `toJSON` described, to the last bit. */
export function fromJSON(value: TensorSurfaceJSON, options?: ReadOptions): TensorSurface;
/** The curve or surface that `toJSON` described, to the last bit: from its object, or from JSON text. */
export function fromJSON(value: unknown, options?: ReadOptions): Readable;
export function fromJSON(value: unknown, options?: ReadOptions): Readable {
  const { onWarning } = checkOptions(OP, options, ["onWarning"]);
  if (onWarning !== undefined && typeof onWarning !== "function") {
    throw wrong("E_TYPE", OP, "onWarning", onWarning, "a function");
  }
  const object = record(typeof value === "string" ? parsed(value) : value, "$");
  const own = (name: string): unknown => (Object.hasOwn(object, name) ? object[name] : undefined);
  const kind = kindOf(own);
  const known = ["type", "version", ...kind.required, ...kind.optional];
  const extra: [string, unknown][] = [];
  const copies: Copies = new Map();
  for (const name of Object.keys(object)) {
    if (!known.includes(name)) extra.push([name, plain(object[name], `$${step(name)}`, [object], copies)]);
  }
  const made = read(kind, own, extra.length > 0 ? Object.fromEntries(extra) : undefined);
  for (const [name] of extra) {
    (onWarning as ((warning: JSONWarning) => void) | undefined)?.({ code: "W_UNKNOWN_FIELD", path: `$${step(name)}` });
  }
  return made;
}

function parsed(text: string): unknown {
  if (text.length > MAX_TEXT) throw overLimit(OP, "json", "maxBytes", MAX_TEXT, text.length);
  const clean = text.startsWith("\ufeff") ? text.slice(1) : text;
  scan(OP, clean, MAX_DEPTH);
  try {
    return JSON.parse(clean) as unknown;
  } catch (cause) {
    const [, digits] = /position (\d+)/.exec(String(cause)) ?? [];
    const index = digits === undefined ? undefined : Number(digits) + text.length - clean.length;
    const where = index === undefined ? "" : ` at offset ${index}`;
    throw new ExplineError("E_PARSE_JSON", OP, `json makes no sense${where}`, { arg: "json", argument: "json", index, cause });
  }
}

function schema(path: string, what: string, code: ErrorCode = "E_SCHEMA", details: ErrorDetails = {}): ExplineError {
  return new ExplineError(code, OP, `${path} ${what}`, { arg: "json", argument: path, path, ...details });
}

function expected(path: string, value: unknown, bound: string): ExplineError {
  return value === undefined
    ? schema(path, `is missing; expected ${bound}`, "E_SCHEMA", { bound })
    : schema(path, `is ${shown(value)}; expected ${bound}`, "E_SCHEMA", { bound });
}

function step(name: string): string {
  return /^[A-Za-z_$][\w$]*$/.test(name) ? `.${name}` : `[${JSON.stringify(name.slice(0, 40))}]`;
}

function record(value: unknown, path: string): Record<string, unknown> {
  if (typeof value !== "object" || value === null || Array.isArray(value)) throw expected(path, value, "an object");
  return value as Record<string, unknown>;
}

/** What the file says it is, in a version that is known. */
function kindOf(own: (name: string) => unknown): Kind {
  const version = own("version");
  if (typeof version !== "number" || !Number.isInteger(version) || version < 1) {
    throw expected("$.version", version, "1");
  }
  if (version > VERSION) throw schema("$.version", `is ${version}; this version reads 1`, "E_UNSUPPORTED");
  const type = own("type");
  if (typeof type !== "string" || !Object.hasOwn(KINDS, type)) {
    throw expected("$.type", type, Object.keys(KINDS).map((name) => `"${name}"`).join(" or "));
  }
  return KINDS[type] as Kind;
}

/** The object, checked by the same rules as its constructor's options. */
function read(
  { required, optional, make }: Kind,
  own: (name: string) => unknown,
  extra: Readonly<Record<string, unknown>> | undefined,
): Readable {
  for (const name of required) if (own(name) === undefined) throw expected(`$.${name}`, undefined, "a value");
  try {
    const options: Record<string, unknown> = Object.create(null) as Record<string, unknown>;
    for (const name of [...required, ...optional]) options[name] = own(name);
    return make(options, extra);
  } catch (error) {
    throw error instanceof ExplineError && error.argument !== undefined ? located(error) : error;
  }
}

/** The same failure, said of a place in the JSON. */
function located(error: ExplineError): ExplineError {
  const { name, message, stack, code: kind, op, ...fields } = error;
  const code = kind === "E_TYPE" || kind === "E_LENGTH" ? "E_SCHEMA" : kind;
  const what = message.slice(op.length + 2, -kind.length - 3);
  const path = `$.${error.argument}`;
  return new ExplineError(code, OP, `$.${what}`, { ...fields, arg: "json", argument: path, path, cause: error });
}

/**
 * What was copied, and how many brackets stand inside one another in it. What is shared is copied once: else a few
 * lists of lists never end.
 */
type Copies = Map<unknown, { readonly copy: unknown; readonly depth: number }>;

/** A copy that is nothing but JSON: own properties, finite numbers, whole characters, no circle. */
function plain(value: unknown, path: string, around: readonly unknown[], copies: Copies): unknown {
  if (typeof value === "string") return value.replace(/\p{Surrogate}/gu, "\ufffd");
  if (value === null || typeof value === "boolean") return value;
  if (typeof value === "number") {
    if (!Number.isFinite(value)) throw schema(path, `is ${value}; expected a finite number`, "E_NOT_FINITE");
    return value + 0;
  }
  if (typeof value !== "object") throw expected(path, value, "something that JSON can carry");
  if (around.includes(value)) throw schema(path, "contains itself");
  const known = copies.get(value);
  if (around.length + (known?.depth ?? 1) > MAX_DEPTH) {
    throw schema(path, `is too deep; maxDepth is ${MAX_DEPTH}`, "E_LIMIT", { limit: "maxDepth", max: MAX_DEPTH });
  }
  if (known !== undefined) return known.copy;
  const inside = [...around, value];
  let depth = 1;
  const copied = (item: unknown, at: string): unknown => {
    const copy = plain(item, at, inside, copies);
    depth = Math.max(depth, 1 + (copies.get(item)?.depth ?? 0));
    return copy;
  };
  const copy = Array.isArray(value)
    ? Array.from(value as unknown[], (item, i) => copied(item, `${path}[${i}]`))
    : Object.fromEntries(
        Object.keys(value).map((name) => [name, copied((value as Record<string, unknown>)[name], `${path}${step(name)}`)]),
      );
  copies.set(value, { copy, depth });
  return copy;
}
