import type { Action, Editor, EditorState } from "../editor.ts";
import { chooseFitTool, clearFit, openFitSample, setCorners, setFitView, setModel, setSmoothing, showData, stepKnot } from "./fit-edits.ts";
import type { Compare, FitOverlay } from "./fit-state.ts";

/** Fit's commands: one definition for its panel, its keys and the help. */

const inFit = (state: EditorState): boolean => state.mode === "fit";
const hasData = (state: EditorState): boolean => inFit(state) && state.fit.data.length > 0;
const hasKnots = (state: EditorState): boolean => inFit(state) && (state.fitRun.outcome?.knots.length ?? 0) > 0;

const compares: readonly Compare[] = ["off", "onion", "split"];

export function registerFitActions(editor: Editor): void {
  const add = (id: string, label: string, group: Action["group"], keys: readonly string[], run: () => void, enabled: Action["enabled"] & object = inFit): void => {
    editor.actions.register({ id, label, group, keys, run, enabled });
  };
  add("fit-erase", "Erase points", "Tools", ["E"], () => chooseFitTool(editor, "erase"));
  add("fit-next-knot", "Next knot", "Points", ["]"], () => stepKnot(editor, 1), hasKnots);
  add("fit-previous-knot", "Previous knot", "Points", ["["], () => stepKnot(editor, -1), hasKnots);
  add("fit-smoother", "Fewer knots", "Curve", ["}"], () => setSmoothing(editor, editor.state.value.fit.smoothing + 5), hasData);
  add("fit-rougher", "More knots", "Curve", ["{"], () => setSmoothing(editor, editor.state.value.fit.smoothing - 5), hasData);
  add("fit-clear", "Clear the points", "Edit", [], () => clearFit(editor), hasData);
  add("fit-redraw", "Redraw", "Edit", [], () => {
    clearFit(editor);
    chooseFitTool(editor, "draw");
  });
  add("fit-compare", "Compare with the points", "View", [], () => {
    const { compare } = editor.state.value.fitView;
    setFitView(editor, { compare: compares[(compares.indexOf(compare) + 1) % compares.length] ?? "off" });
  }, hasData);
  add("fit-comb", "Curvature comb of the fit", "View", ["K"], () => toggleFitOverlay(editor, "comb"), hasKnots);
  add("fit-show-data", "Fit the points in view", "View", [], () => showData(editor, 64), hasData);
  for (const [model, label] of [["linear", "Straight pieces"], ["cubic", "Smooth curve"], ["hybrid", "Straight and smooth"]] as const) {
    add(`fit-model-${model}`, label, "Curve", [], () => setModel(editor, model));
  }
  add("fit-corners", "Keep corners", "Curve", ["C"], () => setCorners(editor, !editor.state.value.fit.corners));
  add("fit-open-star", "Open the noisy star", "File", [], () => void openFitSample(editor, "fit-star"));
}

export function toggleFitOverlay(editor: Editor, overlay: FitOverlay): void {
  const { overlays } = editor.state.value.fitView;
  setFitView(editor, { overlays: { ...overlays, [overlay]: !overlays[overlay] } });
}
