import type { Command } from "../../document/curve/commands.ts";
import { joinEnds } from "../../document/curve/joining.ts";
import type { CurveDocument, PointRef } from "../../document/document.ts";

/** An end of an open contour that is dropped on another one, of its own contour or of another, is joined to it. */

/** As much as rounding takes an end away from where it was drawn to, in document units. */
const rounding = 1e-9;

/**
 * The move and the join as one command; null where nothing would be joined. `curve` may be before the move or after it.
 */
export function dropped(curve: CurveDocument, move: Command, end: PointRef, onto: PointRef): Command | null {
  const own = end.contour === onto.contour;
  // Of two points one would be left.
  if (own && (curve.contours[end.contour]?.points.length ?? 0) < 3) return null;
  // A contour that goes on behind the other keeps its direction, and so does the other.
  const ends = end.index === 0 ? ([onto, end] as const) : ([end, onto] as const);
  const join = (now: CurveDocument): Command | null => joinEnds(now, ends, rounding);
  const known = join(curve);
  if (known === null) return null;
  return {
    ...known,
    apply: (now) => {
      const moved = move.apply(now);
      return join(moved)?.apply(moved) ?? moved;
    },
  };
}
