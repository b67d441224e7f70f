import type { Editor } from "../../editor/editor.ts";
import { panned } from "../../editor/pointer/camera.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";

/** A finger on empty paper moves the paper. */
export function panWith(editor: Editor, start: PointerSample): Drag {
  const before = editor.state.value.view;
  let last = start.screen;
  return {
    update({ screen }) {
      editor.patch({ view: panned(editor.state.value.view, screen.x - last.x, screen.y - last.y) });
      last = screen;
    },
    finish: () => undefined,
    cancel: () => editor.patch({ view: before }),
  };
}
