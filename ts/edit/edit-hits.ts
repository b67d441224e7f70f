/** What lies under a pointer: the nearest point, handle or curve within reach. */
import { type Curve, type CurveData, type HeldCurve, HermiteCurve, MeasuredCurve, coordinate, dataOf, inRange, integer, numbers, options as checkOptions, wrong } from "../core.js";
import { type HandleSide, type Place, SIDES, THIRD, notCurve } from "./edit-joints.js";

/** How far from the pointer something may lie, in the curve's unit: pixels divided by the zoom. */
export interface HitOptions {
  /** For points and handles: 8 to 10 pixels for a mouse, 22 for a finger. */
  reach: number;
  /** For the curve itself; by default six tenths of `reach`. */
  curveReach?: number | undefined;
  /** Points of which the handles are shown, of all curves or of each; by default none. */
  handles?: "all" | readonly (readonly number[])[] | undefined;
}

/** What lies under a place: which curve of the list, what of it, and how far away. */
export type Hit = HitPoint | HitHandle | HitCurve;

/** What every hit says. */
interface Found {
  /** The number of the curve in the list. */
  curve: number;
  /** How far it is from the place. */
  distance: number;
}

/** A point. */
export interface HitPoint extends Found {
  /** What was hit. */
  kind: "point";
  /** The number of the point on its curve. */
  index: number;
}

/** The end of a handle. */
export interface HitHandle extends Found {
  /** What was hit. */
  kind: "handle";
  /** The number of the point that it is a handle of. */
  index: number;
  /** Whether it is that of the side where the curve arrives, or leaves. */
  side: HandleSide;
}

/** A place on a curve. */
export interface HitCurve extends Found {
  /** What was hit. */
  kind: "curve";
  /** The parameter of the nearest place. */
  t: number;
  /** Where that is. */
  x: number;
  /** Where that is. */
  y: number;
}

/** The curve's part of the reach: it passes near many places, and its points are wanted more often. */
const CURVE_REACH = 0.6;

/**
 * What lies under a place of the plane: of points and handles the nearest within `reach`, a point before a handle at
 * the same place; or else the nearest curve within `curveReach`; or undefined. Handles of no length are hidden under
 * their point and never found. Costs a comparison for every curve; for those whose box is within reach also one for
 * every point, and a `nearest`. The boxes of a curve are made when it is first looked at, and anew when it has been
 * changed.
 *
 * @throws {ExplineError} E_TYPE for what is no curve of the plane; E_RANGE of a `reach` below 0.
 */
export function hitTest(curves: readonly Curve[], x: number, y: number, options: HitOptions): Hit | undefined {
  const op = "hitTest";
  if (!Array.isArray(curves)) throw wrong("E_TYPE", op, "curves", curves, "a list of curves");
  const list = Array.from(curves, (curve: unknown, i) => planeCurve(op, curve, i));
  const at: Place = [coordinate(op, "x", x), coordinate(op, "y", y)];
  const { reach, curveReach, handles } = checkOptions(op, options, ["reach", "curveReach", "handles"]);
  const far = inRange(op, "reach", reach, 0, Infinity);
  const near = curveReach === undefined ? CURVE_REACH * far : inRange(op, "curveReach", curveReach, 0, Infinity);
  const best: Best = { hit: undefined, distance: far };
  const data = list.map((curve) => dataOf(curve, op));
  data.forEach((held, c) => everyPoint(held, at, best, c));
  if (handles !== undefined) list.forEach((curve, c) => curve instanceof HermiteCurve && everyHandle(op, data[c] as CurveData, handles, at, best, c));
  return best.hit ?? nearestCurve(list, data, at, near);
}

/** A rectangle along the axes: the least x and y, the largest x and y. */
type Box = readonly [number, number, number, number];

/** Where a curve lies in one of its states: around its points and handles, and around itself. */
interface Extent {
  readonly id: number;
  readonly marks: Box;
  self: Box | undefined;
}

const extents = new WeakMap<HeldCurve, Extent>();

/** Where a curve lies as it is now. */
function extentOf(data: HeldCurve): Extent {
  const known = extents.get(data);
  if (known?.id === data.id) return known;
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  const add = (x: number, y: number): void => {
    if (x < box[0]) box[0] = x;
    if (y < box[1]) box[1] = y;
    if (x > box[2]) box[2] = x;
    if (y > box[3]) box[3] = y;
  };
  for (let i = 0; i < data.points.length; i += 2) add(data.points[i] ?? 0, data.points[i + 1] ?? 0);
  if ("tangents" in data) for (let i = 0; i < data.count; i += 1) handleEnds(data as CurveData, i, (_, x, y) => add(x, y));
  const made: Extent = { id: data.id, marks: box, self: undefined };
  extents.set(data, made);
  return made;
}

/** Where the curve itself lies as it is now. */
function selfOf(curve: MeasuredCurve, data: HeldCurve): Box {
  const extent = extentOf(data);
  if (extent.self === undefined) {
    const { minX, minY, maxX, maxY } = curve.bounds();
    extent.self = [minX, minY, maxX, maxY];
  }
  return extent.self;
}

/** Whether all that is in a box is farther away than this. */
function isBeyond([left, top, right, bottom]: Box, [x, y]: Place, distance: number): boolean {
  return left - x > distance || x - right > distance || top - y > distance || y - bottom > distance;
}

function planeCurve(op: string, curve: unknown, i: number): MeasuredCurve {
  if (!(curve instanceof MeasuredCurve) || curve.dimension !== 2) throw notCurve(op, "curves", curve, "a curve of the plane", i);
  return curve;
}

/** The nearest so far; of several as near the first. */
interface Best {
  hit: Hit | undefined;
  distance: number;
}

/**
 * How far a place is from another, where that may be nearer than the best: nearly all are refused by two comparisons.
 */
function nearer({ hit, distance: least }: Best, [x, y]: Place, u: number, v: number): number | undefined {
  if (!(Math.abs(u - x) <= least && Math.abs(v - y) <= least)) return undefined;
  const away = Math.hypot(u - x, v - y);
  return away < least || (away === least && hit === undefined) ? away : undefined;
}

function everyPoint(data: HeldCurve, at: Place, best: Best, c: number): void {
  if (isBeyond(extentOf(data).marks, at, best.distance)) return;
  const { points } = data;
  for (let i = 0; i < points.length; i += 2) {
    const away = nearer(best, at, points[i] ?? 0, points[i + 1] ?? 0);
    if (away === undefined) continue;
    best.distance = away;
    best.hit = { kind: "point", curve: c, index: i / 2, distance: away };
  }
}

function nearestCurve(curves: readonly MeasuredCurve[], data: readonly HeldCurve[], at: Place, reach: number): Hit | undefined {
  let best: Hit | undefined;
  curves.forEach((curve, c) => {
    if (isBeyond(selfOf(curve, data[c] as HeldCurve), at, best?.distance ?? reach)) return;
    const found = curve.nearest(...at);
    if (found.distance <= reach && !(best !== undefined && best.distance <= found.distance)) {
      best = { kind: "curve", curve: c, t: found.t, x: found.x, y: found.y, distance: found.distance };
    }
  });
  return best;
}

/** The handles of curve c that are shown and do not lie in their point. */
function everyHandle(op: string, data: CurveData, shown: unknown, at: Place, best: Best, c: number): void {
  if (shown !== "all" && !Array.isArray(shown)) throw wrong("E_TYPE", op, "handles", shown, '"all" or a list of indices for each curve');
  const { count } = data;
  const arg = `handles[${c}]`;
  const indices = shown === "all" ? undefined : numbers(op, arg, shown[c] ?? [], "maxPoints", 2 * count);
  indices?.forEach((index, i) => integer(op, arg, index, 0, count - 1, i));
  if (isBeyond(extentOf(data).marks, at, best.distance)) return;
  for (let i = 0; i < (indices?.length ?? count); i += 1) {
    const index = indices?.[i] ?? i;
    handleEnds(data, index, (side, x, y) => {
      const away = nearer(best, at, x, y);
      if (away === undefined) return;
      best.distance = away;
      best.hit = { kind: "handle", curve: c, index, side, distance: away };
    });
  }
}

/**
 * The handles of a point that have a length, from the curve's own lists: with every handle of every curve shown, copies
 * of them are what takes the time.
 */
function handleEnds({ points, tangents, tangentsIn, lengths, segments, closed }: CurveData, index: number, look: (side: HandleSide, x: number, y: number) => void): void {
  const arriving = tangentsIn.length === 0 ? tangents : tangentsIn;
  const [x = 0, y = 0] = [points[2 * index], points[2 * index + 1]];
  for (const side of SIDES) {
    const into = side === "in";
    const segment = !into ? index : index > 0 || !closed ? index - 1 : segments - 1;
    if (segment < 0 || segment >= segments) continue;
    const list = into ? arriving : tangents;
    const reach = (into ? -THIRD : THIRD) * (lengths.length === 0 ? 1 : (lengths[lengths.length === 1 ? 0 : segment] ?? 1));
    const [u, v] = [x + (list[2 * index] ?? 0) * reach, y + (list[2 * index + 1] ?? 0) * reach];
    if (u !== x || v !== y) look(side, u, v);
  }
}
