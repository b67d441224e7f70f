import type { Editor, EditorState } from "../editor/editor.ts";
import type { Frame } from "../editor/frame.ts";

/**
 * Buttons that stand for what the stage shows, for those who do not see it: each is at the place of a point and named
 * as the hint line names it.
 */
export interface Proxy {
  readonly element: HTMLButtonElement;
  label: string;
  place: string;
}

/** The most that are offered; of more, a mode offers those around what is worked on, or none. */
export const mostProxies = 256;

export function createProxy(layer: HTMLElement, testid: string, choose: () => void): Proxy {
  const element = document.createElement("button");
  element.type = "button";
  element.className = "proxy";
  element.tabIndex = -1;
  element.dataset["testid"] = testid;
  element.addEventListener("click", choose);
  layer.append(element);
  return { element, label: "", place: "" };
}

/** Names it and moves it; only what is different is told to the page. */
export function showProxy(proxy: Proxy, label: string, { x, y }: { readonly x: number; readonly y: number }, active: boolean): void {
  const { element } = proxy;
  if (proxy.label !== label) element.setAttribute("aria-label", (proxy.label = label));
  const place = `translate(${x - 12}px, ${y - 12}px)`;
  if (proxy.place !== place) element.style.transform = proxy.place = place;
  const tabIndex = active ? 0 : -1;
  if (element.tabIndex !== tabIndex) element.tabIndex = tabIndex;
}

/**
 * Makes the proxy of the selection, or the stage itself, the one tab stop. The focus follows, but only while it is in
 * the stage.
 */
export function stopAt(editor: Editor, surface: HTMLElement, target: HTMLElement = surface): void {
  surface.tabIndex = target === surface ? 0 : -1;
  const { activeElement } = document;
  if (activeElement === target || !surface.contains(activeElement)) return;
  // A pointer's press has put the focus on the stage itself; it stays there until a key moves the selection.
  if (activeElement === surface && !editor.state.value.keyboard) return;
  target.focus({ preventScroll: true });
}

/** Paints in the next frame when one of these parts of the state is another than it was painted last. */
export function paintOn(editor: Editor, frame: Frame, parts: readonly (keyof EditorState)[], paint: (state: EditorState) => void, until: AbortSignal): void {
  let painted: Partial<EditorState> = {};
  editor.state.subscribe(() => frame.request(), { until });
  frame.add("paint", () => {
    const state = editor.state.value;
    if (parts.every((part) => painted[part] === state[part])) return;
    painted = state;
    paint(state);
  });
}
