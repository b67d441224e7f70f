import { panned, type ScreenPoint } from "./camera.ts";
import type { Editor, Modifiers } from "../editor.ts";
import type { ModeParts } from "../mode.ts";
import { sampleAt, type Tool } from "../tool.ts";
import type { PointerRecord } from "./pointer-record.ts";

/** What pointers that are pressed are doing: working a tool, moving the view, or pinching it. */
export interface Activity {
  /** Whether it is over when this pointer is gone. */
  endsWith(id: number): boolean;
  /** `trail` has every place of the pointer since the last time. */
  moved(record: PointerRecord, trail: readonly ScreenPoint[]): void;
  /** It is over: its last pointer was let go. */
  released(record: PointerRecord): void;
  /** It is over, and what it began is taken back. */
  cancelled(): void;
}

/** A press that a tool answers, and the moves that follow it. */
export interface ToolPress extends Activity {
  readonly kind: "tool";
  /** When the press was, in milliseconds. */
  readonly since: number;
  /** A modifier was pressed or let go while the pointer rests. */
  modified(modifiers: Modifiers): void;
}

export function pressTool(editor: Editor, tool: Tool, first: PointerRecord, clicks: number): ToolPress {
  const { id, kind } = first;
  let { screen } = first;
  const sample = (record: PointerRecord, count = clicks): ReturnType<typeof sampleAt> => sampleAt(editor.state.value, record.screen, kind, record.modifiers, count);
  return {
    kind: "tool",
    since: first.time,
    endsWith: (gone) => gone === id,
    moved(record, trail) {
      if (record.id !== id) return;
      screen = record.screen;
      tool.drag({ ...sample(record), trail: trail.map((place) => sample({ ...record, screen: place }).page) });
    },
    modified(modifiers) {
      tool.drag(sampleAt(editor.state.value, screen, kind, modifiers, clicks));
    },
    released(record) {
      tool.release(sample(record));
      // A finger that is gone is above nothing.
      if (kind !== "touch") tool.hover(sample(record, 1));
    },
    cancelled: () => void tool.cancel(),
  };
}

/** The view follows one pointer. `rest` puts back the cursor that there is with no button down. */
export interface Panning extends Activity {
  readonly kind: "pan";
}

export function pan(editor: Editor, own: () => ModeParts | undefined, first: PointerRecord, rest: () => void): Panning {
  const { id } = first;
  let last = first.screen;
  return {
    kind: "pan",
    endsWith: (gone) => gone === id,
    moved({ id: moving, screen }) {
      if (moving !== id) return;
      const [dx, dy] = [screen.x - last.x, screen.y - last.y];
      last = screen;
      const view = own()?.view;
      if (view === undefined) editor.patch({ view: panned(editor.state.value.view, dx, dy) });
      else view.pan(dx, dy);
    },
    released: rest,
    cancelled: rest,
  };
}
