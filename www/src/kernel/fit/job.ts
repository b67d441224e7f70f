/** What passes between the page and the worker that fits: plain data only. */
import type { FitStatus } from "expline/slim";
import type { Painted } from "../../document/contour.ts";

/** A stroke as the fit takes it. */
export interface FitInput extends Painted {
  /** x and y in turn. */
  readonly points: Float64Array;
  readonly closed: boolean;
}

/** Everything of a fit but how strong it is: the same set of these is fitted again and again while a slider moves. */
export interface FitSubject {
  readonly strokes: readonly FitInput[];
  readonly degree: 1 | 3 | readonly [1, 3];
  /** 0 … 1 */
  readonly mix: number;
  /** Whether there are corners; a number: the least angle in radians that they turn by. */
  readonly corners: boolean | number;
  /** Whether the straight part and the smooth part are wanted by themselves, too. */
  readonly parts?: boolean;
}

export type FitStrength =
  | { readonly by: "smoothing"; readonly smoothing: number }
  | { readonly by: "error"; readonly tolerance: number }
  /** The least smoothing that leaves so few knots. */
  | { readonly by: "knots"; readonly knots: number };

export type FitRequest =
  /** A new subject: fitters of the one before are dropped. */
  | { readonly kind: "subject"; readonly subject: number; readonly what: FitSubject }
  | {
    readonly kind: "fit"; readonly subject: number; readonly id: number; readonly strength: FitStrength;
    /** Within a drag: as fast as can be, from the last result on. */
    readonly live: boolean;
  }
  /** Fill the chart at these values of the smoothing, until something else is asked for. */
  | { readonly kind: "chart"; readonly subject: number; readonly at: readonly number[] }
  | { readonly kind: "stop" };

/** A fit of one stroke. */
export interface PlainFit {
  /** As `HermiteCurve.toJSON` gives it. */
  readonly curve: object;
  readonly parts: readonly object[];
  readonly knots: readonly { readonly t: number; readonly x: number; readonly y: number; readonly degree: number }[];
  readonly parameters: Float64Array;
  readonly rms: number;
  readonly maxError: number;
  readonly lambda: readonly number[];
  readonly smoothing?: number;
  readonly gap: number;
  readonly status: FitStatus;
}

export type FitAnswer =
  /** How much of the work is done, from 0 to 1. */
  | { readonly kind: "progress"; readonly subject: number; readonly id: number; readonly value: number }
  | { readonly kind: "fitted"; readonly subject: number; readonly id: number; readonly fits: readonly PlainFit[]; readonly ms: number }
  | { readonly kind: "stopped"; readonly subject: number; readonly id: number }
  | { readonly kind: "failed"; readonly subject: number; readonly id: number; readonly code: string; readonly message: string }
  | { readonly kind: "chart"; readonly subject: number; readonly smoothing: number; readonly knots: number; readonly rms: number };
