import { differentPoints, isJoined, strokesOf, type FitDocument } from "../../document/fit/fit.ts";
import type { FitInput, FitStrength, FitSubject } from "../../kernel/fit/job.ts";

/** What a document asks the fitter: which points, and how far the curve may be from them. */

/** Fewer different points than this are no stroke to be fitted. */
const leastPoints = 4;

const degrees = { linear: 1, cubic: 3, hybrid: [1, 3] } as const;

/** What is to be fitted, or null where no stroke has enough points. */
export function subjectOf(fit: FitDocument): FitSubject | null {
  const strokes: FitInput[] = [];
  for (const stroke of strokesOf(fit)) {
    if (differentPoints(fit, stroke, leastPoints) < leastPoints) continue;
    strokes.push({ points: Float64Array.from(fit.data.slice(stroke.from, stroke.to).flat()), closed: isJoined(fit, stroke) });
  }
  return strokes.length === 0 ? null : { strokes, degree: degrees[fit.model], mix: fit.mix / 100, corners: fit.corners };
}

export function strengthOf(fit: FitDocument): FitStrength {
  switch (fit.target) {
    case "off":
      return { by: "smoothing", smoothing: fit.smoothing / 100 };
    case "knots":
      return { by: "knots", knots: fit.targetKnots };
    case "error":
      return { by: "error", tolerance: fit.targetError };
  }
}

/** What a target sets the slider to is no new question. */
export function sameQuestion(a: FitDocument, b: FitDocument): boolean {
  return a === b || (sameSubject(a, b) && sameStrength(a, b));
}

const madeOf = ["data", "starts", "closing", "model", "mix", "corners"] as const;

export function sameSubject(a: FitDocument, b: FitDocument): boolean {
  return madeOf.every((key) => a[key] === b[key]);
}

const drivenBy = { off: "smoothing", knots: "targetKnots", error: "targetError" } as const;

function sameStrength(a: FitDocument, b: FitDocument): boolean {
  const key = drivenBy[a.target];
  return a.target === b.target && a[key] === b[key];
}
