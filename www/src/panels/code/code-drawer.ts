import "../../styles/buttons.css";
import "../../styles/drawer.css";
import type { CurveDocument } from "../../document/document.ts";
import { whenLoaded } from "../../editor/loading.ts";
import { decimalsIn } from "../../document/unit.ts";
import { unitOf } from "../../kernel/unit.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import { inNextFrame, printedKey, type Shell } from "../shell.ts";
import { abridged, mostShown, snippetFor, snippetNames, type SnippetId } from "./snippets.ts";

/** As the export dialog has them before anybody changes them. */
function optionsFor(curve: CurveDocument): Parameters<typeof snippetFor>[2] {
  const unit = unitOf(curve);
  return { segments: "arcs", tolerance: Number((0.02 * unit).toPrecision(6)), decimals: decimalsIn(unit, 3), relative: false };
}

export interface CodeDrawer {
  toggle(): void;
  readonly isOpen: () => boolean;
}

/** Under the stage: the program that makes what is on it, changing as it changes. */
export function mountCodeDrawer(shell: Shell, changed: (open: boolean) => void): CodeDrawer {
  const { editor, io, toasts, regions, until } = shell;
  let active: SnippetId = "vanilla";
  let whole = "";
  const code = h("code", {});
  const listing = h("pre", { class: "code-listing", testid: "code-listing", tabindex: "0", role: "tabpanel", "aria-label": "Program" }, code);
  const tabs = snippetNames.map(([id, name]) => h("button", { class: "code-tab", type: "button", role: "tab", testid: `code-${id}`, click: () => choose(id) }, name));
  const copy = h("button", { class: "button", type: "button", testid: "code-copy", title: "Copy the code" }, icon("copy"), h("span", {}, "Copy"));
  const close = h("button", { class: "icon-button", type: "button", "aria-label": "Close the code", title: "Close", click: () => set(false) }, icon("close"));
  const list = h("div", { class: "code-tabs", role: "tablist", "aria-label": "Framework" }, ...tabs);
  const drawer = h("section", { class: "drawer", testid: "code-drawer", "aria-label": "Code", hidden: true },
    h("div", { class: "drawer-head" }, list, h("span", { class: "space" }), copy, close),
    listing,
  );
  regions.stage.append(drawer);

  const refresh = (): void => {
    if (drawer.hidden) return;
    const { mode, curve } = editor.state.value;
    const program = editor.modes.get(mode)?.program?.(editor.state.value);
    list.hidden = program !== undefined;
    whole = program ?? snippetFor(active, curve, optionsFor(curve));
    setText(code, abridged(whole));
  };
  const choose = (id: SnippetId): void => {
    active = id;
    tabs.forEach((tab, i) => {
      const chosen = snippetNames[i]?.[0] === id;
      setAttribute(tab, "aria-selected", String(chosen));
      setAttribute(tab, "tabindex", chosen ? "0" : "-1");
    });
    listing.scrollTop = 0;
    refresh();
  };
  const set = (open: boolean): void => {
    const inside = drawer.contains(document.activeElement);
    drawer.hidden = !open;
    changed(open);
    refresh();
    if (inside && !open) regions.panel.querySelector<HTMLElement>("[data-testid=btn-code]")?.focus();
    if (open) tabs.find((tab) => tab.getAttribute("aria-selected") === "true")?.focus();
  };
  list.addEventListener("keydown", (event) => {
    const at = tabs.findIndex((tab) => tab === document.activeElement);
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (at === -1 || step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const next = (at + step + tabs.length) % tabs.length;
    tabs[next]?.focus();
    choose(snippetNames[next]?.[0] ?? "vanilla");
  });
  drawer.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    set(false);
  });
  copy.addEventListener("click", () => {
    const text = whole;
    void io.copyText(text).then((done) => {
      if (done) toasts.say("Code copied.");
      else whenLoaded(editor, import("../controls/by-hand.ts"), ({ offerByHand }) => offerByHand(text, printedKey("Mod+C")));
    });
  });
  // A very long program is not printed sixty times a second: it waits for the end of the drag.
  const soon = inNextFrame(shell.frame, () => (editor.state.value.drag === null || whole.length <= mostShown) && refresh());
  editor.state.subscribe((state, before) => {
    const isOver = state.drag === null && before.drag !== null;
    if (!drawer.hidden && (isOver || state.curve !== before.curve || state.fit !== before.fit || state.surface !== before.surface || state.trace !== before.trace || state.traceRun !== before.traceRun
      || state.mode !== before.mode)) soon.request();
  }, { until });
  choose(active);
  return { toggle: () => set(drawer.hidden), isOpen: () => !drawer.hidden };
}
