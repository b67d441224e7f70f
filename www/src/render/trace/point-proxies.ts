import { toScreen } from "../../editor/pointer/camera.ts";
import type { Editor, EditorState } from "../../editor/editor.ts";
import type { Frame } from "../../editor/frame.ts";
import { choosePoint, describePoint, drawingOf } from "../../editor/trace/trace-edits.ts";
import { showsPoints } from "../../editor/trace/trace-hit.ts";
import type { PointOfOutline } from "../../editor/trace/trace-state.ts";

/** The outlines' points for those who do not see them: a button for each at its place, named by its kind. */

/** Of more than this, only those of the outline that the chosen point is on. */
const mostProxies = 256;

interface Shown {
  readonly element: HTMLButtonElement;
  ref: PointOfOutline;
  label: string;
  place: string;
}

export function createPointProxies(editor: Editor, frame: Frame, surface: HTMLElement, layer: HTMLElement, until: AbortSignal): void {
  let shown: Shown[] = [];
  let drawn: Pick<EditorState, "trace" | "traceRun" | "traceView" | "view" | "stage" | "mode"> | null = null;

  function make(ref: PointOfOutline): Shown {
    const element = document.createElement("button");
    const proxy: Shown = { element, ref, label: "", place: "" };
    element.type = "button";
    element.className = "proxy";
    element.tabIndex = -1;
    element.addEventListener("click", () => choosePoint(editor, proxy.ref));
    layer.append(element);
    return proxy;
  }

  function wanted(state: EditorState): PointOfOutline[] {
    const drawing = state.mode === "trace" && showsPoints(state) ? drawingOf(state) : null;
    if (drawing === null) return [];
    const all = drawing.contours.flatMap(({ points }, contour) => points.map((_, index) => ({ contour, index })));
    if (all.length <= mostProxies) return all;
    const own = state.traceView.chosen?.contour;
    return all.filter(({ contour }) => contour === own).slice(0, mostProxies);
  }

  function paint(): void {
    const state = editor.state.value;
    const { trace, traceRun, traceView, view, stage, mode } = state;
    if (drawn !== null && drawn.trace === trace && drawn.traceRun === traceRun && drawn.traceView === traceView && drawn.view === view && drawn.stage === stage
      && drawn.mode === mode) return;
    drawn = { trace, traceRun, traceView, view, stage, mode };
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
      const label = describePoint(state, ref);
      if (proxy.label !== label) proxy.element.setAttribute("aria-label", (proxy.label = label));
      proxy.element.dataset["testid"] = `trace-point-${ref.contour}-${ref.index}`;
      const at = toScreen(view, stage, point);
      const place = `translate(${at.x - 12}px, ${at.y - 12}px)`;
      if (proxy.place !== place) proxy.element.style.transform = proxy.place = place;
      const active = traceView.chosen?.contour === ref.contour && traceView.chosen.index === ref.index;
      proxy.element.tabIndex = active ? 0 : -1;
      if (active) target = proxy;
    });
    if (mode !== "trace") return;
    surface.tabIndex = target === undefined ? 0 : -1;
    if (target !== undefined && state.keyboard && surface.contains(document.activeElement)) target.element.focus({ preventScroll: true });
  }

  editor.state.subscribe(() => frame.request(), { until });
  frame.add("paint", paint);
  until.addEventListener("abort", () => (shown = []), { once: true });
}
