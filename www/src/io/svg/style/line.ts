import { styledLength, type Measures } from "../lengths.ts";
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
}

/** Of a scale that is not the same in all directions: the side of a square as large as what becomes of one of 1. */
function scaleOf([a, b, c, d]: Matrix): number {
  return Math.sqrt(Math.abs(a * d - b * c));
}

/** The line of a shape that `matrix` places; null where it has none. */
export function strokeOf(paint: Paint, element: Element, { css, around, warn }: Measures, matrix: Matrix, painter: Painter): Stroke | null {
  if (paint.stroke === unknownStroke) return { color: null };
  const seen = painter.strokeOf(paint, element);
  const own = styledLength(paint["stroke-width"], around) ?? 1;
  if (seen === null || !(own > 0)) return null;
  if (/[1-9]/u.test(paint["stroke-dasharray"])) warn("W_DASHES", element);
  const isOfPage = (css.get("vector-effect") ?? element.getAttribute("vector-effect")) === "non-scaling-stroke";
  const [cap, join] = [paint["stroke-linecap"], paint["stroke-linejoin"]];
  return {
    ...seen,
    width: isOfPage ? own : own * scaleOf(matrix),
    ...(cap === "round" || cap === "square" ? { cap } : {}),
    ...(join === "round" || join === "bevel" ? { join } : {}),
  };
}
