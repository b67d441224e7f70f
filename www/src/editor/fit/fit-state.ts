import type { Pair } from "../../document/fit/fit.ts";
import type { ChartPoint, FitOutcome } from "../../kernel/fit/outcome.ts";
import type { PagePoint } from "../pointer/camera.ts";

/** What Fit shows and does at the moment, beside its document: never saved, never in the history. */

export type FitTool = "draw" | "points" | "erase";

export type FitOverlay = "data" | "residual" | "knots" | "parts" | "heat" | "comb";

export type Compare = "off" | "onion" | "split";

export interface FitView {
  readonly tool: FitTool;
  readonly overlays: Readonly<Record<FitOverlay, boolean>>;
  readonly compare: Compare;
  /** Where the stage is divided while comparing by halves, 0 … 1 of its width. */
  readonly split: number;
  /** Chosen knots, by their place in the outcome. */
  readonly chosen: readonly number[];
  /** The knot under the pointer. */
  readonly over: number | null;
  /** The stroke that is being drawn. */
  readonly stroke: readonly Pair[];
  /** Where the eraser is. */
  readonly brush: PagePoint | null;
}

/** Why there is no curve for the points. */
export interface FitFailure {
  readonly id: string;
  readonly details: { readonly count?: number; readonly code?: string };
}

export interface FitRun {
  /** The last fit that came back; while another is under way it stays on the stage. */
  readonly outcome: FitOutcome | null;
  readonly failure: FitFailure | null;
  /** Since when a fit is under way, in milliseconds of the page; null: none is. */
  readonly since: number | null;
  /** Knots and error over the smoothing, filled while nothing else is to be done. */
  readonly chart: readonly ChartPoint[];
  /** Milliseconds that the last fit took. */
  readonly lastMs: number;
}

export const initialFitView: FitView = {
  tool: "draw",
  overlays: { data: true, residual: false, knots: true, parts: false, heat: false, comb: false },
  compare: "off",
  split: 0.5,
  chosen: [],
  over: null,
  stroke: [],
  brush: null,
};

export const noFitRun: FitRun = { outcome: null, failure: null, since: null, chart: [], lastMs: 0 };
