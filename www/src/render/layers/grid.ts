import { toPage } from "../../editor/pointer/camera.ts";
import { gridOf } from "../../editor/pointer/snapping.ts";
import { inScreen, onScreen, type Scene } from "../scene.ts";

/** Dots at the grid's steps; the step doubles until dots are at least 12 px apart. */
export function drawGrid(scene: Scene): void {
  const { state, palette } = scene;
  let step = gridOf(state);
  if (step === null) return;
  const { view, stage } = state;
  while (step * view.zoom < 12) step *= 2;
  const context = inScreen(scene);
  const from = toPage(view, stage, { x: 0, y: 0 });
  const to = toPage(view, stage, { x: stage.width, y: stage.height });
  context.fillStyle = palette.line;
  context.globalAlpha = 0.55;
  for (let x = Math.ceil(from.x / step) * step; x <= to.x; x += step) {
    for (let y = Math.ceil(Math.min(from.y, to.y) / step) * step; y <= Math.max(from.y, to.y); y += step) {
      const at = onScreen(scene, { x, y });
      context.fillRect(Math.round(at.x) - 0.5, Math.round(at.y) - 0.5, 1, 1);
    }
  }
  context.globalAlpha = 1;
}
