import type { CurveDocument, HandleRef, PointRef, Side } from "../document/document.ts";
import { toScreen } from "../editor/pointer/camera.ts";
import { describe } from "../editor/curve/edits.ts";
import type { Editor, EditorState } from "../editor/editor.ts";
import type { Frame } from "../editor/frame.ts";
import { shownHandles } from "../editor/pointer/hit-test.ts";

/**
 * The picture for those who do not see it: a button for every point and every shown handle, at its place, named as the
 * hint line names it. The stage is one tab stop; the focus moves inside it with the selection.
 */

const mostProxies = 256;

interface Wanted {
  readonly id: string;
  readonly label: string;
  readonly ref: PointRef;
  readonly side: Side | null;
  readonly x: number;
  readonly y: number;
}

interface Shown {
  readonly element: HTMLButtonElement;
  label: string;
  place: string;
  ref: PointRef;
  side: Side | null;
}

/** A large drawing offers the points of the contour that is being worked on. */
function proxiedContours(curve: CurveDocument, state: EditorState): ReadonlySet<number> {
  const total = curve.contours.reduce((sum, contour) => sum + contour.points.length, 0);
  if (total <= mostProxies) return new Set(curve.contours.keys());
  return new Set([state.selection.points[0]?.contour ?? 0]);
}

/** Of a long contour, the points around the chosen one: the keys that step from point to point bring the others. */
function isNear(index: number, chosen: number, count: number): boolean {
  const away = Math.abs(index - chosen);
  return count <= mostProxies || Math.min(away, count - away) < mostProxies / 2;
}

/** "pt-0-2" for a point, "hin-0-2" and "hout-0-2" for its handles. */
function idOf({ contour, index }: PointRef, side: Side | null): string {
  return `${side === null ? "pt" : `h${side}`}-${contour}-${index}`;
}

function wantedProxies(state: EditorState): Wanted[] {
  if (state.mode !== "curve") return [];
  const { curve, view, stage } = state;
  const shown = proxiedContours(curve, state);
  const handles = shownHandles(state).filter((handle) => shown.has(handle.contour));
  const list: Wanted[] = [];
  curve.contours.forEach((contour, c) => {
    if (!shown.has(c)) return;
    const chosen = state.selection.points.filter((ref) => ref.contour === c).at(-1)?.index ?? 0;
    contour.points.forEach((point, index) => {
      if (!isNear(index, chosen, contour.points.length)) return;
      const ref = { contour: c, index };
      list.push({ id: idOf(ref, null), label: describe(curve, ref), ref, side: null, ...toScreen(view, stage, point) });
      for (const handle of handles) if (handle.contour === c && handle.index === index) list.push(handleProxy(state, handle));
    });
  });
  return list;
}

function handleProxy({ curve, view, stage }: EditorState, handle: HandleRef): Wanted {
  const point = curve.contours[handle.contour]?.points[handle.index];
  const offset = point?.[handle.side] ?? { dx: 0, dy: 0 };
  const place = toScreen(view, stage, { x: (point?.x ?? 0) + offset.dx, y: (point?.y ?? 0) + offset.dy });
  return { id: idOf(handle, handle.side), label: describe(curve, handle, handle.side), ref: handle, side: handle.side, ...place };
}

/** The proxy that stands for the selection: it carries the stage's tab stop. */
function activeId({ selection: { handle, points } }: EditorState): string | null {
  if (handle !== null) return idOf(handle, handle.side);
  const last = points.at(-1);
  return last === undefined ? null : idOf(last, null);
}

export function createProxies(editor: Editor, frame: Frame, surface: HTMLElement, layer: HTMLElement, until: AbortSignal): void {
  const shown = new Map<string, Shown>();
  let drawn: Pick<EditorState, "curve" | "view" | "stage" | "selection" | "mode"> | null = null;
  let handlesShown = true;

  function choose(proxy: Shown): void {
    const { contour, index } = proxy.ref;
    const point = { contour, index };
    editor.patch({ selection: { points: [point], handle: proxy.side === null ? null : { ...point, side: proxy.side } }, keyboard: true });
  }

  function make(wanted: Wanted): Shown {
    const element = document.createElement("button");
    element.type = "button";
    element.className = "proxy";
    element.tabIndex = -1;
    element.dataset["testid"] = wanted.id;
    const proxy: Shown = { element, label: "", place: "", ref: wanted.ref, side: wanted.side };
    element.addEventListener("click", () => choose(proxy));
    layer.append(element);
    return proxy;
  }

  function update(wanted: Wanted, active: string | null): void {
    const proxy = shown.get(wanted.id) ?? make(wanted);
    shown.set(wanted.id, proxy);
    proxy.ref = wanted.ref;
    proxy.side = wanted.side;
    if (proxy.label !== wanted.label) {
      proxy.label = wanted.label;
      proxy.element.setAttribute("aria-label", wanted.label);
    }
    const place = `translate(${wanted.x - 12}px, ${wanted.y - 12}px)`;
    if (proxy.place !== place) {
      proxy.place = place;
      proxy.element.style.transform = place;
    }
    const tabIndex = wanted.id === active ? 0 : -1;
    if (proxy.element.tabIndex !== tabIndex) proxy.element.tabIndex = tabIndex;
  }

  function paint(): void {
    const state = editor.state.value;
    const { curve, view, stage, selection, mode, settings } = state;
    const same = drawn !== null && drawn.curve === curve && drawn.view === view && drawn.stage === stage && drawn.selection === selection && drawn.mode === mode;
    if (same && handlesShown === settings.overlays.handles) return;
    drawn = { curve, view, stage, selection, mode };
    handlesShown = settings.overlays.handles;
    const wanted = wantedProxies(state);
    const ids = new Set(wanted.map(({ id }) => id));
    const hadFocus = surface.contains(document.activeElement);
    const active = activeId(state);
    const reachable = active !== null && ids.has(active);
    for (const each of wanted) update(each, active);
    surface.tabIndex = reachable ? -1 : 0;
    if (hadFocus) moveFocus(reachable ? active : null);
    for (const [id, proxy] of shown) {
      if (ids.has(id)) continue;
      proxy.element.remove();
      shown.delete(id);
    }
  }

  /** The focus follows the selection, but only while it is in the stage. */
  function moveFocus(active: string | null): void {
    const target = active === null ? surface : shown.get(active)?.element ?? surface;
    if (document.activeElement === target) return;
    // A pointer's press has put the focus on the stage itself; it stays there until a key moves the selection.
    if (target !== surface && !editor.state.value.keyboard && document.activeElement === surface) return;
    target.focus({ preventScroll: true });
  }

  editor.state.subscribe(() => frame.request(), { until });
  frame.add("paint", paint);
}
