import { cornerGrips } from "../../editor/curve/corners/grips.ts";
import { inScreen, type Scene } from "../scene.ts";

/** The grips that round the chosen corners; they step aside while something is dragged. */
export function drawCornerGrips(scene: Scene): void {
  const { state, palette } = scene;
  if (state.drag !== null || state.originalOnly) return;
  const context = inScreen(scene);
  context.strokeStyle = palette.focus;
  context.fillStyle = palette.canvas;
  // All of them follow the one that is dragged.
  const size = state.hover.kind === "grip" && state.hover.grip === "corner" ? 6.5 : 5;
  for (const { screen: { x, y } } of cornerGrips(state)) {
    context.lineWidth = 1.5;
    context.beginPath();
    context.arc(x, y, size, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
    // A dot in its middle: it is no handle and no grip of the frame.
    context.beginPath();
    context.arc(x, y, 1.75, 0, 2 * Math.PI);
    context.fillStyle = palette.focus;
    context.fill();
    context.fillStyle = palette.canvas;
  }
}
