import "../../styles/buttons.css";
import "../../styles/dialogs.css";
import "../../styles/gallery.css";
import { h, type Child } from "./dom.ts";
import { icon } from "./icons.ts";

export interface DialogOptions {
  readonly title: string;
  readonly testid: string;
  /** A wider one, for two columns. */
  readonly wide?: boolean;
  /** Called once it is gone, however it went. */
  readonly closed?: () => void;
}

export interface Dialog {
  readonly element: HTMLDialogElement;
  readonly body: HTMLElement;
  readonly foot: HTMLElement;
  close(): void;
}

/**
 * A modal dialog: the browser keeps the focus inside, Esc and a press beside it close it, and the focus goes back to
 * where it was.
 */
export function openDialog(options: DialogOptions, ...children: readonly Child[]): Dialog {
  const title = h("h2", { class: "dialog-title", tabindex: "-1" }, options.title);
  const body = h("div", { class: "dialog-body" }, ...children);
  const foot = h("div", { class: "dialog-foot" });
  const close = h("button", { class: "icon-button", type: "button", "aria-label": "Close", title: "Close (Esc)" }, icon("close"));
  const element = h(
    "dialog",
    { class: options.wide === true ? "dialog dialog-wide" : "dialog", testid: options.testid, "aria-label": options.title },
    h("div", { class: "dialog-frame" }, h("div", { class: "dialog-head" }, title, close), body, foot),
  );
  const before = document.activeElement;
  const gone = new AbortController();
  close.addEventListener("click", () => element.close());
  // It was opened over what the address named.
  window.addEventListener("hashchange", () => element.close(), { signal: gone.signal });
  element.addEventListener("close", () => {
    gone.abort();
    // Messages that were said over the dialog outlive it.
    document.querySelector("[data-region=stage]")?.append(...element.querySelectorAll(":scope > .toast-stack"));
    element.remove();
    // The browser says that it is closed later than it closes it: by then somebody may have gone on elsewhere.
    const isNowhere = document.activeElement === null || document.activeElement === document.body;
    if (isNowhere && before instanceof HTMLElement && before.isConnected) before.focus();
    options.closed?.();
  });
  // A press that begins and ends on the backdrop; a text selection that ends outside does not close it.
  let pressedOutside = false;
  element.addEventListener("pointerdown", (event) => {
    pressedOutside = event.target === element;
  });
  element.addEventListener("click", (event) => {
    if (pressedOutside && event.target === element) element.close();
  });
  // Keys in a dialog are the dialog's: the page's shortcuts stay out of it.
  element.addEventListener("keydown", (event) => event.stopPropagation());
  // And so are those of who has gone past its last control and is nowhere.
  window.addEventListener("keydown", (event) => event.target === document.body && event.stopPropagation(), { capture: true, signal: gone.signal });
  document.body.append(element);
  element.showModal();
  return { element, body, foot, close: () => element.close() };
}

/** One line of buttons, told apart by what they do. */
export function button(
  label: string,
  attributes: Record<string, string | number | boolean | null | ((event: never) => void)>,
  ...children: readonly Child[]
): HTMLButtonElement {
  const { class: extra = "", ...rest } = attributes;
  return h("button", { class: `button ${String(extra)}`.trim(), type: "button", ...rest }, ...children, h("span", {}, label));
}
