import { numbersOf } from "./matrix.ts";
import { lengthOf, type Warn } from "./lengths.ts";

/** The path data of a shape element, exactly (arcs for what is round); null when it draws nothing. */
export function pathDataOf(element: Element, warn: Warn): string | null {
  switch (element.localName) {
    case "path": {
      const d = element.getAttribute("d")?.trim() ?? "";
      return d === "" || d === "none" ? null : d;
    }
    case "rect":
      return rectangle(element, warn);
    case "circle":
      return round(element, "r", "r", warn);
    case "ellipse":
      return round(element, "rx", "ry", warn);
    case "line":
      return line(element, warn);
    case "polyline":
      return polygon(element, "", warn);
    case "polygon":
      return polygon(element, "Z", warn);
    default:
      return null;
  }
}

export const shapeNames: ReadonlySet<string> = new Set(["path", "rect", "circle", "ellipse", "line", "polyline", "polygon"]);

function positive(value: number | null, element: Element, warn: Warn): number | null {
  if (value !== null && value > 0) return value;
  if (value !== null) warn("W_BAD_LENGTH", element);
  return null;
}

function rectangle(element: Element, warn: Warn): string | null {
  const x = lengthOf(element, "x", 0, warn);
  const y = lengthOf(element, "y", 0, warn);
  const width = positive(lengthOf(element, "width", 0, warn), element, warn);
  const height = positive(lengthOf(element, "height", 0, warn), element, warn);
  if (x === null || y === null || width === null || height === null) return null;
  const given = [lengthOf(element, "rx", -1, warn) ?? -1, lengthOf(element, "ry", -1, warn) ?? -1] as const;
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
function round(element: Element, first: string, second: string, warn: Warn): string | null {
  const cx = lengthOf(element, "cx", 0, warn);
  const cy = lengthOf(element, "cy", 0, warn);
  const a = lengthOf(element, first, -1, warn);
  const b = second === first ? a : lengthOf(element, second, -1, warn);
  // An ellipse with one radius left out is a circle of the other.
  const rx = positive(a === -1 ? b : a, element, warn);
  const ry = positive(b === -1 ? a : b, element, warn);
  if (cx === null || cy === null || rx === null || ry === null) return null;
  const to = (x: number, y: number): string => `A${rx} ${ry} 0 0 1 ${x} ${y}`;
  return `M${cx + rx} ${cy}${to(cx, cy + ry)}${to(cx - rx, cy)}${to(cx, cy - ry)}${to(cx + rx, cy)}Z`;
}

function line(element: Element, warn: Warn): string | null {
  const ends = ["x1", "y1", "x2", "y2"].map((attribute) => lengthOf(element, attribute, 0, warn));
  if (ends.includes(null) || (ends[0] === ends[2] && ends[1] === ends[3])) return null;
  return `M${ends[0]} ${ends[1]}L${ends[2]} ${ends[3]}`;
}

function polygon(element: Element, end: "" | "Z", warn: Warn): string | null {
  const text = element.getAttribute("points") ?? "";
  const values = numbersOf(text) ?? numbersOf(/^[-+\d.eE,\s]*/u.exec(text)?.[0] ?? "") ?? [];
  if (values.length % 2 === 1) {
    warn("W_ODD_POINTS", element);
    values.pop();
  }
  if (values.length < 4) return null;
  const pairs: string[] = [];
  for (let i = 0; i < values.length; i += 2) pairs.push(`${values[i]} ${values[i + 1]}`);
  return `M${pairs.join("L")}${end}`;
}
