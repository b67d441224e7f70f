import type { CurveDocument } from "../../document/document.ts";
import type { Pair } from "../../document/fit/fit.ts";
import { placesAlong } from "../../kernel/trace/as-strokes.ts";
import { byColor } from "../../kernel/trace/outcome.ts";
import type { Editor, EditorState } from "../editor.ts";
import { bringStrokes } from "../fit/fit-edits.ts";
import { openInCurve } from "../curve/open-in-curve.ts";
import { drawingOf } from "./trace-edits.ts";

/** From outlines to points that are fitted, and to a drawing that is edited: copies, both times. */

/** More points than this are a slow fit: long outlines are then sampled more sparsely. */
const mostPoints = 12_000;

/** The outlines for Export; null while there are none. */
export function tracedDrawing(state: EditorState): CurveDocument | null {
  return drawingOf(state);
}

/** The outlines by their colours, for a file of them. */
export function tracedLayers(state: EditorState): { readonly color: string; readonly drawing: CurveDocument }[] {
  const drawing = drawingOf(state);
  const { outcome } = state.traceRun;
  return drawing === null || outcome === null ? [] : byColor(outcome, drawing);
}

export function smoothInFit(editor: Editor): void {
  const drawing = drawingOf(editor.state.value);
  if (drawing === null) return;
  const strokes: Pair[][] = placesAlong(drawing, mostPoints);
  bringStrokes(editor, "Smooth the trace", strokes);
  const count = strokes.reduce((sum, stroke) => sum + stroke.length, 0);
  editor.notify({ kind: "toast", text: `The outlines are in Fit, ${count} points. The picture stays in Trace.` });
}

export function editTraceInCurve(editor: Editor): void {
  const drawing = drawingOf(editor.state.value);
  if (drawing === null) return;
  openInCurve(editor, "Edit the trace", drawing.contours, (count) => `The outlines are in Curve, ${count} points. The picture stays in Trace.`);
}
