import type { CurveDocument } from "../../document/document.ts";
import { toleranceOf } from "../../document/trace/trace.ts";
import { mostPlaces, placesAlong } from "../../kernel/fit/as-strokes.ts";
import { byColor, inkedContours } from "../../kernel/trace/outcome.ts";
import type { Editor, EditorState } from "../editor.ts";
import { bringStrokes, handOver } from "../fit/bring.ts";
import { openInCurve } from "../curve/open-in-curve.ts";
import { shownOf, sizeOf } from "./trace-edits.ts";

/** From outlines to points that are fitted, and to a drawing that is edited: copies, both times. */

/** Pixels of the picture from one point to the next, where there is room for so many. */
const apart = 2;

/** The outlines for Export; null while there are none. */
export function tracedDrawing(state: EditorState): CurveDocument | null {
  const [shown, size] = [shownOf(state), sizeOf(state)];
  if (shown === null) return null;
  // A file of the outlines takes the place of the picture: it is as large, and they are where they were.
  const artboard = size === null ? {} : { artboard: { x: 0, y: 0, width: size.width, height: size.height } };
  // Colours lie over each other, and their layers are filled by winding number.
  if (shown.colors.length > 0) return { ...shown.drawing, ...artboard, filling: "nonzero" };
  // A stroke that closes encloses paper, not ink.
  return { ...shown.drawing, ...artboard, ...(state.trace.settings.mode === "lines" ? { filling: "none" } : {}) };
}

/** The outlines by their colours, for a file of them. */
export function tracedLayers(state: EditorState): { readonly color: string; readonly drawing: CurveDocument }[] {
  const shown = shownOf(state);
  return shown === null ? [] : byColor(shown);
}

export function smoothInFit(editor: Editor): void {
  const { trace, traceRun } = editor.state.value;
  const [shown, drawing] = [shownOf(editor.state.value), tracedDrawing(editor.state.value)];
  if (shown === null || drawing === null) return;
  const strokes = placesAlong(drawing, inkedContours(shown), apart, mostPlaces);
  // Smoother than the trace, by as much again as Detail gave away when it was made.
  const { settings } = traceRun.of ?? trace;
  const within = Number((2 * toleranceOf(settings.detail)).toPrecision(2));
  const count = strokes.reduce((sum, { places }) => sum + places.length, 0);
  handOver(editor, `Copied the outlines to Fit, ${count} points. The picture stays in Trace.`, () =>
    bringStrokes(editor, { name: "Smooth the trace", strokes, within, instead: "all", setting: drawing }));
}

export function editTraceInCurve(editor: Editor): void {
  const [shown, drawing] = [shownOf(editor.state.value), tracedDrawing(editor.state.value)];
  if (shown === null || drawing === null) return;
  openInCurve(editor, "Edit the trace", { ...drawing, contours: inkedContours(shown) }, (count) => `Copied the outlines to Curve, ${count} points. The picture stays in Trace.`);
}
