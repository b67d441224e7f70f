import { settingOf } from "../../document/artboard.ts";
import { paintOf } from "../../document/painted.ts";
import type { FitDocument } from "../../document/fit/fit-document.ts";
import { emptyCurve, type Contour, type CurveDocument } from "../../document/document.ts";
import { contourFromFit } from "../../kernel/fit/as-contour.ts";
import type { FitOutcome } from "../../kernel/fit/outcome.ts";
import type { Editor, EditorState } from "../editor.ts";
import { openInCurve } from "../curve/open-in-curve.ts";

function contoursOf({ strokes }: FitOutcome, { up }: FitDocument): Contour[] {
  return strokes.map((stroke) => ({ ...contourFromFit(stroke.curve, up), ...paintOf(stroke) }));
}

/** The fitted curve for Export; null while there is none. */
export function fittedDrawing({ fit, fitRun }: EditorState): CurveDocument | null {
  if (fitRun.outcome === null) return null;
  return { ...emptyCurve, contours: contoursOf(fitRun.outcome, fit), ...settingOf(fit), ...(fit.sample === undefined ? {} : { sample: fit.sample }) };
}

/** The fitted curve as a drawing in Curve: a copy, ready to be edited; the points stay in Fit. */
export function editInCurve(editor: Editor): void {
  const { fit, fitRun: { outcome } } = editor.state.value;
  if (outcome === null) return;
  const turned = fit.up === true ? " In Curve y points down, so every y has changed its sign." : "";
  openInCurve(editor, "Edit the fit", { ...fit, contours: contoursOf(outcome, fit) }, (count) => `Copied the fit to Curve, ${count} points. The data stay in Fit.${turned}`);
}
