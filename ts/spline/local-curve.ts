/** More control points where the user works, and none elsewhere. */
import {
  type Floats,
  type MatrixLike,
  type Root,
  finite,
  flag,
  integer,
  numbers,
  options as checkOptions,
  overLimit,
  patchNumber,
  wrong,
  wrongLength,
} from "../core.js";
import { type AnyPointsLike, SplineCurve, anyPoints, imageOf, placeOf, plain, rootsOrDefault, splineOf } from "./spline-curve.js";
import { type Patch, SplineData, SplineKind, readSpline } from "./spline-data.js";
import { copy } from "./spline-engine.js";

/** What a {@link LocalCurve} is made from. */
export interface LocalCurveOptions {
  /** Points of the interpolating curve under the patches. */
  points: AnyPointsLike;
  /** 2 or 3 coordinates for each point. Default: what the points show; interleaved numbers are of the plane. */
  dimension?: 2 | 3 | undefined;
  /** Whether the last point is joined to the first. Default true. */
  closed?: boolean | undefined;
  /** Roots per unit of the parameter; the default is that of `InterpolatingCurve`. */
  roots?: readonly Root[] | undefined;
  /** The patches, as `patches` gives them. Default none. */
  patches?: readonly { level: number; first: number; displacements: Float64Array | readonly number[] }[] | undefined;
}

/** A {@link LocalCurve} as plain data. Fields that a newer version wrote are kept. */
export interface LocalCurveJSON {
  /** What it is. */
  type: "LocalCurve";
  /** Of the format; a file of a newer one is refused. */
  version: 1;
  /** Whether the last point is followed by the first. */
  closed: boolean;
  /** Coordinates of each point. */
  dimension: 2 | 3;
  /** All coordinates of each point in turn. */
  points: number[];
  /** What the curve under the patches reproduces. */
  roots: Root[];
  /** Finer control points, as what they add to the curve under them. */
  patches: { level: number; first: number; displacements: number[] }[];
  [unknown: string]: unknown;
}

const CURVE = "LocalCurve";
/** The most patches of one curve. */
const MAX_PATCHES = 4096;
/** The most numbers in one patch. */
const MAX_NUMBERS = 12_000_000;

/**
 * An interpolating curve with patches of finer control points where they are wanted. Making room changes no bit of the
 * shape; moving a point of the curve takes the detail along; dropping a patch takes its detail away.
 */
export class LocalCurve extends SplineCurve {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static override readonly name = CURVE;

  /**
   * A curve from points and patches. The arrays are copied.
   *
   * @throws {ExplineError} for whatever is wrong with the options; nothing is made then.
   */
  constructor(options: LocalCurveOptions) {
    super(options instanceof SplineData ? options : checkedLocal(CURVE, options));
  }

  /** The patches, the coarser ones first: copies. */
  get patches(): Patch[] {
    const copyOf = ({ level, first, displacements }: Patch): Patch => ({ level, first, displacements: displacements.slice() });
    return splineOf(this, "patches").patches.map(copyOf);
  }

  /**
   * The same curve with a patch of all control points of the grid 2^−levels that lie within `reach` of t in the
   * parameter; `levels`, from 1 to 12, defaults to 2, `reach` to 1.
   *
   * @throws {ExplineError} E_RANGE of `t` outside the domain of an open curve, of `levels`, and of a `reach` outside 0
   *   to 1e6; E_DEGENERATE of a `reach` within which there is no control point.
   */
  refineAt(t: number, options?: { levels?: number | undefined; reach?: number | undefined }): LocalCurve {
    return refinedAt(splineOf(this, "refineAt"), t, options);
  }

  /**
   * The control points of patch k where the refined curve has them, coarser patches included: all coordinates in turn.
   *
   * @throws {ExplineError} E_RANGE of a `k` that is no patch's, and where the refined curve has points beyond ±1e9.
   */
  patchPoints(k: number): Float64Array {
    const op = "patchPoints";
    const data = splineOf(this, op);
    const which = patchNumber(op, "k", k, data.patches.length);
    return copy(data.ask(op, (kernel, slot) => kernel.patch_points(slot, which)));
  }

  /**
   * Moves control point i of patch k, both counted from 0; in space `z` goes with x and y.
   *
   * @throws {ExplineError} E_RANGE of an `i` or `k` that there is not, and of coordinates beyond ±1e9.
   */
  setPatchPoint(k: number, i: number, x: number, y: number, z?: number): void {
    const op = "setPatchPoint";
    const data = splineOf(this, op);
    const which = patchNumber(op, "k", k, data.patches.length);
    const { displacements = new Float64Array() } = data.patches[which] ?? {};
    const at = integer(op, "i", i, 0, displacements.length / data.dimension - 1);
    const place = placeOf(op, data, x, y, z);
    data.patches = readSpline(data.ask(op, (kernel, slot) => kernel.move_patch_point(slot, which, at, ...place))).patches;
    data.touch();
  }

  /**
   * The curve without patch k and its detail.
   *
   * @throws {ExplineError} E_RANGE of a `k` that is no patch's.
   */
  withoutPatch(k: number): LocalCurve {
    const op = "withoutPatch";
    const data = splineOf(this, op);
    const which = patchNumber(op, "k", k, data.patches.length);
    return localOf(data.over(data.points.slice() as Floats, data.patches.filter((_, i) => i !== which)));
  }

  /**
   * The image under an affine map: of a plane curve x′ = a·x + c·y + e, y′ = b·x + d·y + f with the six numbers of
   * SVG's `matrix(a b c d e f)`, of one in space that of a 4 × 4 matrix, 16 numbers column by column, whose last row is
   * 0, 0, 0, 1. Exact to rounding; the patches come along.
   *
   * @throws {ExplineError} E_DEGENERATE of `matrix` for a translation where 0 is not among the roots: no points make
   *   the image then.
   */
  transform(matrix: MatrixLike): LocalCurve {
    return localOf(imageOf(this, matrix));
  }

  /**
   * The curve as plain data, for files and for `postMessage`, which takes no curve; `fromJSON` is the inverse to the
   * last bit, of up to a million points.
   */
  toJSON(): LocalCurveJSON {
    const data = splineOf(this, "toJSON");
    const patches = data.patches.map(({ level, first, displacements }) => ({ level, first, displacements: Array.from(displacements) }));
    return { type: CURVE, ...plain(data), patches, ...data.extra };
  }
}

/** A curve with one patch more. @internal */
export function refinedAt(data: SplineData, t: unknown, options: unknown): LocalCurve {
  const op = "refineAt";
  const { levels = 2, reach = 1 } = checkOptions(op, options, ["levels", "reach"]);
  const at = finite(op, "t", t);
  const steps = integer(op, "levels", levels, 1, 12);
  const within = finite(op, "reach", reach);
  return localOf(readSpline(data.ask(op, (kernel, slot) => kernel.refine_at(slot, at, steps, within))));
}

/** Makes a curve of arrays that the kernel or a check has vouched for. @internal */
export function localOf(data: SplineData): LocalCurve {
  return new LocalCurve(data as unknown as LocalCurveOptions);
}

/**
 * The arrays of a curve that a caller or a file describes, checked: of an interpolating one, too, which has no patches.
 * @internal
 */
export function checkedLocal(op: string, options: unknown, kind = SplineKind.Local): SplineData {
  const names = ["points", "dimension", "closed", "roots", "patches"] as const;
  type Own = { readonly [name in (typeof names)[number]]?: unknown };
  const own: Own = checkOptions(op, options, kind === SplineKind.Local ? names : names.slice(0, -1));
  const { points, dimension } = anyPoints(op, own.points, own.dimension);
  const roots = rootsOrDefault(op, own.roots);
  const closed = flag(op, "closed", own.closed, true);
  const { patches = [] } = own;
  if (!Array.isArray(patches)) throw wrong("E_TYPE", op, "patches", patches, "an array");
  if (patches.length > MAX_PATCHES) throw overLimit(op, "patches", "maxPatches", MAX_PATCHES, patches.length);
  const list = Array.from(patches as unknown[], (patch, i) => checkedPatch(op, patch, i, dimension));
  const data = new SplineData(kind, points, dimension, closed, roots, 1, 0, list);
  data.load(op);
  return data;
}

function checkedPatch(op: string, value: unknown, i: number, dimension: number): Patch {
  const patch = `patches[${i}]`;
  const { level, first, displacements } = checkOptions(op, value, ["level", "first", "displacements"], patch);
  const arg = `${patch}.displacements`;
  const given: Floats = numbers(op, arg, displacements, "maxPoints", MAX_NUMBERS);
  if (given.length % dimension !== 0) throw wrongLength(op, arg, given.length, `a multiple of ${dimension}`);
  return {
    level: integer(op, `${patch}.level`, level, 1, 12),
    first: integer(op, `${patch}.first`, first, 0, 0xffffffff),
    displacements: given.map((number, k) => finite(op, arg, number, k) + 0),
  };
}
