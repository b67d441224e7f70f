import { locate } from "../document/curve/contours.ts";
import { isEnd, pointAt, segmentCount, type Contour } from "../document/document.ts";
import { affectedSegments } from "../document/curve/roots.ts";
import { measureCurve } from "../kernel/curve/measure.ts";
import { isStraight } from "./curve/bending.ts";
import { describe } from "./curve/edits.ts";
import type { EditorState } from "./editor.ts";

/** The line under the stage: what the next press would do, in terms of what is under the pointer. */
export function hintFor(state: EditorState): string {
  if (state.mode !== "curve") return "";
  if (state.hint !== "") return state.hint;
  if (state.drag !== null) {
    const step = state.drag.says ?? `Δx ${fixed(state.drag.dx)}  Δy ${fixed(state.drag.dy)}`;
    const parts = [step, state.drag.snapped === null ? "" : `snapped ${state.drag.snapped}`, ellipseNote(state), localityNote(state)];
    return parts.filter((part) => part !== "").join("  ·  ");
  }
  switch (state.tool) {
    case "pen":
      return penHint(state);
    case "hand":
      return "Drag to pan. V goes back to editing.";
    case "draw":
      return "Drag to draw by hand: the line becomes a curve with few points, its corners kept.";
    case "select":
      return selectHint(state);
  }
}

/** The drag of a point of an ellipse leaves an ellipse, to the last digit; nobody believes it before they see it. */
function ellipseNote({ curve }: EditorState): string {
  if (curve.contours.length > 1) return "";
  const { modelError } = measureCurve(curve);
  return modelError !== undefined && modelError < 1e-9 ? "still an exact ellipse" : "";
}

/** Which part of an interpolating curve the drag of one point changes: the rest stays to the last bit. */
function localityNote({ curve, selection }: EditorState): string {
  const [ref] = selection.points;
  const contour = curve.contours[ref?.contour ?? -1];
  if (ref === undefined || contour === undefined || contour.family !== "interpolating" || selection.points.length > 1) return "";
  const list = affectedSegments(curve, contour, ref.index);
  const [first, last] = [list[0], list.at(-1)];
  return first === undefined || last === undefined ? "" : `affects segments ${first + 1}–${last + 1} of ${segmentCount(contour)}`;
}

function fixed(value: number): string {
  return value.toFixed(2);
}

function penHint(state: EditorState): string {
  if (state.sketch.rubber?.closing === true) return "Click to close the contour.";
  if (state.sketch.rubber !== null) {
    return `${state.touch ? "Tap" : "Click"} for a corner, drag for a smooth point. ${state.touch ? "A double tap finishes." : "Enter finishes, Esc drops the segment."}`;
  }
  return "Click to place the first point, or drag to pull its handles.";
}

function curveHint(contour: Contour | undefined, t: number): string {
  if (contour === undefined) return "";
  if (contour.family === "interpolating") return "Drag to move this segment. Double-click to insert a point; it says how far the curve moves.";
  const drag = isStraight(contour, locate(contour, t).segment)
    ? "Drag to move this line, Alt-drag to bend it."
    : "Drag to bend the curve, Alt-drag to move this segment.";
  return `${drag} Double-click to insert a point; the curve stays.`;
}

function selectHint(state: EditorState): string {
  const { hover, modifiers, curve } = state;
  switch (hover.kind) {
    case "point": {
      const kind = pointAt(curve, hover.point)?.kind;
      const name = describe(curve, hover.point);
      if (curve.contours[hover.point.contour]?.family === "interpolating") return `${name}: drag to move; only nearby segments follow`;
      if (modifiers.alt) return `${name}: drag pulls out fresh handles`;
      if (isEnd(curve, hover.point)) return `${name}: drag to move, onto another end to join them`;
      return `${name}: drag to move, double-click for ${kind === "cusp" ? "smooth" : "a cusp"}`;
    }
    case "handle": {
      const name = describe(curve, hover.handle, hover.handle.side);
      return modifiers.alt ? `${name}: drag breaks it into a cusp` : `${name}: drag to turn, Alt breaks, Shift keeps 15° steps`;
    }
    case "curve":
      return curveHint(curve.contours[hover.contour], hover.t);
    case "grip":
      return hover.hint;
    case "empty":
      if (curve.contours.length === 0) return "";
      if (curve.contours[state.selection.points[0]?.contour ?? 0]?.family === "interpolating") {
        return `Drag a point: only nearby segments follow. ${state.touch ? "Drag elsewhere to move the view, two fingers to zoom." : "Drag across empty space to select."}`;
      }
      if (state.touch) return "Drag a point or a handle. Drag elsewhere to move the view, two fingers to zoom.";
      return state.selection.points.length > 0 ? "Drag a point. Alt-drag a handle to make a cusp." : "Drag a point or a handle. Drag across empty space to select.";
  }
}
