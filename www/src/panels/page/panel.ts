import type { Mode } from "../../document/document.ts";
import type { EditorState } from "../../editor/editor.ts";
import { h } from "../controls/dom.ts";
import { curvePanel } from "../curve/curve-panel.ts";
import type { ModePanel } from "../mode/panel-parts.ts";
import { inNextFrame, type Shell } from "../shell.ts";
import { codeToggle } from "./code-toggle.ts";
import { panelHead } from "./panel-head.ts";
import { mountSheet } from "./sheet.ts";

export interface PanelHost {
  /** Adds a mode's panel. */
  put(mode: Mode, panel: ModePanel): void;
}

/** The properties of the mode, at the side of the stage; on a phone, a sheet. */
export function mountPanel(shell: Shell, metrics: HTMLElement): PanelHost {
  const { editor, regions, until } = shell;
  const curve = curvePanel(shell);
  const panels = new Map<Mode, ModePanel>([["curve", curve]]);
  const head = panelHead(editor);
  const code = codeToggle(shell);
  const scroll = h("div", { class: "panel-scroll" }, head.element, curve.element);
  regions.panel.append(scroll, h("div", { class: "panel-foot" }, code));
  const sheet = mountSheet(regions.panel, [metrics, curve.peek], until);
  regions.panel.prepend(sheet.head);

  let shown: Mode | null = null;
  const update = (state: EditorState): void => {
    const { mode } = state;
    const own = panels.get(mode);
    if (mode !== shown) {
      scroll.scrollTop = 0;
      // What another mode shows is to be seen, above all what was handed over to it.
      sheet.uncover();
    }
    shown = mode;
    head.update(state, own);
    code.hidden = mode !== "curve" && editor.modes.get(mode)?.program === undefined;
    for (const [each, panel] of panels) showPanel(scroll, panel, each === mode);
    own?.update(state);
  };
  // Once a frame: a drag changes the state more often than anyone can read.
  const soon = inNextFrame(shell.frame, () => update(editor.state.value));
  editor.state.subscribe((state, before) => {
    const hasOwn = state.mode !== "curve" && panels.has(state.mode);
    if (hasOwn || !looksSame(state, before)) soon.request();
  }, { until });
  // What was asked for with a control may have been refused, by what is loaded for it.
  scroll.addEventListener("change", () => void Promise.allSettled(editor.loading).then(soon.request));
  update(editor.state.value);
  return {
    put(mode, panel) {
      panels.set(mode, panel);
      if (panel.peek !== undefined) sheet.add(panel.peek);
      update(editor.state.value);
    },
  };
}

/** Only the mode's own controls are in the page: some have the same name in another mode. */
function showPanel(scroll: HTMLElement, { element, peek }: ModePanel, shown: boolean): void {
  if (!shown) element.remove();
  else if (!element.isConnected) scroll.append(element);
  if (peek !== undefined) peek.hidden = !shown;
}

/** To Curve's panel, and while a mode's own is still on its way. */
function looksSame(state: EditorState, before: EditorState): boolean {
  return (["curve", "selection", "settings", "mode", "engine"] as const).every((key) => state[key] === before[key]);
}
