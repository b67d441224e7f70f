import { replaceContour } from "../../document/curve/commands.ts";
import { setOmega as setOmegaCommand } from "../../document/curve/frequency/frequency.ts";
import { nothingSelected, segmentCount, type Contour, type CurveDocument, type Family, type Order, type PointRef, type Selection } from "../../document/document.ts";
import { finePlaceOf, rootsOf, supportOf } from "../../document/curve/roots.ts";
import { inserted } from "../../kernel/curve/points/contours.ts";
import { refinedAround } from "../../kernel/curve/fine-places.ts";
import { asHermite, asInterpolating } from "../../kernel/curve/families.ts";
import { finerInterpolating } from "../../kernel/curve/interpolating.ts";
import { activeContours, hasPlaces, isRefined, middleOf, mostPoints, printed, refuse, say, unnoticed } from "./edits.ts";
import type { Editor } from "../editor.ts";

/** Edits of what a contour is made of: its family, its generator, and where it has more points than elsewhere. */

/** The active contours in the other family, through the same points; says how far the curve moved. */
export function setFamily(editor: Editor, family: Family): void {
  const { curve } = editor.state.value;
  const chosen = new Set(activeContours(editor.state.value));
  const others = curve.contours.filter((contour, index) => chosen.has(index) && contour.family !== family);
  if (others.length === 0 || others.some((contour) => hasPlaces(editor, contour))) return;
  // Levels belong to the drawing; a contour of the other family begins at level 0.
  const level = curve.contours.length === others.length ? 0 : curve.level;
  let [moved, added] = [0, 0];
  const put = new Map<Contour, Contour>();
  for (const drawn of others) {
    const contour = family === "interpolating" ? withEnoughPoints(curve, drawn) : drawn;
    if (contour === null) return refuse(editor, "An interpolating contour needs at least 2 points.");
    const next = family === "hermite" ? asHermite(curve, contour) : asInterpolating(curve, contour);
    added += contour.points.length - drawn.points.length;
    moved = Math.max(moved, next.moved);
    put.set(drawn, family === "interpolating" && level > 0 ? finerInterpolating(curve, next.contour, level) : next.contour);
  }
  editor.dispatch({
    name: family === "hermite" ? "Hermite family" : "Interpolating family",
    apply: (document) => ({ ...document, contours: document.contours.map((contour) => put.get(contour) ?? contour), level }),
    select: nothingSelected,
  });
  // What was said of the curve as it was is over.
  editor.patch({ hint: "" });
  const more = added === 0 ? "" : `, with ${added} more points (a closed one needs 3)`;
  say(editor, moved <= unnoticed ? `Converted without moving the curve${more}.` : `The curve moved by at most ${printed(moved)}${more}.`);
}

/**
 * A closed contour of two points with one more in the middle of each segment, which changes nothing; any other as it
 * is.
 */
function withEnoughPoints(document: CurveDocument, contour: Contour): Contour | null {
  if (contour.points.length < 2) return null;
  if (!contour.closed || contour.points.length > 2) return contour;
  // The second segment first, so that its new point does not renumber the first one.
  let next: Contour | undefined = contour;
  for (const segment of [1, 0]) next = next && inserted(document, next, middleOf(next, segment))?.contour;
  return next ?? null;
}

/** How many roots the active contours' generators have: one more is one more continuous derivative. */
export function setOrder(editor: Editor, order: Order): void {
  const chosen = new Set(activeContours(editor.state.value));
  const isMeant = ({ family }: Contour, index: number): boolean => chosen.has(index) && family === "interpolating";
  if (editor.state.value.curve.contours.some((contour, index) => isMeant(contour, index) && isRefined(editor, contour))) return;
  const ordered = (document: CurveDocument, { order: _old, roots: _roots, ...plainContour }: Contour): Contour => {
    const next: Contour = { ...plainContour, ...(order === 3 ? {} : { order }) };
    return { ...next, support: supportOf(document, next) };
  };
  editor.dispatch({
    name: "Smoothness",
    apply: (document) => ({ ...document, contours: document.contours.map((contour, index) => (isMeant(contour, index) ? ordered(document, contour) : contour)) }),
  });
}

/** Finer control points around a point of an interpolating contour. */
function refinePlace(editor: Editor, ref: PointRef, contour: Contour): void {
  if (contour.grid !== undefined) return refuse(editor, "This level is refined everywhere. Go to level 0 to refine one area.");
  const { curve } = editor.state.value;
  const fine = finePlaceOf(contour, ref.index, rootsOf(curve, contour).length);
  const next = refinedAround(curve, contour, fine === null ? ref.index : fine.parameter);
  if (next === null) return;
  const added = next.points.length - contour.points.length;
  editor.dispatch({ name: "Refine here", apply: (document) => replaceContour(document, ref.contour, next), select: nothingSelected });
  say(editor, `Added ${added} finer points. The curve did not move.`);
}

/** More points where the chosen ones are, none elsewhere; the curve stays where it is. */
export function refineCurveHere(editor: Editor): void {
  const { curve, selection } = editor.state.value;
  const [first] = selection.points;
  let contour = curve.contours[first?.contour ?? -1];
  if (first === undefined || contour === undefined) return refuse(editor, "Select a point first: refining happens around it.");
  if (contour.family === "interpolating") return refinePlace(editor, first, contour);
  const chosen = new Set(selection.points.filter((ref) => ref.contour === first.contour).map((ref) => ref.index));
  const count = segmentCount(contour);
  const touched = Array.from({ length: count }, (_, segment) => segment).filter((segment) =>
    chosen.has(segment) || chosen.has((segment + 1) % (contour?.points.length ?? 1)));
  if (contour.points.length + touched.length > mostPoints) return refuse(editor, `A contour can have at most ${mostPoints} points.`);
  // Last first, so that a new point does not renumber the segments still to be cut.
  for (const segment of [...touched].reverse()) contour = inserted(curve, contour, middleOf(contour, segment))?.contour ?? contour;
  const next = contour;
  editor.dispatch({ name: "Refine here", apply: (document) => replaceContour(document, first.contour, next), select: nothingSelected });
  say(editor, `Added ${touched.length === 1 ? "1 point" : `${touched.length} points`}. The curve did not move.`);
}

/** The frequency of what was chosen; with nothing chosen, of the drawing. */
export function setOmega(editor: Editor, selection: Selection, omega: number | "auto", run?: string): void {
  editor.dispatch(setOmegaCommand(selection, omega, run));
}
