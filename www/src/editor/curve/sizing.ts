import { stretching, transformPoints } from "../../document/curve/affine.ts";
import { movePoints } from "../../document/curve/commands.ts";
import { pointAt } from "../../document/document.ts";
import type { Bounds } from "../../kernel/curve/samples.ts";
import type { Editor, EditorState } from "../editor.ts";
import { frameOf } from "./framing.ts";

/** Where several selected points are, and how large what they make is, in numbers. */

export type Measure = "x" | "y" | "width" | "height";

/** The exact box of whole contours, as the frame around them has it; else that of the points. */
function boxOf(state: EditorState): Bounds | null {
  const frame = frameOf({ ...state, tool: "select" });
  if (frame !== null || state.selection.points.length < 2) return frame;
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  // No list in between: there may be a hundred thousand points, and this is asked at every frame of a drag.
  for (const ref of state.selection.points) {
    const point = pointAt(state.curve, ref);
    if (point === undefined) continue;
    [minX, minY] = [Math.min(minX, point.x), Math.min(minY, point.y)];
    [maxX, maxY] = [Math.max(maxX, point.x), Math.max(maxY, point.y)];
  }
  return minX > maxX ? null : { minX, minY, maxX, maxY };
}

/** What of a drawing is flatter than this has no width that a factor could change. */
const flat = 1e-9;

/** Left, top, width and height; null for a size that cannot be changed, as points in a column have no width. */
export function measuresOf(state: EditorState): Readonly<Record<Measure, number | null>> {
  const box = boxOf(state);
  if (box === null) return { x: null, y: null, width: null, height: null };
  const size = (length: number): number | null => (length > flat ? length : null);
  return { x: box.minX, y: box.minY, width: size(box.maxX - box.minX), height: size(box.maxY - box.minY) };
}

/**
 * Moves the selection so that it begins there, or scales it from its left and top to that size. A run of typed steps is
 * one entry.
 */
export function setMeasure(editor: Editor, measure: Measure, value: number): void {
  const { selection } = editor.state.value;
  const now = measuresOf(editor.state.value);
  const [x, y, old] = [now.x, now.y, now[measure]];
  if (x === null || y === null || old === null) return;
  const run = `${measure} ${JSON.stringify(selection.points)}`;
  if (measure === "x" || measure === "y") {
    const [dx, dy] = measure === "x" ? [value - old, 0] : [0, value - old];
    editor.dispatch(movePoints({ ...selection, handle: null }, dx, dy, run));
  } else {
    const factor = value / old;
    const map = stretching({ x, y }, measure === "width" ? factor : 1, measure === "height" ? factor : 1);
    editor.dispatch(transformPoints("Stretch", selection, map, run));
  }
}
