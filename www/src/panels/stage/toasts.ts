import type { Editor, EditorState, Notice } from "../../editor/editor.ts";
import { h } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import type { Toasts } from "../shell.ts";

const shownForMs = 5000;
const mostShown = 2;

/**
 * Messages over the foot of the stage: news go by themselves, errors stay until they are closed or the next success.
 */
export function mountToasts(stage: HTMLElement, editor: Editor): Toasts {
  // Of what stands there, only what is new is read out.
  const news = h("div", { class: "toasts", role: "status", "aria-live": "polite", "aria-atomic": "false" });
  const errors = h("div", { class: "toasts toasts-errors" });
  const stack = h("div", { class: "toast-stack" }, errors, news);
  stage.append(stack);

  const add = (list: HTMLElement, toast: HTMLElement): void => {
    // What is said while a dialog is open is said in it: the page behind is out of sight and out of reach.
    const host = [...document.querySelectorAll("dialog[open]")].at(-1) ?? stage;
    if (stack.parentElement !== host) host.append(stack);
    list.append(toast);
    while (list.children.length > mostShown) list.firstElementChild?.remove();
  };
  const addButtons = (toast: HTMLElement, action: Parameters<Toasts["say"]>[1]): void => {
    if (action !== undefined) toast.append(h("button", { class: "toast-action", type: "button", click: () => { toast.remove(); action.run(); } }, action.label));
    toast.append(h("button", { class: "icon-button", type: "button", "aria-label": "Dismiss", click: () => toast.remove() }, icon("close")));
  };

  const show = (...[text, action]: Parameters<Toasts["say"]>): HTMLElement => {
    news.querySelectorAll("[data-testid=toast]").forEach((old) => old.removeAttribute("data-testid"));
    const toast: HTMLElement = h("div", { class: "toast", testid: "toast" }, h("p", {}, text));
    if (action !== undefined) {
      addButtons(toast, action);
    }
    errors.replaceChildren();
    // What is offered is offered of the last that was done.
    if (action !== undefined) news.querySelectorAll(".toast:has(.toast-action)").forEach((old) => old.remove());
    add(news, toast);
    // News are of the mode they were said in; and what an action would do is another thing after the next step.
    if (action?.lasting !== true) leaveWhen(editor, toast, (state, before) => state.mode !== before.mode || (action !== undefined && state.undoName !== before.undoName));
    leaveLater(toast, action === undefined ? shownForMs : 3 * shownForMs);
    return toast;
  };
  const error: Toasts["error"] = (id, text, action) => {
    errors.replaceChildren();
    const toast: HTMLElement = h("div", { class: "toast toast-error", testid: "error", "data-error": id, role: "alert" }, icon("warn"), h("p", {}, text));
    addButtons(toast, action);
    add(errors, toast);
  };
  editor.notices.subscribe((notice: Notice | null) => {
    if (notice?.kind === "toast") {
      const action = notice.actionId === undefined ? undefined : editor.actions.get(notice.actionId);
      const toast = show(notice.text, action === undefined ? undefined : { label: action.label, run: () => void editor.actions.run(action.id) });
      // News of a step that is taken back are no longer true, and what cannot be done any more is not offered.
      leaveWhen(editor, toast, (state, before) => (state.canRedo && state.redoName !== before.redoName) || action?.enabled?.(state) === false);
    }
    if (notice?.kind === "error") error(notice.id, notice.text);
    if (notice?.kind === "well" && (notice.of === undefined || errors.querySelector(`[data-error=${notice.of}]`) !== null)) errors.replaceChildren();
  });
  return { say: (text, action) => void show(text, action), error };
}

function leaveWhen(editor: Editor, toast: HTMLElement, isOver: (state: EditorState, before: EditorState) => boolean): void {
  const gone = new AbortController();
  editor.state.subscribe((state, before) => {
    if (toast.isConnected && !isOver(state, before)) return;
    gone.abort();
    toast.remove();
  }, { until: gone.signal });
}

/** A toast whose button is under the pointer or has the focus waits until it is left alone. */
function leaveLater(toast: HTMLElement, ms: number): void {
  setTimeout(() => {
    if (!toast.isConnected) return;
    if (toast.matches(":hover, :focus-within")) leaveLater(toast, 1000);
    else toast.remove();
  }, ms);
}
