import { inkLayers } from "../../document/curve/inks.ts";
import type { CurveDocument, Mode } from "../../document/document.ts";
import type { Editor } from "../../editor/editor.ts";
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

/** What a file of areas has of each colour, the lowest first; nothing where there is only ink. */
export function layersOf({ modes, state }: Editor, curve: CurveDocument): readonly { readonly color?: string; readonly drawing: CurveDocument }[] {
  const traced = modes.get(state.value.mode)?.layers?.(state.value);
  if (traced !== undefined) return traced;
  const inked = inkLayers(curve).map(({ ink, drawing }) => (ink === undefined ? { drawing } : { color: ink, drawing }));
  return inked.some(({ color }) => color !== undefined) ? inked : [];
}
