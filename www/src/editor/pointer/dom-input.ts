import { zoomBy } from "../actions/standard-actions.ts";
import { panned, type ScreenPoint } from "./camera.ts";
import type { Frame } from "../frame.ts";
import { listenToKeys, type KeyOptions } from "./dom-keys.ts";
import { placeOf, recordOf } from "./dom-record.ts";
import { hitTest } from "./hit-test.ts";

/** What the stage hears. This file and dom-keys are the only ones of the editor that listen to elements. */

interface Options extends KeyOptions {
  readonly frame: Frame;
}

export function listenToStage(options: Options): void {
  options.editor.patch({ touch: matchMedia("(pointer: coarse)").matches });
  listenToPointers(options);
  listenToWheel(options);
  listenToKeys(options);
}

/** A little later than systems that ask for the menu themselves. */
const longPressMs = 650;
/** A finger that has moved by more than this, in CSS pixels, does not ask for anything. */
const stillPixels = 6;

/** A finger that stays where it came down asks for the menu. */
class LongPress {
  readonly #surface: HTMLElement;
  #pending: { readonly timer: ReturnType<typeof setTimeout>; readonly at: ScreenPoint } | null = null;

  constructor(surface: HTMLElement) {
    this.#surface = surface;
  }

  begin({ clientX, clientY }: PointerEvent, at: ScreenPoint): void {
    const ask = (): boolean => this.#surface.dispatchEvent(new MouseEvent("contextmenu", { clientX, clientY, bubbles: true, cancelable: true }));
    this.#pending = { at, timer: setTimeout(ask, longPressMs) };
  }

  moveTo({ x, y }: ScreenPoint): void {
    if (this.#pending !== null && Math.hypot(x - this.#pending.at.x, y - this.#pending.at.y) > stillPixels) this.drop();
  }

  drop(): void {
    if (this.#pending !== null) clearTimeout(this.#pending.timer);
    this.#pending = null;
  }
}

function listenToPointers({ editor, input, frame, surface, until }: Options): void {
  const press = new LongPress(surface);
  const on = <K extends keyof HTMLElementEventMap>(type: K, listener: (event: HTMLElementEventMap[K]) => void): void => {
    surface.addEventListener(type, listener, { signal: until });
  };
  on("pointerdown", (event) => {
    const record = recordOf(event, editor);
    takeHold(surface, event);
    press.drop();
    if (record.kind === "touch" && event.isPrimary) press.begin(event, record.screen);
    input.down(record);
    frame.request();
  });
  on("pointermove", (event) => {
    const record = recordOf(event, editor);
    press.moveTo(record.screen);
    // Between two frames a pen or a fast mouse has been at many places.
    const between = event.getCoalescedEvents?.() ?? [];
    for (const each of between.slice(0, -1)) input.move(recordOf(each, editor));
    input.move(record);
    frame.request();
  });
  on("pointerup", (event) => {
    press.drop();
    input.up(recordOf(event, editor));
    frame.request();
  });
  on("pointercancel", (event) => {
    press.drop();
    input.lost(event.pointerId);
  });
  on("blur", () => delete surface.dataset["pointer"]);
  on("pointerleave", () => {
    if (!input.busy) editor.patch({ hover: { kind: "empty" } });
  });
  // Whoever shows the menu reads what it is over from the state; the press itself comes to nothing.
  on("contextmenu", (event) => {
    event.preventDefault();
    press.drop();
    input.cancel();
    editor.patch({ hover: hitTest(editor.state.value, placeOf(event, editor), "mouse") });
  });
  frame.add("input", () => input.flush());
  // Who goes back in the browser, or presses a tab with another finger, takes what is dragged out of sight.
  editor.state.subscribe(({ mode }, before) => mode !== before.mode && input.busy && input.cancel(), { until });
}

function takeHold(surface: HTMLElement, event: PointerEvent): void {
  // The drag goes on outside the stage and over the panel.
  capture(surface, event.pointerId);
  // Put there by the pointer, the focus needs no ring round the whole stage, whatever keys come later.
  surface.dataset["pointer"] = "";
  surface.focus({ preventScroll: true });
  event.preventDefault();
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
      zoomBy(editor, 1.1 ** notches, placeOf(event, editor));
    },
    { signal: until, passive: false },
  );
}
