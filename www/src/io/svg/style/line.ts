import { styledLength, type Measures, type Size } from "../lengths.ts";
import type { Matrix } from "../matrix.ts";
import type { Painter } from "./color.ts";
import { unknownStroke, type Paint } from "./paint.ts";

/** The line along an outline. */
export interface Stroke {
  /** `#rrggbb`, or `#rrggbbaa` where something shows through; null where only a page could tell. */
  readonly color: string | null;
  /** In the document's units. Absent: nothing says that it is there, let alone how wide. */
  readonly width?: number;
  readonly cap?: "round" | "square";
  readonly join?: "round" | "bevel";
  readonly dashes?: readonly number[];
  readonly dashOffset?: number;
}

/** Of a scale that is not the same in all directions: the side of a square as large as what becomes of one of 1. */
function scaleOf([a, b, c, d]: Matrix): number {
  return Math.sqrt(Math.abs(a * d - b * c));
}

const mostDashes = 256;

/**
 * Dashes and gaps in a line's own units; null where they cannot be read, and empty where it is solid: a list with a
 * negative length in it is none.
 */
function dashesOf(text: string, around: Size): readonly number[] | null {
  const lengths = text === "none" ? [] : text.split(/[\s,]+/u).map((each) => styledLength(each, around) ?? NaN);
  if (lengths.some((each) => !Number.isFinite(each)) || lengths.length > mostDashes) return null;
  return lengths.some((each) => each < 0) || !lengths.some((each) => each > 0) ? [] : lengths;
}

/** What a line runs along. */
export interface Outline {
  /** What places it. */
  readonly matrix: Matrix;
  /** Its length in its own units; null where that is not known. */
  along(): number | null;
}

/**
 * How many units of an outline are one of its dashes': the author may say how long the whole of it counts for. NaN
 * where nobody can tell.
 */
function dashUnit(element: Element, { along }: Outline): number {
  const said = Number(element.getAttribute("pathLength") ?? NaN);
  if (!(said >= 0)) return 1;
  const length = said > 0 ? along() : null;
  return length === null ? NaN : length / said;
}

/** The line of a shape; null where it has none. */
export function strokeOf(paint: Paint, element: Element, { css, around, warn }: Measures, outline: Outline, painter: Painter): Stroke | null {
  if (paint.stroke === unknownStroke) return { color: null };
  const seen = painter.strokeOf(paint, element);
  const own = styledLength(paint["stroke-width"], around) ?? 1;
  if (seen === null || !(own > 0)) return null;
  const isOfPage = (css.get("vector-effect") ?? element.getAttribute("vector-effect")) === "non-scaling-stroke";
  const scale = isOfPage ? 1 : scaleOf(outline.matrix);
  const isSolid = paint["stroke-dasharray"] === "none";
  const dashScale = isSolid ? 1 : scale * dashUnit(element, outline);
  const dashes = Number.isNaN(dashScale) ? null : dashesOf(paint["stroke-dasharray"], around);
  const offset = (styledLength(paint["stroke-dashoffset"], around) ?? 0) * dashScale;
  if (dashes === null) warn("W_DASHES", element);
  const isDashed = dashes !== null && dashes.length > 0;
  const [cap, join] = [paint["stroke-linecap"], paint["stroke-linejoin"]];
  return {
    ...seen,
    width: own * scale,
    ...(cap === "round" || cap === "square" ? { cap } : {}),
    ...(join === "round" || join === "bevel" ? { join } : {}),
    ...(isDashed ? { dashes: dashes.map((each) => each * dashScale) } : {}),
    ...(isDashed && offset !== 0 ? { dashOffset: offset } : {}),
  };
}
