import type { CurveDocument, PointRef } from "../document.ts";
import { movePoints, type Command } from "./commands.ts";

/** Contours and points in line with each other, or evenly spread. */

/** What moves as one, and the room it takes. */
export interface Piece {
  readonly points: readonly PointRef[];
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

export type Axis = "across" | "down";
/** Which part of each piece is brought in line: its beginning (left, top), its middle or its end. */
export type Part = "start" | "middle" | "end";

interface Extent {
  readonly from: number;
  readonly to: number;
}

function extent(piece: Piece, axis: Axis): Extent {
  return axis === "across" ? { from: piece.minX, to: piece.maxX } : { from: piece.minY, to: piece.maxY };
}

function whole(extents: readonly Extent[]): Extent {
  return { from: Math.min(...extents.map(({ from }) => from)), to: Math.max(...extents.map(({ to }) => to)) };
}

function placeOf({ from, to }: Extent, part: Part): number {
  return part === "start" ? from : part === "end" ? to : (from + to) / 2;
}

/** Every piece moves along the axis by a step of its own. */
function moving(name: string, pieces: readonly Piece[], axis: Axis, steps: readonly number[]): Command {
  const move = (curve: CurveDocument, { points }: Piece, i: number): CurveDocument => {
    const step = steps[i] ?? 0;
    return step === 0 ? curve : movePoints({ points, handle: null }, axis === "across" ? step : 0, axis === "down" ? step : 0).apply(curve);
  };
  return { name, apply: (curve) => pieces.reduce(move, curve) };
}

/** All pieces in line with that part of the room that they take together. */
export function aligned(pieces: readonly Piece[], axis: Axis, part: Part): Command {
  const extents = pieces.map((piece) => extent(piece, axis));
  const line = placeOf(whole(extents), part);
  return moving("Align", pieces, axis, extents.map((own) => line - placeOf(own, part)));
}

/** Equal gaps between the pieces, in their order; the first and the last stay. */
export function distributed(pieces: readonly Piece[], axis: Axis): Command {
  const extents = pieces.map((piece) => extent(piece, axis));
  const { from, to } = whole(extents);
  const gap = (to - from - extents.reduce((sum, own) => sum + own.to - own.from, 0)) / (pieces.length - 1);
  const order = extents.map((_, i) => i).sort((a, b) => placeOf(extents[a] ?? { from, to }, "middle") - placeOf(extents[b] ?? { from, to }, "middle"));
  const steps = pieces.map(() => 0);
  let next = from;
  for (const i of order) {
    const own = extents[i] ?? { from: next, to: next };
    steps[i] = next - own.from;
    next += own.to - own.from + gap;
  }
  return moving("Distribute", pieces, axis, steps);
}
