import type { Box } from "../../document/imported.ts";

/** Browsers refuse or blank canvases beyond these. */
const mostSide = 16_384;
const mostPixels = 16_777_216;
export const margin = 16;

/** The size in pixels that a picture of the drawing would have, or null when it is larger than browsers can draw. */
export function pngSize(box: Box | null, scale: number): { width: number; height: number } | null {
  if (box === null) return null;
  const width = Math.ceil(scale * (box.maxX - box.minX + 2 * margin));
  const height = Math.ceil(scale * (box.maxY - box.minY + 2 * margin));
  return width <= mostSide && height <= mostSide && width * height <= mostPixels ? { width, height } : null;
}
