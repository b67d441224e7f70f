import { replaceContour, type Command } from "../../document/curve/commands.ts";
import { addContours, closeContour, duplicateContours, reverseContour, startContourAt, restacked } from "../../document/curve/whole/commands.ts";
import { withoutPoints } from "../../document/curve/whole/rearranging.ts";
import { baseCount, lengthOf, nothingSelected, segmentCount, type Contour, type PointRef, type Selection } from "../../document/document.ts";
import { healed, inserted, resampled } from "../../kernel/curve/points/contours.ts";
import { withoutPlaces } from "../../kernel/curve/fine-places.ts";
import { closedRefined } from "../../kernel/curve/interpolating.ts";
import { insertedInterpolating, removedInterpolating, resampledInterpolating } from "../../kernel/curve/points/interpolating.ts";
import { largestMove } from "../../kernel/curve/samples.ts";
import { activeContours, hasPlaces, isRefined, mostPoints, printed, refuse, say, unnoticed } from "./edits.ts";
import type { Editor } from "../editor.ts";

/**
 * Edits that change which points a contour has: one more, fewer, another number of them, another first one, the other
 * way round, closed or open.
 */

/** As many points as a file may bring. */
const mostInserted = 100_000;

/** Inserts a point at parameter `t` without changing the curve, and chooses it. */
export function insertAt(editor: Editor, contour: number, t: number): void {
  const { curve } = editor.state.value;
  const before = curve.contours[contour];
  if (before === undefined) return;
  if (before.points.length >= mostInserted) return refuse(editor, `A contour can have at most ${mostInserted} points.`);
  if (isRefined(editor, before)) return;
  const isHermite = before.family === "hermite";
  const result: { contour: Contour; index: number; moved?: number } | null = isHermite ? inserted(curve, before, t) : insertedInterpolating(curve, before, t);
  if (result === null) return refuse(editor, "There is already a point here.");
  editor.dispatch({
    name: "Insert point",
    apply: (document) => replaceContour(document, contour, result.contour),
    select: { points: [{ contour, index: result.index }], handle: null },
  });
  const { moved = 0 } = result;
  say(
    editor,
    `Point ${result.index + 1} inserted. ${moved <= unnoticed ? "The curve did not move." : `The curve moved by at most ${printed(moved)}; use Level to refine without moving it.`}`,
  );
}

/** Midway to the next point after the chosen one. */
export function insertAfterSelected(editor: Editor): void {
  const ref = editor.state.value.selection.points[0];
  const contour = editor.state.value.curve.contours[ref?.contour ?? -1];
  if (ref === undefined || contour === undefined) return;
  const segment = Math.min(ref.index, segmentCount(contour) - 1);
  let t = lengthOf(contour, segment) / 2;
  for (let before = 0; before < segment; before += 1) t += lengthOf(contour, before);
  insertAt(editor, ref.contour, t);
}

/** Chosen points of each contour, last first, so that taking one away does not renumber those still to go. */
function chosenByContour(selection: Selection): Map<number, number[]> {
  const map = new Map<number, number[]>();
  for (const { contour, index } of selection.points) map.set(contour, [...(map.get(contour) ?? []), index]);
  for (const list of map.values()) list.sort((a, b) => b - a);
  return map;
}

/** Takes the chosen points away and lets their neighbours' handles close the gap with the least change of shape. */
export function deleteAndHeal(editor: Editor): void {
  const { curve, selection } = editor.state.value;
  const chosen = chosenByContour(selection);
  const contours: Contour[] = [];
  let [deviation, gone] = [0, 0];
  let stay: PointRef | null = null;
  for (const [c, contour] of curve.contours.entries()) {
    const indices = chosen.get(c) ?? [];
    if (indices.length > 0 && indices.length === contour.points.length) {
      // All of it: there is nothing left to heal.
      gone += indices.length;
      continue;
    }
    let rest = contour;
    const fine = indices.filter((index) => index >= baseCount(contour));
    if (fine.length > 0) {
      const result = withoutPlaces(curve, contour, fine);
      deviation = Math.max(deviation, result.moved);
      gone += 1;
      contours.push(result.contour);
      continue;
    }
    if (indices.length > 0 && isRefined(editor, contour)) return;
    for (const index of indices) {
      const result = rest.points.length <= 2 ? null : rest.family === "hermite" ? healed(curve, rest, index) : removedInterpolating(curve, rest, index);
      if (result === null) {
        const least = rest.family === "interpolating" && rest.closed ? "A closed interpolating contour needs three points" : "A contour needs two points";
        return refuse(editor, `${least}. Select them all to delete it, or press Shift+Delete to open it.`);
      }
      rest = result.contour;
      deviation = Math.max(deviation, result.deviation);
      gone += 1;
    }
    contours.push(rest);
    const lowest = indices[indices.length - 1];
    if (stay === null && lowest !== undefined) stay = { contour: contours.length - 1, index: Math.min(lowest, rest.points.length - 1) };
  }
  if (gone === 0) return;
  editor.dispatch({
    name: gone === 1 ? "Delete point" : `Delete ${gone} points`,
    apply: (document) => ({ ...document, contours }),
    select: stay === null ? nothingSelected : { points: [stay], handle: null },
  });
  const what = gone === 1 ? "Point deleted." : `${gone} points deleted.`;
  say(editor, stay !== null || deviation > 0 ? `${what} The curve moved by at most ${printed(deviation)}.` : what);
}

/** Takes the chosen points away and leaves the gaps open. */
export function deleteAndOpen(editor: Editor): void {
  const { curve, selection } = editor.state.value;
  const chosen = chosenByContour(selection);
  if (chosen.size === 0) return;
  if (curve.contours.some((contour, c) => chosen.has(c) && isRefined(editor, contour))) return;
  const contours = curve.contours.flatMap((contour, c) => withoutPoints(curve, contour, chosen.get(c) ?? []));
  editor.dispatch({ name: "Delete and open", apply: (document) => ({ ...document, contours }), select: nothingSelected });
  const gone = selection.points.length;
  const wasClosed = [...chosen.keys()].some((contour) => curve.contours[contour]?.closed === true);
  say(editor, `${gone === 1 ? "Point deleted." : `${gone} points deleted.`}${wasClosed && contours.length > 0 ? " The path is now open there." : ""}`);
}

/** The one active contour with another number of points, at equal parameters. */
export function resample(editor: Editor, count: number, run?: string): void {
  const { curve } = editor.state.value;
  const [index = 0, ...others] = activeContours(editor.state.value);
  const contour = curve.contours[index];
  if (contour === undefined || others.length > 0) return;
  const isHermite = contour.family === "hermite";
  // A contour that came with more points than are set here still gets one more.
  const most = Math.max(mostPoints, Math.min(mostInserted, contour.points.length + 1));
  const points = Math.max(isHermite ? 2 : 3, Math.min(most, Math.round(count)));
  if (contour.points.length === points || contour.points.length < 2 || isRefined(editor, contour)) return;
  const next = isHermite ? resampled(curve, contour, points) : resampledInterpolating(curve, contour, points);
  editor.dispatch({
    name: "Points",
    apply: (document) => ({ ...replaceContour(document, index, next), level: 0 }),
    select: nothingSelected,
    ...(run === undefined ? {} : { run }),
  });
  const moved = largestMove(curve, contour, next);
  if (moved > unnoticed) say(editor, `${points} points: the curve moved by up to ${printed(moved)}.`);
}

/** All active contours that can be; refuses where none can. */
export function setClosed(editor: Editor, closed: boolean): void {
  const { curve } = editor.state.value;
  const others = activeContours(editor.state.value).flatMap((index) => {
    const contour = curve.contours[index];
    return contour === undefined || contour.closed === closed ? [] : [{ index, contour }];
  });
  if (others.length === 0 || others.some(({ contour }) => hasPlaces(editor, contour))) return;
  const able = others.filter(({ contour }) => contour.points.length >= (closed ? 2 : 3));
  if (able.length === 0) return refuse(editor, closed ? "A closed contour needs two points." : "Opening removes the last segment, and this contour has too few points.");
  let moved = 0;
  const steps = able.map(({ index, contour }): Command => {
    const step = closeContour(index, closed);
    if (contour.grid === undefined) return step;
    const refined = closedRefined(curve, contour, closed);
    moved = Math.max(moved, refined.moved);
    return { ...step, apply: (document) => replaceContour(document, index, refined.contour) };
  });
  const [{ name } = { name: "" }] = steps;
  editor.dispatch({
    name,
    apply: (document) => steps.reduce((now, step) => step.apply(now), document),
    ...(able.some(({ contour }) => contour.grid !== undefined) ? { select: nothingSelected } : {}),
  });
  if (moved > unnoticed) say(editor, `Edits to the finer points were lost: the curve moved by up to ${printed(moved)}.`);
}

export function duplicate(editor: Editor): void {
  const { curve, selection, view } = editor.state.value;
  const indices = [...chosenByContour(selection).keys()];
  if (indices.length === 0) return;
  const copies = duplicateContours(indices, 16 / view.zoom).copies(curve);
  editor.dispatch(addContours("Duplicate", copies, true));
}

function restack(editor: Editor, end: "front" | "back"): void {
  editor.dispatch(restacked([...chosenByContour(editor.state.value.selection).keys()], editor.state.value.selection, end));
}

export function toFront(editor: Editor): void {
  restack(editor, "front");
}

export function toBack(editor: Editor): void {
  restack(editor, "back");
}

export function reverse(editor: Editor, indices = activeContours(editor.state.value)): void {
  const { curve } = editor.state.value;
  if (indices.length === 0 || indices.some((index) => hasPlaces(editor, curve.contours[index]))) return;
  const steps = indices.map(reverseContour);
  editor.dispatch({ name: "Reverse", apply: (document) => steps.reduce((now, step) => step.apply(now), document), select: nothingSelected });
}

export function startHere(editor: Editor): void {
  const ref = editor.state.value.selection.points[0];
  if (ref !== undefined && ref.index > 0 && !hasPlaces(editor, editor.state.value.curve.contours[ref.contour])) editor.dispatch(startContourAt(ref));
}
