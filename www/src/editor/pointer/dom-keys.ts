import { actionFor, chordOf, takesText } from "../actions/keymap.ts";
import type { Action, Editor } from "../editor.ts";
import { modifiersOf } from "./dom-record.ts";
import type { PointerInput } from "./pointer-input.ts";

/** What a key that is pressed anywhere on the page means for the stage. */

export interface KeyOptions {
  readonly editor: Editor;
  readonly input: PointerInput;
  readonly surface: HTMLElement;
  readonly until: AbortSignal;
  /** Esc with nothing left to cancel or deselect. */
  leaveStage(): void;
}

export function listenToKeys(options: KeyOptions): void {
  const keys = new Keys(options);
  const { until: signal } = options;
  window.addEventListener("keydown", (event) => keys.down(event), { signal });
  window.addEventListener("keyup", (event) => keys.up(event), { signal });
  window.addEventListener("blur", () => keys.upAll(), { signal });
}

/**
 * "nowhere" is the page itself; whoever keeps the keys (a dialog, a menu) leaves none to the stage, and a text field
 * few.
 */
type Focus = "stage" | "nowhere" | "widget" | "keeper" | "field";

function focusIn(surface: HTMLElement, mod: boolean): Focus {
  const { activeElement } = document;
  // Letters choose among the options of a list; with Ctrl they do not.
  if (activeElement?.closest(`dialog, [role=menu]${mod ? "" : ", select"}`) != null) return "keeper";
  if (takesText(activeElement)) return "field";
  if (surface.contains(activeElement)) return "stage";
  return activeElement === document.body ? "nowhere" : "widget";
}

/** Keys that work whatever widget has the focus: the stage takes them only for itself. */
const widgetKeys: ReadonlySet<string> = new Set(["Enter", "Tab", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End", "PageUp", "PageDown"]);

/** Asks whoever is dragged outside of the stage to go back to where it was; who does so prevents the default. */
export const dragTakenBack = "dragtakenback";
const takesBack = (): boolean => !dispatchEvent(new Event(dragTakenBack, { cancelable: true }));

const travels = ({ id }: Action): boolean => id === "undo" || id === "redo";

class Keys {
  readonly #options: KeyOptions;
  readonly #editor: Editor;
  readonly #input: PointerInput;
  /** The actions that end with their key, by its code. */
  readonly #held = new Map<string, string>();

  constructor(options: KeyOptions) {
    this.#options = options;
    this.#editor = options.editor;
    this.#input = options.input;
  }

  down(event: KeyboardEvent): void {
    const modifiers = modifiersOf(event);
    this.#input.modifiers(modifiers);
    if (event.defaultPrevented || event.isComposing) return;
    if (event.key === "Escape" && takesBack()) return event.preventDefault();
    const focus = focusIn(this.#options.surface, modifiers.mod);
    if (focus === "keeper") return;
    if (focus === "field") return this.#fromField(event);
    if (event.key === "Escape") return this.#escape(focus);
    if (this.#steers(event.key, focus)) return event.preventDefault();
    if (focus === "widget" && widgetKeys.has(event.key)) return;
    const action = actionOf(this.#editor, event);
    if (action !== undefined) this.#act(action, event, focus);
  }

  up(event: KeyboardEvent): void {
    this.#input.modifiers(modifiersOf(event));
    if (event.key === "Alt" && this.#options.surface.contains(document.activeElement)) event.preventDefault();
    if (event.key === " ") this.#input.space(false);
    const id = this.#held.get(event.code);
    this.#held.delete(event.code);
    if (id !== undefined) this.#release(id);
  }

  /** Keys released while another window has the focus are never reported. */
  upAll(): void {
    this.#input.space(false);
    this.#input.modifiers({ shift: false, alt: false, mod: false });
    for (const id of this.#held.values()) this.#release(id);
    this.#held.clear();
  }

  #release(id: string): void {
    this.#editor.actions.get(id)?.release?.(this.#editor);
  }

  /** Whether the key is one that changes what the pointer does. */
  #steers(key: string, focus: Focus): boolean {
    // Alone, Alt opens the menu bar of some browsers, in the middle of a drag that it is meant to change.
    if (key === "Alt") return focus === "stage";
    if (key === "Enter") return focus === "stage" && this.#input.finish();
    if (key !== " " || focus === "widget") return false;
    this.#input.space(true);
    return true;
  }

  /**
   * Files, for what is typed belongs to them; and where the field's number is in force already, Undo means the drawing.
   */
  #fromField(event: KeyboardEvent): void {
    const field = document.activeElement as HTMLInputElement;
    const action = actionOf(this.#editor, event);
    if (action?.group === "File") field.dispatchEvent(new Event("change"));
    // What a field shows by itself is its default: what is typed differs from it until it is taken.
    else if (action === undefined || !travels(action) || field.value !== field.defaultValue) return;
    this.#act(action, event, "stage");
  }

  #act(action: Action, event: KeyboardEvent, focus: Focus): void {
    if (travels(action) && (takesBack() || this.#input.busy)) {
      // Undo during a drag takes back the drag, and no more than that, even when there is nothing else to undo.
      event.preventDefault();
      if (this.#input.busy) this.#input.cancel();
      return;
    }
    const can = action.enabled?.(this.#editor.state.value) !== false;
    // What cannot be done now is not what the browser has on the key: going back, a bookmark, all of the page's text.
    if (can || focus === "stage") event.preventDefault();
    if (!can) return;
    if (action.release !== undefined) {
      if (event.repeat) return;
      this.#held.set(event.code, action.id);
    }
    this.#input.flush();
    if (this.#input.busy && action.live !== true) this.#input.cancel();
    action.run(this.#editor);
  }

  /** One step out of what is going on. */
  #escape(focus: Focus): void {
    if (this.#input.cancel()) return;
    const { selection, sketch, mode, chosen } = this.#editor.state.value;
    if (mode === "surface") {
      if (chosen.length > 0) return this.#editor.patch({ chosen: [] });
    } else if (mode === "curve") {
      if (sketch.proposal !== null) return this.#editor.patch({ sketch: { ...sketch, proposal: null } });
      if (selection.points.length > 0) return this.#editor.actions.get("select-none")?.run(this.#editor);
    }
    if (focus === "stage") this.#options.leaveStage();
  }
}

function actionOf(editor: Editor, event: KeyboardEvent): Action | undefined {
  const press = { key: event.key, ...modifiersOf(event) };
  // A digit with Shift is printed as a sign that differs from keyboard to keyboard.
  const digit = event.shiftKey && /^Digit\d$/u.test(event.code) ? { ...press, key: event.code.slice(-1) } : press;
  return actionFor(editor, chordOf(digit)) ?? actionFor(editor, chordOf(press));
}
