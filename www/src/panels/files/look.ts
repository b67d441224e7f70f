import { paintLayers, type PaintedPath, type PaintLayer } from "../../document/paint-layers.ts";
import { isPainted, noInk } from "../../document/painted.ts";
import type { Contour, CurveDocument, Mode } from "../../document/document.ts";
import type { Editor } from "../../editor/editor.ts";
import type { FileLook } from "../page-io.ts";

/**
 * Whether a file shows areas of ink, holes left out, and lines as wide as they are, rather than thin lines only. Logos
 * and what was traced are areas wherever they are edited; the samples teach curves, and a line that is open encloses
 * nothing.
 */
function isOfAreas({ contours, filling, sample }: CurveDocument, mode: Mode): boolean {
  if (contours.some(({ line }) => line !== undefined)) return true;
  if (filling === "none" || (mode !== "trace" && sample !== undefined)) return false;
  // Where areas have colours, what is open is a line beside them.
  return contours.some(isArea) && (contours.every(({ closed, ink }) => closed || ink === noInk) || contours.some((contour) => isArea(contour) && contour.ink !== undefined));
}

/** How a file shows a drawing, where nobody says otherwise. */
export function lookOf(curve: CurveDocument, mode: Mode): FileLook & { readonly filled: boolean } {
  const { artboard, filling } = curve;
  return { filled: isOfAreas(curve, mode), ...(filling === undefined ? {} : { filling }), ...(artboard === undefined ? {} : { artboard }) };
}

function isArea({ closed, ink }: Contour): boolean {
  return closed && ink !== noInk;
}

/** A path of a file that is not printed yet. */
export type PaintedDrawing = Omit<PaintedPath, "d"> & { readonly drawing: CurveDocument };

/**
 * What a file of areas has of each colour, and the lines among them, the lowest first; nothing where there is only ink.
 */
export function layersOf({ modes, state }: Editor, curve: CurveDocument): readonly PaintedDrawing[] {
  const traced = modes.get(state.value.mode)?.layers?.(state.value);
  if (traced !== undefined) return traced;
  const layers = paintLayers(curve);
  return layers.some(isPainted) ? layers.flatMap(areasAndLines) : [];
}

function areasAndLines({ ink, line, drawing }: PaintLayer): PaintedDrawing[] {
  const has = (contour: Contour): boolean => drawing.filling !== "none" && isArea(contour);
  const along = line === undefined ? {} : { line };
  const areas = { ...(ink === undefined ? {} : { color: ink }), ...along, drawing: { ...drawing, contours: drawing.contours.filter(has) } };
  const lines = { isLine: true, ...along, drawing: { ...drawing, contours: drawing.contours.filter((contour) => !has(contour)) } };
  return [areas, lines].filter((each) => each.drawing.contours.length > 0);
}
