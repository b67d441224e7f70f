import { movePoints, turnHandle, type Command } from "../../document/curve/commands.ts";
import { scaled } from "../../document/curve/offset.ts";
import { isStraight } from "../../document/curve/straight.ts";
import { noOffset, type Contour, type CurveDocument, type Offset, type PointRef, type Side } from "../../document/document.ts";
import { handleWeights, pointWeights } from "../../kernel/curve/bending.ts";

/**
 * Pulling a segment by a place of its own: its two inner handles give way, and the place stays under the pointer. Near
 * a smooth point they have little hold on the curve: they would have to swing out far, and the curve would get a beak
 * there. There the point goes along.
 */

/** Nearer to a corner or an open end than this part of the segment, the place follows by a part of the way only. */
const reach = 0.1;
/**
 * Nearer to a smooth point than this part of the segment, the point goes along: on the point all of the way, here not
 * at all.
 */
const along = 0.18;

export interface Segment {
  readonly contour: number;
  /** The segment that begins with this point. */
  readonly index: number;
  /** 0 … 1 along it. */
  readonly x: number;
}

function endsOf(contour: Contour, index: number): readonly [number, number] {
  return [index, (index + 1) % contour.points.length];
}

/**
 * Whether a point can go along when the curve is pulled beside it: corners, open ends and ends of straight lines stay.
 */
function goesAlong(contour: Contour, index: number): boolean {
  const count = contour.points.length;
  const isEnd = !contour.closed && (index === 0 || index === count - 1);
  return !isEnd && contour.points[index]?.kind !== "cusp" && !isStraight(contour, index) && !isStraight(contour, (index + count - 1) % count);
}

/** How much of the way the nearer end of a segment takes over, and the step of its own that this needs. */
function nearEnd(document: CurveDocument, contour: Contour, { index, x }: Segment, step: Offset): { end: number; part: number; step: Offset } {
  const which = x < 0.5 ? 0 : 1;
  const end = endsOf(contour, index)[which];
  const part = goesAlong(contour, end) ? Math.max(0, 1 - ((which === 0 ? x : 1 - x) / along) ** 2) : 0;
  return { end, part, step: part === 0 ? noOffset : scaled(step, part / pointWeights(document, contour, index, x)[which]) };
}

/** Keeps the weights of handles from vanishing where a point goes all of the way. */
const onPoint = 1e-6;

/**
 * Moves the place of a segment by a step. Of all pairs of handles that do, these two move least. Smooth points stay
 * smooth: the handle on the other side turns and keeps its length, so that the neighbours change as little as they can.
 * Null where the segment has no handles.
 */
export function bend(document: CurveDocument, segment: Segment, step: Offset): Command | null {
  const { contour: c, index, x } = segment;
  const contour = document.contours[c];
  if (contour === undefined || contour.family !== "hermite") return null;
  const [from, to] = endsOf(contour, index);
  const near = nearEnd(document, contour, segment, step);
  const least = near.part > 0 ? onPoint : reach;
  const [first, second] = handleWeights(document, contour, index, Math.min(1 - least, Math.max(least, x)));
  const hold = first * first + second * second;
  if (hold === 0) return null;
  const [a, b]: [PointRef, PointRef] = [{ contour: c, index: from }, { contour: c, index: to }];
  const turn = (ref: PointRef, side: Side, weight: number): Command => {
    const point = contour.points[ref.index];
    const [old, more] = [point?.[side] ?? noOffset, scaled(step, ((1 - near.part) * weight) / hold)];
    return turnHandle(ref, side, { dx: old.dx + more.dx, dy: old.dy + more.dy }, point?.kind === "cusp" ? "cusp" : "smooth");
  };
  const goes = movePoints({ points: [{ contour: c, index: near.end }], handle: null }, near.step.dx, near.step.dy);
  const changes = [turn(a, "out", first), turn(b, "in", second), ...(near.part > 0 ? [goes] : [])];
  return { name: "Bend segment", apply: (curve) => changes.reduce((bent, change) => change.apply(bent), curve), select: { points: [a, b], handle: null } };
}
