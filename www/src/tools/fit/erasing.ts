import type { Editor } from "../../editor/editor.ts";
import { eraseAt, setFitView } from "../../editor/fit/fit-edits.ts";
import type { PointerSample } from "../../editor/tool.ts";
import type { FitPress } from "./fit-press.ts";

/** CSS pixels. */
const brushRadius = 14;

/** Erases from the press on, as one entry of the history. */
export function erase(editor: Editor, start: PointerSample): FitPress {
  editor.fitEdits.begin("Erase");
  eraseUnder(editor, start);
  return {
    drag: (sample) => eraseUnder(editor, sample),
    release: () => editor.fitEdits.commit(),
  };
}

function eraseUnder(editor: Editor, { trail, page }: PointerSample): void {
  for (const { x, y } of trail ?? [page]) eraseAt(editor, x, y, brushRadius / editor.state.value.view.zoom);
  setFitView(editor, { brush: page });
}
