import { turnHandle, type Command } from "../../document/curve/commands.ts";
import { lengthOfOffset, scaled } from "../../document/curve/offset.ts";
import { noOffset, type Contour, type CurveDocument, type Offset, type PointRef, type Selection, type Side } from "../../document/document.ts";
import { handleWeights } from "../../kernel/curve/contours.ts";

/** Pulling a segment by a place of its own: its two inner handles give way, and the place stays under the pointer. */

/** Nearer to an end than this part of the segment, its handle has too little hold on the curve. */
const reach = 0.1;

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

/** Whether a segment is a straight line: its handles, if it has any, lie along its chord. */
export function isStraight(contour: Contour, index: number): boolean {
  const [from, to] = endsOf(contour, index).map((i) => contour.points[i]);
  if (from === undefined || to === undefined) return false;
  const chord = { dx: to.x - from.x, dy: to.y - from.y };
  const along = (handle: Offset): boolean => Math.abs(handle.dx * chord.dy - handle.dy * chord.dx) <= 1e-6 * lengthOfOffset(handle) * lengthOfOffset(chord);
  return along(from.out) && along(to.in);
}

/**
 * Moves the place of a segment by a step. Of all pairs of handles that do, these two move least. Smooth points stay
 * smooth: the handle on the other side turns and keeps its length, so that the neighbours change as little as they can.
 * Null where the segment has no handles.
 */
export function bend(document: CurveDocument, { contour: c, index, x }: Segment, step: Offset): Command | null {
  const contour = document.contours[c];
  if (contour === undefined || contour.family !== "hermite") return null;
  const [from, to] = endsOf(contour, index);
  const [first, second] = handleWeights(document, contour, index, Math.min(1 - reach, Math.max(reach, x)));
  const hold = first * first + second * second;
  if (hold === 0) return null;
  const [a, b]: [PointRef, PointRef] = [{ contour: c, index: from }, { contour: c, index: to }];
  const select: Selection = { points: [a, b], handle: null };
  const turn = (ref: PointRef, side: Side, weight: number): Command => {
    const point = contour.points[ref.index];
    const [old, more] = [point?.[side] ?? noOffset, scaled(step, weight / hold)];
    return turnHandle(ref, side, { dx: old.dx + more.dx, dy: old.dy + more.dy }, point?.kind === "cusp" ? "cusp" : "smooth");
  };
  const [out, into] = [turn(a, "out", first), turn(b, "in", second)];
  return { name: "Bend segment", apply: (curve) => into.apply(out.apply(curve)), select };
}
