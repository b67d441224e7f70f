import type { Command } from "../../document/curve/commands.ts";
import { translationOf } from "../../document/curve/contours.ts";
import { partsOf } from "../../document/curve/parts.ts";
import { pointAt, type Contour, type CurveDocument, type Selection } from "../../document/document.ts";
import type { Moment } from "../../document/history.ts";
import { curveOf } from "../../kernel/curve/curve-cache.ts";
import { settled } from "../../kernel/curve/settling.ts";

/** What a drawing must be before it is put on the stage, and a selection before it goes with it. */

/** The selection without what the document no longer has. */
export function surviving(curve: CurveDocument, selection: Selection): Selection {
  const points = selection.points.filter((ref) => pointAt(curve, ref) !== undefined);
  const handle = selection.handle !== null && pointAt(curve, selection.handle) === undefined ? null : selection.handle;
  return points.length === selection.points.length && handle === selection.handle ? selection : { points, handle };
}

/** Whether all points are places that the engine knows. */
function isOnPaper(contour: Contour): boolean {
  return contour.points.every(({ x, y }) => Math.abs(x) <= farthest && Math.abs(y) <= farthest);
}

/** Well inside the engine's own limit of 1e9, so that handles fit, too. */
const farthest = 1e8;

/**
 * What the engine says against a document, or null. Building a curve is the check, and the cache keeps it for the next
 * frame.
 */
export function objection(curve: CurveDocument, before: CurveDocument): Error | null {
  try {
    const known = curve.space === before.space && curve.omega === before.omega ? new Set(before.contours) : new Set();
    for (const contour of curve.contours) {
      if (known.has(contour)) continue;
      const moved = translationOf(contour);
      // What was good stays good where else it stands; its curve is made when something asks for it.
      if (moved === undefined || !known.has(moved.from) || !isOnPaper(contour)) for (const part of partsOf(curve, contour)) curveOf(curve, part);
    }
    return null;
  } catch (error) {
    return error instanceof Error ? error : new Error(String(error));
  }
}

/** The document with its refined places settled, and what the engine says against it. */
function checked(curve: CurveDocument, before: CurveDocument): { curve: CurveDocument; problem: Error | null } {
  const problem = objection(curve, before);
  if (problem !== null) return { curve, problem };
  const next = settled(before, curve);
  return { curve: next, problem: next === curve ? null : objection(next, curve) };
}

/** What a command makes of a moment; null where nothing changes, or the engine refuses it, as `refuse` is told. */
export function outcomeOf(command: Command, from: Moment, refuse: (problem: Error) => void): Moment | null {
  const wanted = command.apply(from.curve);
  if (wanted === from.curve) return null;
  const { curve, problem } = checked(wanted, from.curve);
  if (problem !== null) {
    refuse(problem);
    return null;
  }
  const select = command.select ?? from.selection;
  return { curve, selection: surviving(curve, typeof select === "function" ? select(curve) : select) };
}
