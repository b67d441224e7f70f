import { turnHandle } from "../../document/curve/commands.ts";
import { pointAt, type HandleRef, type Kind, type Selection } from "../../document/document.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import type { Editor } from "../../editor/editor.ts";
import { snapHandle, turnedBySteps } from "../../editor/pointer/snapping.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";
import { curveDrag } from "./curve-drag.ts";

/**
 * Turning and stretching a handle. Its partner follows as the point's kind asks. While Alt is held the point is a cusp
 * and the partner stays; letting go of Alt before the pointer links them again.
 */
export function dragHandle(editor: Editor, start: PointerSample, handle: HandleRef): Drag {
  const origin = pointAt(editor.state.value.curve, handle);
  const { selection: before } = editor.state.value;
  const { contour, index, side } = handle;
  const chosen = before.points.some((ref) => ref.contour === contour && ref.index === index);
  const selection: Selection = { points: chosen ? before.points : [{ contour, index }], handle };
  editor.begin("Turn handle");
  editor.patch({ selection });

  return curveDrag(editor, (sample) => {
    if (origin === undefined) return;
    const { settings, view } = editor.state.value;
    const breaks = sample.modifiers.alt;
    const old = origin[side];
    let offset = { dx: old.dx + sample.page.x - start.page.x, dy: old.dy + sample.page.y - start.page.y };
    let guides = nothingSketched.guides;
    let snapped: string | null = null;
    if (sample.modifiers.shift) {
      offset = turnedBySteps(offset);
    } else if (settings.snap && !sample.modifiers.mod) {
      // Only a free partner can be lined up with: a linked one follows anyway.
      const free = breaks || origin.kind === "cusp";
      const found = snapHandle(origin, offset, free ? origin[side === "out" ? "in" : "out"] : null, view.zoom);
      offset = found.value;
      guides = found.guides;
      snapped = found.to;
    }
    const kind: Kind = breaks ? "cusp" : origin.kind;
    editor.preview({ ...turnHandle(handle, side, offset, kind), select: selection }, {
      drag: { dx: offset.dx - old.dx, dy: offset.dy - old.dy, snapped },
      cursor: breaks ? "alias" : "grabbing",
      sketch: { ...nothingSketched, guides, finger: sample.kind === "touch" ? sample.page : null },
    });
  });
}
