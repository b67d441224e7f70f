/** What a surface is made from, and the checks of it. */
import {
  type Floats,
  LARGEST,
  type Root,
  coordinates,
  count as checkCount,
  flag,
  inRange,
  integer,
  isFloat64Array,
  lengthOfArray,
  numbers,
  options as checkOptions,
  overLimit,
  rootNumbers,
  wrong,
  wrongLength,
} from "../core.js";
import { type DirectionData, type PatchData, type PatchWindow, SurfaceData } from "./surface-data.js";

/** How a net runs in one of its two directions. */
export interface Direction {
  /** The roots of the generator, per unit of the parameter; closed under conjugation and under negation. */
  roots: readonly Root[];
  /** How many points: 3 or more where closed, else 2·n₀ − 2 or more (n₀ at a level above 0). */
  count: number;
  /** Whether the last point is followed by the first. */
  closed: boolean;
  /**
   * 0, the default: points on the surface, one for each unit. k: B-spline control points near it, 2ᵏ for each unit. At
   * most 12.
   */
  level?: number | undefined;
}

/** A patch of finer control points over a part of a surface, as plain data. */
export interface SurfacePatch {
  /** Level of the patch's grid in u, its first row there, and how many rows. */
  u: PatchWindow;
  /** The same in v. */
  v: PatchWindow;
  /** How far each control point was moved from where the refined net has it: three numbers each, v fastest. */
  displacements: Float64Array;
}

/** What a {@link TensorSurface} is made from. */
export interface TensorSurfaceOptions {
  /** 3-D points, three numbers each, row by row: v runs fastest. */
  net: Float64Array | readonly number[];
  /** From row to row. */
  u: Direction;
  /** Along a row. */
  v: Direction;
  /** Detail, as `patches` or the `toJSON` of another surface gives it. */
  patches?: readonly { u: PatchWindow; v: PatchWindow; displacements: Float64Array | readonly number[] }[] | undefined;
}

/** The most points of a net. */
const MAX_NET = 4_194_304;
/** The most patches of one surface. */
const MAX_PATCHES = 4096;
/** The finest level. @internal */
export const MAX_LEVEL = 12;

/** A net's numbers: finite, within ±1e9, as many as there should be. @internal */
export function netOf(op: string, value: unknown, needed: number): Floats {
  // One that is as long as it likes is refused before it is copied.
  const length = isFloat64Array(value) ? lengthOfArray(op, "net", value) : needed;
  if (length !== needed) throw wrongLength(op, "net", length, String(needed));
  const net = numbers(op, "net", value, "maxSurfacePoints", 3 * MAX_NET);
  if (net.length !== needed) throw wrongLength(op, "net", net.length, String(needed));
  return coordinates(op, "net", net);
}

/** A pair of indices within a net or a patch. @internal */
export function place(op: string, i: unknown, j: unknown, rows: number, cols: number): readonly [number, number] {
  return [integer(op, "i", i, 0, rows - 1), integer(op, "j", j, 0, cols - 1)];
}

function directionOf(op: string, arg: string, value: unknown): DirectionData {
  const { roots, count, closed, level = 0 } = checkOptions(op, value, ["roots", "count", "closed", "level"], arg);
  return {
    roots: rootNumbers(op, roots, `${arg}.roots`),
    count: checkCount(op, `${arg}.count`, count, 0, "maxSurfacePoints", MAX_NET),
    closed: flag(op, `${arg}.closed`, closed, true),
    level: integer(op, `${arg}.level`, level, 0, MAX_LEVEL),
  };
}

function windowOf(op: string, arg: string, value: unknown): PatchWindow {
  const { level, first, count } = checkOptions(op, value, ["level", "first", "count"], arg);
  return {
    level: integer(op, `${arg}.level`, level, 1, MAX_LEVEL),
    first: integer(op, `${arg}.first`, first, 0, MAX_NET),
    count: integer(op, `${arg}.count`, count, 1, MAX_NET),
  };
}

function patchOf(op: string, value: unknown, i: number): PatchData {
  const arg = `patches[${i}]`;
  const { u, v, displacements } = checkOptions(op, value, ["u", "v", "displacements"], arg);
  const windows = { u: windowOf(op, `${arg}.u`, u), v: windowOf(op, `${arg}.v`, v) };
  const given = numbers(op, `${arg}.displacements`, displacements, "maxSurfacePoints", 3 * MAX_NET);
  const needed = 3 * windows.u.count * windows.v.count;
  if (given.length !== needed) throw wrongLength(op, `${arg}.displacements`, given.length, String(needed));
  // From one end of what is allowed to the other at most.
  const checked = given.map((number, k) => inRange(op, `${arg}.displacements`, number, -2 * LARGEST, 2 * LARGEST, k) + 0);
  return { ...windows, displacements: checked };
}

/** The arrays of a surface that a caller or a file describes, checked. @internal */
export function checkedSurface(op: string, options: unknown): SurfaceData {
  const own = checkOptions(op, options, ["net", "u", "v", "patches"]);
  const [u, v] = [directionOf(op, "u", own.u), directionOf(op, "v", own.v)];
  const points = u.count * v.count;
  if (points > MAX_NET) throw overLimit(op, "net", "maxSurfacePoints", MAX_NET, points);
  const net = netOf(op, own.net, 3 * points);
  const { patches = [] } = own;
  if (!Array.isArray(patches)) throw wrong("E_TYPE", op, "patches", patches, "an array");
  if (patches.length > MAX_PATCHES) throw overLimit(op, "patches", "maxPatches", MAX_PATCHES, patches.length);
  // Array.from looks at holes, too.
  const list = Array.from(patches as unknown[], (patch, i) => patchOf(op, patch, i));
  const data = new SurfaceData(net, u, v, list);
  data.load(op);
  return data;
}
