import { reversedContour } from "../../document/curve/contours.ts";
import { emptyCurve, type Contour, type CurveDocument, type Filling, type Space } from "../../document/document.ts";
import { curveOf, type AnyCurve } from "../curve/curve-cache.ts";
import { around, boundsOf, type Bounds } from "../curve/samples.ts";
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
  const seen = shapes.filter(({ fill }) => fill !== null);
  const grid = gridAround(seen, space);
  if (grid === null) return { contours };
  const areas = seen.map((shape) => areaOf(shape, space, grid));
  const wanted = painted(areas, grid);
  const away = (rule: CanvasFillRule, all: readonly Area[]): Difference => difference(wanted, shown(all.flatMap(({ outlines }) => outlines.map(({ flat }) => flat)), grid, rule));
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

/** In pixels of the grid. */
interface Outline {
  readonly contour: Contour;
  readonly flat: Float64Array;
  readonly box: Bounds;
  /** What it encloses, signed, in document units. */
  readonly area: number;
}

interface Area extends Pick<FilledShape, "rule" | "fill"> {
  readonly outlines: readonly Outline[];
}

/** The pixels that rules are compared on. */
interface Grid {
  readonly x: number;
  readonly y: number;
  readonly scale: number;
  readonly columns: number;
  readonly rows: number;
}

const finest = 256;
/** In all shapes together: of thousands nobody sees what is that small, and each may be as large as the drawing. */
const mostPixels = 4e6;
/** Of a pixel: what one of them shows and the other does not, and is nothing to be seen. */
const unseen = 0.1;
/** Pixels that a polyline may be away; all rules look at the same ones. */
const flatness = 0.05;

/** Only closed contours have an area: of an open one the page shows the line. */
function curvesOf({ contours }: FilledShape, space: Space): readonly { readonly contour: Contour; readonly curve: AnyCurve }[] {
  const document: CurveDocument = { ...emptyCurve, space, contours };
  return contours.filter(({ closed }) => closed).flatMap((contour) => {
    const curve = curveOf(document, contour);
    return curve === null ? [] : [{ contour, curve }];
  });
}

function gridAround(shapes: readonly FilledShape[], space: Space): Grid | null {
  const box = around(shapes.flatMap((shape) => curvesOf(shape, space).map(({ contour }) => boundsOf({ ...emptyCurve, space }, contour))));
  const size = box === null ? 0 : Math.max(box.maxX - box.minX, box.maxY - box.minY);
  if (box === null || !(size > 0)) return null;
  const scale = Math.min(finest, Math.sqrt(mostPixels / shapes.length)) / size;
  const pixels = (length: number): number => Math.max(1, Math.ceil(scale * length));
  return { x: box.minX, y: box.minY, scale, columns: pixels(box.maxX - box.minX), rows: pixels(box.maxY - box.minY) };
}

function areaOf(shape: FilledShape, space: Space, { x, y, scale }: Grid): Area {
  const outlines = curvesOf(shape, space).flatMap(({ contour, curve }): Outline[] => {
    const box = boundsOf({ ...emptyCurve, space }, contour);
    if (box === null) return [];
    const flat = curve.flatten(flatness / scale);
    for (let i = 0; i < flat.length; i += 1) flat[i] = scale * ((flat[i] ?? 0) - (i % 2 === 0 ? x : y));
    const inGrid = { minX: scale * (box.minX - x), minY: scale * (box.minY - y), maxX: scale * (box.maxX - x), maxY: scale * (box.maxY - y) };
    return [{ contour, flat, box: inGrid, area: curve.area() }];
  });
  return { outlines, rule: shape.rule, fill: shape.fill };
}

function shown(flats: readonly Float64Array[], { columns, rows }: Pick<Grid, "columns" | "rows">, rule: CanvasFillRule): Float32Array {
  return coverage(flats, columns, rows, 1, rule);
}

/** What the shapes show: those of one fill the places that any of them has; of several fills one makes holes in another. */
function painted(areas: readonly Area[], { columns, rows }: Grid): Float32Array {
  const byFill = new Map<string | null, Float32Array>();
  for (const { outlines, rule, fill } of areas) {
    const box = around(outlines.map((outline) => outline.box));
    if (box === null) continue;
    // The part of the grid that the shape is in: of thousands most are small.
    const [left, top] = [Math.max(0, Math.floor(box.minX)), Math.max(0, Math.floor(box.minY))];
    const size = { columns: Math.min(columns, Math.ceil(box.maxX)) - left, rows: Math.min(rows, Math.ceil(box.maxY)) - top };
    const own = shown(outlines.map(({ flat }) => flat.map((value, i) => value - (i % 2 === 0 ? left : top))), size, rule);
    const all = byFill.get(fill) ?? new Float32Array(columns * rows);
    byFill.set(fill, all);
    for (let i = 0; i < own.length; i += 1) {
      const at = (top + Math.floor(i / size.columns)) * columns + left + (i % size.columns);
      all[at] = Math.max(all[at] ?? 0, own[i] ?? 0);
    }
  }
  return [...byFill.values()].reduce((all, own) => all.map((share, i) => share + (own[i] ?? 0) * (1 - 2 * share)), new Float32Array(columns * rows));
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
