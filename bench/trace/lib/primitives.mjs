// Circles, ellipses, rounded rectangles and lines: whether a drawing says what was drawn, and how near its numbers are.

import svgpath from "svgpath";

import { random } from "./degrade.mjs";
import { cleaned } from "./outline.mjs";
import { segments } from "./svg.mjs";
import { drawn } from "./unseen.mjs";

const SIZE = 256;

/**
 * The drawn commands of path data, absolute, with the place that each starts from; lines are all L, the closing one
 * too.
 */
function commands(d) {
  const out = [];
  let start = [0, 0];
  svgpath(d).abs().unshort().iterate(([letter, ...numbers], _, x, y) => {
    const ends = { H: [numbers[0], y], V: [x, numbers[0]], Z: start }[letter] ?? numbers.slice(-2);
    if (letter === "M") start = numbers;
    else if (Math.hypot(ends[0] - x, ends[1] - y) > 1e-6) {
      const straight = "HVZ".includes(letter);
      out.push({ kind: straight ? "L" : letter, numbers: straight ? ends : numbers, x, y });
    }
  });
  return out;
}

const dataOf = (svg) => [...svg.matchAll(/ d="([^"]*)"/g)].map(([, d]) => d).join("");

/** The centre of an arc of given radii and rotation. */
function centre({ x, y, numbers: [rx, ry, rotation, large, sweep, toX, toY] }) {
  const angle = (rotation * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const [ux, uy] = [(cos * (x - toX) + sin * (y - toY)) / 2 / rx, (cos * (y - toY) - sin * (x - toX)) / 2 / ry];
  const far = Math.sqrt(Math.max(0, 1 / (ux * ux + uy * uy) - 1)) * (large === sweep ? -1 : 1);
  const [cx, cy] = [far * uy * rx, -far * ux * ry];
  return [cos * cx - sin * cy + (x + toX) / 2, sin * cx + cos * cy + (y + toY) / 2];
}

/** How far an arc's centre, radii and direction are from those of an ellipse: the largest, in pixels. */
function ellipseError(arc, [x, y, rx, ry, rotation]) {
  const [cx, cy] = centre(arc);
  const [a, b, turned] = arc.numbers;
  const swapped = a < b !== rx < ry;
  const [wide, high] = swapped ? [b, a] : [a, b];
  // Half the difference of the radii times the angle is how far the direction moves the ellipse.
  const off = ((turned + (swapped ? 90 : 0) - rotation) * Math.PI) / 180;
  const moved = Math.abs(Math.sin(off) * (rx - ry));
  return Math.max(Math.abs(cx - x), Math.abs(cy - y), Math.abs(wide - rx), Math.abs(high - ry), moved);
}

/** The largest error of a drawing of one ellipse; undefined where it is not one. */
function oneEllipse(svg, ellipse) {
  const all = commands(dataOf(svg));
  if (all.length === 0 || !all.every(({ kind }) => kind === "A")) return undefined;
  return Math.max(...all.map((arc) => ellipseError(arc, ellipse)));
}

/** As `oneEllipse`, of a rectangle with rounded corners: four arcs and four lines. */
function roundedRectangle(svg, [x, y, w, h, r]) {
  const all = commands(dataOf(svg));
  const arcs = all.filter(({ kind }) => kind === "A");
  const lines = all.filter(({ kind }) => kind === "L");
  if (arcs.length !== 4 || lines.length !== 4 || all.length !== 8) return undefined;
  const corners = [[x + r, y + r], [x + w - r, y + r], [x + w - r, y + h - r], [x + r, y + h - r]];
  return Math.max(
    ...corners.map(([cx, cy]) => Math.min(...arcs.map((arc) => ellipseError(arc, [cx, cy, r, r, 0])))),
    ...lines.map((line) => {
      const side = (px, py) => Math.min(Math.abs(px - x), Math.abs(px - x - w), Math.abs(py - y), Math.abs(py - y - h));
      return Math.max(side(line.x, line.y), side(...line.numbers));
    }),
  );
}

/** As `oneEllipse`, of a polygon: as many lines as it has corners, ends at the corners. */
function polygon(svg, corners) {
  const all = commands(dataOf(svg));
  if (all.length !== corners.length || !all.every(({ kind }) => kind === "L")) return undefined;
  return Math.max(...corners.map(([x, y]) => Math.min(...all.map((line) => Math.hypot(line.x - x, line.y - y)))));
}

const ovalData = ([x, y, rx, ry, turn]) => {
  const [dx, dy] = [rx * Math.cos((turn * Math.PI) / 180), rx * Math.sin((turn * Math.PI) / 180)];
  return `M${x - dx} ${y - dy}A${rx} ${ry} ${turn} 0 1 ${x + dx} ${y + dy}A${rx} ${ry} ${turn} 0 1 ${x - dx} ${y - dy}Z`;
};

const roundedData = ([x, y, w, h, r]) =>
  `M${x + r} ${y}H${x + w - r}a${r} ${r} 0 0 1 ${r} ${r}V${y + h - r}a${r} ${r} 0 0 1 ${-r} ${r}H${x + r}a${r} ${r} 0 0 1 ${-r} ${-r}V${y + r}a${r} ${r} 0 0 1 ${r} ${-r}Z`;

/** Ten of each kind by lot: kind, path data, and the error of a drawing. */
export function cases() {
  const next = random(99);
  const among = (least, most) => least + (most - least) * next();
  const ten = (make) => Array.from({ length: 10 }, make);
  return [
    ...ten(() => {
      const r = among(6, 100);
      const it = [among(r + 4, SIZE - r - 4), among(r + 4, SIZE - r - 4), r, r, 0];
      return { kind: "circle", d: ovalData(it), error: (svg) => oneEllipse(svg, it) };
    }),
    ...ten(() => {
      const [rx, ry] = [among(40, 110), among(12, 36)];
      const it = [among(116, 140), among(116, 140), rx, ry, among(0, 180)];
      return { kind: "ellipse", d: ovalData(it), error: (svg) => oneEllipse(svg, it) };
    }),
    ...ten(() => {
      const [w, h, r] = [among(60, 200), among(60, 200), among(6, 28)];
      const it = [among(10, 40), among(10, 40), w, h, r];
      return { kind: "rounded rectangle", d: roundedData(it), error: (svg) => roundedRectangle(svg, it) };
    }),
    ...ten((_, i) => {
      const corners = Array.from({ length: 3 + (i % 4) }, (_v, k) => {
        const [angle, r] = [(2 * Math.PI * (k + among(0.1, 0.5))) / (3 + (i % 4)), among(60, 120)];
        return [128 + r * Math.cos(angle), 128 + r * Math.sin(angle)];
      });
      return { kind: "polygon", d: `M${corners.join("L")}Z`, error: (svg) => polygon(svg, corners) };
    }),
  ];
}

/** By kind: how many were recognised of how many, and the largest error among these, in pixels. */
export async function recognised(trace) {
  const kinds = new Map();
  for (const { kind, d, error } of cases()) {
    const contours = cleaned(segments(svgpath(d).abs().unshort()).contours).map((c) => c.map((p) => p.map((v) => v / SIZE)));
    const { svg } = await trace(drawn({ contours }, SIZE), 1);
    const found = error(svg);
    const entry = kinds.get(kind) ?? { kind, all: 0, found: 0, error: 0 };
    kinds.set(kind, { kind, all: entry.all + 1, found: entry.found + (found === undefined ? 0 : 1), error: Math.max(entry.error, found ?? 0) });
  }
  return [...kinds.values()];
}
