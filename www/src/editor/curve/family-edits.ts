import { replaceContour } from "../../document/curve/commands.ts";
import { nothingSelected, segmentCount, type Contour, type Family, type Order, type PointRef } from "../../document/document.ts";
import { finePlaceOf, rootsOf, supportOf } from "../../document/curve/roots.ts";
import { inserted } from "../../kernel/curve/points/contours.ts";
import { refinedAround } from "../../kernel/curve/fine-places.ts";
import { asHermite, asInterpolating } from "../../kernel/curve/families.ts";
import { finerInterpolating } from "../../kernel/curve/interpolating.ts";
import { activeContour, hasPlaces, isRefined, middleOf, mostPoints, printed, refuse, say, unnoticed } from "./edits.ts";
import type { Editor } from "../editor.ts";

/** Edits of what a contour is made of: its family, its generator, and where it has more points than elsewhere. */

/** The active contour in the other family, through the same points; says how far the curve moved. */
export function setFamily(editor: Editor, family: Family): void {
  const { curve } = editor.state.value;
  const index = activeContour(editor);
  const contour = curve.contours[index];
  if (contour === undefined || contour.family === family || hasPlaces(editor, contour)) return;
  const least = contour.closed ? 3 : 2;
  if (family === "interpolating" && contour.points.length < least) {
    return refuse(editor, `An interpolating contour needs ${least} points; this one has ${contour.points.length}.`);
  }
  const { contour: next, moved } = family === "hermite" ? asHermite(curve, contour) : asInterpolating(curve, contour);
  // Levels belong to the drawing; a contour of the other family begins at level 0.
  const level = curve.contours.length === 1 ? 0 : curve.level;
  const put = family === "interpolating" && level > 0 ? finerInterpolating(curve, next, level) : next;
  editor.dispatch({
    name: family === "hermite" ? "Hermite family" : "Interpolating family",
    apply: (document) => ({ ...replaceContour(document, index, put), level }),
    select: nothingSelected,
  });
  say(editor, moved <= unnoticed ? "The same curve in the other family." : `The curve moved by at most ${printed(moved)}.`);
}

/** How many roots the active contour's generator has: one more is one more continuous derivative. */
export function setOrder(editor: Editor, order: Order): void {
  const { curve } = editor.state.value;
  const index = activeContour(editor);
  const contour = curve.contours[index];
  if (contour === undefined || contour.family !== "interpolating" || isRefined(editor, contour)) return;
  const { order: _old, roots: _roots, ...plainContour } = contour;
  const next: Contour = { ...plainContour, ...(order === 3 ? {} : { order }) };
  editor.dispatch({ name: "Smoothness", apply: (document) => replaceContour(document, index, { ...next, support: supportOf(document, next) }) });
}

/** Finer control points around a point of an interpolating contour. */
function refinePlace(editor: Editor, ref: PointRef, contour: Contour): void {
  if (contour.grid !== undefined) return refuse(editor, "All of this level is refined already. Go to level 0 to refine one place.");
  const { curve } = editor.state.value;
  const fine = finePlaceOf(contour, ref.index, rootsOf(curve, contour).length);
  const next = refinedAround(curve, contour, fine === null ? ref.index : fine.parameter);
  if (next === null) return;
  const added = next.points.length - contour.points.length;
  editor.dispatch({ name: "Refine here", apply: (document) => replaceContour(document, ref.contour, next), select: nothingSelected });
  say(editor, `${added} finer points here. The curve has not moved.`);
}

/** More points where the chosen ones are, none elsewhere; the curve stays where it is. */
export function refineCurveHere(editor: Editor): void {
  const { curve, selection } = editor.state.value;
  const [first] = selection.points;
  let contour = curve.contours[first?.contour ?? -1];
  if (first === undefined || contour === undefined) return refuse(editor, "Choose a point first: the curve is refined around it.");
  if (contour.family === "interpolating") return refinePlace(editor, first, contour);
  const chosen = new Set(selection.points.filter((ref) => ref.contour === first.contour).map((ref) => ref.index));
  const count = segmentCount(contour);
  const touched = Array.from({ length: count }, (_, segment) => segment).filter((segment) =>
    chosen.has(segment) || chosen.has((segment + 1) % (contour?.points.length ?? 1)));
  if (contour.points.length + touched.length > mostPoints) return refuse(editor, `A contour holds at most ${mostPoints} points here.`);
  // Last first, so that a new point does not renumber the segments still to be cut.
  for (const segment of [...touched].reverse()) contour = inserted(curve, contour, middleOf(contour, segment))?.contour ?? contour;
  const next = contour;
  editor.dispatch({ name: "Refine here", apply: (document) => replaceContour(document, first.contour, next), select: nothingSelected });
  say(editor, `${touched.length === 1 ? "1 point" : `${touched.length} points`} added here. The curve has not moved.`);
}
