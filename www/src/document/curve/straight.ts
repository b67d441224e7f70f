import { segmentCount, type Contour, type ControlPoint, type Offset } from "../document.ts";
import { lengthOfOffset, scaled, withHandle } from "./offset.ts";

/** Straight segments: lines of a drawing, which stay lines when a point of them is moved. */

function endsOf({ points }: Contour, index: number): readonly [number, number] {
  return [index, (index + 1) % points.length];
}

function chordOf(from: ControlPoint, to: ControlPoint): Offset {
  return { dx: to.x - from.x, dy: to.y - from.y };
}

/** Whether a segment is a straight line: its handles lie along its chord, or it has none. */
export function isStraight(contour: Contour, index: number): boolean {
  const [from, to] = endsOf(contour, index).map((i) => contour.points[i]);
  if (from === undefined || to === undefined) return false;
  const chord = chordOf(from, to);
  const along = (handle: Offset): boolean => Math.abs(handle.dx * chord.dy - handle.dy * chord.dx) <= 1e-6 * lengthOfOffset(handle) * lengthOfOffset(chord);
  return along(from.out) && along(to.in);
}

/** A handle at another chord, as long a part of it as it was. */
function turned(handle: Offset, from: Offset, to: Offset): Offset {
  return scaled(to, (handle.dx * from.dx + handle.dy * from.dy) / (from.dx * from.dx + from.dy * from.dy));
}

/**
 * Where points were moved, the lines that they end: handles at corners and open ends turn with them. Where a line goes
 * on smoothly into a curve it does not, since the curve would turn as well.
 */
export function withStraightLines(before: Contour, after: Contour, moved: readonly number[]): Contour {
  if (before.family !== "hermite") return after;
  const [count, segments] = [before.points.length, segmentCount(before)];
  const touched = new Set(moved.flatMap((i) => [i, before.closed ? (i + count - 1) % count : i - 1]).filter((i) => i >= 0 && i < segments));
  const points = after.points.slice();
  for (const index of touched) if (isFreeLine(before, index)) turnLine(before, points, index);
  return { ...after, points };
}

/** Whether a segment is a line between corners and open ends. */
function isFreeLine(contour: Contour, index: number): boolean {
  const { closed, points } = contour;
  const ends = endsOf(contour, index);
  const [from, to] = ends.map((i) => points[i]);
  const isFree = (i: number): boolean => points[i]?.kind === "cusp" || (!closed && (i === 0 || i === points.length - 1));
  return from !== undefined && to !== undefined && lengthOfOffset(chordOf(from, to)) > 0 && ends.every(isFree) && isStraight(contour, index);
}

function turnLine(before: Contour, points: ControlPoint[], index: number): void {
  const [first, last] = endsOf(before, index);
  const [from, to, start, end] = [before.points[first], before.points[last], points[first], points[last]];
  if (from === undefined || to === undefined || start === undefined || end === undefined) return;
  const [old, chord] = [chordOf(from, to), chordOf(start, end)];
  points[first] = withHandle(start, "out", turned(start.out, old, chord));
  points[last] = withHandle(end, "in", turned(end.in, old, chord));
}
