/** The two sides of a point: where their handles end, and what they become when one of them is turned. */
import { ExplineError, HermiteCurve, MeasuredCurve, coordinate, integer, wrong } from "../core.js";

/** The side of a point: where the curve arrives, or where it leaves. */
export type HandleSide = "in" | "out";

/** Both sides of a point. */
export const SIDES = ["in", "out"] as const;

/** How the other handle of a point follows: turned into one line, made its mirror image, or left where it is. */
export type Joint = "smooth" | "symmetric" | "cusp";

/** Handles end at a third of the tangent: for cubics, at the control points of the Bézier. */
export const THIRD = 1 / 3;
/** Handles whose directions differ by less than this, in radians, are one line. */
const ONE_LINE = 1e-9;

/** A place of the plane, or a step in it. */
export type Place = [number, number];

/** One side of a point: its tangent, and the length of its segment where it has one. */
interface SideOfPoint {
  readonly tangent: Place;
  readonly length: number | undefined;
}

/** A point with both its sides. */
export interface PointOfCurve {
  readonly index: number;
  readonly at: Place;
  readonly in: SideOfPoint;
  readonly out: SideOfPoint;
}

/**
 * What is no curve of this copy of the package; one of another, as `expline/slim` is beside `expline`, looks as if it
 * were.
 */
export function notCurve(op: string, arg: string, value: unknown, bound: string, index?: number): ExplineError {
  if (!isForeign(value)) return wrong("E_TYPE", op, arg, value, bound, index);
  const argument = index === undefined ? arg : `${arg}[${index}]`;
  return new ExplineError("E_TYPE", op, `${argument} is a curve of another copy of expline, as expline/slim is beside expline; expected ${bound}`, { arg, argument, bound });
}

function isForeign(value: unknown): boolean {
  try {
    return /Curve\]$/.test(Object.prototype.toString.call(value)) && !(value instanceof MeasuredCurve);
  } catch {
    return false;
  }
}

/**
 * Every point of a curve, by its number; a number that is not one throws. The curve's lists are copied once for all of
 * them.
 */
export function pointsOf(op: string, curve: HermiteCurve): (i: unknown, arg?: string) => PointOfCurve {
  if (!(curve instanceof HermiteCurve)) throw notCurve(op, "curve", curve, "a HermiteCurve");
  const { points, tangents, tangentsIn, lengths, closed } = curve;
  const last = points.length / 2 - 1;
  return (i, arg = "i") => {
    const index = integer(op, arg, i, 0, last);
    const before = closed ? (index + last) % (last + 1) : index - 1;
    return {
      index,
      at: pair(points, index),
      in: { tangent: pair(tangentsIn, index), length: lengths[before] },
      out: { tangent: pair(tangents, index), length: lengths[index] },
    };
  };
}

/** Where the handle of a side ends; undefined at the free end of an open curve. */
export function handleOf(point: PointOfCurve, side: HandleSide): Place | undefined {
  const { tangent, length } = point[side];
  return length === undefined ? undefined : moved(point.at, tangent, (side === "in" ? -length : length) * THIRD);
}

/** What a point is now: smooth where its two sides are one line, and else a corner. */
export function jointAt(point: PointOfCurve): "smooth" | "cusp" {
  const [[a, b], [c, d]] = [point.in.tangent, point.out.tangent];
  const size = Math.hypot(a, b) * Math.hypot(c, d);
  return size > 0 && a * c + b * d > 0 && Math.abs(a * d - b * c) <= ONE_LINE * size ? "smooth" : "cusp";
}

/** A side of a point with its new tangent, and how the other side of it follows. */
type Turn = readonly [PointOfCurve, HandleSide, Place, Joint];

/** What becomes of the tangents at both ends of the straight segments beside a point when it moves. */
export function keptStraight(op: string, curve: HermiteCurve, point: PointOfCurve, to: Place): Turn[] {
  const at = pointsOf(op, curve);
  const count = curve.points.length / 2;
  /** The point at the other end of a side's segment. */
  const across = ({ index }: PointOfCurve, side: HandleSide): PointOfCurve => at((index + (side === "in" ? count - 1 : 1)) % count);
  const isLine = (from: PointOfCurve, side: HandleSide): boolean => from[side].length !== undefined && straight(from, side, across(from, side));
  return SIDES.filter((side) => isLine(point, side)).flatMap((side) => {
    const [end, other] = [across(point, side), opposite(side)];
    const [before, after] = [moved(end.at, point.at, -1), moved(end.at, to, -1)];
    const turned = ([x, y]: Place): Place => scaled(after, (x * before[0] + y * before[1]) / (before[0] * before[0] + before[1] * before[1]));
    // Two lines at one point are each as straight as before, whatever the angle between them.
    const follows = (at: PointOfCurve, own: HandleSide): Joint => (isLine(at, opposite(own)) ? "cusp" : jointAt(at));
    return [
      [point, side, turned(point[side].tangent), follows(point, side)],
      [end, other, turned(end[other].tangent), follows(end, other)],
    ] satisfies Turn[];
  });
}

const opposite = (side: HandleSide): HandleSide => (side === "in" ? "out" : "in");

/** Whether a segment is a straight line: both its tangents run along its chord. */
function straight(from: PointOfCurve, side: HandleSide, end: PointOfCurve): boolean {
  const [x, y] = moved(end.at, from.at, -1);
  const along = ([dx, dy]: Place): boolean => Math.abs(dx * y - dy * x) <= ONE_LINE * Math.hypot(dx, dy) * Math.hypot(x, y);
  return (x !== 0 || y !== 0) && along(from[side].tangent) && along(end[opposite(side)].tangent);
}

/**
 * Gives sides of points new tangents, their other sides what the joints ask; nothing is set before all of it has been
 * checked.
 */
export function turn(op: string, curve: HermiteCurve, changes: readonly Turn[]): void {
  const tangents: [number, Place, HandleSide][] = [];
  for (const [point, side, tangent, joint] of changes) {
    const other = side === "in" ? "out" : "in";
    tangents.push([point.index, tangent, side]);
    const follows = followed(point, side, tangent, joint);
    if (follows !== undefined) tangents.push([point.index, follows, other]);
  }
  for (const [, tangent] of tangents) for (const part of tangent) coordinate(op, "tangent", part);
  for (const [index, [dx, dy], side] of tangents) curve.setTangent(index, dx, dy, side);
}

/** The tangent of the other side; undefined where it stays. */
function followed(point: PointOfCurve, side: HandleSide, tangent: Place, joint: Joint): Place | undefined {
  const [mine, other] = side === "in" ? [point.in, point.out] : [point.out, point.in];
  if (joint === "cusp") return undefined;
  // Handles are mirror images where tangents times lengths are the same.
  if (joint === "symmetric") return scaled(tangent, (mine.length ?? 1) / (other.length ?? mine.length ?? 1));
  const size = Math.hypot(...tangent);
  return size > 0 ? scaled(tangent, Math.hypot(...other.tangent) / size) : undefined;
}

/** A step, so many times as long. */
export function scaled([x, y]: Place, factor: number): Place {
  return [factor * x, factor * y];
}

/** A place, so many steps on. */
export function moved([x, y]: Place, [dx, dy]: Place, factor: number): Place {
  return [x + factor * dx, y + factor * dy];
}

/** Place i of a list of numbers. */
function pair(list: Float64Array, i: number): Place {
  return [list[2 * i] ?? 0, list[2 * i + 1] ?? 0];
}
