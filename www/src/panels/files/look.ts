import type { CurveDocument, Mode } from "../../document/document.ts";
import type { FileLook } from "../page-io.ts";

/**
 * Whether a file shows areas of ink, holes left out, rather than lines. Logos and what was traced are areas wherever they
 * are edited; the samples teach curves, and a line that is open encloses nothing.
 */
function isOfAreas({ contours, filling, sample }: CurveDocument, mode: Mode): boolean {
  return filling !== "none" && (mode === "trace" || sample === undefined) && contours.every(({ closed }) => closed);
}

/** How a file shows a drawing, where nobody says otherwise. */
export function lookOf(curve: CurveDocument, mode: Mode): FileLook & { readonly filled: boolean } {
  const { artboard, filling } = curve;
  return { filled: isOfAreas(curve, mode), ...(filling === undefined ? {} : { filling }), ...(artboard === undefined ? {} : { artboard }) };
}
