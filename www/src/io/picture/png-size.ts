import type { Box } from "../../document/imported.ts";

/** Browsers refuse or blank canvases beyond these. */
const mostSide = 16_384;
const mostPixels = 16_777_216;
const margin = 16;
/** An icon of 24 units would be a thumbnail, and its lines as thick as itself: it is drawn as if it were as large as this. */
const leastSize = 256;

/** Times as large as it is that a drawing is drawn in a file: 1 but for small ones. */
export function enlargement(box: Box): number {
  const size = Math.max(box.maxX - box.minX, box.maxY - box.minY);
  return size > 0 ? Math.max(1, leastSize / size) : 1;
}

/** What is left free around the drawing, in its own units. */
export function marginAround(box: Box): number {
  return margin / enlargement(box);
}

/** The size in pixels that a picture of the drawing would have, or null when it is larger than browsers can draw. */
export function pngSize(box: Box | null, scale: number): { width: number; height: number } | null {
  if (box === null) return null;
  const pixels = (length: number): number => Math.ceil(scale * (enlargement(box) * length + 2 * margin));
  const [width, height] = [pixels(box.maxX - box.minX), pixels(box.maxY - box.minY)];
  return width <= mostSide && height <= mostSide && width * height <= mostPixels ? { width, height } : null;
}
