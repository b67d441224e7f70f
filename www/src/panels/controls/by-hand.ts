import { openDialog } from "./dialog.ts";
import { h } from "./dom.ts";

/**
 * Where the browser keeps the clipboard to itself, what was to be copied is there to be copied by hand, with the keys
 * that copy.
 */
export function offerByHand(text: string, keys: string): void {
  const field = h("textarea", { class: "code-field", testid: "by-hand", rows: 6, readonly: true, spellcheck: "false", "aria-label": "What to copy" });
  field.value = text;
  openDialog(
    { title: "Copy by hand", testid: "by-hand-dialog" },
    h("p", {}, `The browser blocked copying. All of the text is selected: press ${keys}, or hold a finger on it.`),
    field,
  );
  field.focus();
  field.select();
}
