/** What Fit works on, and what it opens with: all that the page knows of it before it is opened. */

import type { Setting } from "../artboard.ts";
import type { Painted } from "../painted.ts";

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
  /** Whether y points up, as in charts: so tables are read. */
  readonly up?: boolean;
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

export const fitLimits = { smoothing: 100, mix: 100, knots: 1000, error: 1e9, noise: 20, seed: 9999 } as const;

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
