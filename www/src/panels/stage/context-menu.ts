import { whenLoaded } from "../../editor/loading.ts";
import type { Shell } from "../shell.ts";

/** The menu of the stage: right press, long press, or the menu key. It acts on what it was opened over. */
export function mountContextMenu({ editor, regions, until }: Shell): void {
  regions.stage.addEventListener("contextmenu", (event) => {
    if (!(event.target instanceof Element) || event.target.closest("[data-part=surface]") === null) return;
    event.preventDefault();
    const { value: state } = editor.state;
    if (state.mode !== "curve" || state.engine.status !== "ready") return;
    const { hover } = state;
    whenLoaded(editor, import("./menu.ts"), ({ openMenuOver }) => openMenuOver(editor, hover, event));
  }, { signal: until });
}
