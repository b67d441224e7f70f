import type { Artboard } from "../../document/artboard.ts";
import { inPage, type Scene } from "../scene.ts";

/** Where a sheet ends. */
export function drawSheet(scene: Scene, { x, y, width, height }: Artboard): void {
  const context = inPage(scene);
  context.strokeStyle = scene.palette.line;
  context.lineWidth = 1 / scene.state.view.zoom;
  context.strokeRect(x, y, width, height);
}
