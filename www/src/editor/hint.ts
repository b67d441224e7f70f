import { locate } from "../document/curve/contours.ts";
import { isEnd, pointAt, segmentCount } from "../document/document.ts";
import { affectedSegments } from "../document/curve/roots.ts";
import { isStraight } from "../document/curve/straight.ts";
import { measureCurve } from "../kernel/curve/measuring/measure.ts";
import { decimalsIn } from "../document/unit.ts";
import { unitOf } from "../kernel/unit.ts";
import { describe } from "./curve/edits.ts";
import type { EditorState } from "./editor.ts";

/** The line under the stage: what the next press would do, in terms of what is under the pointer. */
export function hintFor(state: EditorState): string {
  if (state.mode !== "curve") return "";
  if (state.hint !== "") return state.hint;
  if (state.drag !== null) {
    const along = (step: number): string => step.toFixed(decimalsIn(unitOf(state.curve), 2));
    const step = state.drag.says ?? `Δx ${along(state.drag.dx)}  Δy ${along(state.drag.dy)}`;
    const parts = [step, state.drag.snapped === null ? "" : `snapped ${state.drag.snapped}`, ellipseNote(state), localityNote(state)];
    return parts.filter((part) => part !== "").join("  ·  ");
  }
  switch (state.tool) {
    case "pen":
      return penHint(state);
    case "hand":
      return "Drag to pan. Press V to edit again.";
    case "draw":
      return "Drag to draw freehand. Your stroke becomes a curve with few points and sharp corners.";
    case "select":
      return selectHint(state);
    default:
      // Shapes bring their own.
      return "";
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

function penHint(state: EditorState): string {
  const press = state.touch ? "Tap" : "Click";
  if (state.sketch.rubber?.closing === true) return `${press} to close the contour.`;
  if (state.sketch.joint !== null) return `${press} to ${state.sketch.rubber === null ? "continue" : "join"} this path.`;
  if (state.sketch.rubber !== null) {
    return `${press} for a corner, drag for a smooth point. ${state.touch ? "A double tap finishes." : "Enter finishes, Esc cancels the segment."}`;
  }
  return `${press} to place the first point, or drag to pull its handles.`;
}

/** A second press at the same place, as whoever has no mouse calls it; fingers have no Alt either. */
function twice(touch: boolean): string {
  return touch ? "Double-tap" : "Double-click";
}

function curveHint({ curve, touch }: EditorState, index: number, t: number): string {
  const contour = curve.contours[index];
  if (contour === undefined) return "";
  if (contour.family === "interpolating") return `Drag to move this segment. ${twice(touch)} to insert a point; you see how far the curve moves.`;
  const [drag, alt] = isStraight(contour, locate(contour, t).segment)
    ? ["Drag to move this line", "Alt-drag to bend it"]
    : ["Drag to bend the curve", "Alt-drag to move this segment"];
  return `${touch ? drag : `${drag}, ${alt}`}. ${twice(touch)} to insert a point without changing the curve.`;
}

function selectHint(state: EditorState): string {
  const { hover, modifiers, curve, touch } = state;
  switch (hover.kind) {
    case "point": {
      const kind = pointAt(curve, hover.point)?.kind;
      const name = describe(curve, hover.point);
      if (curve.contours[hover.point.contour]?.family === "interpolating") return `${name}: drag to move; only nearby segments change`;
      if (modifiers.alt) return `${name}: drag to pull out new handles`;
      if (isEnd(curve, hover.point)) return `${name}: drag to move, or onto another end to join`;
      return `${name}: drag to move, ${twice(touch).toLowerCase()} for ${kind === "cusp" ? "smooth" : "a cusp"}`;
    }
    case "handle": {
      const name = describe(curve, hover.handle, hover.handle.side);
      if (modifiers.alt) return `${name}: drag to break it into a cusp`;
      return touch ? `${name}: drag to turn` : `${name}: drag to turn, Alt to break, Shift for 15° steps`;
    }
    case "curve":
      return curveHint(state, hover.contour, hover.t);
    case "grip":
      return hover.hint;
    case "empty":
      if (curve.contours.length === 0) return "";
      if (state.settings.moveByClicks && state.selection.points.length > 0) return `${touch ? "Tap" : "Click"} where it should go.`;
      if (curve.contours[state.selection.points[0]?.contour ?? 0]?.family === "interpolating") {
        return `Drag a point: only nearby segments change. ${touch ? "Drag elsewhere to move the view, two fingers to zoom." : "Drag across empty space to select."}`;
      }
      if (touch) return `${state.selection.points.length > 1 ? "Drag inside a selected shape to move it" : "Drag a point or a handle"}. Drag elsewhere to move the view, two fingers to zoom.`;
      switch (state.selection.points.length) {
        case 0:
          return "Drag a point or a handle, or across points to select them. Double-click inside a shape for all of it.";
        case 1:
          return "Alt-drag a handle to make a cusp. Press E to select the whole contour.";
        default:
          return "Drag a selected point to move them all. Shift-click to add or remove points.";
      }
  }
}
