import { aligned, distributed, type Axis, type Part, type Piece } from "../../document/curve/aligning.ts";
import { pointAt, type PointRef } from "../../document/document.ts";
import { boundsOf } from "../../kernel/curve/samples.ts";
import type { Editor, EditorState } from "../editor.ts";
import { refuse } from "./edits.ts";

/** What is chosen, brought in line or spread evenly. */

function pieceOf({ curve }: EditorState, ref: PointRef): Piece[] {
  const point = pointAt(curve, ref);
  return point === undefined ? [] : [{ points: [ref], minX: point.x, minY: point.y, maxX: point.x, maxY: point.y }];
}

/** Contours that are chosen as a whole are one piece each; of others every chosen point is one. */
function piecesOf(state: EditorState): Piece[] {
  const { curve, selection } = state;
  const chosen = new Map<number, PointRef[]>();
  for (const ref of selection.points) chosen.set(ref.contour, [...(chosen.get(ref.contour) ?? []), ref]);
  return [...chosen].flatMap(([index, points]) => {
    const contour = curve.contours[index];
    // The two points of a single line are what can be levelled about it.
    const isLine = chosen.size === 1 && points.length === 2;
    const box = contour === undefined || isLine || points.length < contour.points.length ? null : boundsOf(curve, contour);
    return box === null ? points.flatMap((ref) => pieceOf(state, ref)) : [{ points, ...box }];
  });
}

/** Puts all pieces in line at one part of each. */
export function align(editor: Editor, axis: Axis, part: Part): void {
  const pieces = piecesOf(editor.state.value);
  if (pieces.length < 2) return refuse(editor, "Select several contours, or several points of one, to align them.");
  editor.dispatch(aligned(pieces, axis, part));
}

/** Makes the gaps between pieces equal. */
export function distribute(editor: Editor, axis: Axis): void {
  const pieces = piecesOf(editor.state.value);
  if (pieces.length < 3) return refuse(editor, "Select at least three contours or points; the outer two stay put.");
  editor.dispatch(distributed(pieces, axis));
}
