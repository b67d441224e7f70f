/** What Fit works on: points as they were measured, drawn or brought in, and how they are to become a curve. */

import type { Setting } from "../artboard.ts";
import { isPainted, paintOf, type Painted } from "../painted.ts";

export type Pair = readonly [number, number];

/** Straight pieces with corners, smooth pieces, or the sum of both. */
export type FitModel = "linear" | "cubic" | "hybrid";

/** Whether a stroke's ends are joined; "auto": where they are near each other. */
export type FitClosing = "auto" | "open" | "closed";

/** What drives the smoothing, if not the slider. */
export type FitTarget = "off" | "knots" | "error";

export interface FitDocument extends Setting {
  /** The sample that the data are, for as long as nothing was drawn, erased or brought in. */
  readonly sample?: string;
  /** All strokes, one after the other. With a sample's name, none: the sample is still to be opened. */
  readonly data: readonly Pair[];
  /** Where in the data each stroke after the first begins. */
  readonly starts: readonly number[];
  /** How each stroke is painted, as contours are; absent where none is. */
  readonly paints?: readonly Painted[];
  readonly model: FitModel;
  /** 0 … 100 */
  readonly smoothing: number;
  /** 0 (straight) … 100 (smooth), for the hybrid model. */
  readonly mix: number;
  readonly corners: boolean;
  readonly closing: FitClosing;
  readonly target: FitTarget;
  readonly targetKnots: number;
  /** Document units. */
  readonly targetError: number;
  /** Standard deviation of the sample's noise in document units, and the seed that it is made from. */
  readonly noise: number;
  readonly seed: number;
}

export const fitLimits = { smoothing: 100, mix: 100, knots: 1000, error: 1000, noise: 20, seed: 9999 } as const;

export const fitDefaults = {
  starts: [], model: "hybrid", smoothing: 40, mix: 50, corners: true, closing: "auto", target: "off", targetKnots: 12, targetError: 2, noise: 0, seed: 1,
} as const satisfies Omit<FitDocument, "data">;

/** The sample that shows corners and smooth parts best. */
export const firstFitSample = "fit-signature";

/** What Fit opens with, still to be opened. */
export const emptyFit: FitDocument = { ...fitDefaults, sample: firstFitSample, data: [] };

/** What an entry of Fit's history brings back. */
export interface FitMoment {
  readonly fit: FitDocument;
}

/** A run of the data: from one index up to another, without it. */
export interface Stroke {
  readonly from: number;
  readonly to: number;
}

export function strokesOf({ data, starts }: Pick<FitDocument, "data" | "starts">): readonly Stroke[] {
  if (data.length === 0) return [];
  const from = [0, ...starts];
  return from.map((start, i) => ({ from: start, to: from[i + 1] ?? data.length }));
}

/** How near the ends of a stroke are taken for joined, as a part of the diagonal of its box. */
const nearEnds = 0.03;

/** Whether a stroke's ends are to be joined. */
export function isJoined({ data, closing }: Pick<FitDocument, "data" | "closing">, { from, to }: Stroke): boolean {
  if (closing !== "auto") return closing === "closed" && to - from >= 3;
  const [first, last] = [data[from], data[to - 1]];
  if (first === undefined || last === undefined || to - from < 8) return false;
  let [minX, minY, maxX, maxY] = [first[0], first[1], first[0], first[1]];
  for (let i = from; i < to; i += 1) {
    const [x, y] = data[i] ?? first;
    [minX, minY, maxX, maxY] = [Math.min(minX, x), Math.min(minY, y), Math.max(maxX, x), Math.max(maxY, y)];
  }
  return Math.hypot(last[0] - first[0], last[1] - first[1]) <= nearEnds * Math.hypot(maxX - minX, maxY - minY);
}

/** The document without strokes, and without what was true of the drawing that they came from. */
export function emptied({ sample: _gone, filling: _filling, artboard: _artboard, paints: _paints, ...fit }: FitDocument): FitDocument {
  return { ...fit, data: [], starts: [] };
}

/** The document without its sample's name: its data are somebody's own from now on. */
export function owned({ sample: _gone, ...fit }: FitDocument): FitDocument {
  return fit;
}

/** A stroke on its way into a document. */
export interface NewStroke extends Painted {
  readonly places: readonly Pair[];
}

/** The document with more strokes. */
export function withStrokes(fit: FitDocument, strokes: readonly NewStroke[]): FitDocument {
  const fresh = strokes.filter(({ places }) => places.length > 0);
  if (fresh.length === 0) return fit;
  const data = [...fit.data];
  const starts = [...fit.starts];
  for (const { places } of fresh) {
    if (data.length > 0) starts.push(data.length);
    for (const place of places) data.push(place);
  }
  const paints = [...(fit.paints ?? strokesOf(fit).map(() => ({}))), ...fresh.map(paintOf)];
  return withPaints({ ...owned(fit), data, starts }, paints);
}

function withPaints({ paints: _old, ...fit }: FitDocument, paints: readonly Painted[]): FitDocument {
  return paints.some(isPainted) ? { ...fit, paints } : fit;
}

/** The document with one more point at the end of its last stroke. */
export function withPoint(fit: FitDocument, point: Pair): FitDocument {
  return { ...owned(fit), data: [...fit.data, point] };
}

/** The document without the points that lie in a disc; strokes of which nothing is left are gone. */
export function withoutDisc(fit: FitDocument, x: number, y: number, radius: number): FitDocument {
  const kept: Pair[] = [];
  const starts: number[] = [];
  const paints: Painted[] = [];
  for (const [stroke, { from, to }] of strokesOf(fit).entries()) {
    const before = kept.length;
    for (let i = from; i < to; i += 1) {
      const point = fit.data[i];
      if (point !== undefined && Math.hypot(point[0] - x, point[1] - y) > radius) kept.push(point);
    }
    if (kept.length > before && before > 0) starts.push(before);
    if (kept.length > before) paints.push(fit.paints?.[stroke] ?? {});
  }
  return kept.length === fit.data.length ? fit : withPaints({ ...owned(fit), data: kept, starts }, paints);
}

/** How many different points a stroke has; counting stops at `enough`. */
export function differentPoints({ data }: Pick<FitDocument, "data">, { from, to }: Stroke, enough: number): number {
  const seen = new Set<string>();
  for (let i = from; i < to && seen.size < enough; i += 1) seen.add(String(data[i]));
  return seen.size;
}
