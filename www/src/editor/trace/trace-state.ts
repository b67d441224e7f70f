import type { TraceDocument } from "../../document/trace/trace.ts";
import type { PictureSource, TraceStage } from "../../kernel/trace/job.ts";
import type { ShownPicture, TraceOutcome } from "../../kernel/trace/outcome.ts";

/** What Trace shows and does at the moment, beside its document: never saved, never in the history. */

export type TraceViewId = "result" | "outline" | "source" | "edges";

export interface PointOfOutline {
  readonly contour: number;
  readonly index: number;
}

export interface TraceView {
  readonly view: TraceViewId;
  /** Opacity of the picture under the outlines, 0 … 100. */
  readonly alpha: number;
  readonly chosen: PointOfOutline | null;
  /** The point under the pointer. */
  readonly over: PointOfOutline | null;
}

/** Why there are no outlines. */
export interface TraceFailure {
  readonly id: "trace-none" | "trace-photo" | "image-broken" | "engine";
  readonly count?: number;
  readonly speckle?: number;
  readonly code?: string;
}

export interface TraceProgress {
  readonly stage: TraceStage;
  /** Of the whole job, 0 … 1; never goes back. */
  readonly value: number;
  readonly done: number;
  readonly total: number;
}

export interface TraceRun {
  readonly picture: ShownPicture | null;
  /** The last outlines that came back; while others are under way they stay on the stage. */
  readonly outcome: TraceOutcome | null;
  /** What those outlines were asked for with; null where they came without a picture. */
  readonly of: TraceDocument | null;
  /** The settings have changed since, and the trace with them was cancelled. */
  readonly behind: boolean;
  readonly failure: TraceFailure | null;
  /** Since when a job is under way, in milliseconds of the page; null: none is. */
  readonly since: number | null;
  /** Milliseconds that the last job took. */
  readonly lastMs: number;
}

/** A picture that was brought in and has not been looked at yet. */
export interface Incoming {
  readonly name: string;
  readonly source: PictureSource;
  /** What Trace held when it was brought in. */
  readonly instead: TraceDocument;
}

export const initialTraceView: TraceView = { view: "result", alpha: 35, chosen: null, over: null };

export const noTraceRun: TraceRun = { picture: null, outcome: null, of: null, behind: false, failure: null, since: null, lastMs: 0 };
