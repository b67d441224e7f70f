import { nothingSketched } from "../../editor/sketch.ts";
import type { Editor } from "../../editor/editor.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";

/** A drag that changes the drawing: one entry of the history when it ends, nothing when it is given up. */
export function curveDrag(editor: Editor, update: (sample: PointerSample) => void, end: () => void = () => editor.commit()): Drag {
  const over = (): void => editor.patch({ drag: null, sketch: nothingSketched });
  return {
    update,
    finish() {
      end();
      over();
    },
    cancel() {
      editor.bail();
      over();
    },
  };
}
