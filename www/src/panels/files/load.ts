import type { Contour } from "../../document/document.ts";
import type { Imported } from "../../document/imported.ts";
import { addDrawing } from "../../editor/curve/adding/drawing.ts";
import { whileLoading } from "../../editor/loading.ts";
import { routeOf } from "../../editor/route.ts";
import type { Shell } from "../shell.ts";
import { report } from "./report.ts";

export type Placement = "replace" | "add";

/** Where drawings go: Curve, to be edited, or Fit, to be made simpler. */
export type Destination = "curve" | "fit";

/** A sample as it was opened gives way to what is brought in; anything that was worked on is added to. */
export function naturalPlacement({ editor }: Shell, to: Destination): Placement {
  return routeOf(editor, to).sample === null ? "add" : "replace";
}

export function naturalDestination({ editor }: Shell): Destination {
  return editor.state.value.mode === "fit" ? "fit" : "curve";
}

/**
 * Puts what was read on the stage, in view, as one step of the history; offers the other place that a drawing can go
 * to.
 */
export async function place(shell: Shell, imported: Imported, to: Destination, how?: Placement | "offered"): Promise<void> {
  const { editor, toasts } = shell;
  if (imported.kind === "json") {
    editor.setState(imported.state);
    toasts.say(["File opened.", ...imported.notes].join(" "));
    return;
  }
  const placement = how === undefined || how === "offered" ? naturalPlacement(shell, to) : how;
  if (to === "fit") await placeInFit(editor, imported, placement);
  else placeInCurve(editor, imported, placement);
  const says = [summary(imported.contours), ...notesFor(editor, imported, to).map((note) => `Note: ${note}.`)].join(" ");
  // Where it has come from on taking the offer, it is already.
  toasts.say(says, how === "offered"
    ? undefined
    : { label: offers(imported.kind, to), run: () => void place(shell, imported, to === "fit" ? "curve" : "fit", "offered").catch((error: unknown) => report(shell, error)) });
}

/** What was read leniently, and which way y points where that of numbers may be meant otherwise. */
function notesFor({ state }: Shell["editor"], { kind, notes }: Drawn, to: Destination): readonly string[] {
  if (kind !== "points") return notes;
  const isUp = to === "fit" && state.value.fit.up === true;
  return [...notes, isUp ? "y points up, as in a chart; Y axis in the panel turns it over" : "y points down, as in drawings"];
}

function offers(kind: Drawn["kind"], to: Destination): string {
  if (to === "fit") return "Edit in Curve";
  return kind === "points" ? "Fit the points" : "Simplify in Fit";
}

type Drawn = Exclude<Imported, { kind: "json" }>;

async function placeInFit(editor: Shell["editor"], { contours, kind, ...setting }: Drawn, how: Placement): Promise<void> {
  const { bringContours } = await whileLoading(editor, import("../../editor/fit/bring.ts"));
  bringContours(editor, contours, kind === "points", { instead: how === "replace" ? "all" : "nothing", setting });
}

function placeInCurve(editor: Shell["editor"], drawing: Drawn, how: Placement): void {
  if (editor.state.value.mode !== "curve") editor.actions.run("mode-curve");
  addDrawing(editor, "Import", drawing, how);
  // What belongs to a sample's lesson would only clutter a drawing of one's own.
  editor.setOverlay("bezier", false);
  editor.setOverlay("comb", false);
  editor.patch({ hint: "" });
  editor.actions.run("zoom-fit");
}

function summary(contours: readonly Contour[]): string {
  const points = contours.reduce((sum, contour) => sum + contour.points.length, 0);
  return `Imported ${contours.length === 1 ? "1 contour" : `${contours.length} contours`}, ${points} points.`;
}

/** Reads a text. A path that breaks off counts as failure here. @throws Problem */
export async function readWhole(shell: Shell, text: string): Promise<Imported> {
  const imported = await shell.io.readImport(text, shell.editor.state.value.curve.space);
  if (imported.kind !== "json" && imported.broken !== null) throw imported.broken;
  return imported;
}
