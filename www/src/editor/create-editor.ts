import type { Command } from "../document/curve/commands.ts";
import { emptyCurve, nothingSelected, stateVersion, type CurveDocument, type DemoState, type Mode, type Selection, type View } from "../document/document.ts";
import type { FitMoment } from "../document/fit/fit.ts";
import { othersOf } from "../document/file/others.ts";
import { noNetPoints, type SurfaceMoment } from "../document/surface/surface.ts";
import type { TraceMoment } from "../document/trace/trace.ts";
import { emptyHistory, record, stepBack, stepForward, type History, type Moment } from "../document/history.ts";
import { createActions } from "./actions/actions.ts";
import { checked, objection, surviving } from "./curve/checked.ts";
import type { Editor, EditorPatch, EditorState, Notice } from "./editor.ts";
import { initialState } from "./initial-state.ts";
import { resized } from "./pointer/camera.ts";
import { createSignal } from "./signal.ts";
import { createTimeline, type Timeline } from "./timeline.ts";

/** `now` is the clock for joining runs of small edits, in milliseconds. */
export function createEditor(now: () => number): Editor {
  const state = createSignal<EditorState>(initialState);
  const notices = createSignal<Notice | null>(null);
  let history: History<Moment> = emptyHistory();
  /** What the open file holds beside this page's own fields: somebody else's, and written again as it was. */
  let others: Record<string, unknown> = {};
  /** Where the modes that are not on the stage were looked at. */
  const views = new Map<Mode, View>();
  let gesture: { name: string; start: Moment; changed: boolean } | null = null;

  const moment = (): Moment => ({ curve: state.value.curve, selection: state.value.selection });

  function put(curve: CurveDocument, selection: Selection, also: EditorPatch = {}): void {
    const sketch = also.sketch ?? state.value.sketch;
    state.set({
      ...state.value,
      // What lay under the pointer is somewhere else, or gone.
      ...(gesture === null && curve !== state.value.curve ? { hover: { kind: "empty" as const } } : {}),
      ...also,
      curve,
      // A proposal is about the drawing as it was.
      sketch: sketch.proposal === null || curve === state.value.curve ? sketch : { ...sketch, proposal: null },
      selection: surviving(curve, selection),
      ...travels(also.mode ?? state.value.mode),
    });
  }

  /** What undo and redo would do in a mode: each mode has its own history. */
  function travels(mode: Mode): Pick<EditorState, "canUndo" | "canRedo" | "undoName" | "redoName"> {
    const timeline = timelineOf(mode);
    const undoName = timeline === null ? (history.past.at(-1)?.name ?? null) : timeline.past;
    const redoName = timeline === null ? (history.future.at(-1)?.name ?? null) : timeline.future;
    return { canUndo: undoName !== null, canRedo: redoName !== null, undoName, redoName };
  }

  function timelineOf(mode: Mode): Pick<Timeline<unknown>, "past" | "future" | "undo" | "redo"> | null {
    return mode === "surface" ? surfaceEdits : mode === "fit" ? fitEdits : mode === "trace" ? traceEdits : null;
  }

  const refresh = (): void => state.set({ ...state.value, ...travels(state.value.mode) });

  const surfaceEdits = createTimeline<SurfaceMoment>({
    read: () => ({ surface: state.value.surface, chosen: state.value.chosen }),
    write: (moment) => state.set({ ...state.value, ...moment }),
    same: (a, b) => a.surface === b.surface,
    changed: refresh,
    now,
  });

  const fitEdits = createTimeline<FitMoment>({
    read: () => ({ fit: state.value.fit }),
    write: (moment) => state.set({ ...state.value, ...moment }),
    same: (a, b) => a.fit === b.fit,
    changed: refresh,
    now,
  });

  const traceEdits = createTimeline<TraceMoment>({
    read: () => ({ trace: state.value.trace }),
    write: (moment) => state.set({ ...state.value, ...moment }),
    same: (a, b) => a.trace === b.trace,
    changed: refresh,
    now,
  });

  /** The command's result on a moment, or null when the engine refuses it or nothing changes. */
  function applied(command: Command, from: Moment): Moment | null {
    const wanted = command.apply(from.curve);
    if (wanted === from.curve) return null;
    const { curve, problem } = checked(wanted, from.curve);
    if (problem !== null) {
      // A step of a drag that goes too far is dropped silently: the drag is held at the last good place.
      if (gesture === null) notices.set({ kind: "error", id: "number", text: `${command.name} was refused: ${problem.message}` });
      return null;
    }
    const select = command.select ?? from.selection;
    return { curve, selection: surviving(curve, typeof select === "function" ? select(curve) : select) };
  }

  const editor: Editor = {
    state,
    notices,
    modes: new Map(),
    loading: new Set(),
    get actions() {
      return actions;
    },
    surfaceEdits,
    fitEdits,
    traceEdits,
    get inGesture() {
      return gesture !== null || surfaceEdits.inGesture || fitEdits.inGesture || traceEdits.inGesture;
    },
    get origin() {
      return gesture?.start.curve ?? state.value.curve;
    },
    dispatch(command) {
      const before = moment();
      const after = applied(command, before);
      if (after === null) return;
      if (gesture === null) history = record(history, { name: command.name, before, after, run: command.run, time: now() });
      else gesture.changed = true;
      put(after.curve, after.selection);
    },
    begin(name) {
      if (gesture !== null) editor.commit();
      gesture = { name, start: moment(), changed: false };
    },
    preview(command, also = {}) {
      if (gesture === null) {
        editor.patch(also);
        return editor.dispatch(command);
      }
      const after = applied(command, gesture.start);
      if (after === null) return editor.patch(also);
      gesture.changed = true;
      put(after.curve, after.selection, also);
    },
    commit() {
      if (gesture === null) return;
      const { name, start, changed } = gesture;
      gesture = null;
      if (changed && state.value.curve !== start.curve) {
        history = record(history, { name, before: start, after: moment(), run: undefined, time: now() });
      }
      put(state.value.curve, state.value.selection);
    },
    bail() {
      if (gesture === null) return;
      const { start } = gesture;
      gesture = null;
      put(start.curve, start.selection);
    },
    undo() {
      const timeline = timelineOf(state.value.mode);
      if (timeline === null) travel(stepBack);
      else timeline.undo();
    },
    redo() {
      const timeline = timelineOf(state.value.mode);
      if (timeline === null) travel(stepForward);
      else timeline.redo();
    },
    patch(change) {
      const { mode, view, stage } = state.value;
      if (change.mode === undefined || change.mode === mode) return state.set({ ...state.value, ...change });
      views.set(mode, view);
      const known = views.get(change.mode);
      state.set({ ...state.value, view: resized(known ?? view, stage), ...change, ...travels(change.mode) });
      // A drawing that came with a file or a link has not been looked at yet.
      if (known === undefined && change.mode === "curve") actions.run("zoom-fit");
    },
    setSettings(change) {
      editor.patch({ settings: { ...state.value.settings, ...change } });
    },
    setOverlay(overlay, on) {
      editor.setSettings({ overlays: { ...state.value.settings.overlays, [overlay]: on } });
    },
    notify(notice) {
      // A copy, so that saying the same thing twice is heard twice.
      notices.set({ ...notice });
    },
    getState() {
      const { mode, view, curve, fit, trace, surface, solid } = state.value;
      const look = surface.net.length === 0 ? {} : { orbit: solid.orbit };
      return {
        ...others,
        format: "expline-demo",
        version: stateVersion,
        mode,
        view,
        curve,
        fit,
        trace: editor.modes.get("trace")?.saved?.(state.value) ?? trace,
        surface,
        ...look,
      };
    },
    setState(next: DemoState, options = {}) {
      editor.bail();
      const { mode, view, fit, trace, surface } = next;
      const before = moment();
      const problem = objection(next.curve, emptyCurve);
      if (problem !== null) throw problem;
      surfaceEdits.bail();
      fitEdits.bail();
      traceEdits.bail();
      others = othersOf(next);
      views.clear();
      if (options.fresh === true) {
        history = emptyHistory();
        state.set({ ...state.value, surface, chosen: noNetPoints, fit, trace });
        surfaceEdits.forget();
        fitEdits.forget();
        traceEdits.forget();
      } else {
        history = record(history, { name: "Open", before, after: { curve: next.curve, selection: nothingSelected }, run: undefined, time: now() });
        surfaceEdits.dispatch("Open", () => ({ surface, chosen: noNetPoints }));
        fitEdits.dispatch("Open", () => ({ fit }));
        traceEdits.dispatch("Open", () => ({ trace }));
      }
      const { solid } = state.value;
      state.set({ ...state.value, mode, view, solid: next.orbit === undefined ? solid : { ...solid, orbit: next.orbit } });
      put(next.curve, nothingSelected, { mode });
    },
  };

  function travel(step: typeof stepBack): void {
    // Undo during a drag takes back the drag and nothing else.
    if (gesture !== null) return editor.bail();
    const taken = step(history);
    if (taken === null) return;
    history = taken.history;
    put(taken.moment.curve, taken.moment.selection);
  }

  const actions = createActions(editor);
  return editor;
}
