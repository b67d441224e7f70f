import type { Contour } from "../../document/document.ts";
import type { Imported } from "../../document/imported.ts";
import { addContours } from "../../editor/curve/edits.ts";
import { routeOf } from "../../editor/route.ts";
import type { Shell } from "../shell.ts";
import { report } from "./report.ts";

/** A sample as it was opened gives way to what is brought in; anything that was worked on is added to. */
export function naturalPlacement({ editor }: Shell): Placement {
  return routeOf(editor).sample === null ? "add" : "replace";
}

export type Placement = "replace" | "add";

/** Puts what was read on the stage, in view, as one step of the history. */
export function place(shell: Shell, imported: Imported, how: Placement): void {
  const { editor, toasts } = shell;
  if (imported.kind === "json") {
    editor.setState(imported.state);
    toasts.say(["Opened the file.", ...imported.notes].join(" "));
    return;
  }
  const bring = editor.modes.get(editor.state.value.mode)?.bring;
  if (bring !== undefined) {
    bring(editor.state.value.curve, imported.contours, imported.kind);
    toasts.say([summary(imported.contours), ...imported.notes.map((note) => `Note: ${note}.`)].join(" "));
    return;
  }
  if (editor.state.value.mode !== "curve") editor.actions.run("mode-curve");
  addContours(editor, "Import", imported.contours, how);
  // What belongs to a sample's lesson would only clutter a drawing of one's own.
  editor.setOverlay("bezier", false);
  editor.setOverlay("comb", false);
  editor.patch({ hint: "" });
  editor.actions.run("zoom-fit");
  toasts.say([summary(imported.contours), ...imported.notes.map((note) => `Note: ${note}.`)].join(" "));
}

function summary(contours: readonly Contour[]): string {
  const points = contours.reduce((sum, contour) => sum + contour.points.length, 0);
  return `Imported ${contours.length === 1 ? "1 contour" : `${contours.length} contours`}, ${points} points.`;
}

/** Reads a text or reports why not; nothing changes on failure. A path that breaks off counts as failure here. */
export async function readOrReport(shell: Shell, text: string): Promise<Imported | null> {
  try {
    const imported = await shell.io.readImport(text, shell.editor.state.value.curve.space);
    if (imported.kind !== "json" && imported.broken !== null) throw imported.broken;
    return imported;
  } catch (error) {
    report(shell, error);
    return null;
  }
}
