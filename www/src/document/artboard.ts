/**
 * The sheet that a drawing lies on: what an SVG file calls its viewBox. Without one, a drawing's sheet is its own box.
 */
export interface Artboard {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface Box {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/**
 * How the closed contours are filled, where that is not even-odd, by which holes are holes whichever way they run: by
 * the winding number, as most SVG files are, or not at all.
 */
export type Filling = "nonzero" | "none";

/** What a drawing is besides its contours, which another mode hands back with what it made of them. */
export interface Setting {
  readonly filling?: Filling;
  readonly artboard?: Artboard;
}

/** Nothing else of a drawing. */
export function settingOf({ filling, artboard }: Setting): Setting {
  return { ...(filling === undefined ? {} : { filling }), ...(artboard === undefined ? {} : { artboard }) };
}

const [farthest, least] = [1e9, 1e-6];

/** Null where it is none that a file of ours may have. */
export function artboardOf(box: { readonly left: number; readonly top: number; readonly right: number; readonly bottom: number }): Artboard | null {
  const { left: x, top: y } = box;
  const [width, height] = [box.right - x, box.bottom - y];
  const isGood = [x, y, box.right, box.bottom].every((value) => Math.abs(value) <= farthest) && width >= least && height >= least;
  return isGood ? { x: x + 0, y: y + 0, width, height } : null;
}

/**
 * So much of its size may a drawing reach over its artboard, as rounded ones do, before the sheet grows: nothing that
 * can be seen.
 */
const slack = 1e-3;

/** The artboard, and beyond it on every side as far as the drawing reaches out of it. */
export function sheetOf({ x, y, width, height }: Artboard, box: Box | null): Box {
  const board = { minX: x, minY: y, maxX: x + width, maxY: y + height };
  if (box === null) return board;
  const over = slack * Math.max(width, height);
  return {
    minX: box.minX < board.minX - over ? box.minX : board.minX,
    minY: box.minY < board.minY - over ? box.minY : board.minY,
    maxX: box.maxX > board.maxX + over ? box.maxX : board.maxX,
    maxY: box.maxY > board.maxY + over ? box.maxY : board.maxY,
  };
}
