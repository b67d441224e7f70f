import type { FitMoment } from "../../document/fit/fit.ts";
import type { Moment } from "../../document/history.ts";
import type { SurfaceMoment } from "../../document/surface/surface.ts";
import type { TraceMoment } from "../../document/trace/trace.ts";
import { surviving } from "../curve/checked.ts";
import type { EditorPatch, EditorState } from "../editor.ts";
import type { Signal } from "../signal.ts";
import { createTimeline, type Timeline } from "./timeline.ts";

/** What each mode's undo and redo go through. */
export interface Timelines {
  readonly curve: Timeline<Moment, EditorPatch>;
  readonly fit: Timeline<FitMoment>;
  readonly trace: Timeline<TraceMoment>;
  readonly surface: Timeline<SurfaceMoment>;
}

type Travels = Pick<EditorState, "canUndo" | "canRedo" | "undoName" | "redoName">;

export function momentOf({ curve, selection }: EditorState): Moment {
  return { curve, selection };
}

/** What undo and redo would do in a mode: each mode has its own history. */
export function travels({ past, future }: Pick<Timeline<unknown>, "past" | "future">): Travels {
  return { canUndo: past !== null, canRedo: future !== null, undoName: past, redoName: future };
}

export function createTimelines(state: Signal<EditorState>, now: () => number): Timelines {
  const changed = (): void => state.set({ ...state.value, ...travels(timelines[state.value.mode]) });

  function timeline<M extends Partial<EditorState>>(read: (state: EditorState) => M, same: (a: M, b: M) => boolean): Timeline<M> {
    return createTimeline({ read: () => read(state.value), write: (moment) => state.set({ ...state.value, ...moment }), same, changed, now });
  }

  function put({ curve, selection }: Moment, also: EditorPatch = {}): void {
    const sketch = also.sketch ?? state.value.sketch;
    const isSame = curve === state.value.curve;
    state.set({
      ...state.value,
      // What lay under the pointer is somewhere else, or gone.
      ...(isSame || timelines.curve.inGesture ? {} : { hover: { kind: "empty" as const } }),
      ...also,
      curve,
      // A proposal is about the drawing as it was.
      sketch: sketch.proposal === null || isSame ? sketch : { ...sketch, proposal: null },
      selection: surviving(curve, selection),
    });
  }

  const timelines: Timelines = {
    curve: createTimeline<Moment, EditorPatch>({ read: () => momentOf(state.value), write: put, same: (a, b) => a.curve === b.curve, changed, now }),
    fit: timeline(({ fit }) => ({ fit }), (a, b) => a.fit === b.fit),
    trace: timeline(({ trace }) => ({ trace }), (a, b) => a.trace === b.trace),
    surface: timeline(({ surface, chosen }) => ({ surface, chosen }), (a, b) => a.surface === b.surface),
  };
  return timelines;
}
