import type { Action, Editor, EditorState } from "../editor.ts";
import { chooseFitTool, clearFit, openFitSample, setCorners, setFitView, setModel, setSmoothing, showData, stepKnot } from "./fit-edits.ts";
import type { Compare, FitOverlay } from "./fit-state.ts";

/** Fit's commands: one definition for its panel, its keys and the help. */

const inFit = (state: EditorState): boolean => state.mode === "fit";
const hasData = (state: EditorState): boolean => inFit(state) && state.fit.data.length > 0;
const hasKnots = (state: EditorState): boolean => inFit(state) && (state.fitRun.outcome?.knots.length ?? 0) > 0;

const compares: readonly Compare[] = ["off", "onion", "split"];

export function registerFitActions(editor: Editor): void {
  const add = (id: string, label: string, keys: readonly string[], run: () => void, enabled: Action["enabled"] & object = inFit): void => {
    editor.actions.register({ id, label, group: "Fit", keys, run, enabled });
  };
  add("fit-erase", "Erase points", ["E"], () => chooseFitTool(editor, "erase"));
  add("fit-next-knot", "Next knot", ["]"], () => stepKnot(editor, 1), hasKnots);
  add("fit-previous-knot", "Previous knot", ["["], () => stepKnot(editor, -1), hasKnots);
  add("fit-smoother", "Fewer knots", ["}"], () => setSmoothing(editor, editor.state.value.fit.smoothing + 5), hasData);
  add("fit-rougher", "More knots", ["{"], () => setSmoothing(editor, editor.state.value.fit.smoothing - 5), hasData);
  add("fit-clear", "Clear points", [], () => clearFit(editor), hasData);
  add("fit-redraw", "Redraw", [], () => {
    clearFit(editor);
    chooseFitTool(editor, "draw");
  });
  add("fit-compare", "Compare with points", [], () => {
    const { compare } = editor.state.value.fitView;
    setFitView(editor, { compare: compares[(compares.indexOf(compare) + 1) % compares.length] ?? "off" });
  }, hasData);
  add("fit-comb", "Curvature comb", ["K"], () => toggleFitOverlay(editor, "comb"), hasKnots);
  add("fit-show-data", "Fit points in view", [], () => showData(editor), hasData);
  for (const [model, label] of [["linear", "Straight pieces"], ["cubic", "Smooth curve"], ["hybrid", "Straight and smooth"]] as const) {
    add(`fit-model-${model}`, label, [], () => setModel(editor, model));
  }
  add("fit-corners", "Keep corners", ["C"], () => setCorners(editor, !editor.state.value.fit.corners));
  add("fit-open-star", "Open noisy star", [], () => void openFitSample(editor, "fit-star"));
}

export function toggleFitOverlay(editor: Editor, overlay: FitOverlay): void {
  const { overlays } = editor.state.value.fitView;
  setFitView(editor, { overlays: { ...overlays, [overlay]: !overlays[overlay] } });
}
