import { numbersOf } from "./matrix.ts";
import { lengthOf, type Measures } from "./lengths.ts";

/** The path data of a shape element, exactly (arcs for what is round); null when it draws nothing. */
export function pathDataOf(element: Element, measures: Measures): string | null {
  switch (element.localName) {
    case "path": {
      const d = dataOf(element, measures).trim();
      return d === "" || d === "none" ? null : d;
    }
    case "rect":
      return rectangle(element, measures);
    case "circle":
      return round(element, "r", "r", measures);
    case "ellipse":
      return round(element, "rx", "ry", measures);
    case "line":
      return line(element, measures);
    case "polyline":
      return polygon(element, "", measures);
    case "polygon":
      return polygon(element, "Z", measures);
    default:
      return null;
  }
}

/** The path data of a style, `path("…")`, or of the attribute. */
function dataOf(element: Element, { css, warn }: Measures): string {
  const styled = css.get("d");
  const d = styled === "none" ? styled : /^path\("([^"]*)"\)$/u.exec(styled ?? "")?.[1];
  if (styled !== undefined && d === undefined) warn("W_STYLE", element);
  return d ?? element.getAttribute("d") ?? "";
}

export const shapeNames: ReadonlySet<string> = new Set(["path", "rect", "circle", "ellipse", "line", "polyline", "polygon"]);

function positive(value: number | null, element: Element, measures: Measures): number | null {
  if (value !== null && value > 0) return value;
  if (value !== null) measures.warn("W_BAD_LENGTH", element);
  return null;
}

function rectangle(element: Element, measures: Measures): string | null {
  const x = lengthOf(element, "x", 0, measures);
  const y = lengthOf(element, "y", 0, measures);
  const width = positive(lengthOf(element, "width", 0, measures), element, measures);
  const height = positive(lengthOf(element, "height", 0, measures), element, measures);
  if (x === null || y === null || width === null || height === null) return null;
  const given = [lengthOf(element, "rx", -1, measures) ?? -1, lengthOf(element, "ry", -1, measures) ?? -1] as const;
  // A missing or negative radius takes the other's value; neither is more than half the side.
  const rx = Math.min(width / 2, Math.max(0, given[0] < 0 ? given[1] : given[0]));
  const ry = Math.min(height / 2, Math.max(0, given[1] < 0 ? given[0] : given[1]));
  const [right, bottom] = [x + width, y + height];
  if (rx === 0 || ry === 0) return `M${x} ${y}H${right}V${bottom}H${x}Z`;
  const corner = (toX: number, toY: number): string => `A${rx} ${ry} 0 0 1 ${toX} ${toY}`;
  const across = width > 2 * rx;
  const down = height > 2 * ry;
  return [
    `M${x + rx} ${y}`,
    across ? `H${right - rx}` : "",
    corner(right, y + ry),
    down ? `V${bottom - ry}` : "",
    corner(right - rx, bottom),
    across ? `H${x + rx}` : "",
    corner(x, bottom - ry),
    down ? `V${y + ry}` : "",
    corner(x + rx, y),
    "Z",
  ].join("");
}

/** Four quarter arcs from 3 o'clock, clockwise on the screen: the points an editor would put there. */
function round(element: Element, first: string, second: string, measures: Measures): string | null {
  const cx = lengthOf(element, "cx", 0, measures);
  const cy = lengthOf(element, "cy", 0, measures);
  const a = lengthOf(element, first, -1, measures);
  const b = second === first ? a : lengthOf(element, second, -1, measures);
  // An ellipse with one radius left out is a circle of the other.
  const rx = positive(a === -1 ? b : a, element, measures);
  const ry = positive(b === -1 ? a : b, element, measures);
  if (cx === null || cy === null || rx === null || ry === null) return null;
  const to = (x: number, y: number): string => `A${rx} ${ry} 0 0 1 ${x} ${y}`;
  return `M${cx + rx} ${cy}${to(cx, cy + ry)}${to(cx - rx, cy)}${to(cx, cy - ry)}${to(cx + rx, cy)}Z`;
}

function line(element: Element, measures: Measures): string | null {
  const ends = ["x1", "y1", "x2", "y2"].map((attribute) => lengthOf(element, attribute, 0, measures));
  if (ends.includes(null) || (ends[0] === ends[2] && ends[1] === ends[3])) return null;
  return `M${ends[0]} ${ends[1]}L${ends[2]} ${ends[3]}`;
}

function polygon(element: Element, end: "" | "Z", measures: Measures): string | null {
  const text = element.getAttribute("points") ?? "";
  const values = numbersOf(text) ?? numbersOf(/^[-+\d.eE,\s]*/u.exec(text)?.[0] ?? "") ?? [];
  if (values.length % 2 === 1) {
    measures.warn("W_ODD_POINTS", element);
    values.pop();
  }
  if (values.length < 4) return null;
  const pairs: string[] = [];
  for (let i = 0; i < values.length; i += 2) pairs.push(`${values[i]} ${values[i + 1]}`);
  return `M${pairs.join("L")}${end}`;
}
