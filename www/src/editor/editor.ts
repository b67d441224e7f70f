import type { Command } from "../document/curve/commands.ts";
import type { CurveDocument, DemoState, Mode } from "../document/document.ts";
import type { FitMoment } from "../document/fit/fit.ts";
import type { SurfaceMoment } from "../document/surface/surface.ts";
import type { TraceMoment } from "../document/trace/trace.ts";
import type { Timeline } from "./history/timeline.ts";
import type { ModeParts } from "./mode.ts";
import type { Readable } from "./signal.ts";
import type { EditorPatch, EditorState, OverlayId, Settings } from "./state.ts";

export type * from "./sketch.ts";
export type * from "./state.ts";

/** Something to tell the user: panels show toasts and errors, the live region says announcements. */
export type Notice =
  | { readonly kind: "toast"; readonly text: string; readonly actionId?: string }
  | { readonly kind: "error"; readonly id: string; readonly text: string }
  | { readonly kind: "announce"; readonly text: string }
  /**
   * What was wrong is over, though there is nothing to say about it: an error that still shows goes, if it is `of` this
   * kind.
   */
  | { readonly kind: "well"; readonly of?: string };

/** One definition serves toolbar, menu, keys and help. */
export interface Action {
  readonly id: string;
  /** "Delete and heal" */
  readonly label: string;
  readonly group: "Edit" | "View" | "Tools" | "Points" | "Curve" | "Fit" | "Trace" | "Surface" | "File" | "Modes" | "Help";
  /** As in "Mod+Shift+Z", "]", "Shift+Delete"; Mod is Ctrl, or Cmd on macOS. The first one is printed. */
  readonly keys: readonly string[];
  /** False keeps the key out of effect and greys the button. */
  enabled?(state: EditorState): boolean;
  /** Works in the middle of a drag and leaves it going. */
  readonly live?: boolean;
  /** For toggles. */
  checked?(state: EditorState): boolean;
  run(editor: Editor): void;
  /** For keys that act while held (O, Space): called on release. */
  release?(editor: Editor): void;
}

export interface ActionRegistry {
  register(action: Action): void;
  get(id: string): Action | undefined;
  all(): readonly Action[];
  /** Runs it if it is enabled; says whether it did. */
  run(id: string): boolean;
}

export interface Editor {
  readonly state: Readable<EditorState>;
  /** The last notice; each call of notify is a new value. */
  readonly notices: Readable<Notice | null>;
  readonly actions: ActionRegistry;
  /** What modes bring of their own, once they are there. */
  readonly modes: Map<Mode, ModeParts>;
  /** What is being loaded just now. */
  readonly loading: Set<Promise<unknown>>;

  /** Applies a command: one entry in the history, or part of the gesture that is open. */
  dispatch(command: Command): void;
  /** Opens a gesture (a slider drag, a point drag): everything until `commit` is one entry. */
  begin(name: string): void;
  /**
   * Applies the command to the state at `begin`, so that a drag can be re-evaluated from its start; `also` is set in
   * the same step.
   */
  preview(command: Command, also?: EditorPatch): void;
  commit(): void;
  /** Back to the state at `begin`; no entry. */
  bail(): void;
  readonly inGesture: boolean;
  /** Undo and redo of the mode that is shown: each has a history of its own. */
  undo(): void;
  redo(): void;
  /** Changes of the surface. */
  readonly surfaceEdits: Timeline<SurfaceMoment>;
  /** The same for the points that are fitted. */
  readonly fitEdits: Timeline<FitMoment>;
  /** The same for the picture that is traced. */
  readonly traceEdits: Timeline<TraceMoment>;

  /** Replaces parts of the state that are outside the history (view, selection, settings, hover, hint …). */
  patch(change: EditorPatch): void;
  setSettings(change: Partial<Settings>): void;
  setOverlay(overlay: OverlayId, on: boolean): void;
  notify(notice: Notice): void;
  /** What the curve was when the open gesture began, for ghosts; the curve itself outside gestures. */
  readonly origin: CurveDocument;

  /** Plain JSON of everything worth saving. */
  getState(): DemoState;
  /** Replaces everything; one undoable entry, or (with `fresh`) a new history. */
  setState(state: DemoState, options?: { fresh?: boolean }): void;
}
