import { extentOf, meshOf } from "../../kernel/surface/surface-mesh.ts";
import { firstMet } from "../../kernel/surface/surface-sight.ts";
import type { Editor } from "../editor.ts";
import type { ModeView } from "../mode.ts";
import type { ScreenPoint } from "../pointer/camera.ts";
import { trackPinch } from "../pointer/pinch.ts";
import { add, dollied, fittingDistance, shifted, sightThrough, type Orbit, type Vector } from "./orbit.ts";
import { fitSurface, patchSolid } from "./surface-edits.ts";

/** How the surface is looked at: wheel and pinch dolly, the right button and two fingers pan. */
export function surfaceView(editor: Editor): ModeView {
  const fitting = (): number => {
    const { surface, stage } = editor.state.value;
    return fittingDistance(extentOf(surface), stage);
  };
  // Moving a point changes how large the surface is, but not how it is looked at.
  const full = (): number => {
    const { solid, stage } = editor.state.value;
    return fittingDistance({ radius: solid.full }, stage);
  };
  const see = (orbit: Orbit): void => patchSolid(editor, { orbit });
  // Of the surface, so that coming closer does not lead through it; beside it, as far away as what one turns about.
  const seenAt = (at: ScreenPoint | null, orbit = editor.state.value.solid.orbit): Vector => {
    const { surface, solid, stage } = editor.state.value;
    const { eye, along } = sightThrough(orbit, stage, at ?? { x: stage.width / 2, y: stage.height / 2 });
    const mesh = meshOf(surface, solid.tessellation, false);
    return add(eye, along, (mesh === null ? null : firstMet(mesh, eye, along)) ?? orbit.distance);
  };
  return {
    pan(dx, dy) {
      const { solid, stage } = editor.state.value;
      see(shifted(solid.orbit, stage, dx, dy));
    },
    zoom(factor, at) {
      see(dollied(editor.state.value.solid.orbit, factor, fitting(), seenAt(at)));
    },
    zoomTo(zoom) {
      const { orbit } = editor.state.value.solid;
      see(dollied(orbit, (zoom * orbit.distance) / full(), fitting(), seenAt(null)));
    },
    fit: () => fitSurface(editor),
    get zoomNow() {
      return full() / editor.state.value.solid.orbit.distance;
    },
    pinch(a, b) {
      const { solid, stage } = editor.state.value;
      let at: Vector | null = null;
      return trackPinch(a, b, ({ ratio, dx, dy, centre }) => {
        at ??= seenAt(centre, solid.orbit);
        const orbit = shifted(dollied(solid.orbit, ratio, fitting(), at), stage, dx, dy, at);
        return { solid: { ...editor.state.value.solid, orbit } };
      });
    },
  };
}
