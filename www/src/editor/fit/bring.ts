import type { Contour } from "../../document/document.ts";
import { owned, withStroke, type FitDocument, type Pair } from "../../document/fit/fit.ts";
import { diagonalOf, mostPlaces, placesAlong } from "../../kernel/fit/as-strokes.ts";
import type { Editor } from "../editor.ts";
import { setFitView, showData } from "./fit-edits.ts";

/** Strokes from outside Fit: a file, a drawing of Curve, outlines of Trace. Copies, always. */

export interface Brought {
  /** Of the history's entry. */
  readonly name: string;
  readonly strokes: readonly (readonly Pair[])[];
  /** The largest error that the fit may have: what was drawn exactly has no noise that a smoothing could be measured by. */
  readonly within?: number;
  /** What goes for it beside a sample: nothing, what the same name has brought, or everything. */
  readonly instead?: "nothing" | "same" | "all";
}

/** Data that came under a name, for as long as they are as they came. */
const came = new WeakMap<FitDocument["data"], string>();

export function bringStrokes(editor: Editor, { name, strokes, within, instead = "nothing" }: Brought): void {
  if (editor.state.value.mode !== "fit") editor.actions.run("mode-fit");
  editor.fitEdits.dispatch(name, ({ fit }) => {
    const fresh = instead === "all" || fit.sample !== undefined || fit.data.length === 0;
    const gone = fresh || (instead === "same" && came.get(fit.data) === name);
    const rest: FitDocument = gone ? { ...owned(fit), data: [], starts: [], closing: "auto" } : fit;
    const asked: FitDocument = fresh && within !== undefined ? { ...rest, target: "error", targetError: within } : rest;
    const next = strokes.reduce(withStroke, asked);
    came.set(next.data, name);
    return { fit: next };
  });
  setFitView(editor, { chosen: [] });
  showData(editor, 64);
}

/** Of a drawing's size, the error that a simpler one may have: a unit and a half of one that fills the stage. */
const simpler = 1 / 400;
const apart = 1 / 600;

/** Contours of files: points are what was measured, curves are followed. */
export function bringContours(editor: Editor, contours: readonly Contour[], arePoints: boolean, more: Pick<Brought, "instead"> & { readonly name?: string } = {}): void {
  const named = { name: "Import", ...more };
  if (arePoints) return bringStrokes(editor, { ...named, strokes: contours.map(({ points }) => points.map(({ x, y }): Pair => [x, y])) });
  const { curve } = editor.state.value;
  const size = diagonalOf(curve, contours);
  bringStrokes(editor, { ...named, strokes: placesAlong(curve, contours, apart * size, mostPlaces), within: Number((simpler * size).toPrecision(2)) });
}

/** The drawing in Fit, ready to be simplified: the contours that hold the selection, else all of it. */
export function simplifyInFit(editor: Editor): void {
  const { curve, selection } = editor.state.value;
  const chosen = new Set(selection.points.map((ref) => ref.contour));
  const contours = curve.contours.filter((_, i) => chosen.size === 0 || chosen.has(i));
  bringContours(editor, contours, false, { name: "Simplify", instead: "same" });
  editor.notify({ kind: "toast", text: "The drawing is in Fit: Smoothing takes knots away. The original stays in Curve." });
}
