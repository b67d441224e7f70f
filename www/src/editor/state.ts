import type { CurveDocument, HandleRef, Mode, PointRef, Selection, View } from "../document/document.ts";
import type { FitDocument } from "../document/fit/fit.ts";
import type { NetRef, SurfaceDocument } from "../document/surface/surface.ts";
import type { TraceDocument } from "../document/trace/trace.ts";
import type { FitRun, FitView } from "./fit/fit-state.ts";
import type { StageBox } from "./pointer/camera.ts";
import type { Sketch } from "./sketch.ts";
import type { SolidState } from "./surface/solid.ts";
import type { Incoming, TraceProgress, TraceRun, TraceView } from "./trace/trace-state.ts";

/** What the editor knows at one moment: documents, selections, how all of it is looked at. */

export type ToolId = "select" | "pen" | "draw" | "ellipse" | "rectangle" | "hand";

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

/** What a drag is doing, while it lasts. */
export interface DragReadout {
  readonly dx: number;
  readonly dy: number;
  /** What the pointer snapped to, in words. */
  readonly snapped: string | null;
  /** Says more than the two steps would: an angle, a percentage. */
  readonly says?: string;
}

/**
 * What a frame is taken hold of by: a corner, the middle of a side, what turns it, or what is in it; and what rounds a
 * corner of the drawing.
 */
export type Grip = "nw" | "n" | "ne" | "e" | "se" | "s" | "sw" | "w" | "turn" | "inside" | "corner";

/** What stretches it. */
export type StretchingGrip = Exclude<Grip, "turn" | "inside" | "corner">;

/** What the pointer or the keyboard is over, for markers, cursors and the hint line. */
export type Target =
  | { readonly kind: "point"; readonly point: PointRef }
  | { readonly kind: "handle"; readonly handle: HandleRef }
  | { readonly kind: "curve"; readonly contour: number; readonly t: number; readonly x: number; readonly y: number }
  | { readonly kind: "grip"; readonly grip: Grip; readonly cursor: string; readonly hint: string }
  | { readonly kind: "empty" };

export type Engine =
  | { readonly status: "booting" }
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
  /**
   * How far the trace has come that is under way. Beside `traceRun`: who draws that need not draw it again for a
   * percent.
   */
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
  /** The space bar is held: a press pans, and a shape that is being drawn moves. */
  readonly space: boolean;
  /** Where the stage is in the window, CSS pixels. */
  readonly stage: StageBox;
  /**
   * Says something particular in the hint line until the pointer or the selection moves on; empty: the ordinary hint.
   */
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

/** What may be set without the history knowing. */
export type EditorPatch = Partial<Omit<EditorState, "curve" | "surface" | "fit" | "trace" | "canUndo" | "canRedo" | "undoName" | "redoName">>;
