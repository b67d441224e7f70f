import { differentPoints, isJoined, strokesOf, type FitDocument } from "../../document/fit/fit.ts";
import type { FitInput, FitStrength, FitSubject } from "../../kernel/fit/job.ts";

/** What a document asks the fitter: which points, and how far the curve may be from them. */

/** Fewer different points than this are no stroke to be fitted. */
const leastPoints = 4;

/** Of straight pieces and smooth ones by a price of knots, the smooth ones alone have no corners. */
export function degreeOf({ model, corners, target }: FitDocument): FitSubject["degree"] {
  if (model === "linear") return 1;
  return model === "cubic" || (!corners && target !== "error") ? 3 : [1, 3];
}

/**
 * Whether it matters if corners are kept: straight pieces are nothing else, and smooth ones by a price of knots have
 * none.
 */
export function choosesCorners({ model, target }: FitDocument): boolean {
  return model === "hybrid" || (model === "cubic" && target === "error");
}

/** Whether the curve has a straight and a smooth part. */
export function hasParts(fit: FitDocument): boolean {
  return typeof degreeOf(fit) !== "number" && fit.target !== "error";
}

/** The most different points that one stroke has. */
export function mostDifferent(fit: FitDocument): number {
  return Math.max(0, ...strokesOf(fit).map((stroke) => differentPoints(fit, stroke, leastPoints)));
}

/**
 * What is to be fitted, or null where no stroke has enough points; with `parts`, the parts are wanted by themselves,
 * too.
 */
export function subjectOf(fit: FitDocument, parts: boolean): FitSubject | null {
  const strokes: FitInput[] = [];
  for (const [i, stroke] of strokesOf(fit).entries()) {
    if (differentPoints(fit, stroke, leastPoints) < leastPoints) continue;
    strokes.push({ points: Float64Array.from(fit.data.slice(stroke.from, stroke.to).flat()), closed: isJoined(fit, stroke), ...fit.paints?.[i] });
  }
  return strokes.length === 0 ? null : { strokes, degree: degreeOf(fit), mix: fit.mix / 100, corners: fit.corners, parts };
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
  return madeOf.every((key) => a[key] === b[key]) && String(degreeOf(a)) === String(degreeOf(b));
}

const drivenBy = { off: "smoothing", knots: "targetKnots", error: "targetError" } as const;

function sameStrength(a: FitDocument, b: FitDocument): boolean {
  const key = drivenBy[a.target];
  return a.target === b.target && a[key] === b[key];
}
