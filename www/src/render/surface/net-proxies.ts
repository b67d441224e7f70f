import { sameNetPoint, type NetRef } from "../../document/surface/surface.ts";
import type { Editor, EditorState } from "../../editor/editor.ts";
import type { Frame } from "../../editor/frame.ts";
import { projector } from "../../editor/surface/orbit.ts";
import { chooseNet, describeNet, facesAway } from "../../editor/surface/surface-edits.ts";
import { netPoints, type ShownPoint } from "../../kernel/surface/surface-mesh.ts";
import { createProxy, mostProxies, paintOn, showProxy, stopAt, type Proxy } from "../proxy.ts";

/** A named button for every control point of the surface, at its place: the stage stays one stop of Tab. */

function proxyId({ u, v, detail }: NetRef): string {
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
  const shown = new Map<string, Proxy>();

  function make(id: string): Proxy {
    const proxy = createProxy(layer, id, () => {
      const point = netPoints(editor.state.value.surface).find(({ ref }) => proxyId(ref) === id);
      if (point !== undefined) chooseNet(editor, [point.ref], true);
    });
    shown.set(id, proxy);
    return proxy;
  }

  function paint(state: EditorState): void {
    const { mode, stage, chosen, solid } = state;
    layer.hidden = mode !== "surface";
    if (mode !== "surface") return;
    const project = projector(solid.orbit, stage);
    const last = chosen.at(-1);
    const present = new Set<string>();
    let active: HTMLElement | undefined;
    for (const point of wanted(state)) {
      const id = proxyId(point.ref);
      present.add(id);
      const proxy = shown.get(id) ?? make(id);
      const isActive = last !== undefined && sameNetPoint(last, point.ref);
      showProxy(proxy, `${describeNet(point)}${facesAway(solid.orbit, point) ? ", facing away" : ""}`, project(point.at), isActive);
      if (isActive) active = proxy.element;
    }
    stopAt(editor, surface, active);
    for (const [id, { element }] of shown) {
      if (present.has(id)) continue;
      element.remove();
      shown.delete(id);
    }
  }

  paintOn(editor, frame, ["surface", "mode", "stage", "chosen", "solid"], paint, until);
}
