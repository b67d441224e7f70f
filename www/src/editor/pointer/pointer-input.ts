import type { Editor, Modifiers, ToolId } from "../editor.ts";
import type { ModeParts } from "../mode.ts";
import { sampleAt, type Tool } from "../tool.ts";
import { pan, pressTool, type Panning, type ToolPress } from "./activity.ts";
import type { ScreenPoint } from "./camera.ts";
import { createDoublePress } from "./double-press.ts";
import type { PointerRecord } from "./pointer-record.ts";
import { pinchOrTap, type TwoFingers } from "./two-fingers.ts";

/**
 * Pointers to tools. It knows no DOM: events come in as plain records, so that the headless tests press the same keys
 * and move the same pointers as a hand. One pointer works the tool; two fingers pinch; space, the middle button and the
 * hand tool pan.
 */
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

const secondFingerMs = 150;
/** More places in one frame than any device reports. */
const mostTrail = 4096;

export function createPointerInput(editor: Editor, tools: Readonly<Record<ToolId, Tool>>): PointerInput {
  return new Pointers(editor, tools);
}

class Pointers implements PointerInput {
  readonly #editor: Editor;
  readonly #tools: Readonly<Record<ToolId, Tool>>;
  readonly #fingers = new Map<number, ScreenPoint>();
  readonly #presses = createDoublePress();
  #activity: ToolPress | Panning | TwoFingers | null = null;
  /** The last move that was not worked off, and every place of its pointer since the last that was. */
  #pending: PointerRecord | null = null;
  #trail: ScreenPoint[] = [];
  /** Where a pointer is that is not pressed. */
  #above: PointerRecord | null = null;
  #penSeen = false;

  constructor(editor: Editor, tools: Readonly<Record<ToolId, Tool>>) {
    this.#editor = editor;
    this.#tools = tools;
  }

  get busy(): boolean {
    return this.#activity !== null;
  }

  down(record: PointerRecord): void {
    this.flush();
    if (record.kind === "pen") this.#penSeen = true;
    if (record.kind === "touch") {
      this.#fingers.set(record.id, record.screen);
      if (this.#anotherFinger(record)) return;
    }
    if (this.#activity !== null || !this.#answers(record)) return;
    const { hint } = this.#editor.state.value;
    this.#editor.patch({ keyboard: false, touch: record.kind === "touch", modifiers: record.modifiers, ...(hint === "" ? {} : { hint: "" }) });
    if (this.#pansWith(record)) {
      this.#activity = pan(this.#editor, () => this.#own(), record, () => this.#restCursor());
      this.#editor.patch({ cursor: "grabbing" });
      return;
    }
    const tool = this.#tool();
    const clicks = this.#presses.clicks(record);
    this.#activity = pressTool(this.#editor, tool, record, clicks);
    tool.press(sampleAt(this.#editor.state.value, record.screen, record.kind, record.modifiers, clicks));
  }

  move(record: PointerRecord): void {
    // Two fingers report in turn: the place of each counts.
    if (this.#fingers.has(record.id)) this.#fingers.set(record.id, record.screen);
    if (this.#pending !== null && this.#pending.id !== record.id) this.#trail = [];
    this.#pending = record;
    if (this.#activity?.kind === "tool" && this.#trail.length < mostTrail) this.#trail.push(record.screen);
  }

  flush(): void {
    const [record, trail] = [this.#pending, this.#trail];
    if (record === null) return;
    this.#pending = null;
    this.#trail = [];
    if (this.#activity === null) {
      this.#above = record.kind === "touch" ? null : record;
      this.#hover(record.modifiers);
      return;
    }
    if (this.#activity.kind === "tool" && this.#activity.endsWith(record.id)) this.#presses.dragged(record.screen);
    this.#activity.moved(record, trail);
  }

  up(record: PointerRecord): void {
    this.flush();
    this.#fingers.delete(record.id);
    this.#ended(record.id)?.released(record);
  }

  lost(id: number): void {
    this.#fingers.delete(id);
    if (this.#pending?.id === id) this.#pending = null;
    this.#ended(id)?.cancelled();
  }

  modifiers(modifiers: Modifiers): void {
    const { modifiers: old, hover } = this.#editor.state.value;
    if (old.shift === modifiers.shift && old.alt === modifiers.alt && old.mod === modifiers.mod) return;
    this.flush();
    this.#editor.patch({ modifiers });
    // What a press would do has changed, and the cursor says so.
    if (this.#activity === null && hover.kind !== "empty") this.#hover(modifiers);
    if (this.#activity?.kind === "tool") this.#activity.modified(modifiers);
  }

  space(held: boolean): void {
    if (held === this.#editor.state.value.space) return;
    this.flush();
    this.#editor.patch({ space: held });
    if (this.#activity === null) this.#restCursor();
  }

  cancel(): boolean {
    this.#pending = null;
    if (this.#activity?.kind !== "tool") return this.#tool().cancel();
    const pressed = this.#activity;
    this.#activity = null;
    pressed.cancelled();
    return true;
  }

  finish(): boolean {
    return this.#tool().finish();
  }

  /** The parts of the mode that is up, where it brings its own. */
  #own(): ModeParts | undefined {
    return this.#editor.modes.get(this.#editor.state.value.mode);
  }

  #tool(): Tool {
    return this.#own()?.tool ?? this.#tools[this.#editor.state.value.tool];
  }

  #hover(modifiers: Modifiers): void {
    if (this.#above !== null) this.#tool().hover(sampleAt(this.#editor.state.value, this.#above.screen, this.#above.kind, modifiers));
  }

  /** Only a mode with a view of its own has the right button free, to pan with. */
  #answers({ button }: PointerRecord): boolean {
    const own = this.#own();
    return (this.#editor.state.value.mode === "curve" || own !== undefined) && (button !== 2 || own?.view !== undefined);
  }

  #pansWith({ button, kind }: PointerRecord): boolean {
    if (button === 1 || this.#editor.state.value.space) return true;
    if (this.#own()?.view !== undefined) return button === 2;
    const { tool, settings } = this.#editor.state.value;
    return tool === "hand" || (kind === "touch" && this.#penSeen && settings.penPans);
  }

  /** Whether a finger that came down belongs to others that are down already. */
  #anotherFinger({ time }: PointerRecord): boolean {
    if (this.#fingers.size < 2) return false;
    if (this.#activity?.kind === "tool") {
      // A finger that comes late touches by accident; one that comes at once means two from the start.
      if (time - this.#activity.since > secondFingerMs && this.#editor.inGesture) return true;
      this.#activity.cancelled();
      this.#presses.forget();
    }
    if (this.#activity?.kind === "pinch") this.#activity.joined();
    else this.#activity = pinchOrTap(this.#editor, this.#own(), this.#fingers, time);
    return true;
  }

  /** What is over with this pointer; it is no longer going on when it hears of it. */
  #ended(id: number): ToolPress | Panning | TwoFingers | null {
    const activity = this.#activity;
    if (activity?.endsWith(id) !== true) return null;
    this.#activity = null;
    return activity;
  }

  #restCursor(): void {
    const { space, tool } = this.#editor.state.value;
    this.#editor.patch({ cursor: space || tool === "hand" ? "grab" : "default" });
  }
}
