import type { Command } from "../document/curve/commands.ts";
import type { Mode, View } from "../document/document.ts";
import type { Moment } from "../document/history.ts";
import { createActions } from "./actions/actions.ts";
import { outcomeOf } from "./curve/checked.ts";
import type { Editor, EditorState, Notice } from "./editor.ts";
import { createSaving } from "./history/saving.ts";
import type { Timeline } from "./history/timeline.ts";
import { createTimelines, momentOf, travels } from "./history/timelines.ts";
import { initialState } from "./initial-state.ts";
import { resized } from "./pointer/camera.ts";
import { createSignal } from "./signal.ts";

/** `now` is the clock for joining runs of small edits, in milliseconds. */
export function createEditor(now: () => number): Editor {
  const state = createSignal<EditorState>(initialState);
  const notices = createSignal<Notice | null>(null);
  const timelines = createTimelines(state, now);
  const { curve: curveEdits } = timelines;
  /** Where the modes that are not on the stage were looked at. */
  const views = new Map<Mode, View>();
  const modes: Editor["modes"] = new Map();

  /** The command's result on a moment, or null when the engine refuses it or nothing changes. */
  function applied(command: Command, from: Moment): Moment | null {
    return outcomeOf(command, from, ({ message }) => {
      // A step of a drag that goes too far is dropped silently: the drag is held at the last good place.
      if (!curveEdits.inGesture) notices.set({ kind: "error", id: "number", text: `${command.name} was refused: ${message}` });
    });
  }

  function travel(way: "undo" | "redo", done: string): void {
    const { mode, [`${way}Name` as const]: name } = state.value;
    // In a drag it is the drag that is taken back.
    const isSaid = name !== null && !editor.inGesture;
    timelines[mode][way]();
    if (!isSaid) return;
    // What the hint said of the step is no longer so; of a path that it draws the pen says by itself how it goes on.
    if (state.value.tool === "select") editor.patch({ hint: "" });
    editor.notify({ kind: "announce", text: `${done}: ${name}` });
  }

  const editor: Editor = {
    state,
    notices,
    modes,
    loading: new Set(),
    get actions() {
      return actions;
    },
    surfaceEdits: timelines.surface,
    fitEdits: timelines.fit,
    traceEdits: timelines.trace,
    get inGesture() {
      return Object.values(timelines).some((timeline: Pick<Timeline<unknown>, "inGesture">) => timeline.inGesture);
    },
    get origin() {
      return curveEdits.origin.curve;
    },
    dispatch(command) {
      curveEdits.dispatch(command.name, (before) => applied(command, before) ?? before, command.run);
    },
    begin: curveEdits.begin,
    preview(command, also = {}) {
      curveEdits.preview((start) => applied(command, start) ?? momentOf(state.value), also);
    },
    commit: curveEdits.commit,
    bail: curveEdits.bail,
    undo: () => travel("undo", "Undone"),
    redo: () => travel("redo", "Redone"),
    patch(change) {
      const { mode, view, stage } = state.value;
      if (change.mode === undefined || change.mode === mode) return state.set({ ...state.value, ...change });
      views.set(mode, view);
      const known = views.get(change.mode);
      // The tools of Fit are not those of Curve, though the rail's buttons stand for both.
      const own = mode === "fit" ? { tool: "select" as const } : {};
      state.set({ ...state.value, view: resized(known ?? view, stage), ...own, ...change, ...travels(timelines[change.mode]) });
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
    ...createSaving({ state, timelines, modes, opened: () => views.clear() }),
  };

  const actions = createActions(editor);
  return editor;
}
