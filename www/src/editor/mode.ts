import type { CurveDocument } from "../document/document.ts";
import type { TraceDocument } from "../document/trace/trace.ts";
import type { ScreenPoint } from "./pointer/camera.ts";
import type { EditorState } from "./state.ts";
import type { Pinch } from "./pointer/pinch.ts";
import type { Tool } from "./tool.ts";

/** How a mode that is not drawn on the plane is looked at. */
export interface ModeView {
  /** Moves with the hand, by CSS pixels. */
  pan(dx: number, dy: number): void;
  /** Closer by a factor; what is at `at` stays there as well as it can. */
  zoom(factor: number, at: ScreenPoint | null): void;
  zoomTo(zoom: number): void;
  fit(): void;
  /** 1 is the size at which everything fits. */
  readonly zoomNow: number;
  pinch(a: ScreenPoint, b: ScreenPoint): Pinch;
}

/** What a mode brings of its own; what it does not bring is the plane's. */
export interface ModeParts {
  /** What the stage is, for those who do not see it. */
  readonly label: string;
  /** Works the pointer in place of the rail's tools. */
  readonly tool: Tool;
  readonly view?: ModeView;
  /** The line under the stage. */
  hint?(state: EditorState): string;
  /** What the plane is to show when all of it is to be seen. */
  box?(state: EditorState): { readonly minX: number; readonly minY: number; readonly maxX: number; readonly maxY: number } | null;
  /** What Export writes, in place of Curve's drawing; null while there is nothing. */
  drawing?(state: EditorState): CurveDocument | null;
  /** The same in colours, the lowest layer first; none where it has none. */
  layers?(state: EditorState): readonly { readonly color: string; readonly drawing: CurveDocument }[];
  /** The program that makes what is on the stage. */
  program?(state: EditorState): string;
  /** The sample that is shown as it was opened; null once it was worked on. */
  sample?(state: EditorState): string | null;
  /** Its document as it is saved and shared, where that is not the document itself. */
  saved?(state: EditorState): TraceDocument;
  /** The picture in words, for those who do not see it. */
  summary?(state: EditorState): string;
  /** What arrows would move, and where it is; nothing where nothing is chosen. */
  chosen?(state: EditorState): string;
}
