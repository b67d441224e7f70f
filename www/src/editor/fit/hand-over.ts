import { nothingSelected } from "../../document/document.ts";
import { contourFromFit } from "../../kernel/fit/as-contour.ts";
import type { Editor } from "../editor.ts";

/** The fitted curve as a drawing in Curve: a copy, ready to be edited; the points stay in Fit. */
export function editInCurve(editor: Editor): void {
  const { outcome } = editor.state.value.fitRun;
  if (outcome === null) return;
  const contours = outcome.strokes.map(({ curve }) => contourFromFit(curve));
  const { view } = editor.state.value;
  editor.patch({ mode: "curve", tool: "select" });
  editor.dispatch({
    name: "Edit the fit",
    apply: ({ sample: _gone, ...curve }) => ({ ...curve, space: "trigonometric", omega: "auto", level: 0, contours }),
    select: nothingSelected,
  });
  editor.setOverlay("bezier", false);
  editor.patch({ view, hint: "" });
  const count = contours.reduce((sum, contour) => sum + contour.points.length, 0);
  editor.notify({ kind: "toast", text: `The fit is in Curve, ${count} points. The data stay in Fit.` });
}
