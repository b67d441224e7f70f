import { movePoints, type Command } from "../../document/curve/commands.ts";
import type { Offset, Selection } from "../../document/document.ts";
import { isStraight } from "../../document/curve/straight.ts";
import { bend, type Segment } from "../../editor/curve/bending.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import type { Editor } from "../../editor/editor.ts";
import { constrained } from "../../editor/pointer/snapping.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";
import { curveDrag } from "./curve-drag.ts";

/**
 * Dragging the curve itself. A curved segment bends under the pointer; a straight one, and one without handles, goes
 * along with both its points. Alt does the other.
 */
export function dragSegment(editor: Editor, start: PointerSample, selection: Selection, segment: Segment): Drag {
  const { curve } = editor.state.value;
  const contour = curve.contours[segment.contour];
  const curved = contour !== undefined && !isStraight(contour, segment.index);
  editor.begin(curved ? "Bend segment" : "Move segment");
  editor.patch({ selection });

  function change(step: Offset, other: boolean): Command {
    const bent = curved === other ? null : bend(curve, segment, step);
    return bent ?? { ...movePoints(selection, step.dx, step.dy), name: "Move segment", select: selection };
  }

  return curveDrag(editor, (sample) => {
    let step = { dx: sample.page.x - start.page.x, dy: sample.page.y - start.page.y };
    if (sample.modifiers.shift) step = constrained(step.dx, step.dy);
    const command = change(step, sample.modifiers.alt);
    editor.preview(command, {
      drag: { ...step, snapped: null },
      cursor: command.name === "Move segment" ? "move" : "grabbing",
      sketch: { ...nothingSketched, finger: sample.kind === "touch" ? sample.page : null },
    });
  });
}
