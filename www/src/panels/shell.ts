import type { Mode } from "../document/document.ts";
import type { Editor } from "../editor/editor.ts";
import type { Frame } from "../editor/frame.ts";
import type { PageIo } from "./page-io.ts";

export interface Regions {
  readonly header: HTMLElement;
  readonly rail: HTMLElement;
  readonly panel: HTMLElement;
  readonly status: HTMLElement;
  readonly stage: HTMLElement;
}

/** Short messages over the stage. */
export interface Offer {
  readonly label: string;
  readonly lasting?: boolean;
  run(): void;
}

export interface Toasts {
  /**
   * With an action: a button that does it and takes the toast away. The offer goes with the next step unless it is
   * `lasting`.
   */
  say(text: string, action?: Offer): void;
  /** An offer made in it is the way out. */
  error(id: string, text: string, action?: Offer): void;
}

/** What every panel is handed. */
export interface Shell {
  readonly editor: Editor;
  readonly regions: Regions;
  readonly io: PageIo;
  readonly toasts: Toasts;
  readonly until: AbortSignal;
  readonly frame: Frame;
  /** The gallery of a mode that has samples of its own: one card each, which calls `done` before it opens. */
  readonly samples: Map<Mode, (done: () => void) => readonly HTMLElement[]>;
}

/** A task that runs in the next frame after `request`, once however often it was asked for. */
export function inNextFrame(frame: Frame, task: () => void): { request(): void } {
  let wanted = false;
  frame.add("paint", () => {
    if (!wanted) return;
    wanted = false;
    task();
  });
  return {
    request() {
      wanted = true;
      frame.request();
    },
  };
}

/** The keys of an action as they are printed on this machine: ⌘⇧Z, Ctrl+Shift+Z. */
export function printedKey(chord: string): string {
  const mac = /Mac|iPhone|iPad/u.test(navigator.platform);
  const names: Readonly<Record<string, string>> = mac
    ? { Mod: "⌘", Shift: "⇧", Alt: "⌥", ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓", " ": "Space" }
    : { Mod: "Ctrl", ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓", " ": "Space" };
  const parts = chord === "+" ? ["+"] : chord.split("+").map((part) => names[part] ?? part);
  return parts.join(mac ? "" : "+");
}

/** A tooltip: what it does, and its key. */
export function withKey(editor: Editor, label: string, actionId: string): string {
  const key = editor.actions.get(actionId)?.keys[0];
  return key === undefined ? label : `${label} (${printedKey(key)})`;
}
