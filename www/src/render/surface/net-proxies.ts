import { sameNetPoint, type NetRef } from "../../document/surface/surface.ts";
import type { Editor, EditorState } from "../../editor/editor.ts";
import type { Frame } from "../../editor/frame.ts";
import { projector } from "../../editor/surface/orbit.ts";
import { chooseNet, describeNet, facesAway } from "../../editor/surface/surface-edits.ts";
import { netPoints, type ShownPoint } from "../../kernel/surface/surface-mesh.ts";

/** A named button for every control point of the surface, at its place: the stage stays one stop of Tab. */

const mostProxies = 256;

export function proxyId({ u, v, detail }: NetRef): string {
  return detail === undefined ? `cp-${u}-${v}` : `cd-${detail}-${u}-${v}`;
}

/** A large net offers the rows of the point that is worked on. */
function wanted({ surface, chosen }: EditorState): readonly ShownPoint[] {
  const all = netPoints(surface);
  if (all.length <= mostProxies) return all;
  const at = chosen.at(-1) ?? { u: 0, v: 0 };
  return all.filter(({ ref }) => ref.detail === at.detail && (ref.u === at.u || ref.v === at.v)).slice(0, mostProxies);
}

export function createNetProxies(editor: Editor, frame: Frame, surface: HTMLElement, until: AbortSignal): void {
  const layer = document.createElement("div");
  layer.className = "stage-proxies";
  surface.append(layer);
  const shown = new Map<string, HTMLButtonElement>();
  let drawn: Partial<EditorState> = {};

  function make(id: string): HTMLButtonElement {
    const element = document.createElement("button");
    element.type = "button";
    element.className = "proxy";
    element.dataset["testid"] = id;
    element.addEventListener("click", () => {
      const point = netPoints(editor.state.value.surface).find(({ ref }) => proxyId(ref) === id);
      if (point !== undefined) chooseNet(editor, [point.ref], true);
    });
    layer.append(element);
    shown.set(id, element);
    return element;
  }

  function paint(): void {
    const state = editor.state.value;
    const { mode, stage, chosen, solid } = state;
    if (drawn.surface === state.surface && drawn.mode === mode && drawn.stage === stage && drawn.chosen === chosen && drawn.solid === solid) return;
    drawn = { surface: state.surface, mode, stage, chosen, solid };
    layer.hidden = mode !== "surface";
    if (mode !== "surface") return;
    const hadFocus = surface.contains(document.activeElement);
    const project = projector(solid.orbit, stage);
    const last = chosen.at(-1);
    const present = new Set<string>();
    let active: HTMLButtonElement | null = null;
    for (const point of wanted(state)) {
      const id = proxyId(point.ref);
      present.add(id);
      const element = shown.get(id) ?? make(id);
      const { x, y } = project(point.at);
      const label = `${describeNet(point)}${facesAway(solid.orbit, point) ? ", facing away" : ""}`;
      if (element.getAttribute("aria-label") !== label) element.setAttribute("aria-label", label);
      element.style.transform = `translate(${x - 12}px, ${y - 12}px)`;
      const isActive = last !== undefined && sameNetPoint(last, point.ref);
      element.tabIndex = isActive ? 0 : -1;
      if (isActive) active = element;
    }
    surface.tabIndex = active === null ? 0 : -1;
    if (hadFocus) moveFocus(active);
    for (const [id, element] of shown) {
      if (present.has(id)) continue;
      element.remove();
      shown.delete(id);
    }
  }

  function moveFocus(active: HTMLButtonElement | null): void {
    const target = active ?? surface;
    if (document.activeElement === target) return;
    // A pointer's press leaves the focus on the stage until a key moves the selection.
    if (target !== surface && !editor.state.value.keyboard && document.activeElement === surface) return;
    target.focus({ preventScroll: true });
  }

  editor.state.subscribe(() => frame.request(), { until });
  frame.add("paint", paint);
}
