import type { CurveDocument, Mode } from "../../document/document.ts";

/**
 * Whether a file shows areas of ink, holes left out, rather than lines. Logos and what was traced are areas wherever they
 * are edited; the samples teach curves, and a line that is open encloses nothing.
 */
export function isOfAreas({ contours, sample }: CurveDocument, mode: Mode): boolean {
  return (mode === "trace" || sample === undefined) && contours.every(({ closed }) => closed);
}
