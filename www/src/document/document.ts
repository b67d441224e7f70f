/**
 * The document: plain, readonly JSON. It knows no DOM, no engine and no screen.
 */

import type { Setting } from "./artboard.ts";
import type { Contour, ControlPoint, Offset, Space } from "./contour.ts";
import type { FitDocument } from "./fit/fit.ts";
import type { SavedOrbit, SurfaceDocument } from "./surface/surface.ts";
import type { TraceDocument } from "./trace/trace.ts";

export type { Filling } from "./artboard.ts";
export type * from "./contour.ts";

export type Mode = "curve" | "fit" | "trace" | "surface";

export const modes: readonly Mode[] = ["curve", "fit", "trace", "surface"];

export interface CurveDocument extends Setting {
  readonly space: Space;
  /**
   * Radians per unit of the parameter; "auto" is 2π over the parameter length of a closed contour, 0 for an open one.
   */
  readonly omega: number | "auto";
  readonly level: number;
  readonly contours: readonly Contour[];
  /** The sample this came from, for titles and for the error against the shape it set out to be. */
  readonly sample?: string;
}

/** What the window looks at: the document point in the middle of the stage, and CSS pixels per document unit. */
export interface View {
  readonly zoom: number;
  readonly x: number;
  readonly y: number;
  /** Whether y points up, as in charts, and not down, as in drawings. */
  readonly up?: boolean;
}

/** CSS pixels that a drawing may be across: browsers take seconds for outlines of ten times as many. */
export const mostAcross = 4e6;

/** The version of the file format. 2 added interpolating contours and surfaces; files of version 1 still open. */
export const stateVersion = 2;

/** What the page saves, shares and hands to a tester. */
export interface DemoState {
  readonly format: "expline-demo";
  readonly version: typeof stateVersion;
  readonly mode: Mode;
  readonly view: View;
  readonly curve: CurveDocument;
  readonly fit: FitDocument;
  readonly trace: TraceDocument;
  readonly surface: SurfaceDocument;
  /** Where the surface is looked at from. */
  readonly orbit?: SavedOrbit;
}

export const emptyCurve: CurveDocument = { space: "trigonometric", omega: "auto", level: 0, contours: [] };

export const noOffset: Offset = { dx: 0, dy: 0 };

export type Side = "in" | "out";

export interface PointRef {
  readonly contour: number;
  readonly index: number;
}

export interface HandleRef extends PointRef {
  readonly side: Side;
}

/** The chosen points, and at most one chosen handle (its point is among the points). */
export interface Selection {
  readonly points: readonly PointRef[];
  readonly handle: HandleRef | null;
}

export const nothingSelected: Selection = { points: [], handle: null };

export function samePoint(a: PointRef, b: PointRef): boolean {
  return a.contour === b.contour && a.index === b.index;
}

/** Selections are immutable, and large ones are asked about once for every point: each keeps its set. */
const sets = new WeakMap<Selection, ReadonlySet<number>>();

/** Contours and points number fewer than two million each, so that a pair of them fits a number exactly. */
function keyOf({ contour, index }: PointRef): number {
  return contour * 2 ** 21 + index;
}

export function isSelected(selection: Selection, point: PointRef): boolean {
  let set = sets.get(selection);
  if (set === undefined) {
    set = new Set(selection.points.map(keyOf));
    sets.set(selection, set);
  }
  return set.has(keyOf(point));
}

export function pointAt(curve: CurveDocument, ref: PointRef): ControlPoint | undefined {
  return curve.contours[ref.contour]?.points[ref.index];
}

/** Whether a point is the first or the last of an open contour. */
export function isEnd(curve: CurveDocument, { contour, index }: PointRef): boolean {
  const shape = curve.contours[contour];
  return shape?.closed === false && (index === 0 || index === shape.points.length - 1);
}

/**
 * How many segments a contour has: one per point when closed, one fewer when open; of a refined one, the cells of its
 * grid.
 */
export function segmentCount(contour: Contour): number {
  const { grid } = contour;
  if (grid !== undefined) return Math.round((contour.closed ? grid.count : grid.count - 1) / grid.step);
  const points = baseCount(contour);
  return contour.closed ? points : Math.max(0, points - 1);
}

/** The number of points without the finer ones of refined places. */
export function baseCount({ points, places }: Contour): number {
  return (places ?? []).reduce((left, place) => left - place.count, points.length);
}

/** The parameter length of a segment. */
export function lengthOf(contour: Contour, segment: number): number {
  return contour.grid?.step ?? contour.lengths?.[segment] ?? 1;
}

/** Contours are immutable, and every segment of one may ask for the length of all. */
const domainLengths = new WeakMap<Contour, number>();

/** The parameter length of the whole contour. */
export function domainLength(contour: Contour): number {
  const known = domainLengths.get(contour);
  if (known !== undefined) return known;
  const segments = segmentCount(contour);
  let sum = 0;
  for (let segment = 0; segment < segments; segment += 1) sum += lengthOf(contour, segment);
  domainLengths.set(contour, sum);
  return sum;
}

/**
 * The frequency of a segment: its own, or the document's, or the one that keeps a closed trigonometric contour's
 * circles exact.
 */
export function omegaOf(curve: CurveDocument, contour: Contour, segment: number): number {
  const own = contour.omega?.[segment];
  if (own !== undefined) return own;
  if (curve.omega !== "auto") return curve.omega;
  const space = contour.space ?? curve.space;
  return contour.closed && space === "trigonometric" && contour.points.length > 1 ? (2 * Math.PI) / domainLength(contour) : 0;
}
