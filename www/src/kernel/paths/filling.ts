import { reversedContour } from "../../document/curve/contours.ts";
import { emptyCurve, type Contour, type CurveDocument, type Filling, type Space } from "../../document/document.ts";
import { curveOf } from "../curve/curve-cache.ts";
import type { Bounds } from "../curve/samples.ts";
import { coverage } from "../trace/raster.ts";

/**
 * How a drawing of several shapes is filled as one. Even-odd stays wherever it shows the same: it does not ask which way a
 * contour runs, so that a hole drawn later is one.
 */

/** Contours that are filled together. */
export interface FilledShape {
  readonly contours: readonly Contour[];
  readonly rule: CanvasFillRule;
  /** Two of the same are one area where they overlap, as ink is; null is nothing. */
  readonly fill: string | null;
}

export interface FilledDrawing {
  readonly contours: readonly Contour[];
  readonly filling?: Filling;
}

export function filled(shapes: readonly FilledShape[], space: Space): FilledDrawing {
  const contours = shapes.flatMap((shape) => shape.contours);
  if (shapes.length > 0 && shapes.every(({ fill }) => fill === null)) return { contours, filling: "none" };
  if (shapes.length === 1 && shapes[0]?.rule === "evenodd") return { contours };
  const areas = shapes.filter(({ fill }) => fill !== null).map((shape) => areaOf(shape, space));
  const grid = gridAround(areas);
  if (grid === null) return { contours };
  const wanted = painted(areas, grid);
  const away = (rule: CanvasFillRule, all: readonly Area[]): Difference => difference(wanted, shown(all.flatMap(({ outlines }) => outlines), grid, rule));
  const asToday = away("evenodd", areas);
  if (asToday.largest <= unseen) return { contours };
  const turned = areas.map(turnedForWinding);
  const [asItIs, asTurned] = [away("nonzero", areas), away("nonzero", turned)];
  if (Math.min(asItIs.sum, asTurned.sum) >= asToday.sum) return { contours };
  if (asItIs.sum <= asTurned.sum) return { contours, filling: "nonzero" };
  const turnedOf = new Map(areas.flatMap(({ outlines }, a) => outlines.map(({ contour }, i) => [contour, turned[a]?.outlines[i]?.contour ?? contour] as const)));
  return { contours: contours.map((contour) => turnedOf.get(contour) ?? contour), filling: "nonzero" };
}

/** A drawing and more contours beside it, which each keep the look they had. */
export function filledTogether(before: CurveDocument, added: FilledDrawing): FilledDrawing {
  const contours = [...before.contours, ...added.contours];
  const [one, other] = [before.filling, added.filling];
  const as = (filling: Filling | undefined): FilledDrawing => ({ contours, ...(filling === undefined ? {} : { filling }) });
  if (before.contours.length === 0 || one === other || one === "none") return as(other);
  // Lines and areas in one drawing: it has areas.
  if (other === "none") return as(one);
  return filled([{ contours: before.contours, rule: one ?? "evenodd", fill: "" }, { contours: added.contours, rule: other ?? "evenodd", fill: "" }], before.space);
}

interface Outline {
  readonly contour: Contour;
  readonly flat: Float64Array;
  readonly box: Bounds;
  /** Twice what it encloses, signed. */
  readonly area: number;
}

interface Area extends Pick<FilledShape, "rule" | "fill"> {
  readonly outlines: readonly Outline[];
}

/** Only closed contours have an area: of an open one the page shows the line. */
function areaOf({ contours, rule, fill }: FilledShape, space: Space): Area {
  const document: CurveDocument = { ...emptyCurve, space, contours };
  const outlines = contours.filter(({ closed }) => closed).flatMap((contour): Outline[] => {
    const curve = curveOf(document, contour);
    if (curve === null) return [];
    const box = curve.bounds();
    const flat = curve.flatten(Math.max(1e-9, Math.hypot(box.maxX - box.minX, box.maxY - box.minY)) / 1000);
    return [{ contour, flat, box, area: signedArea(flat) }];
  });
  return { outlines, rule, fill };
}

function signedArea(flat: Float64Array): number {
  let sum = 0;
  for (let i = 0, j = flat.length - 2; i + 1 < flat.length; j = i, i += 2) sum += (flat[j] ?? 0) * (flat[i + 1] ?? 0) - (flat[i] ?? 0) * (flat[j + 1] ?? 0);
  return sum;
}

/** The pixels that rules are compared on. */
interface Grid {
  readonly x: number;
  readonly y: number;
  readonly scale: number;
  readonly columns: number;
  readonly rows: number;
}

const side = 256;
/** Of a pixel: what one of them shows and the other does not, and is nothing to be seen. */
const unseen = 0.1;

function gridAround(areas: readonly Area[]): Grid | null {
  const box = around(areas.flatMap(({ outlines }) => outlines));
  const size = box === null ? 0 : Math.max(box.maxX - box.minX, box.maxY - box.minY);
  if (box === null || !(size > 0)) return null;
  const scale = side / size;
  const pixels = (length: number): number => Math.max(1, Math.ceil(scale * length));
  return { x: box.minX, y: box.minY, scale, columns: pixels(box.maxX - box.minX), rows: pixels(box.maxY - box.minY) };
}

function around(outlines: readonly Outline[]): Bounds | null {
  return outlines.reduce<Bounds | null>((all, { box }) => (all === null ? box : {
    minX: Math.min(all.minX, box.minX), minY: Math.min(all.minY, box.minY), maxX: Math.max(all.maxX, box.maxX), maxY: Math.max(all.maxY, box.maxY),
  }), null);
}

function shown(outlines: readonly Outline[], { x, y, scale, columns, rows }: Grid, rule: CanvasFillRule): Float32Array {
  return coverage(outlines.map(({ flat }) => flat.map((value, i) => scale * (value - (i % 2 === 0 ? x : y)))), columns, rows, 1, rule);
}

/** What the shapes show: those of one fill the places that any of them has; of several fills one makes holes in another. */
function painted(areas: readonly Area[], grid: Grid): Float32Array {
  const byFill = new Map<string | null, Float32Array>();
  for (const { outlines, rule, fill } of areas) {
    const window = windowOf(outlines, grid);
    const own = shown(outlines, window, rule);
    const all = byFill.get(fill) ?? new Float32Array(grid.columns * grid.rows);
    byFill.set(fill, all);
    own.forEach((share, i) => {
      const at = placeIn(grid, window, i);
      all[at] = Math.max(all[at] ?? 0, share);
    });
  }
  return [...byFill.values()].reduce((all, own) => all.map((share, i) => share + (own[i] ?? 0) * (1 - 2 * share)));
}

interface Window extends Grid {
  readonly left: number;
  readonly top: number;
}

/** The part of the grid that outlines are in: of thousands of shapes each is small. */
function windowOf(outlines: readonly Outline[], grid: Grid): Window {
  const box = around(outlines);
  if (box === null) return { ...grid, left: 0, top: 0, columns: 0, rows: 0 };
  const { x, y, scale } = grid;
  const [left, top] = [Math.floor(scale * (box.minX - x)), Math.floor(scale * (box.minY - y))];
  return {
    x: x + left / scale, y: y + top / scale, scale, left, top,
    columns: Math.min(grid.columns, Math.ceil(scale * (box.maxX - x))) - left,
    rows: Math.min(grid.rows, Math.ceil(scale * (box.maxY - y))) - top,
  };
}

function placeIn({ columns }: Grid, window: Window, i: number): number {
  return (window.top + Math.floor(i / window.columns)) * columns + window.left + (i % window.columns);
}

interface Difference {
  readonly largest: number;
  readonly sum: number;
}

function difference(a: Float32Array, b: Float32Array): Difference {
  let [largest, sum] = [0, 0];
  a.forEach((value, i) => {
    const own = Math.abs(value - (b[i] ?? 0));
    largest = Math.max(largest, own);
    sum += own;
  });
  return { largest, sum };
}

/** The same area, with a winding number of 1 where nothing overlaps: holes run the other way, and every shape the same as all others. */
function turnedForWinding(area: Area): Area {
  const { outlines, rule } = area;
  const total = outlines.reduce((sum, outline) => sum + outline.area, 0);
  return {
    ...area,
    outlines: outlines.map((outline) => {
      const backwards = rule === "nonzero" ? total < 0 : (outline.area < 0) !== isHole(outline, outlines);
      return backwards ? { ...outline, contour: reversedContour(outline.contour), flat: reversed(outline.flat) } : outline;
    }),
  };
}

function reversed(flat: Float64Array): Float64Array {
  return flat.map((_, i) => flat[flat.length - 2 - i + 2 * (i % 2)] ?? 0);
}

/** Whether an outline lies in an odd number of others: most of some places on it do. */
function isHole(outline: Outline, outlines: readonly Outline[]): boolean {
  const places = [0.1, 0.3, 0.5, 0.7, 0.9].map((part) => 2 * Math.floor((part * outline.flat.length) / 2));
  const odd = places.filter((at) => {
    const [x, y] = [outline.flat[at] ?? 0, outline.flat[at + 1] ?? 0];
    return outlines.filter((other) => other !== outline && encloses(other, x, y)).length % 2 === 1;
  });
  return odd.length > places.length / 2;
}

function encloses({ flat, box }: Outline, x: number, y: number): boolean {
  if (x < box.minX || x > box.maxX || y < box.minY || y > box.maxY) return false;
  let inside = false;
  for (let i = 0, j = flat.length - 2; i + 1 < flat.length; j = i, i += 2) {
    const [ax, ay, bx, by] = [flat[i] ?? 0, flat[i + 1] ?? 0, flat[j] ?? 0, flat[j + 1] ?? 0];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  }
  return inside;
}
