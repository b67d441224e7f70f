import type { Scene } from "../scene.ts";
import { drawCornerGrips } from "./corner-grips.ts";
import { drawFrame } from "./frame.ts";

/** All grips of what is chosen. */
export function drawGrips(scene: Scene): void {
  drawFrame(scene);
  drawCornerGrips(scene);
}
