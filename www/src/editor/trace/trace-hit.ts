import { toScreen, type ScreenPoint } from "../pointer/camera.ts";
import type { EditorState } from "../editor.ts";
import type { PointerKind } from "../pointer/hit-test.ts";
import { drawingOf } from "./trace-edits.ts";
import type { PointOfOutline } from "./trace-state.ts";

/** How far from a mark a press still counts, CSS pixels. */
const reach: Readonly<Record<PointerKind, number>> = { mouse: 10, pen: 12, touch: 22 };

/** Whether outlines and their points are on the stage. */
export function showsPoints({ traceView, originalOnly }: EditorState): boolean {
  return !originalOnly && (traceView.view === "result" || traceView.view === "outline");
}

/** The point of an outline nearest to a place of the stage, if one is within reach; of two as near, the corner. */
export function pointAt(state: EditorState, at: ScreenPoint, kind: PointerKind): PointOfOutline | null {
  if (!showsPoints(state)) return null;
  let best: PointOfOutline | null = null;
  let least = reach[kind];
  drawingOf(state)?.contours.forEach(({ points }, contour) => points.forEach((point, index) => {
    const { x, y } = toScreen(state.view, state.stage, point);
    const distance = Math.hypot(x - at.x, y - at.y) - (point.kind === "cusp" ? 1 : 0);
    if (distance < least) [best, least] = [{ contour, index }, distance];
  }));
  return best;
}
