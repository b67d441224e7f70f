import { settingOf } from "../../document/artboard.ts";
import { paintOf } from "../../document/painted.ts";
import { emptyCurve, type Contour, type CurveDocument } from "../../document/document.ts";
import { contourFromFit } from "../../kernel/fit/as-contour.ts";
import type { FitOutcome } from "../../kernel/fit/outcome.ts";
import type { Editor, EditorState } from "../editor.ts";
import { openInCurve } from "../curve/open-in-curve.ts";

const contoursOf = ({ strokes }: FitOutcome): Contour[] => strokes.map((stroke) => ({ ...contourFromFit(stroke.curve), ...paintOf(stroke) }));

/** The fitted curve for Export; null while there is none. */
export function fittedDrawing({ fit, fitRun }: EditorState): CurveDocument | null {
  if (fitRun.outcome === null) return null;
  return { ...emptyCurve, contours: contoursOf(fitRun.outcome), ...settingOf(fit), ...(fit.sample === undefined ? {} : { sample: fit.sample }) };
}

/** The fitted curve as a drawing in Curve: a copy, ready to be edited; the points stay in Fit. */
export function editInCurve(editor: Editor): void {
  const { outcome } = editor.state.value.fitRun;
  if (outcome === null) return;
  openInCurve(editor, "Edit the fit", { ...editor.state.value.fit, contours: contoursOf(outcome) }, (count) => `Copied the fit to Curve, ${count} points. The data stay in Fit.`);
}
