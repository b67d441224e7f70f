import type { Editor } from "../../editor/editor.ts";
import { addPoint } from "../../editor/fit/fit-edits.ts";
import { toPage } from "../../editor/pointer/camera.ts";
import type { PointerSample } from "../../editor/tool.ts";
import { choose } from "./choosing.ts";

/**
 * A click on a knot chooses it, any other places a point; where `begins` holds, as the first of a new stroke. Says
 * whether the next one is.
 */
export function placePoint(editor: Editor, sample: PointerSample, begins: boolean): boolean {
  if (choose(editor, sample)) return begins;
  // The second of two quick presses ends the stroke that the first has put its last point on.
  if (sample.clicks > 1) return true;
  const { view, stage, fit } = editor.state.value;
  const { x, y } = toPage(view, stage, sample.screen);
  addPoint(editor, [x, y], begins || fit.data.length === 0 || fit.sample !== undefined);
  return false;
}
