import type { SvgWarningCode } from "./limits.ts";
import type { Declared } from "./style/declared.ts";

export type Warn = (code: SvgWarningCode, element: Element) => void;

/**
 * CSS pixels per unit, for the units that do not depend on anything outside the file; text is of the size that browsers
 * begin with.
 */
const units: ReadonlyMap<string, number> = new Map([
  ["", 1],
  ["px", 1],
  ["pt", 4 / 3],
  ["pc", 16],
  ["mm", 96 / 25.4],
  ["cm", 96 / 2.54],
  ["in", 96],
  ["q", 96 / 101.6],
  ["em", 16],
  ["rem", 16],
  ["ex", 8],
]);
const ofText: ReadonlySet<string> = new Set(["em", "rem", "ex"]);
const length = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(%|[a-z]*)$/iu;

/** The width and height of a viewport in the units inside it; NaN where the page would say. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

export const unknownSize: Size = { width: NaN, height: NaN };

/** What the lengths of an element are read with. */
export interface Measures {
  /** What CSS says of the element, before its attributes. */
  readonly css: Declared;
  /** What percentages refer to: the viewport around the element. */
  readonly around: Size;
  readonly warn: Warn;
}

/** A length in user units: the fallback when absent, null (with a warning) when it cannot be one. */
export function lengthOf(element: Element, name: string, fallback: number | null, { css, around, warn }: Measures): number | null {
  const text = css.get(name)?.replace(/^calc\((.*)\)$/iu, "$1") ?? element.getAttribute(name)?.trim();
  if (text === undefined || text === "") return fallback;
  const isRoot = element.localName === "svg" && element.parentElement?.closest("svg") == null;
  if (text === "auto" && !isRoot) return fallback;
  const [, number, unit = ""] = length.exec(text) ?? [];
  const each = unit === "%" ? hundredth(around, name) : isRoot && ofText.has(unit) ? undefined : units.get(unit.toLowerCase());
  if (number !== undefined && each !== undefined) return Number(number) * each;
  if (number === undefined && text !== "auto") {
    warn("W_BAD_LENGTH", element);
    return null;
  }
  // A whole picture sized by its page is as large as its box says.
  if (!(isRoot && element.hasAttribute("viewBox"))) warn("W_UNIT", element);
  return fallback;
}

const across = new Set(["x", "cx", "x1", "x2", "rx", "width"]);
const down = new Set(["y", "cy", "y1", "y2", "ry", "height"]);

/** A length of a style, in user units; undefined where it is none, or only a page could tell. */
export function styledLength(text: string, around: Size): number | undefined {
  const [, number, unit = ""] = length.exec(text.replace(/^calc\((.*)\)$/u, "$1")) ?? [];
  const each = unit === "%" ? hundredth(around, "") : units.get(unit);
  return number === undefined || each === undefined ? undefined : Number(number) * each;
}

/** A hundredth of a viewport in the direction of a length; of its diagonal over √2 for a radius. */
function hundredth({ width, height }: Size, name: string): number | undefined {
  const size = across.has(name) ? width : down.has(name) ? height : Math.hypot(width, height) / Math.SQRT2;
  return Number.isFinite(size) ? size / 100 : undefined;
}
