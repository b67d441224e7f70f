import type { EditorState } from "../../editor/editor.ts";

/** A part of a panel that follows the state. */
export interface Section {
  readonly element: HTMLElement;
  update(state: EditorState): void;
}

/** Keys are named to who may have some, and points where there are some. */
export function nothingSelected({ mode, curve, touch }: EditorState, point: string): string {
  if (mode === "curve" && curve.contours.length === 0) return "Nothing selected.";
  return `Nothing selected. ${touch ? `Tap ${point}.` : `Click ${point}, or press ] to step through them.`}`;
}

/** The panel of a mode that is loaded when it is first opened. */
export interface ModePanel {
  readonly element: HTMLElement;
  /** What a phone shows of it with the sheet down. */
  readonly peek?: HTMLElement;
  /** Beside the mode's name. */
  note(state: EditorState): string;
  update(state: EditorState): void;
}
