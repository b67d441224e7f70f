import { settingOf, type Setting } from "../../document/artboard.ts";
import type { Contour } from "../../document/document.ts";
import { emptied, withStrokes, type NewStroke, type Pair } from "../../document/fit/fit.ts";
import { diagonalOf, mostPlaces, placesAlong } from "../../kernel/fit/as-strokes.ts";
import type { Editor } from "../editor.ts";
import { base, setFitView, showData } from "./fit-edits.ts";

/** Strokes from outside Fit: a file, a drawing of Curve, outlines of Trace. Copies, always. */

export interface Brought {
  /** Of the history's entry. */
  readonly name: string;
  readonly strokes: readonly NewStroke[];
  /**
   * The largest error that the fit may have: what was drawn exactly has no noise that a smoothing could be measured by.
   */
  readonly within?: number;
  /** Beside a sample, which always gives way: whether everything else does too. */
  readonly instead?: "nothing" | "all";
  /** Whether their y points up. */
  readonly up?: boolean;
  /** Of the drawing that they come from; where Fit has other strokes, theirs stays. */
  readonly setting?: Setting;
}

export function bringStrokes(editor: Editor, { name, strokes, within, instead = "nothing", up = false, setting = {} }: Brought): void {
  if (editor.state.value.mode !== "fit") editor.actions.run("mode-fit");
  editor.fitEdits.dispatch(name, ({ fit }) => {
    const fresh = instead === "all" || fit.sample !== undefined || fit.data.length === 0;
    // Numbers beside others are what they are; a drawing stays upright.
    if (!fresh) return { fit: withStrokes(fit, fit.up === true && !up ? strokes.map(turnedOver) : strokes) };
    // An error in the units of another drawing says nothing of this one.
    const target = within !== undefined ? { target: "error", targetError: within } as const : fit.target === "error" ? { target: "off" } as const : {};
    return { fit: withStrokes({ ...emptied(base(fit)), closing: "auto", ...settingOf(setting), ...target, ...(up ? { up } : {}) }, strokes) };
  });
  setFitView(editor, { chosen: [] });
  showData(editor);
}

function turnedOver({ places, ...paint }: NewStroke): NewStroke {
  return { ...paint, places: places.map(([x, y]): Pair => [x, 0 - y]) };
}

/** Another mode's drawing in place of what Fit holds; said with a way back to what somebody had made there. */
export function handOver(editor: Editor, says: string, bring: () => void): void {
  const { fit } = editor.state.value;
  const own = fit.sample === undefined && fit.data.length > 0;
  bring();
  editor.notify({ kind: "toast", text: own ? `${says} Undo restores what Fit had before.` : says, ...(own ? { actionId: "undo" } : {}) });
}

/** Of a drawing's size, the error that a simpler one may have: a unit and a half of one that fills the stage. */
const simpler = 1 / 400;
const apart = 1 / 600;

/**
 * Contours of files: points are what was measured, with y up as in a chart; curves are followed, and so are points that
 * all end exactly where they began: the rings of a map were drawn.
 */
export function bringContours(editor: Editor, contours: readonly Contour[], arePoints: boolean, more: Pick<Brought, "instead" | "setting"> & { readonly name?: string } = {}): void {
  const named = { name: "Import", ...more };
  const { curve } = editor.state.value;
  const size = diagonalOf(curve, contours);
  const drawn = { ...named, within: Number((simpler * size).toPrecision(2)) };
  if (!arePoints) return bringStrokes(editor, { ...drawn, strokes: placesAlong(curve, contours, apart * size, mostPlaces) });
  bringStrokes(editor, { ...(contours.every(({ closed }) => closed) ? drawn : named), up: true, strokes: contours.map(given) });
}

/** A contour's points as they were given: a closed one ends where it began. */
function given({ points, closed }: Contour): NewStroke {
  const places = points.map(({ x, y }): Pair => [x, y]);
  return { places: closed ? [...places, ...places.slice(0, 1)] : places };
}

/** The drawing alone in Fit, ready to be simplified: the contours that hold the selection, else all of it. */
export function simplifyInFit(editor: Editor): void {
  const { curve, selection } = editor.state.value;
  const chosen = new Set(selection.points.map((ref) => ref.contour));
  const contours = curve.contours.filter((_, i) => chosen.size === 0 || chosen.has(i));
  handOver(editor, "Copied to Fit, where Smoothing removes knots. The original stays in Curve.", () =>
    bringContours(editor, contours, false, { name: "Simplify", instead: "all", setting: curve }));
}
