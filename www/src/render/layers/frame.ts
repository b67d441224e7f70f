import { frameOnScreen, gripsOf } from "../../editor/curve/framing.ts";
import { inScreen, type Scene } from "../scene.ts";

/**
 * The frame around contours that are chosen as a whole, with grips that stretch it and one that turns it. It steps
 * aside while something is dragged.
 */
export function drawFrame(scene: Scene): void {
  const { state, palette } = scene;
  const box = state.drag === null && !state.originalOnly ? frameOnScreen(state) : null;
  if (box === null) return;
  const context = inScreen(scene);
  const grips = gripsOf(state);
  const turn = grips.at(-1);
  context.strokeStyle = palette.focus;
  context.lineWidth = 1;
  context.strokeRect(Math.round(box.minX) + 0.5, Math.round(box.minY) + 0.5, Math.round(box.maxX - box.minX), Math.round(box.maxY - box.minY));
  if (turn !== undefined) {
    context.beginPath();
    context.moveTo(Math.round(turn.x) + 0.5, turn.y);
    context.lineTo(Math.round(turn.x) + 0.5, box.minY);
    context.stroke();
  }
  context.lineWidth = 1.5;
  for (const { grip, x, y } of grips) {
    const size = state.hover.kind === "grip" && state.hover.grip === grip ? 5.5 : 4;
    context.beginPath();
    if (grip === "turn") context.arc(x, y, size + 0.5, 0, 2 * Math.PI);
    else context.rect(x - size, y - size, 2 * size, 2 * size);
    context.fillStyle = palette.canvas;
    context.fill();
    context.stroke();
  }
}
