import type { Contour, CurveDocument } from "../document/document.ts";
import type { Pair } from "../document/fit/fit.ts";
import type { PagePoint } from "./pointer/camera.ts";

/** A line that says what a drag snapped to. */
export interface Guide {
  readonly from: PagePoint;
  readonly to: PagePoint;
}

/** A rectangle in document units, corners in any order. */
export interface Marquee {
  readonly from: PagePoint;
  readonly to: PagePoint;
}

/** A segment that a click of the pen would make. */
export interface Rubber {
  readonly contour: Contour;
  /** The place that the pointer is at; for the closing preview, the first point. */
  readonly closing: boolean;
}

/** What tools draw on top while they work. */
export interface Sketch {
  readonly guides: readonly Guide[];
  readonly marquee: Marquee | null;
  readonly rubber: Rubber | null;
  /** What is being drawn by hand, and what was until its curve is there. */
  readonly stroke: readonly Pair[];
  /** Where letting go joins two ends. */
  readonly joint: PagePoint | null;
  /** The finger that drags, for the loupe. */
  readonly finger: PagePoint | null;
  /** What the drawing would become if the user agrees (going down a level that finer edits were made on). */
  readonly proposal: CurveDocument | null;
}

/** No gesture has drawn anything. */
export const nothingSketched: Sketch = { guides: [], marquee: null, rubber: null, stroke: [], joint: null, finger: null, proposal: null };
