import { isSelected } from "../document/document.ts";
import type { Action, Editor, EditorState } from "../editor/editor.ts";
import { h } from "./dom.ts";
import { printedKey, type Shell } from "./shell.ts";

/** What can be done with what is under the pointer. */
function itemsFor({ hover, curve }: EditorState): readonly string[] {
  switch (hover.kind) {
    case "point":
    case "handle":
      return ["smooth", "symmetric", "cusp", "reset-handles", "delete", "delete-open", "start-here", "reverse"];
    case "curve":
      return ["insert-here", "reverse"];
    case "empty":
      return curve.contours.length > 0 ? ["paste", "zoom-fit", "select-all"] : ["paste", "samples"];
  }
}

/** The menu of the stage: right press, long press, or the menu key. It acts on what it was opened over. */
export function mountContextMenu({ editor, regions, until }: Shell): void {
  regions.stage.addEventListener("contextmenu", (event) => {
    if (!(event.target instanceof Element) || event.target.closest("[data-part=surface]") === null) return;
    event.preventDefault();
    const { state } = editor;
    if (state.value.mode !== "curve" || state.value.engine.status !== "ready") return;
    const { hover, selection } = state.value;
    const over = hover.kind === "point" ? hover.point : hover.kind === "handle" ? { contour: hover.handle.contour, index: hover.handle.index } : null;
    if (over !== null && !isSelected(selection, over)) editor.patch({ selection: { points: [over], handle: null } });
    const actions = itemsFor(state.value).flatMap((id) => editor.actions.get(id) ?? []).filter((action) => action.enabled?.(state.value) !== false);
    if (actions.length > 0) openMenu(editor, event.clientX, event.clientY, actions);
  }, { signal: until });
}

function openMenu(editor: Editor, x: number, y: number, actions: readonly Action[]): void {
  const before = document.activeElement;
  const items = actions.map((action) =>
    h("button", { class: "menu-item", type: "button", role: "menuitem", tabindex: "-1", testid: `menu-${action.id}`, click: () => { close(); editor.actions.run(action.id); } },
      h("span", {}, action.label), action.keys[0] === undefined ? null : h("kbd", {}, printedKey(action.keys[0]))),
  );
  const menu = h("div", { class: "menu", role: "menu", popover: "auto", testid: "context-menu", "aria-label": "Actions here" }, ...items);
  const close = (): void => {
    if (!menu.isConnected) return;
    menu.remove();
    if (before instanceof HTMLElement && before.isConnected) before.focus();
  };
  // A press elsewhere or Esc closes a popover by itself.
  menu.addEventListener("toggle", (event) => {
    if (event instanceof ToggleEvent && event.newState === "closed") close();
  });
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
