import {
  clearCurve as clearCommand, movePoints, placePoint, replaceCurve, resetHandles, setKinds,
  setSpace as setSpaceCommand, turnHandle,
} from "../../document/curve/commands.ts";
import {
  baseCount, domainLength, lengthOf, noOffset, nothingSelected, pointAt, type Contour, type CurveDocument, type Kind, type Offset, type PointRef, type Selection,
  type Side, type Space,
} from "../../document/document.ts";
import { decimalsIn } from "../../document/unit.ts";
import { unitOf } from "../../kernel/unit.ts";
import { lengthOfOffset } from "../../document/curve/offset.ts";
import type { Editor, EditorState } from "../editor.ts";

/** The edits that tools, keys and panels share. Each is one entry in the history unless a gesture is open. */

export const mostPoints = 256;

function selectionOf(editor: Editor): Selection {
  return editor.state.value.selection;
}

/** The contours that the panel's controls act on: those with chosen points, or all where none is chosen. */
export function activeContours({ curve, selection }: Pick<EditorState, "curve" | "selection">): readonly number[] {
  if (selection.points.length === 0) return [...curve.contours.keys()];
  const found = known.get(selection) ?? [...new Set(selection.points.map(({ contour }) => contour))];
  // A drag of very many points asks anew in every frame.
  known.set(selection, found);
  return found;
}

const known = new WeakMap<Selection, readonly number[]>();

/** The contour that is looked at point by point: the chosen point's, else the first. */
export function activeContour(editor: Editor): number {
  return selectionOf(editor).points[0]?.contour ?? 0;
}

export function say(editor: Editor, text: string): void {
  editor.notify({ kind: "toast", text });
}

/** Refuses in the hint line and aloud, without an entry in the history. */
export function refuse(editor: Editor, text: string): void {
  editor.patch({ hint: text });
  editor.notify({ kind: "announce", text });
}

/** A distance in document units as the page prints it. */
export function printed(distance: number): string {
  if (distance === 0) return "0";
  return distance < 1e-4 ? distance.toExponential(0) : String(Number(distance.toPrecision(2)));
}

/** Points of interpolating curves have no handles and so no kinds; says so once for all. */
function hasNoHandles(editor: Editor, selection: Selection): boolean {
  const [first] = selection.points;
  if (first === undefined || editor.state.value.curve.contours[first.contour]?.family !== "interpolating") return false;
  refuse(editor, "Interpolating points have no handles: the curve runs smoothly through them.");
  return true;
}

export function setKind(editor: Editor, kind: Kind): void {
  if (hasNoHandles(editor, selectionOf(editor))) return;
  if (selectionOf(editor).points.length > 0) editor.dispatch(setKinds(selectionOf(editor), kind));
}

/** Cusps become smooth, anything else a cusp. */
export function toggleCusp(editor: Editor, selection: Selection = selectionOf(editor)): void {
  const first = selection.points[0];
  const point = first === undefined ? undefined : pointAt(editor.state.value.curve, first);
  if (point === undefined || hasNoHandles(editor, selection)) return;
  const kind: Kind = point.kind === "cusp" ? "smooth" : "cusp";
  editor.dispatch({ ...setKinds(selection, kind), select: selection });
  editor.notify({ kind: "announce", text: `Point ${(first?.index ?? 0) + 1} is now ${kind === "cusp" ? "a cusp" : "smooth"}` });
}

export function setPoint(editor: Editor, ref: PointRef, place: { x?: number; y?: number }, run?: string): void {
  editor.dispatch(placePoint(ref, place, run));
}

/**
 * Counter-clockwise from 3 o'clock, as people draw angles; the screen's y points down. What rounding puts just below
 * the left is 180, not −180.
 */
export function degreesOf({ dx, dy }: Offset): number {
  const degrees = (Math.atan2(0 - dy, dx) * 180) / Math.PI;
  return degrees < -179.995 ? 180 : degrees;
}

/** Length in document units, angle in degrees counter-clockwise from 3 o'clock, as the inspector prints them. */
export function setHandlePolar(editor: Editor, ref: PointRef, side: Side, polar: { length?: number; angle?: number }, run?: string): void {
  const point = pointAt(editor.state.value.curve, ref);
  if (point === undefined) return;
  const old = point[side];
  const length = polar.length ?? lengthOfOffset(old);
  const angle = polar.angle === undefined ? Math.atan2(old.dy, old.dx) : (-polar.angle * Math.PI) / 180;
  editor.dispatch(turnHandle(ref, side, { dx: length * Math.cos(angle), dy: length * Math.sin(angle) }, undefined, run));
}

export function resetSelectedHandles(editor: Editor, selection: Selection = selectionOf(editor)): void {
  if (hasNoHandles(editor, selection)) return;
  if (selection.points.length > 0) editor.dispatch(resetHandles(selection));
}

/**
 * Moves what is chosen by so many of the drawing's units: the handle, if one is, else the points. A quick run of nudges
 * is one entry.
 */
export function nudge(editor: Editor, right: number, down: number): void {
  const { curve, selection } = editor.state.value;
  const { handle } = selection;
  const unit = unitOf(curve);
  const [dx, dy] = [right * unit, down * unit];
  if (handle !== null) {
    const point = pointAt(curve, handle);
    if (point === undefined) return;
    const old = point[handle.side];
    editor.dispatch(turnHandle(handle, handle.side, { dx: old.dx + dx, dy: old.dy + dy }, undefined, "nudge-handle"));
  } else if (selection.points.length > 0) {
    const name = selection.points.map((ref) => `${ref.contour}:${ref.index}`).join(",");
    editor.dispatch(movePoints(selection, dx, dy, `nudge ${name}`));
  }
}

/** Refined places are for moving points; what renumbers the contour waits until they are gone. */
export function hasPlaces(editor: Editor, contour: Contour | undefined): boolean {
  if (contour?.places === undefined) return false;
  refuse(editor, "This contour has refined areas. Select a finer point and press Delete to remove its area first.");
  return true;
}

/** Control points near the curve come and go with the level only. */
export function isRefined(editor: Editor, contour: Contour): boolean {
  if (hasPlaces(editor, contour)) return true;
  if (contour.grid === undefined) return false;
  refuse(editor, "These points belong to a finer level. Go to level 0 to add or remove points.");
  return true;
}

/** Moves below this, in document units, are rounding and nobody's edit. */
export const unnoticed = 1e-6;

export function setSpace(editor: Editor, space: Space): void {
  editor.dispatch(setSpaceCommand(space));
}

export function clearCurve(editor: Editor): void {
  if (editor.state.value.curve.contours.length === 0) return;
  editor.dispatch(clearCommand());
  // It belongs to a sample's lesson: around every ellipse of one's own drawing it would only clutter.
  editor.setOverlay("bezier", false);
}

/** Puts a whole drawing in place of the present one, undoably. */
export function loadCurve(editor: Editor, name: string, curve: CurveDocument): void {
  editor.dispatch(replaceCurve(name, curve));
}

/** Chooses every point of one kind: what the legend's rows do. */
export function selectKind(editor: Editor, kind: Kind | "point"): void {
  const points = editor.state.value.curve.contours.flatMap((contour, c) =>
    contour.points.flatMap((point, index) => (kind === "point" ? point.kind !== "cusp" : point.kind === kind) ? [{ contour: c, index }] : []),
  );
  editor.patch({ selection: { points, handle: null }, hint: "" });
}

export function selectAll(editor: Editor): void {
  const points = editor.state.value.curve.contours.flatMap((contour, c) => contour.points.map((_, index) => ({ contour: c, index })));
  editor.patch({ selection: { points, handle: null }, hint: "" });
}

export function selectNone(editor: Editor): void {
  editor.patch({ selection: nothingSelected, hint: "" });
}

/** Steps from point to point through all contours. `extend` keeps what was chosen. */
export function stepSelection(editor: Editor, step: 1 | -1, extend: boolean): void {
  const { curve, selection } = editor.state.value;
  const all = curve.contours.flatMap((contour, c) => contour.points.map((_, index) => ({ contour: c, index })));
  const last = selection.points[selection.points.length - 1];
  const at = last === undefined ? (step === 1 ? -1 : 0) : all.findIndex((ref) => ref.contour === last.contour && ref.index === last.index);
  const next = all[(at + step + all.length) % all.length];
  if (next === undefined) return;
  const kept = extend ? selection.points.filter((ref) => ref.contour !== next.contour || ref.index !== next.index) : [];
  chooseByKeyboard(editor, { points: [...kept, next], handle: null });
}

export function selectEnd(editor: Editor, which: "first" | "last"): void {
  const { curve } = editor.state.value;
  const contour = which === "first" ? 0 : curve.contours.length - 1;
  const count = curve.contours[contour]?.points.length ?? 0;
  if (count > 0) chooseByKeyboard(editor, { points: [{ contour, index: which === "first" ? 0 : count - 1 }], handle: null });
}

/** The chosen point itself, its arriving handle, its leaving handle, and round again. */
export function stepPart(editor: Editor, step: 1 | -1): void {
  const { selection } = editor.state.value;
  const point = selection.points[selection.points.length - 1];
  if (point === undefined) return;
  const parts: readonly (Side | null)[] = [null, "in", "out"];
  const at = parts.indexOf(selection.handle?.side ?? null);
  const side = parts[(at + step + parts.length) % parts.length] ?? null;
  chooseByKeyboard(editor, { points: [point], handle: side === null ? null : { ...point, side } });
}

function chooseByKeyboard(editor: Editor, selection: Selection): void {
  editor.patch({ selection, keyboard: true, hint: "" });
  const ref = selection.handle ?? selection.points[selection.points.length - 1];
  if (ref !== undefined) editor.notify({ kind: "announce", text: describe(editor.state.value.curve, ref, selection.handle?.side) });
}

/** "Point 3 of 8, smooth, x 240, y 120": the name of a proxy and what a screen reader hears. */
export function describe(curve: CurveDocument, ref: PointRef, side?: Side): string {
  const contour = curve.contours[ref.contour];
  const point = pointAt(curve, ref);
  if (contour === undefined || point === undefined) return "";
  const where = curve.contours.length > 1 ? ` of contour ${ref.contour + 1}` : "";
  const finer = ref.index - baseCount(contour);
  const name = finer >= 0
    ? `Finer point ${finer + 1} of ${contour.points.length - baseCount(contour)}${where}`
    : `Point ${ref.index + 1} of ${baseCount(contour)}${where}`;
  const kind = contour.family === "hermite" ? point.kind : contour.grid === undefined && finer < 0 ? "on the curve" : "near the curve";
  if (side === undefined) return `${name}, ${kind}, x ${short(point.x, unitOf(curve))}, y ${short(point.y, unitOf(curve))}`;
  const offset = point[side] ?? noOffset;
  return `${side === "in" ? "Arriving" : "Leaving"} handle of ${name.toLowerCase()}, length ${short(lengthOfOffset(offset), unitOf(curve))}, angle ${short(degreesOf(offset), 1)}°`;
}

function short(value: number, unit: number): string {
  return String(Number(value.toFixed(decimalsIn(unit, 2))) + 0);
}

/** The parameter in the middle of a contour's segment. */
export function middleOf(contour: Contour, segment: number): number {
  let t = lengthOf(contour, segment) / 2;
  for (let before = 0; before < segment; before += 1) t += lengthOf(contour, before);
  return Math.min(t, domainLength(contour));
}
