import { lengthOf, unknownSize, type Size, type Warn } from "./lengths.ts";
import { identity, multiply, numbersOf, scale, translate, type Matrix } from "./matrix.ts";
import type { Box } from "./style/box.ts";
import { nothingDeclared } from "./style/declared.ts";

/** The frames that drawings stand in: the whole picture, pictures inside it, and symbols where they are used. */

export interface Viewport {
  /** From the units inside to those around. */
  readonly matrix: Matrix;
  /** In the units inside: what percentages of lengths in it refer to. */
  readonly size: Size;
}

/** A width and height that are given, or not. */
export interface Wanted {
  readonly width: number | null;
  readonly height: number | null;
}

export const nothingWanted: Wanted = { width: null, height: null };

interface ViewBox extends Size {
  readonly left: number;
  readonly top: number;
}

function viewBoxOf(element: Element, warn: Warn): ViewBox | null {
  const text = element.getAttribute("viewBox");
  if (text === null) return null;
  const [left = 0, top = 0, width = 0, height = 0] = numbersOf(text) ?? [];
  if (width > 0 && height > 0) return { left, top, width, height };
  warn("W_BAD_VIEWBOX", element);
  return null;
}

/** The size that the element itself has; browsers take that of an inner picture from its attributes alone. */
export function wantedBy(element: Element, around: Size, warn: Warn): Wanted {
  const measures = { css: nothingDeclared, around, warn };
  return { width: lengthOf(element, "width", null, measures), height: lengthOf(element, "height", null, measures) };
}

/** A side that is not given follows from the other by the box's proportions, or is the box's own. */
function completed({ width, height }: Wanted, box: Size): Size {
  return {
    width: width ?? (height === null ? box.width : (height * box.width) / box.height),
    height: height ?? (width === null ? box.height : (width * box.height) / box.width),
  };
}

export function rootViewport(root: Element, warn: Warn): Viewport {
  const wanted = wantedBy(root, unknownSize, warn);
  const box = viewBoxOf(root, warn);
  if (box === null) return { matrix: identity, size: { width: wanted.width ?? NaN, height: wanted.height ?? NaN } };
  const size = completed(wanted, box);
  if (!(size.width > 0 && size.height > 0)) return { matrix: identity, size: box };
  // The whole picture's corner stays where its own coordinates say: what was exported from here comes back in place.
  return { matrix: multiply(translate(box.left, box.top), onto(root, size, box)), size: box };
}

/** The box of the whole picture in its own units; none where its size is not its own. */
export function pictureOf(root: Element): Box | null {
  const { matrix: [a, , , d, e, f], size } = rootViewport(root, () => undefined);
  const { left, top } = viewBoxOf(root, () => undefined) ?? { left: 0, top: 0 };
  if (!(Number.isFinite(size.width) && Number.isFinite(size.height))) return null;
  return { left: a * left + e, top: d * top + f, right: a * (left + size.width) + e, bottom: d * (top + size.height) + f };
}

/**
 * The frame of an `svg` inside another, or of a symbol: as large as the `use` that draws it says, or as it says itself,
 * or all of what is around. Null if it has no area, where nothing of it is drawn.
 */
export function innerViewport(element: Element, around: Size, byUse: Wanted, warn: Warn): Viewport | null {
  const measures = { css: nothingDeclared, around, warn };
  const own = wantedBy(element, around, warn);
  const whole = (side: number): number | null => (Number.isFinite(side) ? side : null);
  const wanted = { width: byUse.width ?? own.width ?? whole(around.width), height: byUse.height ?? own.height ?? whole(around.height) };
  if ((wanted.width ?? 1) <= 0 || (wanted.height ?? 1) <= 0) return null;
  const place = translate(lengthOf(element, "x", 0, measures) ?? 0, lengthOf(element, "y", 0, measures) ?? 0);
  const box = viewBoxOf(element, warn);
  if (box === null) return { matrix: place, size: { width: wanted.width ?? NaN, height: wanted.height ?? NaN } };
  if (wanted.width === null || wanted.height === null) warn("W_UNIT", element);
  return { matrix: multiply(place, onto(element, completed(wanted, box), box)), size: box };
}

/** From a view box to a frame of that size at the origin. */
function onto(element: Element, size: Size, box: ViewBox): Matrix {
  return multiply(fit(element.getAttribute("preserveAspectRatio") ?? "", size, box), translate(-box.left, -box.top));
}

function fit(rule: string, { width, height }: Size, box: Size): Matrix {
  const stretch: readonly [number, number] = [width / box.width, height / box.height];
  if (/\bnone\b/u.test(rule)) return scale(...stretch);
  const factor = /\bslice\b/u.test(rule) ? Math.max(...stretch) : Math.min(...stretch);
  const share = (part: string): number => (part === "Min" ? 0 : part === "Max" ? 1 : 0.5);
  const align = /x(Min|Mid|Max)Y(Min|Mid|Max)/u.exec(rule);
  const dx = (width - box.width * factor) * share(align?.[1] ?? "Mid");
  const dy = (height - box.height * factor) * share(align?.[2] ?? "Mid");
  return multiply(translate(dx, dy), scale(factor, factor));
}
