import { toleranceOf, type TraceDocument } from "../../document/trace/trace.ts";
import type { PictureSource, TraceHow } from "../../kernel/trace/job.ts";
import { pictureOf } from "../../kernel/trace/pictures.ts";

/** What a document asks the tracer: which picture, and how. */

/** A picture with more outlines than this is a photograph, unless somebody says that it is none. */
const mostOutlines = 1500;
/** And this is where even somebody who wants all of them is told no. */
const mostAnyway = 20_000;
/** Degrees; below, every wave of a noisy line would be a corner. */
const leastCorner = 5;

export function howOf({ settings, anyway }: TraceDocument): TraceHow {
  const { detail, corner, speckle, mode, threshold, blur, invert, colors, size } = settings;
  return {
    size, source: mode, threshold, blur, invert, colors, speckle, tolerance: toleranceOf(detail),
    corner: (Math.max(leastCorner, corner) * Math.PI) / 180,
    mostContours: anyway === true ? mostAnyway : mostOutlines,
  };
}

export function sourceOf(trace: TraceDocument): PictureSource | null {
  if (trace.sample !== undefined) return { kind: "sample", key: `sample:${trace.sample}`, id: trace.sample };
  return trace.picture === undefined ? null : pictureOf(trace.picture.key);
}

/** Corners are decided on the page; the tracer need not know. */
export function sameQuestion(a: TraceDocument, b: TraceDocument): boolean {
  return a.settings === b.settings && a.sample === b.sample && a.picture === b.picture && a.kept === b.kept && a.anyway === b.anyway;
}
