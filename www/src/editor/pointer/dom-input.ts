import { zoomedAt, panned, type ScreenPoint } from "./camera.ts";
import type { Editor, Modifiers } from "../editor.ts";
import type { Frame } from "../frame.ts";
import { hitTest } from "./hit-test.ts";
import { actionFor, chordOf, takesText } from "../actions/keymap.ts";
import type { PointerInput } from "./pointer-input.ts";
import type { PointerRecord } from "./pointer-record.ts";

/** The stage's DOM events as plain records. The only file of the editor that listens to elements. */

interface Options {
  readonly editor: Editor;
  readonly input: PointerInput;
  readonly frame: Frame;
  readonly surface: HTMLElement;
  readonly until: AbortSignal;
  /** Esc with nothing left to cancel or deselect. */
  leaveStage(): void;
}

const isMac = /Mac|iPhone|iPad/.test(navigator.platform);

function modifiersOf(event: MouseEvent | KeyboardEvent): Modifiers {
  return { shift: event.shiftKey, alt: event.altKey, mod: isMac ? event.metaKey : event.ctrlKey };
}

export function listenToStage(options: Options): void {
  options.editor.patch({ touch: matchMedia("(pointer: coarse)").matches });
  listenToPointers(options);
  listenToWheel(options);
  listenToKeys(options);
}

function recordOf(event: PointerEvent, editor: Editor): PointerRecord {
  const { left, top } = editor.state.value.stage;
  return {
    id: event.pointerId,
    kind: event.pointerType === "touch" ? "touch" : event.pointerType === "pen" ? "pen" : "mouse",
    button: event.button,
    screen: { x: event.clientX - left, y: event.clientY - top },
    modifiers: modifiersOf(event),
    time: event.timeStamp,
  };
}

/** A little later than systems that ask for the menu themselves. */
const longPressMs = 650;

function listenToPointers({ editor, input, frame, surface, until }: Options): void {
  let press: { timer: ReturnType<typeof setTimeout>; at: ScreenPoint } | null = null;
  const dropPress = (): void => {
    if (press !== null) clearTimeout(press.timer);
    press = null;
  };
  const on = <K extends keyof HTMLElementEventMap>(type: K, listener: (event: HTMLElementEventMap[K]) => void): void => {
    surface.addEventListener(type, listener, { signal: until });
  };
  on("pointerdown", (event) => {
    const record = recordOf(event, editor);
    // The drag goes on outside the stage and over the panel.
    capture(surface, event.pointerId);
    // Put there by the pointer, the focus needs no ring round the whole stage, whatever keys come later.
    surface.dataset["pointer"] = "";
    surface.focus({ preventScroll: true });
    event.preventDefault();
    dropPress();
    if (record.kind === "touch" && event.isPrimary) {
      const { clientX, clientY } = event;
      const ask = (): boolean => surface.dispatchEvent(new MouseEvent("contextmenu", { clientX, clientY, bubbles: true, cancelable: true }));
      press = { at: record.screen, timer: setTimeout(ask, longPressMs) };
    }
    input.down(record);
    frame.request();
  });
  on("pointermove", (event) => {
    const record = recordOf(event, editor);
    if (press !== null && Math.hypot(record.screen.x - press.at.x, record.screen.y - press.at.y) > 6) dropPress();
    // Between two frames a pen or a fast mouse has been at many places.
    const between = event.getCoalescedEvents?.() ?? [];
    for (const each of between.slice(0, -1)) input.move(recordOf(each, editor));
    input.move(record);
    frame.request();
  });
  on("pointerup", (event) => {
    dropPress();
    input.up(recordOf(event, editor));
    frame.request();
  });
  on("pointercancel", (event) => {
    dropPress();
    input.lost(event.pointerId);
  });
  on("blur", () => delete surface.dataset["pointer"]);
  on("pointerleave", () => {
    if (!input.busy) editor.patch({ hover: { kind: "empty" } });
  });
  // Whoever shows the menu reads what it is over from the state; the press itself comes to nothing.
  on("contextmenu", (event) => {
    event.preventDefault();
    dropPress();
    input.cancel();
    const { left, top } = editor.state.value.stage;
    const at = { x: event.clientX - left, y: event.clientY - top };
    editor.patch({ hover: hitTest(editor.state.value, at, "mouse") });
  });
  frame.add("input", () => input.flush());
}

function capture(surface: HTMLElement, pointer: number): void {
  try {
    surface.setPointerCapture(pointer);
  } catch (error) {
    // The pointer may be gone already, or never have been one (events made by a script); then there is nothing to hold.
    if (!(error instanceof DOMException && error.name === "NotFoundError")) throw error;
  }
}

function listenToWheel({ editor, input, surface, until }: Options): void {
  surface.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      input.flush();
      const { view, stage, settings, mode } = editor.state.value;
      const own = editor.modes.get(mode)?.view;
      // Lines and pages, as some mice report, in pixels.
      const unit = event.deltaMode === 1 ? 40 : event.deltaMode === 2 ? stage.height : 1;
      const [dx, dy] = [event.deltaX * unit, event.deltaY * unit];
      const pan = (x: number, y: number): void => (own === undefined ? editor.patch({ view: panned(view, x, y) }) : own.pan(x, y));
      if (event.shiftKey && !event.ctrlKey) return pan(-(dx === 0 ? dy : dx), 0);
      if (settings.scrollPans && !event.ctrlKey) return pan(-dx, -dy);
      // A notch of a wheel is 100 to 120; a trackpad's pinch comes in small steps with Ctrl.
      const notches = event.ctrlKey && Math.abs(dy) < 50 ? -dy / 10 : -Math.sign(dy) * Math.min(3, Math.max(1, Math.abs(dy) / 120));
      const at = { x: event.clientX - stage.left, y: event.clientY - stage.top };
      if (own === undefined) editor.patch({ view: zoomedAt(view, stage, at, view.zoom * 1.1 ** notches) });
      else own.zoom(1.1 ** notches, at);
    },
    { signal: until, passive: false },
  );
}

/** Keys that work whatever widget has the focus: the stage takes them only for itself. */
const widgetKeys: ReadonlySet<string> = new Set(["Enter", "Tab", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End", "PageUp", "PageDown"]);

/** Keys that must not scroll the page or leave the field they are typed in. */
function listenToKeys({ editor, input, surface, until, leaveStage }: Options): void {
  const held = new Map<string, string>();
  const onModifiers = (event: KeyboardEvent): void => input.modifiers(modifiersOf(event));

  const belongsToStage = (): boolean => {
    const { activeElement } = document;
    if (activeElement?.closest("dialog, [role=menu]") != null) return false;
    return !takesText(activeElement);
  };

  window.addEventListener(
    "keydown",
    (event) => {
      onModifiers(event);
      if (event.defaultPrevented || event.isComposing || !belongsToStage()) return;
      const inStage = surface.contains(document.activeElement);
      // Alone, Alt opens the menu bar of some browsers, in the middle of a drag that it is meant to change.
      if (event.key === "Alt" && inStage) return event.preventDefault();
      if (event.key === "Escape") return escape(inStage);
      if (event.key === " " && (inStage || document.activeElement === document.body)) {
        event.preventDefault();
        return input.space(true);
      }
      if (event.key === "Enter" && inStage && input.finish()) return event.preventDefault();
      if (widgetKeys.has(event.key) && !inStage && document.activeElement !== document.body) return;
      const press = { key: event.key, ...modifiersOf(event) };
      // A digit with Shift is printed as a sign that differs from keyboard to keyboard.
      const digit = event.shiftKey && /^Digit\d$/u.test(event.code) ? { ...press, key: event.code.slice(-1) } : press;
      const action = actionFor(editor, chordOf(digit)) ?? actionFor(editor, chordOf(press));
      if (action === undefined) return;
      if (input.busy && (action.id === "undo" || action.id === "redo")) {
        // Undo during a drag takes back the drag, and no more than that, even when there is nothing else to undo.
        event.preventDefault();
        return void input.cancel();
      }
      if (action.enabled?.(editor.state.value) === false) return;
      event.preventDefault();
      if (action.release !== undefined) {
        if (event.repeat) return;
        held.set(event.code, action.id);
      }
      input.flush();
      if (input.busy && action.live !== true) input.cancel();
      action.run(editor);
    },
    { signal: until },
  );
  window.addEventListener(
    "keyup",
    (event) => {
      onModifiers(event);
      if (event.key === "Alt" && surface.contains(document.activeElement)) event.preventDefault();
      if (event.key === " ") input.space(false);
      const id = held.get(event.code);
      held.delete(event.code);
      if (id !== undefined) editor.actions.get(id)?.release?.(editor);
    },
    { signal: until },
  );
  window.addEventListener(
    "blur",
    () => {
      // Keys released while another window has the focus are never reported.
      input.space(false);
      input.modifiers({ shift: false, alt: false, mod: false });
      for (const id of held.values()) editor.actions.get(id)?.release?.(editor);
      held.clear();
    },
    { signal: until },
  );

  function escape(inStage: boolean): void {
    if (input.cancel()) return;
    const { selection, sketch, mode, chosen } = editor.state.value;
    if (mode === "surface") {
      if (chosen.length > 0) return editor.patch({ chosen: [] });
      if (inStage) leaveStage();
      return;
    }
    if (sketch.proposal !== null) return editor.patch({ sketch: { ...sketch, proposal: null } });
    if (selection.points.length > 0) return editor.actions.get("select-none")?.run(editor);
    if (inStage) leaveStage();
  }
}
