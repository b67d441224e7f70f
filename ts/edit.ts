/** What an editor's pointer does to curves: what lies under it, handles that turn, a curve that bends. */
import { HermiteCurve, coordinate, finite, word, wrong } from "./core.js";
import { type HandleSide, type Joint, THIRD, type Place, handleOf, jointAt, keptStraight, moved, notCurve, pointsOf, scaled, turn } from "./edit/edit-joints.js";

export { hitTest } from "./edit/edit-hits.js";
export type { Hit, HitCurve, HitHandle, HitOptions, HitPoint } from "./edit/edit-hits.js";
export type { HandleSide, Joint } from "./edit/edit-joints.js";

/** Nearer to an end than this part of the segment, a handle has too little hold on the curve. */
const HOLD = 0.1;

/**
 * Where the handles of point i end: `in` a third of the arriving tangent before it, `out` a third of the leaving one
 * behind it, each over the length of its segment. For cubics these are the Bézier's control points. A free end of an
 * open curve has one.
 *
 * @throws {ExplineError} E_RANGE of an `i` that is no point's; E_TYPE where `curve` is no HermiteCurve.
 */
export function handlesOf(curve: HermiteCurve, i: number): { in?: [number, number]; out?: [number, number] } {
  const op = "handlesOf";
  const point = pointsOf(op, curve)(i);
  const [into, out] = [handleOf(point, "in"), handleOf(point, "out")];
  return { ...(into === undefined ? {} : { in: into }), ...(out === undefined ? {} : { out }) };
}

/**
 * What point i is: "smooth" where its two handles lie in one line, to 1e-9 radians, and "cusp" where they do not, or
 * where there is only one. Whether handles are to mirror each other is a choice that no shape tells.
 *
 * @throws {ExplineError} as {@link handlesOf} does.
 */
export function jointOf(curve: HermiteCurve, i: number): "smooth" | "cusp" {
  const point = pointsOf("jointOf", curve)(i);
  const isEnd = point.in.length === undefined || point.out.length === undefined;
  return isEnd ? "cusp" : jointAt(point);
}

/**
 * Moves point i, and its handles with it. Straight segments beside it stay straight: the corner of a polygon is moved,
 * its sides are not bent. Where such a segment runs smoothly into a curve, the curve's handle turns with it. The curve
 * itself is changed.
 *
 * @throws {ExplineError} as {@link handlesOf} does, and E_RANGE of a place beyond ±1e9; nothing has moved then.
 */
export function movePoint(curve: HermiteCurve, i: number, x: number, y: number): void {
  const op = "movePoint";
  const point = pointsOf(op, curve)(i);
  const place: Place = [coordinate(op, "x", x), coordinate(op, "y", y)];
  turn(op, curve, keptStraight(op, curve, point, place));
  curve.setPoint(point.index, ...place);
}

/**
 * Puts the end of a handle of point i at a place; the other handle follows as the joint asks: by default it turns with
 * this one, and "cusp" is for a corner that is to stay one. Point and neighbours stay. The curve itself is changed.
 *
 * @throws {ExplineError} as {@link movePoint} does, and E_RANGE of a `side` that the end of an open curve has not.
 * @example
 * ```js
 * const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [100, 60], count: 4 });
 * const [x, y] = handlesOf(curve, 0).out;
 * moveHandle(curve, 0, "out", x + 10, y, jointOf(curve, 0)); // the arriving handle turns along
 * console.log(jointOf(curve, 0)); // → smooth
 * ```
 */
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
 * How far the place at t goes with one unit of the tangent that leaves the point before it, and with one of the tangent
 * that arrives at the point behind it: the curve is linear in both.
 *
 * @throws {ExplineError} E_RANGE of `t` outside the domain of an open curve; E_TYPE where `curve` is no HermiteCurve.
 */
export function tangentWeights(curve: HermiteCurve, t: number): readonly [number, number] {
  const op = "tangentWeights";
  return weights(curve, segmentAt(op, curve, t));
}

/**
 * Pulls the curve: the place at t goes to (x, y), and of all pairs of tangents of its segment that take it there, these
 * two change least. Points stay; where both sides of a point are one line they still are, and its other handle keeps
 * its length. Nearer to a point than a tenth of the segment the place follows by a part of the way only. The curve
 * itself is changed.
 *
 * @throws {ExplineError} as {@link tangentWeights} does, and E_RANGE where a tangent would be beyond ±8e9; nothing has
 *   moved then.
 * @example
 * ```js
 * const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [100, 60], count: 4 });
 * const hit = hitTest([curve], 72, 43, { reach: 8 });
 * if (hit?.kind === "curve") bendCurve(curve, hit.t, 80, 50);
 * console.log(curve.nearest(80, 50).distance < 1e-9); // → true
 * ```
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
    [from, "out", moved(from.out.tangent, step, leaving / hold), jointAt(from)],
    [to, "in", moved(to.in.tangent, step, arriving / hold), jointAt(to)],
  ]);
}

interface SegmentPlace {
  readonly index: number;
  readonly from: number;
  readonly to: number;
  /** 0 … 1 along it. */
  readonly x: number;
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
