import type { Command } from "../document/curve/commands.ts";
import type {
  Contour, CurveDocument, DemoState, HandleRef, Mode, PointRef, Selection, View,
} from "../document/document.ts";
import type { FitDocument, FitMoment, Pair } from "../document/fit/fit.ts";
import type { TraceDocument, TraceMoment } from "../document/trace/trace.ts";
import type { NetRef, SurfaceDocument, SurfaceMoment } from "../document/surface/surface.ts";
import type { PagePoint, StageBox } from "./pointer/camera.ts";
import type { Grip } from "./curve/framing.ts";
import type { FitRun, FitView } from "./fit/fit-state.ts";
import type { ModeParts } from "./mode.ts";
import type { Readable } from "./signal.ts";
import type { SolidState } from "./surface/solid.ts";
import type { Timeline } from "./history/timeline.ts";
import type { Incoming, TraceProgress, TraceRun, TraceView } from "./trace/trace-state.ts";

export type ToolId = "select" | "pen" | "draw" | "hand";

export type OverlayId = "handles" | "polygon" | "knots" | "comb" | "subdivision" | "weights" | "fill" | "bezier" | "grid";

/** How the page shows and behaves; never part of the drawing, never in its history. */
export interface Settings {
  readonly overlays: Readonly<Record<OverlayId, boolean>>;
  /** 0.1 … 10 */
  readonly combScale: number;
  /** 0 … 8; 0 is off */
  readonly subdivisionSteps: number;
  readonly snap: boolean;
  /** 1 … 100 document units */
  readonly gridStep: number;
  readonly scrollPans: boolean;
  /** Single-key shortcuts (V, P, C …) can be switched off; those with Ctrl stay. */
  readonly singleKeys: boolean;
  /** Click a point, then click where it shall go: moving without dragging. */
  readonly moveByClicks: boolean;
  /** Once a pen has been seen, fingers only pan. */
  readonly penPans: boolean;
}

export interface Modifiers {
  readonly shift: boolean;
  readonly alt: boolean;
  /** Ctrl, or Cmd on macOS. */
  readonly mod: boolean;
}

/** A line that says what a drag snapped to. */
export interface Guide {
  readonly from: PagePoint;
  readonly to: PagePoint;
}

/** A rectangle in document units, corners in any order. */
export interface Marquee {
  readonly from: PagePoint;
  readonly to: PagePoint;
}

/** A segment that a click of the pen would make. */
export interface Rubber {
  readonly contour: Contour;
  /** The place that the pointer is at; for the closing preview, the first point. */
  readonly closing: boolean;
}

/** What tools draw on top while they work. */
export interface Sketch {
  readonly guides: readonly Guide[];
  readonly marquee: Marquee | null;
  readonly rubber: Rubber | null;
  /** What is being drawn by hand, and what was until its curve is there. */
  readonly stroke: readonly Pair[];
  /** Where letting go joins two ends. */
  readonly joint: PagePoint | null;
  /** The finger that drags, for the loupe. */
  readonly finger: PagePoint | null;
  /** What the drawing would become if the user agrees (going down a level that finer edits were made on). */
  readonly proposal: CurveDocument | null;
}

/** What a drag is doing, while it lasts. */
export interface DragReadout {
  readonly dx: number;
  readonly dy: number;
  /** What the pointer snapped to, in words. */
  readonly snapped: string | null;
  /** Says more than the two steps would: an angle, a percentage. */
  readonly says?: string;
}

/** What the pointer or the keyboard is over, for markers, cursors and the hint line. */
export type Target =
  | { readonly kind: "point"; readonly point: PointRef }
  | { readonly kind: "handle"; readonly handle: HandleRef }
  | { readonly kind: "curve"; readonly contour: number; readonly t: number; readonly x: number; readonly y: number }
  | { readonly kind: "grip"; readonly grip: Grip; readonly cursor: string; readonly hint: string }
  | { readonly kind: "empty" };

export type Engine =
  | { readonly status: "booting"; readonly progress: number | null }
  | { readonly status: "ready" }
  | { readonly status: "failed"; readonly reason: "blocked" | "unsupported" | "failed"; readonly detail: string };

export interface EditorState {
  readonly mode: Mode;
  readonly tool: ToolId;
  readonly view: View;
  readonly curve: CurveDocument;
  readonly fit: FitDocument;
  /** How Fit is looked at and worked with. */
  readonly fitView: FitView;
  /** What came of the last fit, and what is under way. */
  readonly fitRun: FitRun;
  readonly trace: TraceDocument;
  /** How Trace is looked at. */
  readonly traceView: TraceView;
  /** The picture, what came of the last trace, and what is under way. */
  readonly traceRun: TraceRun;
  /** How far the trace has come that is under way. Beside `traceRun`: who draws that need not draw it again for a percent. */
  readonly traceProgress: TraceProgress | null;
  /** How much is done of the fit that is under way, from 0 to 1. */
  readonly fitProgress: number;
  /** A picture that has just been brought in, until Trace takes it. */
  readonly incoming: Incoming | null;
  readonly surface: SurfaceDocument;
  /** The chosen points of the surface's net. */
  readonly chosen: readonly NetRef[];
  /** How the surface is looked at and shown. */
  readonly solid: SolidState;
  readonly selection: Selection;
  readonly hover: Target;
  readonly settings: Settings;
  readonly drag: DragReadout | null;
  readonly sketch: Sketch;
  readonly modifiers: Modifiers;
  /** Where the stage is in the window, CSS pixels. */
  readonly stage: StageBox;
  /** Says something particular in the hint line until the pointer or the selection moves on; empty: the ordinary hint. */
  readonly hint: string;
  /** The last thing that moved the selection was the keyboard: the focus ring shows. */
  readonly keyboard: boolean;
  /** Fingers work the stage: hints speak of them. */
  readonly touch: boolean;
  /** CSS cursor of the stage. */
  readonly cursor: string;
  /** Held O: only the original is shown. */
  readonly originalOnly: boolean;
  readonly engine: Engine;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** Name of the entry that Undo would take back. */
  readonly undoName: string | null;
  readonly redoName: string | null;
}

/** Something to tell the user: panels show toasts and errors, the live region says announcements. */
export type Notice =
  | { readonly kind: "toast"; readonly text: string; readonly actionId?: string }
  | { readonly kind: "error"; readonly id: string; readonly text: string }
  | { readonly kind: "announce"; readonly text: string }
  /** What was wrong is over, though there is nothing to say about it: an error that still shows goes. */
  | { readonly kind: "well" };

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

/** What may be set without the history knowing. */
export type EditorPatch = Partial<Omit<EditorState, "curve" | "surface" | "fit" | "trace" | "canUndo" | "canRedo" | "undoName" | "redoName">>;

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
  /** Applies the command to the state at `begin`, so that a drag can be re-evaluated from its start; `also` is set in the same step. */
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
