import type { Action, Editor } from "../editor.ts";

/** Keys to actions. What a key does is written once, in the action's `keys`. */

export interface KeyPress {
  readonly key: string;
  readonly shift: boolean;
  readonly alt: boolean;
  readonly mod: boolean;
}

/** "Mod+Shift+Z" for a key press. Letters are upper case, as printed on the keys. */
export function chordOf({ key, shift, alt, mod }: KeyPress): string {
  const letter = key.length === 1 ? key.toUpperCase() : key;
  // Shift is already in a printed sign such as "?" or "{"; naming it again would hide the sign.
  const signed = key.length === 1 && letter === letter.toLowerCase() && !/^[0-9[\]]$/.test(key);
  return [mod ? "Mod" : "", alt ? "Alt" : "", shift && !signed ? "Shift" : "", letter].filter((part) => part !== "").join("+");
}

/** The action for a chord, or undefined. Single keys are silent when the user switched them off. */
export function actionFor(editor: Editor, chord: string): Action | undefined {
  const all = editor.actions.all().filter((action) => action.keys.includes(chord));
  // One key may mean something else in another mode: what can be done now is meant.
  const found = all.find((action) => action.enabled?.(editor.state.value) !== false) ?? all[0];
  if (found === undefined) return undefined;
  const isSingle = !chord.startsWith("Mod+") && chord.replace("Shift+", "").length === 1;
  return isSingle && !editor.state.value.settings.singleKeys ? undefined : found;
}

/** Whether an element takes typed text for itself. */
export function takesText(element: EventTarget | null): boolean {
  if (element instanceof HTMLInputElement) return !["button", "checkbox", "radio", "range", "submit", "file"].includes(element.type);
  return element instanceof HTMLTextAreaElement || (element instanceof HTMLElement && element.isContentEditable);
}
