import type { CodeDrawer } from "../code/code-drawer.ts";
import { h, setAttribute } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import type { Shell } from "../shell.ts";

/** The button at the foot of the panel that opens the program; the drawer comes with its first press. */
export function codeToggle(shell: Shell): HTMLElement {
  const { actions } = shell.editor;
  const button = h("button", {
    class: "code-toggle",
    type: "button",
    testid: "btn-code",
    "aria-expanded": "false",
    title: "The program that makes this drawing",
    click: () => actions.run("code"),
  }, icon("chevron"), h("span", {}, "Show code"));
  let drawer: Promise<CodeDrawer> | null = null;
  const loadDrawer = async (): Promise<CodeDrawer> => {
    const { mountCodeDrawer } = await import("../code/code-drawer.ts");
    return mountCodeDrawer(shell, (open) => setAttribute(button, "aria-expanded", String(open)));
  };
  actions.register({
    id: "code", label: "Show code", group: "File", keys: [],
    checked: () => button.getAttribute("aria-expanded") === "true",
    run: () => {
      drawer ??= loadDrawer();
      void drawer.then((loaded) => loaded.toggle());
    },
  });
  return button;
}
