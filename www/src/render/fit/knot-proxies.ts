import { toScreen } from "../../editor/pointer/camera.ts";
import type { Editor, EditorState } from "../../editor/editor.ts";
import { describeKnot, setFitView } from "../../editor/fit/fit-edits.ts";
import type { Frame } from "../../editor/frame.ts";
import { createProxy, mostProxies, paintOn, showProxy, type Proxy } from "../proxy.ts";

/** The knots for those who do not see them: a button for each at its place, named by its kind. */

export function createKnotProxies(editor: Editor, frame: Frame, surface: HTMLElement, layer: HTMLElement, until: AbortSignal): void {
  let shown: Proxy[] = [];

  function make(i: number): Proxy {
    return createProxy(layer, `knot-${i}`, () => {
      setFitView(editor, { chosen: [i] });
      editor.patch({ keyboard: true });
    });
  }

  function paint({ fitRun, view, stage, mode, fitView, keyboard }: EditorState): void {
    const all = mode === "fit" ? (fitRun.outcome?.knots ?? []) : [];
    // Of very many the legend and the numbers are the better picture.
    const knots = all.length > mostProxies ? [] : all;
    for (const { element } of shown.splice(knots.length)) element.remove();
    const active = fitView.chosen.at(-1);
    knots.forEach((knot, i) => {
      const proxy = shown[i] ?? make(i);
      shown[i] = proxy;
      showProxy(proxy, describeKnot(knot, i, knots.length), toScreen(view, stage, knot), i === active);
    });
    if (mode !== "fit") return;
    const target = active === undefined ? undefined : shown[active];
    surface.tabIndex = target === undefined ? 0 : -1;
    if (target !== undefined && keyboard && surface.contains(document.activeElement)) target.element.focus({ preventScroll: true });
  }

  paintOn(editor, frame, ["fitRun", "view", "stage", "mode", "fitView"], paint, until);
  until.addEventListener("abort", () => (shown = []), { once: true });
}
