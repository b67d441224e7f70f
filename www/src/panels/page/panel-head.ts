import { isEmptyTrace } from "../../document/trace/trace.ts";
import { clearCurve } from "../../editor/curve/edits.ts";
import type { Editor, EditorState } from "../../editor/editor.ts";
import { h, setText } from "../controls/dom.ts";
import type { ModePanel } from "../mode/panel-parts.ts";

export interface PanelHead {
  readonly element: HTMLElement;
  /** `own` is the mode's panel, if it has come. */
  update(state: EditorState, own: ModePanel | undefined): void;
}

/** The mode's name, what of its samples is open, and Clear. */
export function panelHead(editor: Editor): PanelHead {
  const title = h("h2", { class: "panel-title" });
  const sample = h("span", { class: "section-note" });
  const clear = h("button", {
    class: "small-button",
    type: "button",
    testid: "btn-clear",
    title: "Clear the stage. Undo restores it.",
    click: () => clearMode(editor),
  }, "Clear");
  return {
    element: h("div", { class: "panel-head" }, title, sample, clear),
    update(state, own) {
      setText(title, editor.actions.get(`mode-${state.mode}`)?.label ?? "");
      setText(sample, own?.note(state) ?? "");
      clear.hidden = state.mode === "surface";
      clear.disabled = isEmpty(state);
    },
  };
}

function clearMode(editor: Editor): void {
  if (!editor.actions.run(`${editor.state.value.mode}-clear`)) clearCurve(editor);
  editor.patch({ hint: "" });
}

function isEmpty({ mode, trace, fit, curve }: EditorState): boolean {
  if (mode === "trace") return isEmptyTrace(trace);
  return (mode === "fit" ? fit.data : curve.contours).length === 0;
}
