import { isChosen, noNetPoints, sameNetPoint, type NetRef } from "../../document/surface/surface.ts";
import type { ScreenPoint } from "../../editor/pointer/camera.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import type { Editor } from "../../editor/editor.ts";
import { netHit } from "../../editor/surface/net-hit.ts";
import { lengthOf, shifted, stepAlong, stepInView, turned, type Orbit, type Vector } from "../../editor/surface/orbit.ts";
import type { DragAxis } from "../../editor/surface/solid.ts";
import { axisVector, chooseNet, moved, patchSolid, shownPoint, toggleChosen } from "../../editor/surface/surface-edits.ts";
import type { Drag, PointerSample, Tool } from "../../editor/tool.ts";
import { pressOrDrag } from "../press-or-drag.ts";

/** Surface mode's pointer: control points are dragged, everything else turns the view. */

export interface SurfaceTool extends Tool {
  /** X, Y, Z in the middle of a drag: holds it to an axis, and pressed again lets it go. False while nothing is dragged. */
  hold(axis: DragAxis): boolean;
}

export function createSurfaceTool(editor: Editor): SurfaceTool {
  let held: DragAxis | null = null;
  let last: PointerSample | null = null;

  function dragNet(start: PointerSample, hit: NetRef): Drag {
    const before = editor.state.value.chosen;
    const points = isChosen(before, hit) ? before : [hit];
    const { surface, solid, stage } = editor.state.value;
    const origin = shownPoint(surface, hit);
    held = null;
    editor.surfaceEdits.begin(points.length === 1 ? "Move control point" : "Move control points");
    chooseNet(editor, points);

    function wayOf(sample: PointerSample): { axis: DragAxis; step: Vector } {
      const [dx, dy] = [sample.screen.x - start.screen.x, sample.screen.y - start.screen.y];
      const axis = held ?? (sample.modifiers.shift ? "normal" : solid.axis);
      if (origin === undefined) return { axis, step: [0, 0, 0] };
      const along = axisVector(axis, origin);
      return { axis, step: along === null ? stepInView(solid.orbit, stage, origin.at, dx, dy) : stepAlong(solid.orbit, stage, origin.at, along, dx, dy) };
    }

    return {
      update(sample) {
        const { axis, step } = wayOf(sample);
        try {
          editor.surfaceEdits.preview((from) => moved(from, points, step));
        } catch {
          // Too far for the library: the drag is held at the last good place.
          return;
        }
        const [x, y, z] = step.map((value) => value.toFixed(3));
        const name = axis === "view" ? "" : axis === "normal" ? "  ·  along the normal" : `  ·  along ${axis.toUpperCase()}`;
        editor.patch({ hint: `Δx ${x ?? 0}  Δy ${y ?? 0}  Δz ${z ?? 0}${name}  ·  ${lengthOf(step).toFixed(3)}`, cursor: "grabbing" });
        patchSolid(editor, { drag: { points, axis } });
      },
      finish() {
        editor.surfaceEdits.commit();
        rest();
      },
      cancel() {
        editor.surfaceEdits.bail();
        rest();
      },
    };
  }

  function rest(): void {
    held = null;
    patchSolid(editor, { drag: null, turning: false });
    editor.patch({ hint: "", cursor: "default", sketch: nothingSketched });
  }

  function look(start: PointerSample): Drag {
    const before: Orbit = editor.state.value.solid.orbit;
    let at: ScreenPoint = start.screen;
    return {
      update(sample) {
        const [dx, dy] = [sample.screen.x - at.x, sample.screen.y - at.y];
        at = sample.screen;
        const { solid, stage } = editor.state.value;
        const orbit = sample.modifiers.shift ? shifted(solid.orbit, stage, dx, dy) : turned(solid.orbit, dx, dy);
        patchSolid(editor, { orbit, turning: true });
        editor.patch({ cursor: "grabbing" });
      },
      finish: rest,
      cancel() {
        patchSolid(editor, { orbit: before });
        rest();
      },
    };
  }

  const gestures = pressOrDrag<NetRef | null>({
    hit: (sample) => netHit(editor.state.value, sample.screen, sample.kind),
    begin: (start, hit) => (hit === null ? look(start) : dragNet(start, hit)),
    click(hit, { modifiers }) {
      if (hit !== null && modifiers.shift) toggleChosen(editor, hit);
      else if (hit !== null) chooseNet(editor, [hit]);
      else if (!modifiers.shift) chooseNet(editor, noNetPoints);
    },
  });

  return {
    hover(sample) {
      const { solid, cursor } = editor.state.value;
      const hit = netHit(editor.state.value, sample.screen, sample.kind);
      const same = hit === null ? solid.hover === null : solid.hover !== null && sameNetPoint(hit, solid.hover);
      const wanted = hit === null ? "default" : "move";
      if (!same) patchSolid(editor, { hover: hit });
      if (cursor !== wanted) editor.patch({ cursor: wanted });
    },
    ...gestures,
    press(sample) {
      last = sample;
      gestures.press(sample);
    },
    drag(sample) {
      last = sample;
      gestures.drag(sample);
    },
    finish: () => false,
    hold(axis) {
      const drag = gestures.current();
      if (drag === null || last === null || editor.state.value.solid.drag === null) return false;
      held = held === axis ? null : axis;
      drag.update({ ...last, modifiers: editor.state.value.modifiers });
      return true;
    },
  };
}
