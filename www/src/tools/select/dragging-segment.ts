import { movePoints } from "../../document/commands.ts";
import type { Selection } from "../../document/document.ts";
import { nothingSketched } from "../../editor/create-editor.ts";
import type { Editor } from "../../editor/editor.ts";
import { constrained } from "../../editor/snapping.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";

/** Dragging the curve itself: both points of the segment go along, so that it stays under the pointer. */
export function dragSegment(editor: Editor, start: PointerSample, selection: Selection): Drag {
  editor.begin("Move segment");
  editor.patch({ selection });
  return {
    update(sample) {
      let step = { dx: sample.page.x - start.page.x, dy: sample.page.y - start.page.y };
      if (sample.modifiers.shift) step = constrained(step.dx, step.dy);
      editor.preview({ ...movePoints(selection, step.dx, step.dy), name: "Move segment", select: selection }, { drag: { ...step, snapped: null }, cursor: "move", sketch: { ...nothingSketched, finger: sample.kind === "touch" ? sample.page : null } });
    },
    finish() {
      editor.commit();
      editor.patch({ drag: null, sketch: nothingSketched });
    },
    cancel() {
      editor.bail();
      editor.patch({ drag: null, sketch: nothingSketched });
    },
  };
}
