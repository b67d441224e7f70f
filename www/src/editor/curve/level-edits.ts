import { loweredContour } from "../../document/curve/lowered.ts";
import { nothingSelected, type Contour, type CurveDocument } from "../../document/document.ts";
import { refined } from "../../kernel/curve/refining.ts";
import { coarserInterpolating, finerInterpolating } from "../../kernel/curve/interpolating.ts";
import { largestMove } from "../../kernel/curve/samples.ts";
import { hasPlaces, mostPoints, printed, refuse, unnoticed } from "./edits.ts";
import type { Editor } from "../editor.ts";

/** Up and down the levels of the drawing. */

const mostLevel = 6;

/**
 * Finer or coarser points of the same curve. Going down changes it only if something finer was edited: then the change
 * is shown and measured first, and asking once more makes it.
 */
export function setLevel(editor: Editor, level: number): void {
  const { curve, sketch } = editor.state.value;
  const target = Math.max(0, Math.min(mostLevel, Math.round(level)));
  if (target === curve.level && sketch.proposal !== null) return editor.patch({ sketch: { ...sketch, proposal: null } });
  if (target === curve.level || curve.contours.length === 0 || curve.contours.some((contour) => hasPlaces(editor, contour))) return;
  const next = target > curve.level ? raised(editor, curve, target) : lowered(curve, target);
  if (next === null) return;
  const moved = target > curve.level ? 0 : Math.max(0, ...curve.contours.map((contour, i) => largestMove(curve, contour, next.contours[i] ?? contour)));
  if (moved > unnoticed && sketch.proposal?.level !== target) {
    editor.patch({ sketch: { ...sketch, proposal: next } });
    editor.notify({ kind: "toast", text: `Level ${target} would move the curve by up to ${printed(moved)}, as shown.`, actionId: "apply-level" });
    return;
  }
  editor.dispatch({ name: `Level ${target}`, apply: () => next, select: nothingSelected, run: "level" });
  // What was said of the points before need not be so of these.
  editor.patch({ hint: "" });
}

/** Makes the change of level that is being shown. */
export function applyProposal(editor: Editor): void {
  const { proposal } = editor.state.value.sketch;
  if (proposal !== null) setLevel(editor, proposal.level);
}

function raised(editor: Editor, curve: CurveDocument, target: number): CurveDocument | null {
  let next = curve;
  for (let level = curve.level + 1; level <= target; level += 1) {
    if (next.contours.some((contour) => contour.points.length * 2 > 4 * mostPoints)) {
      refuse(editor, `Level ${level} would need more than ${4 * mostPoints} points.`);
      return next === curve ? null : next;
    }
    const document = next;
    next = {
      ...next,
      level,
      contours: next.contours.map((contour) => (contour.family === "hermite" ? refined(document, contour, level) : finerInterpolating(document, contour, 1))),
    };
  }
  return next;
}

function lowered(curve: CurveDocument, target: number): CurveDocument {
  const lower = (contour: Contour): Contour => (contour.family === "hermite"
    ? plain(curve, loweredContour(contour, target))
    : coarserInterpolating(curve, contour, target));
  return { ...curve, level: target, contours: curve.contours.map(lower) };
}

/** Lengths that are all alike say nothing where the frequency follows from the whole. */
function plain(curve: CurveDocument, contour: Contour): Contour {
  const { lengths, ...rest } = contour;
  if (lengths === undefined || contour.omega !== undefined || curve.omega !== "auto") return contour;
  return lengths.every((length) => length === lengths[0]) ? rest : contour;
}
