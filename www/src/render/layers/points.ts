import { baseCount, isSelected, samePoint, type CurveDocument, type HandleRef, type PointRef } from "../../document/document.ts";
import { hasSide, shownHandles } from "../../editor/pointer/hit-test.ts";
import { drawHandleEnd, drawPoint, drawStart, drawVertex, type MarkerState } from "../markers.ts";
import { inScreen, onScreen, sightOf, type Scene } from "../scene.ts";
import type { SmallPoints } from "../small-points.ts";

/** Control points, the handles of the chosen ones, and where each contour begins. */

function isFocused({ state, focused }: Scene, ref: PointRef, side: HandleRef["side"] | null): boolean {
  const last = state.selection.points[state.selection.points.length - 1];
  if (!focused || !state.keyboard || last === undefined) return false;
  const { handle } = state.selection;
  if (handle === null) return side === null && samePoint(last, ref);
  return handle.side === side && samePoint(handle, ref);
}

export function drawHandles(scene: Scene): void {
  const { state, palette } = scene;
  if (state.originalOnly) return;
  const context = inScreen(scene);
  const handles = shownHandles(state);
  context.strokeStyle = palette.handle;
  context.lineWidth = 1;
  context.beginPath();
  for (const handle of handles) {
    const ends = stem(scene, handle);
    if (ends === null) continue;
    context.moveTo(ends.from.x, ends.from.y);
    context.lineTo(ends.to.x, ends.to.y);
  }
  context.stroke();
  for (const handle of handles) {
    const ends = stem(scene, handle);
    if (ends !== null) drawHandleEnd(context, ends.to, handleState(scene, handle), palette);
  }
}

function stem(scene: Scene, handle: HandleRef): { from: { x: number; y: number }; to: { x: number; y: number } } | null {
  const point = scene.state.curve.contours[handle.contour]?.points[handle.index];
  if (point === undefined) return null;
  const offset = point[handle.side];
  return { from: onScreen(scene, point), to: onScreen(scene, { x: point.x + offset.dx, y: point.y + offset.dy }) };
}

function handleState(scene: Scene, handle: HandleRef): MarkerState {
  const { hover, selection } = scene.state;
  const chosen = selection.handle;
  return {
    hovered: hover.kind === "handle" && hover.handle.side === handle.side && samePoint(hover.handle, handle),
    selected: chosen !== null && chosen.side === handle.side && samePoint(chosen, handle),
    focused: isFocused(scene, handle, handle.side),
  };
}

const mostLargePoints = 300;

/** Whether there are so many points that most of them are small ones. */
export function isCrowded({ contours }: CurveDocument): boolean {
  return contours.reduce((sum, contour) => sum + contour.points.length, 0) > mostLargePoints;
}

/** With the small ones, once they are there. */
export function drawPoints(scene: Scene, small: SmallPoints | undefined): void {
  const { state, palette } = scene;
  if (state.originalOnly) return;
  const context = inScreen(scene);
  const { hover, selection } = state;
  const { minX, minY, maxX, maxY } = sightOf(scene);
  const crowded = isCrowded(state.curve);
  // When a great many are chosen, large marks would hide the drawing.
  const few = selection.points.length <= mostLargePoints;
  state.curve.contours.forEach((contour, c) => {
    const first = contour.points[0];
    if (first !== undefined && contour.points.length > 1 && !crowded && contour.grid === undefined) {
      const direction = hasSide(state.curve, { contour: c, index: 0 }, "out") ? first.out : { dx: 0, dy: 0 };
      const second = contour.points[1] ?? first;
      const along = direction.dx === 0 && direction.dy === 0 ? { dx: second.x - first.x, dy: second.y - first.y } : direction;
      drawStart(context, onScreen(scene, first), along, palette);
    }
    contour.points.forEach((point, index) => {
      const { x, y } = point;
      if (x < minX || y < minY || x > maxX || y > maxY) return;
      const at = onScreen(scene, point);
      const ref = { contour: c, index };
      const marker = {
        hovered: hover.kind === "point" && samePoint(hover.point, ref),
        selected: isSelected(selection, ref),
        focused: isFocused(scene, ref, null),
      };
      if (crowded && !marker.hovered && !(marker.selected && few)) small?.add(at, point.kind, marker.selected);
      else if (contour.grid !== undefined || index >= baseCount(contour)) drawVertex(context, at, marker, palette);
      else drawPoint(context, at, point.kind, marker, palette);
    });
  });
  if (crowded) small?.draw(context, palette);
}
