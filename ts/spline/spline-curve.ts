/**
 * What interpolating and B-spline curves have in common: points on a grid, and the roots of the functions that weigh
 * them.
 */
import {
  type Floats,
  type HermiteCurve,
  LARGEST,
  MeasuredCurve,
  type PointsLike,
  type Root,
  type SpacePointsLike,
  affine,
  coordinate,
  curveIn,
  dataOf,
  integer,
  points as checkPoints,
  rootList,
  rootNumbers,
  tolerance as checkTolerance,
  tooFewPoints,
  wrongLength,
} from "../core.js";
import { SplineData } from "./spline-data.js";
import { peek, result } from "./spline-engine.js";

/** Points in the plane or in space. */
export type AnyPointsLike = PointsLike | SpacePointsLike;

/** The arrays of a curve on a grid, and the proof that it is one. @internal */
export function splineOf(curve: SplineCurve, op: string, arg?: string): SplineData {
  return dataOf(curve, op, SplineData, arg);
}

/** What the plain data of every kind have in common. @internal */
export function plain({ closed, dimension, points, roots }: SplineData): { version: 1; closed: boolean; dimension: 2 | 3; points: number[]; roots: Root[] } {
  return { version: 1, closed, dimension, points: Array.from(points), roots: rootList(roots) };
}

/**
 * Points of the dimension that is asked for, or else that they show: triples and objects with z are in space. @internal
 */
export function anyPoints(op: string, value: unknown, dimension: unknown): { points: Floats; dimension: 2 | 3 } {
  const asked = dimension === undefined ? shownBy(value) : integer(op, "dimension", dimension, 2, 3);
  const axes = asked === 3 ? 3 : 2;
  return { points: checkPoints(op, "points", value, undefined, axes), dimension: axes };
}

function shownBy(value: unknown): number {
  const first: unknown = Array.isArray(value) ? value[0] : undefined;
  if (typeof first !== "object" || first === null) return 2;
  const isList = Array.isArray(first) || ArrayBuffer.isView(first);
  return isList ? (first as ArrayLike<unknown>).length : "z" in first ? 3 : 2;
}

/**
 * Roots that may be left out: none at all are what the kernel takes for the default, so that an empty list must not get
 * there.
 * @internal
 */
export function rootsOrDefault(op: string, value: unknown): Floats {
  if (value === undefined) return new Float64Array();
  const roots = rootNumbers(op, value);
  if (roots.length === 0) throw tooFewPoints(op, "roots", 0, 3);
  return roots;
}

/** Where a point goes; in the plane z is 0. @internal */
export function placeOf(op: string, { dimension }: SplineData, x: unknown, y: unknown, z: unknown): [number, number, number] {
  return [coordinate(op, "x", x), coordinate(op, "y", y), dimension === 3 ? coordinate(op, "z", z) : 0];
}

/** What the image of a curve under an affine map is made of. @internal */
export function imageOf(curve: SplineCurve, matrix: unknown): SplineData {
  const op = "transform";
  const data = splineOf(curve, op);
  const image = affine(op, matrix, data.dimension, data.roots);
  const patches = data.patches.map((patch) => ({ ...patch, displacements: image(patch.displacements, 2 * LARGEST, 0) }));
  return data.over(image(data.points), patches);
}

/** A curve on a grid. */
export abstract class SplineCurve extends MeasuredCurve {
  /** The roots per unit of the parameter: a copy. */
  get roots(): Root[] {
    return rootList(splineOf(this, "roots").roots);
  }

  /** The points, all coordinates in turn: a copy. Setting them moves all at once; there must be as many as before. */
  get points(): Float64Array {
    return splineOf(this, "points").points.slice();
  }

  set points(value: AnyPointsLike) {
    const op = "points";
    const data = splineOf(this, op);
    const next = checkPoints(op, op, value, undefined, data.dimension);
    if (next.length !== data.points.length) throw wrongLength(op, op, next.length, String(data.points.length));
    data.points.set(next);
    data.touch();
  }

  /**
   * Moves point i, counted from 0; in space `z` goes with x and y.
   *
   * @throws {ExplineError} E_RANGE of an `i` that is no point's, and of coordinates beyond ±1e9.
   */
  setPoint(i: number, x: number, y: number, z?: number): void {
    const op = "setPoint";
    const data = splineOf(this, op);
    const at = data.dimension * integer(op, "i", i, 0, data.count - 1);
    data.points.set(placeOf(op, data, x, y, z).slice(0, data.dimension), at);
    data.touch();
  }

  /**
   * The same plane curve with points and tangents, which can `insert`, `remove`, `split`, `trim` and `reverse`. It is
   * exact, and `maxError` 0, where the roots are 0 up to twice and one pair ±iω or ±k, or 0 up to four times; else it
   * is made of cubics within `tolerance` (default 1e-9 of its size), and `maxError` is a proved bound. The parameter
   * starts at 0 and stays: everywhere where it is exact; of cubics at the ends of the curve's own segments, between
   * which places lie at other parameters than before. Where a tangent would be beyond ±1e9 or a segment shorter than
   * 1e-12 it runs slower, by a power of 2.
   *
   * @throws {ExplineError} E_DEGENERATE for a curve in space; E_RANGE of a `tolerance` that is not above 0.
   */
  toHermite(tolerance?: number): { curve: HermiteCurve; maxError: number } {
    const op = "toHermite";
    const data = splineOf(this, op);
    const within = tolerance === undefined ? 0 : checkTolerance(op, tolerance);
    const count = data.ask(op, (kernel, slot) => kernel.to_hermite(slot, within));
    return { curve: curveIn(peek(count)), maxError: result(0) };
  }
}
