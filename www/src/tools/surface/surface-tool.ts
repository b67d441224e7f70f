import { isChosen, noNetPoints, sameNetPoint, type NetRef } from "../../document/surface.ts";
import type { ScreenPoint } from "../../editor/camera.ts";
import { nothingSketched } from "../../editor/create-editor.ts";
import type { Editor } from "../../editor/editor.ts";
import { netHit } from "../../editor/surface/net-hit.ts";
import { lengthOf, shifted, stepAlong, stepInView, turned, type Orbit, type Vector } from "../../editor/surface/orbit.ts";
import type { DragAxis } from "../../editor/surface/solid.ts";
import { axisVector, chooseNet, moved, patchSolid, shownPoint, toggleChosen } from "../../editor/surface/surface-edits.ts";
import { distanceBetween, dragThreshold, type Drag, type PointerSample, type Tool } from "../../editor/tool.ts";

/** Surface mode's pointer: control points are dragged, everything else turns the view. */

export interface SurfaceTool extends Tool {
  /** X, Y, Z in the middle of a drag: holds it to an axis, and pressed again lets it go. False while nothing is dragged. */
  hold(axis: DragAxis): boolean;
}

type State =
  | { readonly kind: "idle" }
  | { readonly kind: "pressing"; readonly start: PointerSample; readonly hit: NetRef | null }
  | { readonly kind: "dragging"; readonly drag: Drag };

export function createSurfaceTool(editor: Editor): SurfaceTool {
  let state: State = { kind: "idle" };
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

  return {
    hover(sample) {
      const { solid, cursor } = editor.state.value;
      const hit = netHit(editor.state.value, sample.screen, sample.kind);
      const same = hit === null ? solid.hover === null : solid.hover !== null && sameNetPoint(hit, solid.hover);
      const wanted = hit === null ? "default" : "move";
      if (!same) patchSolid(editor, { hover: hit });
      if (cursor !== wanted) editor.patch({ cursor: wanted });
    },
    press(sample) {
      last = sample;
      state = { kind: "pressing", start: sample, hit: netHit(editor.state.value, sample.screen, sample.kind) };
    },
    drag(sample) {
      last = sample;
      if (state.kind === "pressing") {
        if (distanceBetween(sample.screen, state.start.screen) < dragThreshold[sample.kind]) return;
        state = { kind: "dragging", drag: state.hit === null ? look(state.start) : dragNet(state.start, state.hit) };
      }
      if (state.kind === "dragging") state.drag.update(sample);
    },
    release(sample) {
      const ended = state;
      state = { kind: "idle" };
      if (ended.kind === "dragging") {
        ended.drag.update(sample);
        ended.drag.finish(sample);
      } else if (ended.kind === "pressing") {
        if (ended.hit === null) {
          if (!sample.modifiers.shift) chooseNet(editor, noNetPoints);
        } else if (sample.modifiers.shift) toggleChosen(editor, ended.hit);
        else chooseNet(editor, [ended.hit]);
      }
    },
    cancel() {
      const ended = state;
      state = { kind: "idle" };
      if (ended.kind === "dragging") ended.drag.cancel();
      return ended.kind !== "idle";
    },
    finish: () => false,
    hold(axis) {
      if (state.kind !== "dragging" || last === null || editor.state.value.solid.drag === null) return false;
      held = held === axis ? null : axis;
      state.drag.update({ ...last, modifiers: editor.state.value.modifiers });
      return true;
    },
  };
}
