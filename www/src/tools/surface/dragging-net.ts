import { isChosen, type NetRef } from "../../document/surface/surface.ts";
import type { Editor } from "../../editor/editor.ts";
import { lengthOf, stepAlong, stepInView, type Vector } from "../../editor/surface/orbit.ts";
import type { DragAxis } from "../../editor/surface/solid.ts";
import { axisVector, chooseNet, moved, patchSolid, shownPoint } from "../../editor/surface/surface-edits.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";
import { rest } from "./resting.ts";

export interface NetDrag extends Drag {
  /** Holds it to an axis; the same once more lets it go. */
  hold(axis: DragAxis): void;
}

/** Moving control points, in the plane of the view or along an axis; Shift moves along the normal. */
export function dragNet(editor: Editor, start: PointerSample, hit: NetRef): NetDrag {
  const { chosen: before, solid } = editor.state.value;
  const points = isChosen(before, hit) ? before : [hit];
  const stepTo = stepsFrom(editor, start, hit);
  let held: DragAxis | null = null;
  let last = start;
  editor.surfaceEdits.begin(points.length === 1 ? "Move control point" : "Move control points");
  chooseNet(editor, points);

  function update(sample: PointerSample): void {
    last = sample;
    const axis = held ?? (sample.modifiers.shift ? "normal" : solid.axis);
    const step = stepTo(sample, axis);
    try {
      editor.surfaceEdits.preview((from) => moved(from, points, step));
    } catch {
      // Too far for the library: the drag is held at the last good place.
      return;
    }
    editor.patch({ hint: readout(step, axis), cursor: "grabbing" });
    patchSolid(editor, { drag: { points, axis } });
  }

  return {
    update,
    hold(axis) {
      held = held === axis ? null : axis;
      update({ ...last, modifiers: editor.state.value.modifiers });
    },
    finish() {
      editor.surfaceEdits.commit();
      rest(editor);
    },
    cancel() {
      editor.surfaceEdits.bail();
      rest(editor);
    },
  };
}

/** How far the point goes with the pointer, seen as it was when it was pressed. */
function stepsFrom(editor: Editor, start: PointerSample, hit: NetRef): (sample: PointerSample, axis: DragAxis) => Vector {
  const { surface, solid: { orbit }, stage } = editor.state.value;
  const origin = shownPoint(surface, hit);
  return ({ screen }, axis) => {
    if (origin === undefined) return [0, 0, 0];
    const [dx, dy] = [screen.x - start.screen.x, screen.y - start.screen.y];
    const along = axisVector(axis, origin);
    return along === null ? stepInView(orbit, stage, origin.at, dx, dy) : stepAlong(orbit, stage, origin.at, along, dx, dy);
  };
}

function readout(step: Vector, axis: DragAxis): string {
  const [x = "0", y = "0", z = "0"] = step.map((value) => value.toFixed(3));
  const name = axis === "view" ? "" : axis === "normal" ? "  ·  along the normal" : `  ·  along ${axis.toUpperCase()}`;
  return `Δx ${x}  Δy ${y}  Δz ${z}${name}  ·  ${lengthOf(step).toFixed(3)}`;
}
