import type { EditorState } from "../../editor/editor.ts";

/** One number of the status bar. */
export interface Metric {
  readonly testid: string;
  readonly about: string;
  /** Null hides the metric. */
  read(state: EditorState): { readonly value: number; readonly strong: string; readonly rest?: string; readonly lead?: string } | null;
  /** Too dear to be computed for every frame of a drag. */
  readonly slow?: boolean;
  /**
   * Works on what slow metrics are read from until the time is `spent`. False: there is more to do in the next frame,
   * and until then they are hidden.
   */
  prepare?(state: EditorState, spent: () => boolean): boolean;
}

/** The numbers of a mode: what is there, what is true about it, what it costs. */
export type ModeMetrics = readonly [present: readonly Metric[], truth: readonly Metric[], cost: readonly Metric[]];
