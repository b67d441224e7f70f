import type { Mode } from "../../document/document.ts";
import { curveSample } from "../../document/curve/samples.ts";
import { isEmptyTrace } from "../../document/trace/trace.ts";
import type { EditorState } from "../../editor/editor.ts";
import { clearCurve } from "../../editor/curve/edits.ts";
import type { CodeDrawer } from "../code/code-drawer.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import { curveSection } from "../curve/curve-panel.ts";
import { inspectorSection } from "../curve/inspector.ts";
import { generatorSection, pointsTableSection } from "../curve/points-table.ts";
import { legendSection, showSection } from "../curve/show.ts";
import type { ModePanel } from "../mode/panel-parts.ts";
import { inNextFrame, type Shell } from "../shell.ts";
import { mountSheet } from "./sheet.ts";

const titles = { curve: "Curve", fit: "Fit", trace: "Trace", surface: "Surface" } as const;

export interface PanelHost {
  /** Adds a mode's panel. */
  put(mode: Mode, panel: ModePanel): void;
}

/** The properties of the mode, at the side of the stage; on a phone, a sheet. */
export function mountPanel(shell: Shell, metrics: HTMLElement): PanelHost {
  const { editor, regions, until } = shell;
  const curve = curveSection(shell);
  const sections = [curve, inspectorSection(shell), showSection(shell), legendSection(shell), generatorSection(shell), pointsTableSection(shell)];
  const curvePart = h("div", {}, ...sections.map((section) => section.element));
  const built = new Map<Mode, ModePanel>();
  const title = h("h2", { class: "panel-title" });
  const sample = h("span", { class: "section-note" });
  const clear = h("button", {
    class: "small-button",
    type: "button",
    testid: "btn-clear",
    title: "Take everything off the stage; undo brings it back.",
    click: () => { if (!editor.actions.run(`${editor.state.value.mode}-clear`)) clearCurve(editor); editor.patch({ hint: "" }); },
  }, "Clear");
  const codeButton = h("button", {
    class: "code-toggle",
    type: "button",
    testid: "btn-code",
    "aria-expanded": "false",
    title: "The program that makes this drawing",
    click: () => editor.actions.run("code"),
  }, icon("chevron"), h("span", {}, "Show code"));
  const scroll = h("div", { class: "panel-scroll" }, h("div", { class: "panel-head" }, title, sample, clear), curvePart);
  regions.panel.append(scroll, h("div", { class: "panel-foot" }, codeButton));
  const sheet = mountSheet(regions.panel, [metrics, curve.level], until);
  regions.panel.prepend(sheet.head);

  let drawer: Promise<CodeDrawer> | null = null;
  const loadDrawer = async (): Promise<CodeDrawer> => {
    const { mountCodeDrawer } = await import("../code/code-drawer.ts");
    return mountCodeDrawer(shell, (open) => setAttribute(codeButton, "aria-expanded", String(open)));
  };
  editor.actions.register({
    id: "code", label: "Show code", group: "File", keys: [],
    checked: () => codeButton.getAttribute("aria-expanded") === "true",
    run: () => {
      drawer ??= loadDrawer();
      void drawer.then((loaded) => loaded.toggle());
    },
  });

  const attach = (part: HTMLElement, shown: boolean): void => {
    if (shown && !part.isConnected) scroll.append(part);
    else if (!shown) part.remove();
  };
  const update = (state: EditorState): void => {
    if (title.textContent !== titles[state.mode]) scroll.scrollTop = 0;
    setText(title, titles[state.mode]);
    const own = built.get(state.mode);
    setText(sample, state.mode === "curve" ? (curveSample(state.curve.sample ?? "")?.title ?? "") : (own?.note(state) ?? ""));
    clear.hidden = state.mode === "surface";
    clear.disabled = state.mode === "trace" ? isEmptyTrace(state.trace) : (state.mode === "fit" ? state.fit.data : state.curve.contours).length === 0;
    // Only the mode's own controls are in the page: some have the same name in another mode.
    attach(curvePart, state.mode === "curve");
    curve.level.hidden = state.mode !== "curve";
    codeButton.hidden = state.mode !== "curve" && editor.modes.get(state.mode)?.program === undefined;
    for (const [mode, panel] of built) {
      attach(panel.element, state.mode === mode);
      if (panel.peek !== undefined) panel.peek.hidden = state.mode !== mode;
    }
    own?.update(state);
    if (state.mode === "curve" && state.engine.status === "ready") for (const section of sections) section.update(state);
  };
  // Once a frame: a drag changes the state more often than anyone can read.
  const soon = inNextFrame(shell.frame, () => update(editor.state.value));
  editor.state.subscribe((state, before) => {
    const same = built.get(state.mode) === undefined && state.curve === before.curve && state.selection === before.selection && state.settings === before.settings
      && state.mode === before.mode && state.engine === before.engine;
    if (!same) soon.request();
  }, { until });
  update(editor.state.value);
  return {
    put(mode, panel) {
      built.set(mode, panel);
      if (panel.peek !== undefined) sheet.add(panel.peek);
      update(editor.state.value);
    },
  };
}
