import { hasPicture, isEmptyTrace } from "../../document/trace/trace.ts";
import type { Action, Editor, EditorState } from "../editor.ts";
import { editTraceInCurve, smoothInFit } from "./hand-over.ts";
import { canView, clearTrace, keepSmall, leftOutOf, setTrace, setTraceView, showBox, sizeOf, stepPoint, toggleCorner, traceAnyway, usualColors } from "./trace-edits.ts";
import type { TraceRunner } from "./trace-runner.ts";
import type { TraceViewId } from "./trace-state.ts";

/** Trace's commands: one definition for its panel, its keys and the help. */

const inTrace = (state: EditorState): boolean => state.mode === "trace";
const canTrace = (state: EditorState): boolean => inTrace(state) && hasPicture(state.trace);
const hasOutlines = (state: EditorState): boolean => inTrace(state) && state.traceRun.outcome !== null;
const hasChosen = (state: EditorState): boolean => hasOutlines(state) && state.traceView.chosen !== null;

export const traceViews: readonly (readonly [TraceViewId, string, string])[] = [
  ["result", "Result", "Outlines over the picture."],
  ["outline", "Outline", "Outlines only, with their points."],
  ["source", "Source", "Picture only."],
  ["edges", "Edges", "What the tracer sees as ink, or as edges."],
];

export function registerTraceActions(editor: Editor, runner: TraceRunner): void {
  const add = (id: string, label: string, keys: readonly string[], run: () => void, enabled: Action["enabled"] & object = inTrace): void => {
    editor.actions.register({ id, label, group: "Trace", keys, run, enabled });
  };
  const state = (): EditorState => editor.state.value;
  add("trace-run", "Trace", [], () => runner.again(), canTrace);
  add("trace-cancel", "Cancel tracing", [], () => runner.cancel(), (now) => inTrace(now) && now.traceRun.since !== null);
  add("trace-anyway", "Trace anyway", [], () => traceAnyway(editor), canTrace);
  add("trace-colors", "Trace in colours", [], () => setTrace(editor, "Flat colours", { colors: usualColors }), (now) => canTrace(now) && now.trace.settings.colors === 0);
  add("trace-keep-small", "Keep small shapes", ["S"], () => keepSmall(editor), (now) => canTrace(now) && leftOutOf(now) !== null);
  add("trace-clear", "Clear picture", [], () => clearTrace(editor), (now) => inTrace(now) && !isEmptyTrace(now.trace));
  add("trace-next", "Next point", ["]"], () => stepPoint(editor, 1, false), hasOutlines);
  add("trace-previous", "Previous point", ["["], () => stepPoint(editor, -1, false), hasOutlines);
  add("trace-next-corner", "Next corner", ["."], () => stepPoint(editor, 1, true), hasOutlines);
  add("trace-previous-corner", "Previous corner", [","], () => stepPoint(editor, -1, true), hasOutlines);
  add(
    "trace-corner",
    "Corner ↔ smooth",
    ["C"],
    () => state().traceView.chosen !== null && toggleCorner(editor, state().traceView.chosen ?? { contour: 0, index: 0 }),
    hasChosen,
  );
  add("trace-smoother", "Smoother outlines", ["}"], () => setTrace(editor, "Detail", { detail: Math.min(100, state().trace.settings.detail + 5) }), canTrace);
  add("trace-finer", "Finer outlines", ["{"], () => setTrace(editor, "Detail", { detail: Math.max(0, state().trace.settings.detail - 5) }), canTrace);
  add("trace-invert", "Invert picture", ["I"], () => setTrace(editor, "Invert", { invert: !state().trace.settings.invert }), canTrace);
  add("trace-smooth-in-fit", "Smooth in Fit", [], () => smoothInFit(editor), hasOutlines);
  add("trace-edit", "Edit in Curve", [], () => editTraceInCurve(editor), hasOutlines);
  add("trace-next-view", "Next view", ["W"], () => {
    const views = traceViews.filter(([id]) => canView(state(), id));
    const at = views.findIndex(([id]) => id === state().traceView.view);
    const [id] = views[(at + 1) % views.length] ?? ["result"];
    setTraceView(editor, { view: id });
  });
  add("trace-show", "Fit picture in view", [], () => {
    const size = sizeOf(state());
    if (size !== null) showBox(editor, size);
  });
}
