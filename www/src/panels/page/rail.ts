import type { ToolId } from "../../editor/editor.ts";
import { h, setAttribute } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import { withKey, type Shell } from "../shell.ts";

const tools: readonly ToolId[] = ["select", "pen", "draw", "hand"];

/** The tools, beside the stage or, on a phone, over its corner. */
export function mountRail({ editor, regions, until }: Shell): void {
  const buttons = tools.map((id) => {
    const label = editor.actions.get(`tool-${id}`)?.label ?? id;
    const title = withKey(editor, label, `tool-${id}`);
    return h("button", { class: "tool", type: "button", testid: `tool-${id}`, "aria-label": label, title, click: () => editor.actions.run(`tool-${id}`) }, icon(id));
  });
  regions.rail.append(h("div", { class: "tools", role: "toolbar", "aria-label": "Tools", "aria-orientation": "vertical" }, ...buttons));
  editor.state.subscribe((state) => {
    // The other modes have one tool each: the stage gets the room.
    regions.rail.hidden = state.mode !== "curve" && state.mode !== "fit";
    buttons.forEach((button, i) => {
      const id = tools[i];
      setAttribute(button, "aria-pressed", String(id === state.tool));
      // A press on a knot selects it whatever Fit's tool is.
      button.hidden = id === "select" && state.mode === "fit";
    });
  }, { now: true, until });
}
