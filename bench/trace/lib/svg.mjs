// Reads the drawings that tracers write: groups, paths, circles, ellipses, rectangles; fills, strokes and transforms.

import svgpath from "svgpath";

import { arcPieces } from "./arc.mjs";
import { cleaned } from "./outline.mjs";

const TAG = /<(\/?)(svg|g|path|circle|ellipse|rect)\b((?:[^>"']|"[^"]*"|'[^']*')*?)(\/?)>/g;
const ATTRIBUTE = /([\w:-]+)\s*=\s*("([^"]*)"|'([^']*)')/g;
const NAMES = { black: [0, 0, 0], white: [255, 255, 255] };

function attributes(text) {
  const out = {};
  for (const [, name, , double, single] of text.matchAll(ATTRIBUTE)) out[name] = double ?? single ?? "";
  for (const part of (out.style ?? "").split(";")) {
    const [name, value] = part.split(":");
    if (value !== undefined) out[name.trim()] = value.trim();
  }
  return out;
}

/** The luminance of a colour, 0…1; undefined for none. */
function luminance(colour) {
  if (colour === "none" || colour === "transparent") return undefined;
  let rgb = NAMES[colour];
  const hex = /^#([0-9a-f]{3}|[0-9a-f]{6})$/i.exec(colour)?.[1];
  if (hex?.length === 6) rgb = [0, 2, 4].map((i) => parseInt(hex.slice(i, i + 2), 16));
  else if (hex) rgb = [...hex].map((c) => parseInt(c + c, 16));
  else if (colour.startsWith("rgb(")) rgb = colour.slice(4).split(",").map((part) => parseFloat(part));
  if (!rgb) throw new Error(`the colour ${colour} is not known here`);
  return (0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]) / 255;
}

const number = (text, otherwise = 0) => (text === undefined ? otherwise : parseFloat(text));

/** Path data of a shape; undefined for a group. */
function shape(name, a) {
  if (name === "path") return a.d ?? "";
  const oval = (cx, cy, rx, ry) => `M${cx - rx} ${cy}A${rx} ${ry} 0 0 1 ${cx + rx} ${cy}A${rx} ${ry} 0 0 1 ${cx - rx} ${cy}Z`;
  if (name === "circle") return oval(number(a.cx), number(a.cy), number(a.r), number(a.r));
  if (name === "ellipse") return oval(number(a.cx), number(a.cy), number(a.rx), number(a.ry));
  if (name !== "rect") return undefined;
  const [x, y, w, h] = [number(a.x), number(a.y), number(a.width), number(a.height)];
  const rx = Math.min(number(a.rx, number(a.ry)), w / 2);
  const ry = Math.min(number(a.ry, number(a.rx)), h / 2);
  if (rx === 0 || ry === 0) return `M${x} ${y}H${x + w}V${y + h}H${x}Z`;
  const arc = (toX, toY) => `A${rx} ${ry} 0 0 1 ${toX} ${toY}`;
  return `M${x + rx} ${y}H${x + w - rx}${arc(x + w, y + ry)}V${y + h - ry}${arc(x + w - rx, y + h)}H${x + rx}${arc(x, y + h - ry)}V${y + ry}${arc(x + rx, y)}Z`;
}

/** All elements with their path data and what they inherit. */
function elements(text) {
  const stack = [{}];
  const found = [];
  for (const [, closing, name, body, alone] of text.matchAll(TAG)) {
    if (closing) {
      stack.pop();
      continue;
    }
    const own = attributes(body);
    const above = stack[stack.length - 1];
    const a = { ...above, ...own, transform: `${above.transform ?? ""} ${name === "svg" ? "" : (own.transform ?? "")}`.trim() };
    const d = shape(name, own);
    if (d !== undefined) found.push({ name, d, a });
    if (!alone) stack.push(Object.fromEntries(["fill", "fill-rule", "stroke", "transform"].filter((key) => a[key] !== undefined).map((key) => [key, a[key]])));
  }
  return found;
}

/**
 * From a drawing's own units to pixels of a picture of that size: stretched, as a browser would show it in that box.
 */
function pixels(text, size) {
  const root = attributes(/<svg\b((?:[^>"']|"[^"]*"|'[^']*')*)>/.exec(text)?.[1] ?? "");
  const box = root.viewBox?.trim().split(/[\s,]+/).map(Number) ?? [0, 0, number(root.width, size), number(root.height, size)];
  return { x: size / box[2], y: size / box[3], left: box[0], top: box[1] };
}

/** Segments [x0, y0, …] of the contours or open lines of path data, arcs as cubics; how many segments were drawn. */
export function segments(path) {
  const contours = [];
  let [contour, drawn, arcs] = [[], 0, 0];
  let [startX, startY] = [0, 0];
  const end = () => {
    if (contour.length > 0) contours.push(contour);
    contour = [];
  };
  const line = (x, y, toX, toY) => {
    if (Math.hypot(toX - x, toY - y) > 1e-9) contour.push([x, y, toX, toY]);
  };
  path.iterate((s, _, x, y) => {
    const [command, ...n] = s;
    if (command === "M") {
      end();
      [startX, startY] = n;
    } else if (command === "Z") {
      line(x, y, startX, startY);
      end();
    } else if (command === "L") line(x, y, ...n);
    else if (command === "H") line(x, y, n[0], y);
    else if (command === "V") line(x, y, x, n[0]);
    else if (command === "A") {
      const pieces = arcPieces(x, y, n);
      contour.push(...pieces);
      arcs += Math.max(0, pieces.length - 1);
    } else contour.push([x, y, ...n]);
    drawn += command === "M" || command === "Z" ? 0 : 1;
  });
  end();
  return { contours, arcs, drawn };
}

function inPixels(element, scale) {
  const path = svgpath(element.d).abs().unshort();
  if (element.a.transform) path.transform(element.a.transform);
  const { contours, arcs, drawn } = segments(path.round(12));
  const moved = contours.map((c) => c.map((p) => p.map((v, i) => (i % 2 === 0 ? (v - scale.left) * scale.x : (v - scale.top) * scale.y))));
  return { contours: moved, arcs, drawn };
}

/** The filled elements in the order of painting: luminance, contours in pixels, segments, rule. */
export function readFilled(text, size) {
  const scale = pixels(text, size);
  const out = [];
  for (const element of elements(text)) {
    const shade = luminance(element.a.fill ?? "black");
    if (shade === undefined) continue;
    const { contours, arcs } = inPixels(element, scale);
    const closed = cleaned(contours);
    const count = closed.reduce((sum, c) => sum + c.length, 0);
    const own = { circle: 1, ellipse: 1, rect: 4 }[element.name] ?? count - arcs;
    out.push({ shade, contours: closed, segments: own, rule: element.a["fill-rule"] ?? "nonzero" });
  }
  return out;
}

/** The stroked lines in pixels, and how many segments they have. */
export function readStroked(text, size) {
  const scale = pixels(text, size);
  const lines = [];
  let count = 0;
  for (const element of elements(text)) {
    if ((element.a.stroke ?? "none") === "none") continue;
    const { contours, drawn } = inPixels(element, scale);
    lines.push(...contours);
    count += drawn;
  }
  return { lines, segments: count };
}
