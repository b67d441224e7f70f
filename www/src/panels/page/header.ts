import { modes } from "../../document/document.ts";
import { h, setAttribute, type Child } from "../controls/dom.ts";
import { icon, type IconName } from "../controls/icons.ts";
import { withKey, type Shell } from "../shell.ts";
import type { Theme, ThemeControl } from "./theme.ts";

/**
 * Brand, the four modes, history and file actions. On a phone the modes move to the foot and the file actions into a
 * menu.
 */
export function mountHeader(shell: Shell, theme: ThemeControl): void {
  const { editor, regions } = shell;
  const run = (id: string) => () => editor.actions.run(id);
  const history = h("div", { class: "header-group", role: "group", "aria-label": "History" }, historyButton(shell, "undo"), historyButton(shell, "redo"));
  const menuId = "header-menu";
  const menu = h(
    "div",
    { class: "header-menu", id: menuId },
    menuButton("Samples", "btn-samples", "Start from a sample", run("samples")),
    menuButton("Import", "btn-import", withKey(editor, "Import a file, a path or points", "import"), run("import")),
    menuButton("Export", "btn-export", withKey(editor, "Export a path, SVG, PNG, JSON or TypeScript", "export"), run("export")),
    menuButton("Share", "btn-share", "Copy a link containing the whole drawing", run("share")),
    themeButton(theme),
    iconButton("help", "Help", "btn-help", withKey(editor, "Help: keys and gestures", "help"), run("help")),
  );
  const toggle = menuToggle(menu, menuId);
  regions.header.append(
    h("a", { class: "brand", href: "#/curve?sample=circle-2", title: "expline: back to the first drawing" }, brandMark(), h("span", {}, "expline")),
    mountTabs(shell),
    history,
    h("span", { class: "header-space" }),
    menu,
    panelToggle(shell),
    toggle,
  );
  // A choice closes the phone's menu; so does a press anywhere else, and going on to anything else.
  menu.addEventListener("click", (event) => {
    if (menu.dataset["open"] !== "true" || !(event.target instanceof Element) || event.target.closest("[data-stays]") !== null) return;
    setOpen(menu, toggle, false);
    // A dialog that it opens gives the focus back to what is still there then.
    toggle.focus();
  });
  for (const type of ["pointerdown", "focusin"]) {
    document.addEventListener(type, ({ target }) => {
      if (target instanceof Node && !menu.contains(target) && !toggle.contains(target)) setOpen(menu, toggle, false);
    }, { signal: shell.until });
  }
  regions.header.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || menu.dataset["open"] !== "true") return;
    event.stopPropagation();
    setOpen(menu, toggle, false);
    toggle.focus();
  });
}

/** Two points, their handles, and the arc between: the mark of the page. */
function brandMark(): SVGSVGElement {
  const mark = icon("brand");
  mark.classList.add("brand-mark");
  return mark;
}

function mountTabs(shell: Shell): HTMLElement {
  const { editor } = shell;
  const tabs = modes.map((mode) => {
    const label = editor.actions.get(`mode-${mode}`)?.label ?? mode;
    return h("button", {
      class: "tab",
      role: "tab",
      type: "button",
      testid: `tab-${mode}`,
      title: withKey(editor, label, `mode-${mode}`),
      click: () => editor.actions.run(`mode-${mode}`),
    }, label);
  });
  const list = h("div", { class: "tabs", role: "tablist", "aria-label": "Mode" }, ...tabs);
  list.addEventListener("keydown", (event) => {
    const at = tabs.findIndex((tab) => tab === document.activeElement);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: tabs.length - 1 }[event.key];
    if (at === -1 || to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const next = (to + tabs.length) % tabs.length;
    tabs[next]?.focus();
    editor.actions.run(`mode-${modes[next] ?? "curve"}`);
  });
  editor.state.subscribe(({ mode }) => {
    tabs.forEach((tab, i) => {
      setAttribute(tab, "aria-selected", String(modes[i] === mode));
      setAttribute(tab, "tabindex", modes[i] === mode ? "0" : "-1");
    });
  }, { now: true, until: shell.until });
  return list;
}

function historyButton(shell: Shell, which: "undo" | "redo"): HTMLButtonElement {
  const { editor } = shell;
  const label = editor.actions.get(which)?.label ?? which;
  const element = iconButton(which, label, `btn-${which}`, withKey(editor, label, which), () => editor.actions.run(which));
  editor.state.subscribe((state) => {
    const can = which === "undo" ? state.canUndo : state.canRedo;
    const name = which === "undo" ? state.undoName : state.redoName;
    element.disabled = editor.actions.get(which)?.enabled?.(state) === false;
    setAttribute(element, "title", withKey(editor, can && name !== null ? `${label}: ${name}` : label, which));
  }, { now: true, until: shell.until });
  return element;
}

function iconButton(name: IconName, label: string, testid: string, title: string, run: () => void): HTMLButtonElement {
  return h("button", { class: "icon-button", type: "button", "aria-label": label, title, testid, click: run },
    icon(name),
    h("span", { class: "menu-label", "aria-hidden": "true" }, label),
  );
}

function menuButton(label: string, testid: string, title: string, run: () => void, ...children: readonly Child[]): HTMLButtonElement {
  return h("button", { class: "menu-button", type: "button", testid, title, click: run }, ...children, label);
}

function themeButton(theme: ThemeControl): HTMLButtonElement {
  const looks: Readonly<Record<Theme, readonly [IconName, string]>> = { system: ["theme", "system"], light: ["sun", "light"], dark: ["moon", "dark"] };
  const label = h("span", { class: "menu-label", "aria-hidden": "true" });
  const element = h("button", { class: "icon-button", type: "button", testid: "btn-theme", "data-stays": "", click: () => show(theme.next()) });
  const show = (now: Theme): void => {
    const [name, text] = looks[now];
    element.replaceChildren(icon(name), label);
    label.textContent = `Theme: ${text}`;
    setAttribute(element, "aria-label", `Theme: ${text}`);
    setAttribute(element, "title", `Theme: ${text}. Click to change.`);
  };
  show(theme.current());
  return element;
}

function menuToggle(menu: HTMLElement, id: string): HTMLButtonElement {
  const toggle = h("button", {
    class: "icon-button menu-toggle",
    type: "button",
    testid: "btn-menu",
    "aria-label": "Menu",
    "aria-controls": id,
  }, icon("menu"));
  setOpen(menu, toggle, false);
  toggle.addEventListener("click", () => {
    const open = menu.dataset["open"] !== "true";
    setOpen(menu, toggle, open);
    if (open) menu.querySelector("button")?.focus();
  });
  return toggle;
}

/** A part of the page, and the button for it. */
function setOpen(part: HTMLElement, toggle: HTMLElement, open: boolean): void {
  part.dataset["open"] = String(open);
  toggle.setAttribute("aria-expanded", String(open));
}

/** Between phone and desktop the panel is a drawer; this opens it. */
function panelToggle({ regions }: Shell): HTMLButtonElement {
  const { panel } = regions;
  // Beside the stage it is always there; as a drawer it would hide what the visitor came to see.
  const starts = window.matchMedia("(width >= 64em)").matches;
  const toggle = h("button", {
    class: "icon-button panel-toggle",
    type: "button",
    testid: "btn-panel",
    "aria-label": "Panel",
    title: "Show or hide the panel",
  }, icon("panel"));
  setOpen(panel, toggle, starts);
  toggle.addEventListener("click", () => setOpen(panel, toggle, panel.dataset["open"] !== "true"));
  // Where it is no drawer, there is no button for it.
  for (const part of [panel, toggle]) {
    part.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || panel.dataset["open"] !== "true" || !toggle.checkVisibility()) return;
      event.stopPropagation();
      setOpen(panel, toggle, false);
      toggle.focus();
    });
  }
  return toggle;
}
