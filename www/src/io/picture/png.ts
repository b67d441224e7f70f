import type { Box } from "../../document/imported.ts";
import { margin, pngSize } from "./png-size.ts";

export interface PngOptions {
  readonly d: string;
  readonly box: Box | null;
  readonly scale: number;
  /** Colour under the drawing; null leaves it transparent. */
  readonly paper: string | null;
  readonly ink: string;
  readonly fill: string;
}

export async function writePng(options: PngOptions): Promise<Blob | null> {
  const size = pngSize(options.box, options.scale);
  if (size === null || options.box === null) return null;
  const canvas = document.createElement("canvas");
  canvas.width = size.width;
  canvas.height = size.height;
  const context = canvas.getContext("2d");
  if (context === null) return null;
  if (options.paper !== null) {
    context.fillStyle = options.paper;
    context.fillRect(0, 0, size.width, size.height);
  }
  context.setTransform(options.scale, 0, 0, options.scale, options.scale * (margin - options.box.minX), options.scale * (margin - options.box.minY));
  const path = new Path2D(options.d);
  context.globalAlpha = 0.08;
  context.fillStyle = options.fill;
  context.fill(path, "evenodd");
  context.globalAlpha = 1;
  context.strokeStyle = options.ink;
  context.lineWidth = 2;
  context.lineJoin = "round";
  context.stroke(path);
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}
