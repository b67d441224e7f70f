import type { CurveDocument, Selection } from "./document.ts";

/**
 * Undo and redo over whole documents. They are immutable and share what did not change, so that an entry costs little.
 */

export interface Moment {
  readonly curve: CurveDocument;
  readonly selection: Selection;
}

export interface Entry<M> {
  readonly name: string;
  readonly before: M;
  readonly after: M;
  readonly run: string | undefined;
  /** Milliseconds on the caller's clock, for joining runs. */
  readonly time: number;
}

/** Each mode has one of its own; `M` is what an entry brings back. */
export interface History<M> {
  readonly past: readonly Entry<M>[];
  readonly future: readonly Entry<M>[];
}

export function emptyHistory<M>(): History<M> {
  return { past: [], future: [] };
}

/** Unlimited as far as anyone goes, bounded for memory. */
const mostEntries = 200;
const runGapMs = 600;

/** Adds an entry, joined to the last one when both belong to one quick run. A new change ends what could be redone. */
export function record<M>(history: History<M>, entry: Entry<M>): History<M> {
  const last = history.past[history.past.length - 1];
  if (last !== undefined && entry.run !== undefined && last.run === entry.run && entry.time - last.time < runGapMs && history.future.length === 0) {
    return { past: [...history.past.slice(0, -1), { ...entry, before: last.before }], future: [] };
  }
  return { past: [...history.past, entry].slice(-mostEntries), future: [] };
}

export function stepBack<M>(history: History<M>): { history: History<M>; moment: M } | null {
  const entry = history.past[history.past.length - 1];
  if (entry === undefined) return null;
  return { history: { past: history.past.slice(0, -1), future: [...history.future, entry] }, moment: entry.before };
}

export function stepForward<M>(history: History<M>): { history: History<M>; moment: M } | null {
  const entry = history.future[history.future.length - 1];
  if (entry === undefined) return null;
  return { history: { past: [...history.past, entry], future: history.future.slice(0, -1) }, moment: entry.after };
}
