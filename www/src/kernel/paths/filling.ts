import { reversedContour } from "../../document/curve/whole/rearranging.ts";
import { paintLayers } from "../../document/paint-layers.ts";
import { isAlike, noInk, paintOf, runsOf } from "../../document/painted.ts";
import { emptyCurve, type Contour, type CurveDocument, type Filling, type Painted, type Space } from "../../document/document.ts";
import { curveOf, type AnyCurve } from "../curve/curve-cache.ts";
import { around, boundsOf, type Bounds } from "../curve/samples.ts";
import { coverage } from "../trace/raster.ts";

/**
 * How a drawing of several shapes is filled as one. Even-odd stays wherever it shows the same: it does not ask which
 * way a contour runs, so that a hole drawn later is one.
 */

/** Contours that are filled together. */
export interface FilledShape extends Painted {
  readonly contours: readonly Contour[];
  readonly rule: CanvasFillRule;
  /** Two of the same are one area where they overlap, as ink is; null is nothing. */
  readonly fill: string | null;
}

export interface FilledDrawing {
  readonly contours: readonly Contour[];
  readonly filling?: Filling;
}

/** One rule for all: each colour, from the lowest up, is filled by itself. */
export function filled(given: readonly FilledShape[], space: Space): FilledDrawing {
  if (given.length > 0 && given.every(({ fill }) => fill === null)) return { contours: given.flatMap((shape) => withPaint(shape).contours), filling: "none" };
  const shapes = given.map((shape) => withPaint(shape.fill === null ? { ...shape, ink: noInk } : shape));
  const contours = shapes.flatMap((shape) => shape.contours);
  if (shapes.length === 1 && shapes[0]?.rule === "evenodd") return { contours };
  const grid = gridAround(shapes.filter(({ fill }) => fill !== null), space);
  if (grid === null) return { contours };
  const layers = runsOf(shapes).filter(([first]) => first?.fill !== null).map((run) => layerOf(run.map((shape) => areaOf(shape, space, grid)), grid));
  const away = (rule: CanvasFillRule, as = (area: Area): Area => area): Difference =>
    inAll(layers.map(({ areas, wanted }) => difference(wanted, shown(areas.flatMap((area) => as(area).outlines.map(({ flat }) => flat)), grid, rule))));
  const asToday = away("evenodd");
  if (asToday.largest <= unseen) return { contours };
  const turned = new Map(layers.flatMap(({ areas }) => areas.map((area) => [area, turnedForWinding(area)] as const)));
  const [asItIs, asTurned] = [away("nonzero"), away("nonzero", (area) => turned.get(area) ?? area)];
  if (Math.min(asItIs.sum, asTurned.sum) >= asToday.sum) return { contours };
  return { contours: asItIs.sum <= asTurned.sum ? contours : contours.map(turnedBy(turned)), filling: "nonzero" };
}

/** What became of a contour of an area, when that was turned. */
function turnedBy(areas: ReadonlyMap<Area, Area>): (contour: Contour) => Contour {
  const turnedOf = new Map([...areas].flatMap(([{ outlines }, turned]) => outlines.map(({ contour }, i) => [contour, turned.outlines[i]?.contour ?? contour] as const)));
  return (contour) => turnedOf.get(contour) ?? contour;
}

/** Contours are painted as their shape is. */
function withPaint(shape: FilledShape): FilledShape {
  const paint = paintOf(shape);
  return { ...shape, contours: shape.contours.map((contour) => (isAlike(contour, paint) ? contour : { ...contour, ...paint })) };
}

/** A drawing and more contours beside it, which each keep the look they had. */
export function filledTogether(before: CurveDocument, added: FilledDrawing): FilledDrawing {
  const [one, other] = [before.filling, added.filling];
  if (before.contours.length === 0 || one === other) return { contours: [...before.contours, ...added.contours], ...(other === undefined ? {} : { filling: other }) };
  return filled([...shapesOf(before, one), ...shapesOf({ ...before, contours: added.contours }, other)], before.space);
}

/** A drawing as the shapes that it fills, each of one colour. */
function shapesOf(curve: CurveDocument, filling: Filling | undefined): readonly FilledShape[] {
  return paintLayers(curve).map(({ ink, line, drawing: { contours } }) => ({
    contours,
    rule: filling === "nonzero" ? filling : "evenodd",
    fill: filling === "none" || ink === noInk ? null : ink ?? "",
    ...paintOf({ ink, line }),
  }));
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

/** Areas of one colour, and what they show together. */
interface Layer {
  readonly areas: readonly Area[];
  readonly wanted: Float32Array;
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

function layerOf(areas: readonly Area[], grid: Grid): Layer {
  return { areas, wanted: painted(areas, grid) };
}

function shown(flats: readonly Float64Array[], { columns, rows }: Pick<Grid, "columns" | "rows">, rule: CanvasFillRule): Float32Array {
  return coverage(flats, columns, rows, 1, rule);
}

/**
 * What the shapes show: those of one fill the places that any of them has; of several fills one makes holes in another.
 */
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

function inAll(layers: readonly Difference[]): Difference {
  return { largest: layers.reduce((most, { largest }) => Math.max(most, largest), 0), sum: layers.reduce((sum, layer) => sum + layer.sum, 0) };
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

/**
 * The same area, with a winding number of 1 where nothing overlaps: holes run the other way, and every shape the same
 * as all others.
 */
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
