import { emptyCurve, nothingSelected, stateVersion, type DemoState } from "../../document/document.ts";
import { othersOf } from "../../document/file/others.ts";
import { noNetPoints } from "../../document/surface/surface.ts";
import { objection } from "../curve/checked.ts";
import type { Editor, EditorState } from "../editor.ts";
import type { Signal } from "../signal.ts";
import type { Timeline } from "./timeline.ts";
import type { Timelines } from "./timelines.ts";

interface SavingOptions {
  readonly state: Signal<EditorState>;
  readonly timelines: Timelines;
  readonly modes: Editor["modes"];
  /** Another document: what is remembered of the last one is no longer so. */
  opened(): void;
}

/** All four drawings as one plain value, out and in: what files, links and the page's own memory hold. */
export function createSaving({ state, timelines, modes, opened }: SavingOptions): Pick<Editor, "getState" | "setState"> {
  /** What the open file holds beside this page's own fields: somebody else's, and written again as it was. */
  let others: Record<string, unknown> = {};

  function getState(): DemoState {
    const { mode, view, curve, fit, trace, surface, solid } = state.value;
    const look = surface.net.length === 0 ? {} : { orbit: solid.orbit };
    return {
      ...others,
      format: "expline-demo",
      version: stateVersion,
      mode,
      // Which way y points follows from the document. Any other view stays the one that knows what it was made to show.
      view: view.up === true ? { zoom: view.zoom, x: view.x, y: view.y } : view,
      curve,
      fit,
      trace: modes.get("trace")?.saved?.(state.value) ?? trace,
      surface,
      ...look,
    };
  }

  function setState(next: DemoState, { fresh = false }: { fresh?: boolean } = {}): void {
    const problem = objection(next.curve, emptyCurve);
    if (problem !== null) throw problem;
    for (const timeline of Object.values(timelines)) timeline.bail();
    others = othersOf(next);
    opened();
    const { mode, view, curve, fit, trace, surface, orbit } = next;
    replace(timelines.surface, { surface, chosen: noNetPoints }, fresh);
    replace(timelines.fit, { fit }, fresh);
    replace(timelines.trace, { trace }, fresh);
    const { solid } = state.value;
    state.set({ ...state.value, mode, view, solid: orbit === undefined ? solid : { ...solid, orbit, full: 0 } });
    // The curve comes last: what it is put on is then the stage that it belongs to.
    replace(timelines.curve, { curve, selection: nothingSelected }, fresh);
  }

  return { getState, setState };
}

/** One entry, or with `fresh` a history that begins here. */
function replace<M, Also>(timeline: Timeline<M, Also>, moment: M, fresh: boolean): void {
  if (!fresh) return timeline.dispatch("Open", () => moment);
  timeline.settle(moment);
  timeline.forget();
}
