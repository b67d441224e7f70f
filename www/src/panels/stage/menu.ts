import "../../styles/menu.css";
import { isEnd, isSelected, samePoint, type PointRef } from "../../document/document.ts";
import { frameOf, isInsideFramed, nearestGrip } from "../../editor/curve/framing.ts";
import { hasSharp } from "../../editor/curve/corners/chosen.ts";
import type { Action, Editor, EditorState, Target } from "../../editor/editor.ts";
import { toPage } from "../../editor/pointer/camera.ts";
import { placeOf } from "../../editor/pointer/dom-record.ts";
import { reachOf } from "../../editor/pointer/hit-test.ts";
import { h } from "../controls/dom.ts";
import { printedKey } from "../shell.ts";

/** What can be done with a point: nothing that would only be refused. */
function itemsForPoint({ curve, ...state }: EditorState, point: PointRef): readonly string[] {
  const contour = curve.contours[point.contour];
  return [
    ...(contour?.family === "interpolating" ? [] : ["smooth", "symmetric", "cusp", "reset-handles"]),
    ...(hasSharp({ ...state, curve }) ? ["round-corners"] : []),
    "delete", "delete-open",
    ...(isEnd(curve, point) ? ["join"] : []),
    ...(contour?.closed === true && point.index > 0 ? ["start-here"] : []),
    "reverse", "select-contour", "copy", "duplicate",
  ];
}

/**
 * Of contours that are chosen as a whole, their frame or its inside takes the press where nothing else does. The menu
 * key points nowhere: it is about what is chosen.
 */
function withFrame(editor: Editor, over: Target, event: MouseEvent): Target {
  const { value: state } = editor.state;
  const at = placeOf(event, editor);
  const isOfKey = event.button < 0 && frameOf(state) !== null;
  const isFramed = isOfKey || over.kind === "empty" && (isInsideFramed(state, toPage(state.view, state.stage, at)) || nearestGrip(state, at, reachOf.touch) !== null);
  return isFramed ? { kind: "grip", grip: "inside", cursor: "", hint: "" } : over;
}

/** What can be done with what is under the pointer. */
function itemsFor(over: Target, state: EditorState): readonly string[] {
  const { contours } = state.curve;
  switch (over.kind) {
    case "point":
      return itemsForPoint(state, over.point);
    case "handle":
      return itemsForPoint(state, over.handle);
    case "curve":
      return ["insert-here", "reverse", "select-contour"];
    case "grip": {
      const [point] = state.selection.points;
      if (over.grip === "corner" && point !== undefined) return itemsForPoint(state, point);
      return ["copy", "cut", "paste", "duplicate", "delete", ...(hasSharp(state) ? ["round-corners"] : []), "to-front", "to-back", "flip-across", "flip-down", "turn-right", "turn-left", "reverse", "zoom-chosen"];
    }
    case "empty":
      return contours.length > 0 ? ["paste", "copy", "zoom-fit", "select-all"] : ["paste", "samples"];
  }
}

/** The menu of what is under the pointer, which is chosen if it is a point. */
export function openMenuOver(editor: Editor, under: Target, event: MouseEvent): void {
  const { selection } = editor.state.value;
  const over = withFrame(editor, under, event);
  const point = over.kind === "point" ? over.point : over.kind === "handle" ? { contour: over.handle.contour, index: over.handle.index } : null;
  // Of several chosen points, it is the one under the pointer that something is done at.
  const others = point !== null && isSelected(selection, point) ? selection.points.filter((each) => !samePoint(each, point)) : [];
  if (point !== null) editor.patch({ selection: { ...(others.length > 0 ? selection : { handle: null }), points: [point, ...others] } });
  const state = editor.state.value;
  const known = itemsFor(over, state).flatMap((id) => editor.actions.get(id) ?? []).filter((action) => action.enabled?.(state) !== false);
  // Where all of a contour goes, there is nothing to heal.
  const actions = known.map((action) => (over.kind === "grip" && over.grip !== "corner" && action.id === "delete" ? { ...action, label: "Delete" } : action));
  if (actions.length > 0) openMenu(event.clientX, event.clientY, actions, (id) => {
    // The pointer has left the stage for the menu; what is chosen is done where the menu was opened.
    editor.patch({ hover: over });
    editor.actions.run(id);
  });
}

/** A menu at a place of the window: the first thing in it has the focus, which goes back to where it was. */
function openMenu(x: number, y: number, actions: readonly Action[], run: (id: string) => void): void {
  const before = document.activeElement;
  const items = actions.map((action) =>
    h("button", {
      class: "menu-item",
      type: "button",
      role: "menuitem",
      tabindex: "-1",
      testid: `menu-${action.id}`,
      click: () => { close(); run(action.id); },
    },
      h("span", {}, action.label), action.keys[0] === undefined ? null : h("kbd", {}, printedKey(action.keys[0]))),
  );
  const menu = h("div", { class: "menu", role: "menu", popover: "manual", tabindex: "-1", testid: "context-menu", "aria-label": "Actions" }, ...items);
  const close = (): void => {
    window.removeEventListener("pointerdown", away, true);
    if (!menu.isConnected) return;
    menu.remove();
    if (before instanceof HTMLElement && before.isConnected) before.focus();
  };
  // Not left to the browser: where a menu opens while its button or finger is still down, Firefox takes the release for
  // a press elsewhere.
  const away = ({ target }: Event): void => {
    if (!(target instanceof Node && menu.contains(target))) close();
  };
  window.addEventListener("pointerdown", away, true);
  menu.addEventListener("keydown", (event) => {
    const at = items.findIndex((item) => item === document.activeElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: items.length - 1 }[event.key];
    event.stopPropagation();
    if (event.key === "Tab" || event.key === "Escape") {
      event.preventDefault();
      close();
    }
    if (to === undefined) return;
    event.preventDefault();
    items[(to + items.length) % items.length]?.focus();
  });
  document.body.append(menu);
  menu.showPopover();
  // Inside the window, whichever corner it was asked for in.
  const { width, height } = menu.getBoundingClientRect();
  const left = Math.max(4, Math.min(x, window.innerWidth - width - 4));
  const top = Math.max(4, Math.min(y, window.innerHeight - height - 4));
  menu.style.transform = `translate(${left}px, ${top}px)`;
  items[0]?.focus();
}
