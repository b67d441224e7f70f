import { describeData, describeKnot } from "./fit-edits.ts";
import type { EditorState } from "../editor.ts";

/** What the next press would do in Fit. */
export function fitHint(state: EditorState): string {
  const { fitRun, fitView, hint, tool } = state;
  const knots = fitRun.outcome?.knots ?? [];
  const over = fitView.over === null ? undefined : knots[fitView.over];
  if (over !== undefined && fitView.over !== null) return describeKnot(over, fitView.over, knots.length);
  if (hint !== "") return hint;
  const press = state.touch ? "Tap" : "Click";
  if (tool === "hand") return "Drag to pan. Press D to draw again.";
  switch (fitView.tool) {
    case "draw":
      if (state.fit.data.length === 0) return "";
      return state.fit.sample === undefined
        ? `Drag to draw another stroke. ${press} a knot to select it.`
        : `Drag to draw your own line instead of the sample. ${press} a knot to select it.`;
    case "points":
      return `${press} to add points; ${state.touch ? "a double tap" : "a double-click or Enter"} ends the stroke.`;
    case "erase":
      return "Drag over points to erase them.";
  }
}

/** The picture in words, for those who do not see it. */
export function fitSummary(state: EditorState): string {
  const { fit, fitRun } = state;
  if (fitRun.outcome === null) return `${describeData(fit)}.`;
  const { counts, knots, max } = fitRun.outcome;
  return `${describeData(fit)}, fitted with ${knots.length} ${knots.length === 1 ? "knot" : "knots"}: ${counts.linear} ${counts.linear === 1 ? "corner" : "corners"}, ${counts.cubic} smooth, ${counts.coincident} both. No point is farther than ${max.toPrecision(2)} from the curve. Brackets step through the knots.`;
}
