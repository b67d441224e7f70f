import { panned, type ScreenPoint } from "./camera.ts";
import type { Editor, Modifiers, ToolId } from "../editor.ts";
import type { PointerKind } from "./hit-test.ts";
import type { ModeParts } from "../mode.ts";
import { createPinch, type Pinch } from "./pinch.ts";
import { distanceBetween, sampleAt, type PointerSample, type Tool } from "../tool.ts";

/**
 * Pointers to tools. It knows no DOM: events come in as plain records, so that the headless tests press the same keys
 * and move the same pointers as a hand. One pointer works the tool; two fingers pinch; space, the middle button and the
 * hand tool pan.
 */

export interface PointerRecord {
  readonly id: number;
  readonly kind: PointerKind;
  /** 0 main, 1 middle, 2 right. */
  readonly button: number;
  readonly screen: ScreenPoint;
  readonly modifiers: Modifiers;
  /** Milliseconds. */
  readonly time: number;
}

export interface PointerInput {
  down(record: PointerRecord): void;
  /** Kept until `flush`; only the last place of a frame counts. */
  move(record: PointerRecord): void;
  up(record: PointerRecord): void;
  /** The browser took the pointer away. */
  lost(id: number): void;
  /** Works off the kept move: once a frame, and before every other event. */
  flush(): void;
  modifiers(modifiers: Modifiers): void;
  /** Space held: the main button pans. */
  space(held: boolean): void;
  /** Esc: cancels what the pointer is doing. Says whether there was anything. */
  cancel(): boolean;
  /** Lets the tool that is up finish what it began (pen). */
  finish(): boolean;
  readonly busy: boolean;
}

const doubleMs = 400;
const doublePx = 5;
const secondFingerMs = 150;
const tapMs = 350;
/** More places in one frame than any device reports. */
const mostTrail = 4096;

interface Finger {
  readonly start: ScreenPoint;
  screen: ScreenPoint;
  readonly time: number;
}

type Activity =
  | { readonly kind: "none" }
  | {
    readonly kind: "tool"; readonly id: number; readonly tool: Tool; readonly pointer: PointerKind; readonly clicks: number; readonly since: number;
    screen: ScreenPoint;
  }
  | { readonly kind: "pan"; readonly id: number; last: ScreenPoint; readonly since: number }
  | { readonly kind: "pinch"; readonly ids: readonly [number, number]; readonly pinch: Pinch; readonly since: number; most: number };

export function createPointerInput(editor: Editor, tools: Readonly<Record<ToolId, Tool>>): PointerInput {
  const fingers = new Map<number, Finger>();
  let activity: Activity = { kind: "none" };
  let pending: PointerRecord | null = null;
  /** Places of the pointer since the last flush. */
  let trail: ScreenPoint[] = [];
  let lastPress: { screen: ScreenPoint; time: number } | null = null;
  /** Where a pointer is that is not pressed. */
  let above: PointerRecord | null = null;
  let spaceHeld = false;
  let penSeen = false;

  const own = (): ModeParts | undefined => editor.modes.get(editor.state.value.mode);
  const tool = (): Tool => own()?.tool ?? tools[editor.state.value.tool];
  const works = (): boolean => editor.state.value.mode === "curve" || own() !== undefined;
  const sample = (record: PointerRecord, clicks = 1): PointerSample => sampleAt(editor.state.value, record.screen, record.kind, record.modifiers, clicks);

  function clicksOf(record: PointerRecord): number {
    const again = lastPress !== null && record.time - lastPress.time < doubleMs && distanceBetween(record.screen, lastPress.screen) < doublePx;
    lastPress = again ? null : { screen: record.screen, time: record.time };
    return again ? 2 : 1;
  }

  function startPinch(time: number): void {
    const [first, second] = [...fingers.entries()];
    if (first === undefined || second === undefined) return;
    const { view, stage } = editor.state.value;
    const [a, b] = [first[1].screen, second[1].screen];
    const pinch = own()?.view?.pinch(a, b) ?? createPinch(view, stage, a, b);
    activity = { kind: "pinch", ids: [first[0], second[0]], pinch, since: time, most: fingers.size };
  }

  function anotherFinger(record: PointerRecord): boolean {
    if (fingers.size < 2) return false;
    if (activity.kind === "tool") {
      // A finger that comes late touches by accident; one that comes at once means two from the start.
      if (record.time - activity.since > secondFingerMs && editor.inGesture) return true;
      activity.tool.cancel();
      lastPress = null;
    }
    if (activity.kind === "pinch") activity.most = Math.max(activity.most, fingers.size);
    else startPinch(record.time);
    return true;
  }

  function pansWith(record: PointerRecord): boolean {
    if (record.button === 1 || spaceHeld) return true;
    // Only a mode with a view of its own has the right button free for it.
    if (own()?.view !== undefined) return record.button === 2;
    if (editor.state.value.tool === "hand") return true;
    return record.kind === "touch" && penSeen && editor.state.value.settings.penPans;
  }

  function flush(): void {
    if (pending === null) return;
    const record = pending;
    const places = trail;
    pending = null;
    trail = [];
    const finger = fingers.get(record.id);
    if (finger !== undefined) finger.screen = record.screen;
    switch (activity.kind) {
      case "none":
        above = record.kind === "touch" ? null : record;
        if (above !== null) tool().hover(sample(above));
        return;
      case "tool":
        if (record.id !== activity.id) return;
        activity.screen = record.screen;
        // A press that became a drag is not the first half of a double-click.
        if (lastPress !== null && distanceBetween(record.screen, lastPress.screen) > doublePx) lastPress = null;
        activity.tool.drag({ ...sample(record, activity.clicks), trail: places.map((place) => sample({ ...record, screen: place }).page) });
        return;
      case "pan":
        if (record.id !== activity.id) return;
        pan(record.screen.x - activity.last.x, record.screen.y - activity.last.y);
        activity.last = record.screen;
        return;
      case "pinch":
        pinchNow();
    }
  }

  function pan(dx: number, dy: number): void {
    const view = own()?.view;
    if (view === undefined) editor.patch({ view: panned(editor.state.value.view, dx, dy) });
    else view.pan(dx, dy);
  }

  function pinchNow(): void {
    if (activity.kind !== "pinch") return;
    const [a, b] = activity.ids.map((id) => fingers.get(id)?.screen);
    if (a !== undefined && b !== undefined) editor.patch(activity.pinch.update(a, b));
  }

  function endPinch(record: PointerRecord): void {
    if (activity.kind !== "pinch" || fingers.size > 0) return;
    const { pinch, since, most } = activity;
    activity = { kind: "none" };
    if (pinch.moved || record.time - since > tapMs) return;
    editor.actions.run(most >= 3 ? "redo" : "undo");
  }

  return {
    get busy() {
      return activity.kind !== "none";
    },
    flush,
    down(record) {
      flush();
      if (record.kind === "pen") penSeen = true;
      if (record.kind === "touch") {
        fingers.set(record.id, { start: record.screen, screen: record.screen, time: record.time });
        if (anotherFinger(record)) return;
      }
      if (activity.kind !== "none" || !works() || (record.button === 2 && own()?.view === undefined)) return;
      editor.patch({ keyboard: false, touch: record.kind === "touch", modifiers: record.modifiers, ...(editor.state.value.hint === "" ? {} : { hint: "" }) });
      if (pansWith(record)) {
        activity = { kind: "pan", id: record.id, last: record.screen, since: record.time };
        editor.patch({ cursor: "grabbing" });
        return;
      }
      const clicks = clicksOf(record);
      activity = { kind: "tool", id: record.id, tool: tool(), pointer: record.kind, clicks, since: record.time, screen: record.screen };
      activity.tool.press(sample(record, clicks));
    },
    move(record) {
      // Two fingers report in turn: the place of each counts.
      const finger = fingers.get(record.id);
      if (finger !== undefined) finger.screen = record.screen;
      if (pending !== null && pending.id !== record.id) trail = [];
      pending = record;
      if (activity.kind === "tool" && trail.length < mostTrail) trail.push(record.screen);
    },
    up(record) {
      flush();
      fingers.delete(record.id);
      switch (activity.kind) {
        case "none":
          return;
        case "tool": {
          if (record.id !== activity.id) return;
          const { tool: worked, clicks } = activity;
          activity = { kind: "none" };
          worked.release(sample(record, clicks));
          if (record.kind !== "touch") worked.hover(sample(record));
          return;
        }
        case "pan":
          if (record.id !== activity.id) return;
          activity = { kind: "none" };
          editor.patch({ cursor: spaceHeld || editor.state.value.tool === "hand" ? "grab" : "default" });
          return;
        case "pinch":
          endPinch(record);
      }
    },
    lost(id) {
      fingers.delete(id);
      if (pending?.id === id) pending = null;
      if (activity.kind === "tool" && activity.id === id) activity.tool.cancel();
      const over = activity.kind === "pinch" ? fingers.size === 0 : activity.kind !== "none" && activity.id === id;
      if (over) activity = { kind: "none" };
    },
    modifiers(modifiers) {
      const old = editor.state.value.modifiers;
      if (old.shift === modifiers.shift && old.alt === modifiers.alt && old.mod === modifiers.mod) return;
      flush();
      editor.patch({ modifiers });
      // What a press would do has changed, and the cursor says so.
      if (activity.kind === "none" && above !== null && editor.state.value.hover.kind !== "empty") tool().hover(sample({ ...above, modifiers }));
      if (activity.kind === "tool") activity.tool.drag(sampleAt(editor.state.value, activity.screen, activity.pointer, modifiers, activity.clicks));
    },
    space(held) {
      if (held === spaceHeld) return;
      spaceHeld = held;
      if (activity.kind === "none") editor.patch({ cursor: held ? "grab" : "default" });
    },
    cancel() {
      pending = null;
      if (activity.kind === "tool") {
        const { tool: worked } = activity;
        activity = { kind: "none" };
        worked.cancel();
        return true;
      }
      return tool().cancel();
    },
    finish() {
      return tool().finish();
    },
  };
}
