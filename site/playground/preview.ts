/** What a run gave, drawn to fit. Its path data goes into an attribute and its SVG into a picture: neither can run. */
import { shape } from "../figures/stage.ts";
import type { Drawn } from "./messages.ts";

/** Around the drawing, and the radii of dots, of many points and of few or knots, in parts of its size. */
const MARGIN = 0.06;
const DOT = 0.006;
const KNOT = 0.011;
/** So many points are many. */
const MANY = 60;

interface Box { x: number; y: number; width: number; height: number }

function around(boxes: readonly Box[]): Box | undefined {
  if (boxes.length === 0) return undefined;
  const [x, y] = [Math.min(...boxes.map((box) => box.x)), Math.min(...boxes.map((box) => box.y))];
  return { x, y, width: Math.max(...boxes.map((box) => box.x + box.width)) - x, height: Math.max(...boxes.map((box) => box.y + box.height)) - y };
}

function boxOfPoints(points: readonly number[]): Box | undefined {
  const boxes: Box[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) boxes.push({ x: points[i] ?? 0, y: points[i + 1] ?? 0, width: 0, height: 0 });
  // One by one: a spread of a hundred thousand is more than a call takes.
  return boxes.reduce<Box | undefined>((box, next) => around(box === undefined ? [next] : [box, next]), undefined);
}

function picture(host: HTMLElement, text: string): void {
  const image = document.createElement("img");
  image.alt = "The SVG that the code gave";
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  host.append(image);
}

type Lines = Exclude<Drawn, { kind: "svg" }>;

/** What encloses an area is filled, a surface drawn in thin lines. */
const lookOf = ({ d, isWire }: Lines & { kind: "path" }): string => (isWire ? "wire" : /z\s*$/i.test(d) ? "filled" : "ink");

/** A path of small discs. */
function discs(points: readonly number[], radius: number): string {
  let d = "";
  for (let i = 0; i + 1 < points.length; i += 2) d += `M${(points[i] ?? 0) - radius} ${points[i + 1]}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0`;
  return d;
}

/** Paths and dots on one sheet, in their order. */
function sheet(host: HTMLElement, lines: readonly Lines[]): void {
  const svg = shape("svg", { role: "img", "aria-label": `A drawing of ${lines.length} ${lines.length === 1 ? "part" : "parts"}` }) as SVGSVGElement;
  host.append(svg);
  const boxes: Box[] = [];
  const dots: { path: SVGElement; line: Lines & { kind: "dots" } }[] = [];
  for (const line of lines) {
    const path = svg.appendChild(shape("path", line.kind === "path" ? { class: lookOf(line), d: line.d } : { class: line.areKnots ? "knots" : "data" })) as SVGPathElement;
    const box = line.kind === "path" ? path.getBBox() : boxOfPoints(line.points);
    if (box !== undefined) boxes.push(box);
    if (line.kind === "dots") dots.push({ path, line });
  }
  const box = around(boxes);
  if (box === undefined) return;
  const size = Math.max(box.width, box.height) || 1;
  const margin = size * MARGIN;
  svg.setAttribute("viewBox", [box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin].join(" "));
  for (const { path, line } of dots) path.setAttribute("d", discs(line.points, size * (line.areKnots || line.points.length < 2 * MANY ? KNOT : DOT)));
}

export function showDrawn(host: HTMLElement, drawn: readonly Drawn[]): void {
  host.replaceChildren();
  for (const each of drawn) if (each.kind === "svg") picture(host, each.text);
  const lines = drawn.filter((each) => each.kind !== "svg");
  if (lines.length > 0) sheet(host, lines);
}
