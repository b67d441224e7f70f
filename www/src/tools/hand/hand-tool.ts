import type { Editor } from "../../editor/editor.ts";
import type { Tool } from "../../editor/tool.ts";

/** Panning is done by the pointer input, which every tool shares; the hand only shows the cursor for it. */
export function createHandTool(editor: Editor): Tool {
  return {
    hover() {
      if (editor.state.value.cursor !== "grab") editor.patch({ cursor: "grab", hover: { kind: "empty" } });
    },
    press: () => undefined,
    drag: () => undefined,
    release: () => undefined,
    cancel: () => false,
    finish: () => false,
  };
}
