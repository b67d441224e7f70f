import type { ToolId } from "../../editor/editor.ts";
import { h, setAttribute } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import { withKey, type Shell } from "../shell.ts";

/** The tools, beside the stage or, on a phone, over its corner. */
export function mountRail({ editor, regions, until }: Shell): void {
  const tools = editor.actions.all().filter(({ id }) => id.startsWith("tool-"));
  const buttons = tools.map(({ id, label }) =>
    h("button", { class: "tool", type: "button", testid: id, "aria-label": label, title: withKey(editor, label, id), click: () => editor.actions.run(id) }, icon(id.slice(5) as ToolId)));
  regions.rail.append(h("div", { class: "tools", role: "toolbar", "aria-label": "Tools", "aria-orientation": "vertical" }, ...buttons));
  editor.state.subscribe((state) => {
    // The other modes have one tool each: the stage gets the room.
    regions.rail.hidden = state.mode !== "curve" && state.mode !== "fit";
    buttons.forEach((button, i) => {
      setAttribute(button, "aria-pressed", String(tools[i]?.checked?.(state)));
      button.hidden = tools[i]?.enabled?.(state) === false;
    });
  }, { now: true, until });
}
