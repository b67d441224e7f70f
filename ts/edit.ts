/** What an editor's pointer does to curves: what lies under it, handles that turn, a curve that bends. */
import { type Curve, type CurveData, HermiteCurve, MeasuredCurve, coordinate, dataOf, finite, inRange, integer, numbers, options as checkOptions, word, wrong } from "./core.js";
import { type HandleSide, type Joint, SIDES, THIRD, type Place, handleOf, jointOf, keptStraight, moved, notCurve, pointsOf, scaled, turn } from "./edit/edit-joints.js";

export type { HandleSide, Joint } from "./edit/edit-joints.js";

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
export type Hit =
  | { kind: "point"; curve: number; index: number; distance: number }
  | { kind: "handle"; curve: number; index: number; side: HandleSide; distance: number }
  | { kind: "curve"; curve: number; t: number; x: number; y: number; distance: number };

/** The curve's part of the reach: it passes near many places, and its points are wanted more often. */
const CURVE_REACH = 0.6;
/** Nearer to an end than this part of the segment, a handle has too little hold on the curve. */
const HOLD = 0.1;

/**
 * What lies under a place of the plane: of points and handles the nearest within `reach`, a point before a handle at the same place; or
 * else the nearest curve within `curveReach`; or undefined. Handles of no length are hidden under their point and never found.
 * Costs one look at every point and one `nearest` for every curve.
 */
export function hitTest(curves: readonly Curve[], x: number, y: number, options: HitOptions): Hit | undefined {
  const op = "hitTest";
  if (!Array.isArray(curves)) throw wrong("E_TYPE", op, "curves", curves, "a list of curves");
  const list = curves.map((curve: unknown, i) => planeCurve(op, curve, i));
  const at: Place = [coordinate(op, "x", x), coordinate(op, "y", y)];
  const { reach, curveReach, handles } = checkOptions(op, options, ["reach", "curveReach", "handles"]);
  const far = inRange(op, "reach", reach, 0, Infinity);
  const near = curveReach === undefined ? CURVE_REACH * far : inRange(op, "curveReach", curveReach, 0, Infinity);
  const best: Best = { hit: undefined, distance: far };
  list.forEach((curve, c) => everyPoint(curve, at, best, c));
  list.forEach((curve, c) => everyHandle(op, curve, handles, at, best, c));
  return best.hit ?? nearestCurve(list, at, near);
}

/**
 * Where the handles of point i end: `in` a third of the arriving tangent before it, `out` a third of the leaving one behind it, each over
 * the length of its segment. For cubics these are the Bézier's control points. A free end of an open curve has one.
 */
export function handlesOf(curve: HermiteCurve, i: number): { in?: [number, number]; out?: [number, number] } {
  const op = "handlesOf";
  const point = pointsOf(op, curve)(i);
  const [into, out] = [handleOf(point, "in"), handleOf(point, "out")];
  return { ...(into === undefined ? {} : { in: into }), ...(out === undefined ? {} : { out }) };
}

/**
 * Moves point i, and its handles with it. Straight segments beside it stay straight: the corner of a polygon is moved, its sides are not bent.
 * Where such a segment runs smoothly into a curve, the curve's handle turns with it.
 */
export function movePoint(curve: HermiteCurve, i: number, x: number, y: number): void {
  const op = "movePoint";
  const point = pointsOf(op, curve)(i);
  const place: Place = [coordinate(op, "x", x), coordinate(op, "y", y)];
  turn(op, curve, keptStraight(op, curve, point, place));
  curve.setPoint(point.index, ...place);
}

/** Puts the end of a handle of point i at a place; the other handle follows as the joint asks. Point and neighbours stay. */
export function moveHandle(curve: HermiteCurve, i: number, side: HandleSide, x: number, y: number, joint: Joint = "smooth"): void {
  const op = "moveHandle";
  const point = pointsOf(op, curve)(i);
  const which = word(op, "side", side, ["in", "out"]);
  const place: Place = [coordinate(op, "x", x), coordinate(op, "y", y)];
  const how = word(op, "joint", joint, ["smooth", "symmetric", "cusp"]);
  const span = point[which].length;
  if (span === undefined) throw wrong("E_RANGE", op, "side", which, which === "in" ? "out: the curve begins here" : "in: the curve ends here");
  const sign = which === "in" ? -1 : 1;
  const tangent = scaled([place[0] - point.at[0], place[1] - point.at[1]], sign / (span * THIRD));
  turn(op, curve, [[point, which, tangent, how]]);
}

/**
 * How far the place at t goes with one unit of the tangent that leaves the point before it, and with one of the tangent that arrives at the
 * point behind it: the curve is linear in both.
 */
export function tangentWeights(curve: HermiteCurve, t: number): readonly [number, number] {
  const op = "tangentWeights";
  return weights(curve, segmentAt(op, curve, t));
}

/**
 * Pulls the curve: the place at t goes to (x, y), and of all pairs of tangents of its segment that take it there, these two change least.
 * Points stay; where both sides of a point are one line they still are, and its other handle keeps its length. Nearer to a point than a tenth
 * of the segment the place follows by a part of the way only.
 */
export function bendCurve(curve: HermiteCurve, t: number, x: number, y: number): void {
  const op = "bendCurve";
  const segment = segmentAt(op, curve, t);
  const goal: Place = [coordinate(op, "x", x), coordinate(op, "y", y)];
  const [fromX = 0, fromY = 0] = curve.evaluate(t);
  const step: Place = [goal[0] - fromX, goal[1] - fromY];
  const held = { ...segment, x: Math.min(1 - HOLD, Math.max(HOLD, segment.x)) };
  const [leaving, arriving] = weights(curve, held);
  const hold = leaving * leaving + arriving * arriving;
  const at = pointsOf(op, curve);
  const [from, to] = [at(segment.from), at(segment.to)];
  turn(op, curve, [
    [from, "out", moved(from.out.tangent, step, leaving / hold), jointOf(from)],
    [to, "in", moved(to.in.tangent, step, arriving / hold), jointOf(to)],
  ]);
}

interface SegmentPlace {
  readonly index: number;
  readonly from: number;
  readonly to: number;
  /** 0 … 1 along it. */
  readonly x: number;
}

function between([x, y]: Place, [u, v]: Place): number {
  return Math.hypot(x - u, y - v);
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

/** How far a place is from another, where that may be nearer than the best: nearly all are refused by two comparisons. */
function nearer({ hit, distance: least }: Best, [x, y]: Place, u: number, v: number): number | undefined {
  if (!(Math.abs(u - x) <= least && Math.abs(v - y) <= least)) return undefined;
  const away = between([u, v], [x, y]);
  return away < least || (away === least && hit === undefined) ? away : undefined;
}

function everyPoint(curve: MeasuredCurve, at: Place, best: Best, c: number): void {
  const { points } = dataOf(curve, "hitTest");
  for (let i = 0; i < points.length; i += 2) {
    const away = nearer(best, at, points[i] ?? 0, points[i + 1] ?? 0);
    if (away === undefined) continue;
    best.distance = away;
    best.hit = { kind: "point", curve: c, index: i / 2, distance: away };
  }
}

function nearestCurve(curves: readonly MeasuredCurve[], at: Place, reach: number): Hit | undefined {
  let best: Hit | undefined;
  curves.forEach((curve, c) => {
    const found = curve.nearest(...at);
    if (found.distance <= reach && !(best !== undefined && best.distance <= found.distance)) {
      best = { kind: "curve", curve: c, t: found.t, x: found.x, y: found.y, distance: found.distance };
    }
  });
  return best;
}

/** The handles of curve c that are shown and do not lie in their point. */
function everyHandle(op: string, curve: MeasuredCurve, shown: unknown, at: Place, best: Best, c: number): void {
  if (shown === undefined || !(curve instanceof HermiteCurve)) return;
  if (shown !== "all" && !Array.isArray(shown)) throw wrong("E_TYPE", op, "handles", shown, '"all" or a list of indices for each curve');
  const data = dataOf<CurveData>(curve, op);
  const { count } = data;
  if (shown === "all") {
    for (let index = 0; index < count; index += 1) bothHandles(data, index, at, best, c);
    return;
  }
  const arg = `handles[${c}]`;
  numbers(op, arg, shown[c] ?? [], "maxPoints", 2 * count).forEach((index, i) => bothHandles(data, integer(op, arg, index, 0, count - 1, i), at, best, c));
}

/** The two handles of a point, from the curve's own lists: with every handle of every curve shown, copies of them are what takes the time. */
function bothHandles({ points, tangents, tangentsIn, lengths, segments, closed }: CurveData, index: number, at: Place, best: Best, c: number): void {
  const arriving = tangentsIn.length === 0 ? tangents : tangentsIn;
  const [x = 0, y = 0] = [points[2 * index], points[2 * index + 1]];
  for (const side of SIDES) {
    const into = side === "in";
    const segment = !into ? index : index > 0 || !closed ? index - 1 : segments - 1;
    if (segment < 0 || segment >= segments) continue;
    const list = into ? arriving : tangents;
    const reach = (into ? -THIRD : THIRD) * (lengths.length === 0 ? 1 : (lengths[lengths.length === 1 ? 0 : segment] ?? 1));
    const [u, v] = [x + (list[2 * index] ?? 0) * reach, y + (list[2 * index + 1] ?? 0) * reach];
    const away = u === x && v === y ? undefined : nearer(best, at, u, v);
    if (away === undefined) continue;
    best.distance = away;
    best.hit = { kind: "handle", curve: c, index, side, distance: away };
  }
}

/** The segment of a parameter, and the place in it; of two segments at a point, the later. */
function segmentAt(op: string, curve: HermiteCurve, t: unknown): SegmentPlace {
  if (!(curve instanceof HermiteCurve)) throw notCurve(op, "curve", curve, "a HermiteCurve");
  const { lengths, closed } = curve;
  const [, end] = curve.domain;
  const given = finite(op, "t", t);
  if (!closed && (given < 0 || given > end)) throw wrong("E_RANGE", op, "t", given, `a number in [0, ${end}]`);
  let rest = closed ? given - end * Math.floor(given / end) : given;
  let index = 0;
  for (; index < lengths.length - 1 && rest >= (lengths[index] ?? 0); index += 1) rest -= lengths[index] ?? 0;
  return { index, from: index, to: (index + 1) % (curve.points.length / 2), x: Math.min(1, rest / (lengths[index] ?? 1)) };
}

/** A segment that is nothing but a unit of one tangent in x and of the other in y shows what each of them weighs. */
function weights(curve: HermiteCurve, { index, x }: SegmentPlace): readonly [number, number] {
  const [length, omega] = [curve.lengths[index] ?? 1, curve.omega[index] ?? 0];
  const probe = new HermiteCurve({
    points: [0, 0, 0, 0], tangents: [1, 0, 0, 0], tangentsIn: [0, 0, 0, 1], closed: false, space: curve.space, omega: [omega], lengths: [length],
  });
  const [leaving = 0, arriving = 0] = probe.evaluate(x * length);
  return [leaving, arriving];
}
