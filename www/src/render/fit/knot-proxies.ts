import { toScreen } from "../../editor/pointer/camera.ts";
import type { Editor, EditorState } from "../../editor/editor.ts";
import { describeKnot, setFitView } from "../../editor/fit/fit-edits.ts";
import type { Frame } from "../../editor/frame.ts";

/** The knots for those who do not see them: a button for each at its place, named by its kind. */

/** Of more than this the legend and the numbers are the better picture. */
const mostProxies = 256;

interface Shown {
  readonly element: HTMLButtonElement;
  label: string;
  place: string;
}

export function createKnotProxies(editor: Editor, frame: Frame, surface: HTMLElement, layer: HTMLElement, until: AbortSignal): void {
  let shown: Shown[] = [];
  let drawn: Pick<EditorState, "fitRun" | "view" | "stage" | "mode" | "fitView"> | null = null;

  function make(i: number): Shown {
    const element = document.createElement("button");
    element.type = "button";
    element.className = "proxy";
    element.tabIndex = -1;
    element.dataset["testid"] = `knot-${i}`;
    element.addEventListener("click", () => {
      setFitView(editor, { chosen: [i] });
      editor.patch({ keyboard: true });
    });
    layer.append(element);
    return { element, label: "", place: "" };
  }

  function paint(): void {
    const { fitRun, view, stage, mode, fitView } = editor.state.value;
    if (drawn !== null && drawn.fitRun === fitRun && drawn.view === view && drawn.stage === stage && drawn.mode === mode && drawn.fitView === fitView) return;
    drawn = { fitRun, view, stage, mode, fitView };
    const all = mode === "fit" ? (fitRun.outcome?.knots ?? []) : [];
    const knots = all.length > mostProxies ? [] : all;
    for (const { element } of shown.splice(knots.length)) element.remove();
    const active = fitView.chosen.at(-1);
    knots.forEach((knot, i) => {
      const proxy = shown[i] ?? make(i);
      shown[i] = proxy;
      const label = describeKnot(knot, i, knots.length);
      if (proxy.label !== label) proxy.element.setAttribute("aria-label", (proxy.label = label));
      const at = toScreen(view, stage, knot);
      const place = `translate(${at.x - 12}px, ${at.y - 12}px)`;
      if (proxy.place !== place) proxy.element.style.transform = proxy.place = place;
      proxy.element.tabIndex = i === active ? 0 : -1;
    });
    if (mode !== "fit") return;
    const target = active === undefined ? undefined : shown[active];
    surface.tabIndex = target === undefined ? 0 : -1;
    if (target !== undefined && editor.state.value.keyboard && surface.contains(document.activeElement)) target.element.focus({ preventScroll: true });
  }

  editor.state.subscribe(() => frame.request(), { until });
  frame.add("paint", paint);
  until.addEventListener("abort", () => (shown = []), { once: true });
}
