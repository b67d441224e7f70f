import { movePoints, turnHandle } from "../../document/curve/commands.ts";
import { isSelected, pointAt, type PointRef, type Selection } from "../../document/document.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import type { DragReadout, Editor, EditorPatch, Guide } from "../../editor/editor.ts";
import { constrained, snapHandle, snapPlace, turnedBySteps } from "../../editor/pointer/snapping.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";
import { curveDrag } from "./curve-drag.ts";

/** Moving points; with Alt, pulling fresh symmetric handles out of the point that was pressed. */
export function dragPoints(editor: Editor, start: PointerSample, pressed: PointRef): Drag {
  const chosen = editor.state.value.selection;
  const selection: Selection = isSelected(chosen, pressed) ? { points: chosen.points, handle: null } : { points: [pressed], handle: null };
  const origin = pointAt(editor.state.value.curve, pressed);
  // Without handles there is nothing to pull out.
  const plain = editor.state.value.curve.contours[pressed.contour]?.family === "interpolating";
  editor.begin(selection.points.length === 1 ? "Move point" : "Move points");
  editor.patch({ selection });

  function move(sample: PointerSample): void {
    const { curve, settings, view } = editor.state.value;
    let step = { dx: sample.page.x - start.page.x, dy: sample.page.y - start.page.y };
    let guides = nothingSketched.guides;
    let snapped: string | null = null;
    if (sample.modifiers.shift) {
      step = constrained(step.dx, step.dy);
    } else if (settings.snap && !sample.modifiers.mod && origin !== undefined) {
      const found = snapPlace(curve, selection, { x: origin.x + step.dx, y: origin.y + step.dy }, view.zoom, settings.overlays.grid ? settings.gridStep : null);
      if (found.to !== null) step = { dx: found.value.x - origin.x, dy: found.value.y - origin.y };
      guides = found.guides;
      snapped = found.to;
    }
    editor.preview({ ...movePoints(selection, step.dx, step.dy), select: selection }, shown(sample, guides, { ...step, snapped }, "move"));
  }

  function pull(sample: PointerSample): void {
    const { settings, view } = editor.state.value;
    if (origin === undefined) return;
    let offset = { dx: sample.page.x - origin.x, dy: sample.page.y - origin.y };
    let guides = nothingSketched.guides;
    let snapped: string | null = null;
    if (sample.modifiers.shift) {
      offset = turnedBySteps(offset);
    } else if (settings.snap && !sample.modifiers.mod) {
      const found = snapHandle(origin, offset, null, view.zoom);
      offset = found.value;
      guides = found.guides;
      snapped = found.to;
    }
    const select: Selection = { points: [pressed], handle: null };
    editor.preview({ ...turnHandle(pressed, "out", offset, "symmetric"), select }, shown(sample, guides, { ...offset, snapped }, "crosshair"));
  }

  function shown(sample: PointerSample, guides: readonly Guide[], drag: DragReadout, cursor: string): EditorPatch {
    return { drag, cursor, sketch: { ...nothingSketched, guides, finger: sample.kind === "touch" ? sample.page : null } };
  }

  return curveDrag(editor, (sample) => {
    if (sample.modifiers.alt && !plain) pull(sample);
    else move(sample);
  });
}
