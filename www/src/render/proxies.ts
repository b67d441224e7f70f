import type { CurveDocument, HandleRef, PointRef, Side } from "../document/document.ts";
import { toScreen } from "../editor/pointer/camera.ts";
import { describe } from "../editor/curve/edits.ts";
import type { Editor, EditorState } from "../editor/editor.ts";
import type { Frame } from "../editor/frame.ts";
import { shownHandles } from "../editor/pointer/hit-test.ts";
import { createProxy, mostProxies, paintOn, showProxy, stopAt, type Proxy } from "./proxy.ts";

/**
 * The picture for those who do not see it: a button for every point and every shown handle, at its place, named as the
 * hint line names it. The stage is one tab stop; the focus moves inside it with the selection.
 */

interface Wanted {
  readonly id: string;
  readonly label: string;
  readonly ref: PointRef;
  readonly side: Side | null;
  readonly x: number;
  readonly y: number;
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
  const shown = new Map<string, Proxy>();

  function make({ id, ref: { contour, index }, side }: Wanted): Proxy {
    const point = { contour, index };
    const handle = side === null ? null : { ...point, side };
    const proxy = createProxy(layer, id, () => editor.patch({ selection: { points: [point], handle }, keyboard: true }));
    shown.set(id, proxy);
    return proxy;
  }

  function paint(state: EditorState): void {
    const active = activeId(state);
    const present = new Set<string>();
    let target: HTMLElement | undefined;
    for (const wanted of wantedProxies(state)) {
      const { id } = wanted;
      present.add(id);
      const proxy = shown.get(id) ?? make(wanted);
      showProxy(proxy, wanted.label, wanted, id === active);
      if (id === active) target = proxy.element;
    }
    stopAt(editor, surface, target);
    for (const [id, { element }] of shown) {
      if (present.has(id)) continue;
      element.remove();
      shown.delete(id);
    }
  }

  paintOn(editor, frame, ["curve", "view", "stage", "selection", "mode", "settings"], paint, until);
}
