import { onDemand } from "../../editor/loading.ts";
import { h, setAttribute } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import type { Shell } from "../shell.ts";

/** The button at the foot of the panel that opens the program; the drawer comes with its first press. */
export function codeToggle(shell: Shell): HTMLElement {
  const { editor } = shell;
  const button = h("button", {
    class: "code-toggle",
    type: "button",
    testid: "btn-code",
    "aria-expanded": "false",
    title: "The code for this drawing",
    click: () => editor.actions.run("code"),
  }, icon("chevron"), h("span", {}, "Show code"));
  const drawer = onDemand(async () => (await import("../code/code-drawer.ts")).mountCodeDrawer(shell, (open) => setAttribute(button, "aria-expanded", String(open))));
  editor.actions.register({
    id: "code", label: "Show code", group: "File", keys: [],
    checked: () => button.getAttribute("aria-expanded") === "true",
    run: () => drawer(editor, (loaded) => loaded.toggle()),
  });
  return button;
}
