import { isSelected } from "../../document/document.ts";
import type { EditorState } from "../../editor/editor.ts";
import type { Shell } from "../shell.ts";

/** What can be done with what is under the pointer. */
function itemsFor({ hover, curve }: EditorState): readonly string[] {
  switch (hover.kind) {
    case "point":
    case "handle":
      return ["smooth", "symmetric", "cusp", "reset-handles", "delete", "delete-open", "join", "start-here", "reverse", "select-contour"];
    case "curve":
      return ["insert-here", "reverse", "select-contour"];
    case "grip":
      return ["flip-across", "flip-down", "turn-right", "turn-left", "duplicate", "reverse"];
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
    const { clientX, clientY } = event;
    if (actions.length > 0) void import("./menu.ts").then(({ openMenu }) => openMenu(editor, clientX, clientY, actions));
  }, { signal: until });
}
