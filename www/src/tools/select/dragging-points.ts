import { movePoints, turnHandle, type Command } from "../../document/curve/commands.ts";
import { isEnd, isSelected, pointAt, type PointRef, type Selection } from "../../document/document.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import type { PagePoint } from "../../editor/pointer/camera.ts";
import type { DragReadout, Editor, EditorPatch, Guide } from "../../editor/editor.ts";
import { onDemand } from "../../editor/loading.ts";
import { constrained, gridOf, snapHandle, snapPlace, turnedBySteps } from "../../editor/pointer/snapping.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";
import { curveDrag } from "./curve-drag.ts";

/** What joins an end to the one that it is dropped on: few drags are of an end. */
const dropping = onDemand(() => import("./dropping-ends.ts"));

/** Moving points; with Alt, pulling fresh symmetric handles out of the point that was pressed. */
export function dragPoints(editor: Editor, start: PointerSample, pressed: PointRef): Drag {
  const chosen = editor.state.value.selection;
  const selection: Selection = isSelected(chosen, pressed) ? { points: chosen.points, handle: null } : { points: [pressed], handle: null };
  const origin = pointAt(editor.state.value.curve, pressed);
  // Without handles there is nothing to pull out.
  const plain = editor.state.value.curve.contours[pressed.contour]?.family === "interpolating";
  let dropped: typeof import("./dropping-ends.ts").dropped | null = null;
  /** What letting go would join. */
  let join: Command | null = null;
  if (selection.points.length === 1 && isEnd(editor.state.value.curve, pressed)) dropping(editor, (loaded) => ({ dropped } = loaded));
  editor.begin(selection.points.length === 1 ? "Move point" : "Move points");
  editor.patch({ selection });

  function move(sample: PointerSample): void {
    const { curve, settings, view } = editor.state.value;
    let step = { dx: sample.page.x - start.page.x, dy: sample.page.y - start.page.y };
    let guides = nothingSketched.guides;
    let snapped: string | null = null;
    let onto: PointRef | undefined;
    if (sample.modifiers.shift) {
      step = constrained(step.dx, step.dy);
    } else if (settings.snap && !sample.modifiers.mod && origin !== undefined) {
      const found = snapPlace(curve, selection, { x: origin.x + step.dx, y: origin.y + step.dy }, view.zoom, gridOf(editor.state.value));
      if (found.to !== null) step = { dx: found.value.x - origin.x, dy: found.value.y - origin.y };
      ({ guides, onto, to: snapped } = found);
    }
    const moving = movePoints(selection, step.dx, step.dy);
    join = onto === undefined ? null : (dropped?.(curve, moving, pressed, onto) ?? null);
    if (join !== null) snapped = `${snapped}: let go to join`;
    const joint = join === null || onto === undefined ? null : (pointAt(curve, onto) ?? null);
    editor.preview({ ...moving, select: selection }, shown(sample, guides, { ...step, snapped }, "move", joint));
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

  function shown(sample: PointerSample, guides: readonly Guide[], drag: DragReadout, cursor: string, joint: PagePoint | null = null): EditorPatch {
    return { drag, cursor, sketch: { ...nothingSketched, guides, joint, finger: sample.kind === "touch" ? sample.page : null } };
  }

  return curveDrag(editor, (sample) => {
    join = null;
    if (sample.modifiers.alt && !plain) pull(sample);
    else move(sample);
  }, () => {
    if (join === null) return editor.commit();
    editor.bail();
    editor.dispatch(join);
  });
}
