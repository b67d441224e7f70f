/** Changes of what Fit works on, stroke by stroke; and all that a document of Fit is (`fit-document`). */

import { isPainted, paintOf, type Painted } from "../painted.ts";
import type { FitDocument, Pair } from "./fit-document.ts";

export * from "./fit-document.ts";

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
  if (first === undefined || last === undefined) return false;
  if (to - from > 3 && first[0] === last[0] && first[1] === last[1]) return true;
  if (to - from < 8) return false;
  let [minX, minY, maxX, maxY] = [first[0], first[1], first[0], first[1]];
  for (let i = from; i < to; i += 1) {
    const [x, y] = data[i] ?? first;
    [minX, minY, maxX, maxY] = [Math.min(minX, x), Math.min(minY, y), Math.max(maxX, x), Math.max(maxY, y)];
  }
  return Math.hypot(last[0] - first[0], last[1] - first[1]) <= nearEnds * Math.hypot(maxX - minX, maxY - minY);
}

/** The document without strokes, and without what was true of the drawing that they came from. */
export function emptied({ sample: _gone, up: _way, filling: _filling, artboard: _artboard, paints: _paints, ...fit }: FitDocument): FitDocument {
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
