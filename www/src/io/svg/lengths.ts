import type { SvgWarningCode } from "./limits.ts";
import { numbersOf } from "./matrix.ts";

export type Warn = (code: SvgWarningCode, element: Element) => void;

/** CSS pixels per unit, for the units that do not depend on anything outside the file; text is of the size that browsers begin with. */
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

/** A length attribute in user units: the fallback when absent, null (with a warning) when it cannot be one. */
export function lengthOf(element: Element, attribute: string, fallback: number | null, warn: Warn): number | null {
  const text = element.getAttribute(attribute)?.trim();
  if (text === undefined || text === "") return fallback;
  const isRoot = element.localName === "svg" && element.parentElement?.closest("svg") == null;
  const [, number, unit = ""] = length.exec(text) ?? [];
  const each = unit === "%" && !isRoot ? hundredth(element, attribute) : isRoot && ofText.has(unit) ? undefined : units.get(unit.toLowerCase());
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

/** A hundredth of the picture around an element, in the direction of the attribute; of its diagonal over √2 for a radius. */
function hundredth(element: Element, attribute: string): number | undefined {
  const around = element.parentElement?.closest("svg");
  const box = numbersOf(around?.getAttribute("viewBox") ?? "") ?? [];
  const [wide, high] = box.length === 4
    ? box.slice(2)
    : ["width", "height"].map((side) => (around == null ? NaN : (lengthOf(around, side, null, () => undefined) ?? NaN)));
  const size = across.has(attribute) ? wide : down.has(attribute) ? high : Math.hypot(wide ?? NaN, high ?? NaN) / Math.SQRT2;
  return size !== undefined && Number.isFinite(size) ? size / 100 : undefined;
}
