import { refuse } from "../../editor/edits.ts";
import type { Editor } from "../../editor/editor.ts";
import type { Tool } from "../../editor/tool.ts";

/** Freehand needs the sparse fit, which this release does not have: the tool says so instead of drawing a bad curve. */
export function createDrawTool(editor: Editor): Tool {
  return {
    hover() {
      if (editor.state.value.cursor !== "not-allowed") editor.patch({ cursor: "not-allowed", hover: { kind: "empty" } });
    },
    press() {
      refuse(editor, "Freehand drawing arrives with Fit. The pen (P) places points today.");
    },
    drag: () => undefined,
    release: () => undefined,
    cancel: () => false,
    finish: () => false,
  };
}
