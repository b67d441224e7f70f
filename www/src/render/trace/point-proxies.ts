import { toScreen } from "../../editor/pointer/camera.ts";
import type { Editor, EditorState } from "../../editor/editor.ts";
import type { Frame } from "../../editor/frame.ts";
import { choosePoint, describePoint, drawingOf } from "../../editor/trace/trace-edits.ts";
import { showsPoints } from "../../editor/trace/trace-hit.ts";
import type { PointOfOutline } from "../../editor/trace/trace-state.ts";
import { createProxy, mostProxies, paintOn, showProxy, type Proxy } from "../proxy.ts";

/** The outlines' points for those who do not see them: a button for each at its place, named by its kind. */

interface Shown extends Proxy {
  ref: PointOfOutline;
}

export function createPointProxies(editor: Editor, frame: Frame, surface: HTMLElement, layer: HTMLElement, until: AbortSignal): void {
  let shown: Shown[] = [];

  function make(ref: PointOfOutline): Shown {
    const proxy: Shown = { ...createProxy(layer, "", () => choosePoint(editor, proxy.ref)), ref };
    return proxy;
  }

  /** All points, or only those of the outline that the chosen point is on. */
  function wanted(state: EditorState): PointOfOutline[] {
    const drawing = state.mode === "trace" && showsPoints(state) ? drawingOf(state) : null;
    if (drawing === null) return [];
    const all = drawing.contours.flatMap(({ points }, contour) => points.map((_, index) => ({ contour, index })));
    if (all.length <= mostProxies) return all;
    const own = state.traceView.chosen?.contour;
    return all.filter(({ contour }) => contour === own).slice(0, mostProxies);
  }

  function paint(state: EditorState): void {
    const { traceView, view, stage, mode } = state;
    const refs = wanted(state);
    for (const { element } of shown.splice(refs.length)) element.remove();
    const drawing = drawingOf(state);
    let target: Shown | undefined;
    refs.forEach((ref, i) => {
      const proxy = shown[i] ?? make(ref);
      shown[i] = proxy;
      proxy.ref = ref;
      const point = drawing?.contours[ref.contour]?.points[ref.index];
      if (point === undefined) return;
      proxy.element.dataset["testid"] = `trace-point-${ref.contour}-${ref.index}`;
      const active = traceView.chosen?.contour === ref.contour && traceView.chosen.index === ref.index;
      showProxy(proxy, describePoint(state, ref), toScreen(view, stage, point), active);
      if (active) target = proxy;
    });
    if (mode !== "trace") return;
    surface.tabIndex = target === undefined ? 0 : -1;
    if (target !== undefined && state.keyboard && surface.contains(document.activeElement)) target.element.focus({ preventScroll: true });
  }

  paintOn(editor, frame, ["trace", "traceRun", "traceView", "view", "stage", "mode"], paint, until);
  until.addEventListener("abort", () => (shown = []), { once: true });
}
