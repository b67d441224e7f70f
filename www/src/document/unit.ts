import type { Box } from "./artboard.ts";

/**
 * The step that suits what is in a box: 1, and of what is smaller than ten units the power of ten that is a tenth to a
 * hundredth of it.
 */
export function unitIn(box: Box | null): number {
  const size = box === null ? 0 : Math.max(box.maxX - box.minX, box.maxY - box.minY);
  return size > 0 && size < 10 ? Number(`1e${Math.max(-9, Math.floor(Math.log10(size)) - 1)}`) : 1;
}

/** Of a drawing with this unit, the decimals that are as many in its own size as so many are in others. */
export function decimalsIn(unit: number, decimals: number): number {
  return Math.max(0, decimals - Math.round(Math.log10(unit)));
}
