import { extentOf } from "../../kernel/surface/surface-mesh.ts";
import type { Editor } from "../editor.ts";
import type { ModeView } from "../mode.ts";
import { trackPinch } from "../pointer/pinch.ts";
import { dollied, fittingDistance, shifted, type Orbit } from "./orbit.ts";
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
  return {
    pan(dx, dy) {
      const { solid, stage } = editor.state.value;
      see(shifted(solid.orbit, stage, dx, dy));
    },
    zoom(factor) {
      see(dollied(editor.state.value.solid.orbit, factor, fitting()));
    },
    zoomTo(zoom) {
      const { orbit } = editor.state.value.solid;
      see(dollied(orbit, (zoom * orbit.distance) / full(), fitting()));
    },
    fit: () => fitSurface(editor),
    get zoomNow() {
      return full() / editor.state.value.solid.orbit.distance;
    },
    pinch(a, b) {
      const { solid, stage } = editor.state.value;
      return trackPinch(a, b, ({ ratio, dx, dy }) => {
        const orbit = shifted(dollied(solid.orbit, ratio, fitting()), stage, dx, dy);
        return { solid: { ...editor.state.value.solid, orbit } };
      });
    },
  };
}
