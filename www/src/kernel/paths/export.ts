import { parsePath } from "expline/slim";
import type { CurveDocument } from "../../document/document.ts";
import { curveOf, type AnyCurve } from "../curve/curve-cache.ts";

/** The drawing as path text, with its deviation measured on the text itself: printed, read back, compared both ways. */

export type ExportSegments = "arcs" | "cubics" | "polyline";

export interface ExportOptions {
  readonly segments: ExportSegments;
  /** Largest distance from the curve, in document units. */
  readonly tolerance: number;
  readonly decimals: number;
  readonly relative: boolean;
}

export interface ExportedPath {
  readonly d: string;
  readonly commands: number;
  /** Largest distance between the curve and what the text draws, at dense samples of both. */
  readonly deviation: number;
}

const samplesInAll = 16_000;
const leastSamples = 64;

export function exportPath(document: CurveDocument, options: ExportOptions): ExportedPath {
  const curves = document.contours.flatMap((contour) => curveOf(document, contour) ?? []);
  const segments = curves.reduce((sum, curve) => sum + curve.points.length / 2, 0);
  let d = "";
  let deviation = 0;
  for (const curve of curves) {
    const text = textOf(curve, options);
    d += text;
    const share = Math.round((samplesInAll * (curve.points.length / 2)) / segments);
    deviation = Math.max(deviation, distanceBetween(curve, text, Math.min(4000, Math.max(leastSamples, share))));
  }
  return { d, commands: commandsOf(d), deviation };
}

/** The same text, not measured: of a drawing in colours each layer is written by itself. */
export function writePath(document: CurveDocument, options: ExportOptions): string {
  return document.contours.map((contour) => {
    const curve = curveOf(document, contour);
    return curve === null ? "" : textOf(curve, options);
  }).join("");
}

function textOf(curve: AnyCurve, options: ExportOptions): string {
  if (options.segments === "polyline") return polyline(curve, options);
  const { tolerance, decimals, relative, segments } = options;
  return curve.toPathD({ tolerance, decimals, arcs: segments === "arcs", relative }).d;
}

/** How many numbers a command takes. */
const numbersOf: Readonly<Record<string, number>> = { m: 2, l: 2, h: 1, v: 1, c: 6, s: 4, q: 4, t: 2, a: 7 };

/** How many commands path data has: a letter that is the same as the one before may have been left out. */
export function commandsOf(d: string): number {
  let count = 0;
  for (const [, letter = "", rest = ""] of d.matchAll(/([a-df-z])([^a-df-z]*)/giu)) {
    const numbers = rest.match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/giu)?.length ?? 0;
    count += Math.max(1, numbers / (numbersOf[letter.toLowerCase()] ?? 1));
  }
  return count;
}

/** Both ways: no piece of either is far from the other. */
function distanceBetween(curve: AnyCurve, text: string, count: number): number {
  let worst = 0;
  const read = parsePath(text);
  for (const back of read) {
    worst = Math.max(worst, farthest(back.sample(count), [curve]));
  }
  return Math.max(worst, read.length === 0 ? 0 : farthest(curve.sample(count), read));
}

function farthest(points: Float64Array, from: readonly AnyCurve[]): number {
  const nearest = from.map((curve) => curve.nearestAll(points));
  let worst = 0;
  for (let i = 0; i < points.length / 2; i += 1) {
    let best = Infinity;
    for (const found of nearest) best = Math.min(best, found[4 * i + 3] ?? Infinity);
    worst = Math.max(worst, best);
  }
  return worst;
}

function polyline(curve: AnyCurve, options: ExportOptions): string {
  const vertices = curve.flatten(options.tolerance);
  const scale = 10 ** options.decimals;
  const rounded = (value: number): number => Math.round(value * scale) / scale + 0;
  const count = vertices.length / 2;
  const last = count - 1;
  // A closed polyline repeats its first vertex; Z says the same.
  const repeats = curve.closed && vertices[0] === vertices[2 * last] && vertices[1] === vertices[2 * last + 1];
  let text = "";
  let [fromX, fromY] = [0, 0];
  for (let i = 0; i < (repeats ? last : count); i += 1) {
    const x = rounded(vertices[2 * i] ?? 0);
    const y = rounded(vertices[2 * i + 1] ?? 0);
    const relative = options.relative && i > 0;
    const letter = i === 0 ? "M" : relative ? "l" : "L";
    text += letter + pair(relative ? rounded(x - fromX) : x, relative ? rounded(y - fromY) : y, options.decimals);
    [fromX, fromY] = [x, y];
  }
  return curve.closed ? `${text}Z` : text;
}

/** Two numbers as short as they can be written: no leading zero, no trailing ones, no exponent. */
function pair(x: number, y: number, decimals: number): string {
  const [a, b] = [short(x, decimals), short(y, decimals)];
  return b.startsWith("-") ? a + b : `${a} ${b}`;
}

function short(value: number, decimals: number): string {
  const fixed = value.toFixed(decimals);
  const trimmed = fixed.includes(".") ? fixed.replace(/\.?0+$/u, "") : fixed;
  return trimmed.replace(/^(-?)0\./u, "$1.");
}
