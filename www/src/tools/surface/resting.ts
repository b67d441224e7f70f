import type { Editor } from "../../editor/editor.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import { patchSolid } from "../../editor/surface/surface-edits.ts";

/** Nothing is dragged and nothing turns any more. */
export function rest(editor: Editor): void {
  patchSolid(editor, { drag: null, turning: false });
  editor.patch({ hint: "", cursor: "default", sketch: nothingSketched });
}
