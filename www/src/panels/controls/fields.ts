/**
 * The controls of the panels: native inputs with a visible label, one sentence of explanation, a reset on the label's
 * double click, and errors said beside the field while the old value stays.
 */
import { dragTakenBack } from "../../editor/pointer/dom-keys.ts";
import type { Timeline } from "../../editor/history/timeline.ts";
import { errorText } from "../messages/errors.ts";
import { freshId, h, setAttribute, setText, type Child } from "./dom.ts";
import { formatCoordinate, parseTyped } from "./format.ts";

export interface Field<T> {
  readonly element: HTMLElement;
  /** Shows a value; null shows the control as not available. */
  show(value: T | null): void;
}

interface FieldOptions {
  readonly label: string;
  readonly testid: string;
  /** One sentence, as the tooltip. */
  readonly about: string;
  readonly reset?: () => void;
}

function labelFor(id: string, options: FieldOptions): HTMLLabelElement {
  const label = h("label", { class: "field-label", for: id, title: options.about }, options.label);
  if (options.reset !== undefined) label.addEventListener("dblclick", options.reset);
  return label;
}

export interface NumberOptions extends FieldOptions {
  readonly least: number;
  readonly most: number;
  readonly step: number;
  /** Printed after the number, inside the field. */
  readonly unit?: string;
  readonly format?: (value: number) => string;
  /** Words that stand for a value, as "Auto"; given to `write` as null. */
  readonly word?: string;
  write(value: number | null): void;
}

/** A number that is typed, or stepped with the arrow keys. NaN shows the word; undefined, that values differ. */
export function numberField(options: NumberOptions): Field<number | undefined> & { readonly input: HTMLInputElement } {
  const id = freshId(options.testid);
  const format = options.format ?? formatCoordinate;
  const input = h(
    "input",
    { id, class: "number", testid: options.testid, type: "text", inputmode: "decimal", autocomplete: "off", spellcheck: "false", title: options.about },
  );
  const message = h("p", { class: "field-error", role: "alert" });
  const unit = options.unit === undefined ? null : h("span", { class: options.unit.length > 1 ? "unit unit-wide" : "unit", "aria-hidden": "true" }, options.unit);
  let shown: number | null | undefined = null;
  let printed = "";

  const print = (): void => {
    // A word has no unit.
    if (unit !== null) unit.textContent = shown === undefined || Number.isNaN(shown) ? "" : (options.unit ?? "");
    if (shown === null) printed = "";
    else if (shown === undefined) printed = "Mixed";
    else printed = Number.isNaN(shown) ? (options.word ?? "") : format(shown);
    input.defaultValue = input.value = printed;
  };
  /** Says what is wrong with what was typed; with nothing, that it is taken. */
  const say = (text: string): void => {
    const [testid, error, invalid] = text === "" ? [null, null, null] : ["error", "number", "true"];
    setText(message, text);
    setAttribute(message, "data-testid", testid);
    setAttribute(message, "data-error", error);
    setAttribute(input, "aria-invalid", invalid);
  };
  const commit = (): void => {
    const text = input.value;
    if (text === printed) return;
    const isWord = options.word !== undefined && text.trim().toLowerCase() === options.word.toLowerCase();
    const value = isWord ? null : parseTyped(text, options.least, options.most);
    if (value === null && !isWord) say(errorText("number", { least: options.least, most: options.most, kept: printed }));
    else {
      say("");
      options.write(value);
    }
    print();
  };
  input.addEventListener("change", commit);
  // A value that arrives in one piece (dictation, a password manager, a script) has no keystroke to wait for.
  input.addEventListener("input", (event) => {
    if (input.value === printed) say("");
    else if (!(event instanceof InputEvent)) commit();
  });
  input.addEventListener("focus", () => input.select());
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && input.value !== printed) {
      print();
      event.stopPropagation();
    }
    if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
    // What is printed may have fewer digits than what it stands for.
    const from = input.value === printed ? shown : parseTyped(input.value, options.least, options.most) ?? shown;
    if (from === null || from === undefined || Number.isNaN(from)) return;
    event.preventDefault();
    const step = options.step * (event.shiftKey ? 10 : 1) * (event.key === "ArrowUp" ? 1 : -1);
    say("");
    options.write(Math.min(options.most, Math.max(options.least, Number((from + step).toPrecision(12)))));
    print();
  });

  const element = h("div", { class: "field field-number" }, labelFor(id, options), h("span", { class: "number-box" }, input, unit), message);
  return {
    element,
    input,
    show(value) {
      input.disabled = value === null;
      if (Object.is(value, shown) && document.activeElement === input) return;
      // What was refused was said of the value before.
      if (!Object.is(value, shown)) say("");
      shown = value;
      if (document.activeElement !== input || input.value === printed) print();
    },
  };
}

/** Everything between press and release is one step of such a history, and called as the slider is. */
type SliderEdits = Pick<Timeline<unknown>, "begin" | "commit" | "bail" | "inGesture">;

export interface SliderOptions extends FieldOptions {
  readonly least: number;
  readonly most: number;
  readonly step: number;
  /** The word at the right end: what more of it means. */
  readonly direction?: string;
  readonly print: (position: number) => string;
  readonly edits?: SliderEdits;
  /** What comes of it is shown again. */
  write(position: number): void;
}

/** It shows its value where it cannot be moved, too: who shows it switches it off afterwards. */
export function sliderField(options: SliderOptions): { readonly element: HTMLElement; readonly input: HTMLInputElement; show(value: number): void } {
  const id = freshId(options.testid);
  const input = h(
    "input",
    { id, class: "slider", testid: options.testid, type: "range", min: options.least, max: options.most, step: options.step, title: options.about },
  );
  const output = h("output", { class: "slider-value num", for: id });
  // The slider is as long at any value: what is pressed stays under the pointer.
  const texts = [options.least, options.most, options.most - options.step].map(options.print);
  output.style.minWidth = `max(1.5rem, min(${Math.max(...texts.map(({ length }) => length))}ch, 40vw))`;
  let shown = 0;
  let { write } = options;
  const show = (value: number): void => {
    input.disabled = false;
    shown = value;
    if (Number(input.value) !== value) input.value = String(value);
    setText(output, options.print(value));
    setAttribute(input, "aria-valuetext", options.print(value));
  };
  input.addEventListener("pointerdown", ({ button }) => {
    // The menu that another button opens may keep the release to itself.
    if (button !== 0) return;
    const from = shown;
    options.edits?.begin(options.label);
    const over = new AbortController();
    const on = (type: string, listener: (event: Event) => void): void => window.addEventListener(type, listener, { signal: over.signal });
    on(dragTakenBack, (event) => {
      event.preventDefault();
      write(from);
      options.edits?.bail();
      // The thumb goes on following the pointer by itself.
      write = () => (input.value = String(shown));
    });
    // A finger that turns out to scroll the panel ends with a cancel.
    for (const type of ["pointerup", "pointercancel"]) {
      on(type, () => {
        over.abort();
        write = options.write;
        options.edits?.commit();
      });
    }
  });
  input.addEventListener("input", () => {
    write(Number(input.value));
    setText(output, options.print(Number(input.value)));
  });
  const direction = options.direction === undefined ? null : h("span", { class: "direction", "aria-hidden": "true" }, `→ ${options.direction}`);
  const element = h("div", { class: "field field-slider" }, labelFor(id, options), h("span", { class: "slider-box" }, input, direction), output);
  return { element, input, show };
}

export interface ToggleOptions extends FieldOptions {
  readonly children?: readonly Child[];
  write(on: boolean): void;
}

/** Undefined where several things differ in it. */
export function toggleField(options: ToggleOptions): Field<boolean | undefined> {
  const id = freshId(options.testid);
  const input = h("input", { id, class: "check", testid: options.testid, type: "checkbox", title: options.about });
  input.addEventListener("change", () => options.write(input.checked));
  const element = h("div", { class: "field-check" }, input, labelFor(id, options), ...(options.children ?? []));
  return {
    element,
    show(value) {
      input.disabled = value === null;
      input.checked = value === true;
      input.indeterminate = value === undefined;
    },
  };
}

export interface ChoiceOption<T extends string> {
  readonly value: T;
  readonly label: string;
  readonly about: string;
  readonly mark?: Node;
  readonly disabled?: boolean | (() => boolean);
}

/** One of a few, as a row of radio buttons; undefined where several things differ in it. */
export function choiceField<T extends string>(options: FieldOptions & { readonly options: readonly ChoiceOption<T>[]; write(value: T): void }): Field<T | undefined> {
  const name = freshId(options.testid);
  const inputs = options.options.map((option) => {
    const input = h("input", { type: "radio", name, value: option.value, title: option.about, "aria-label": option.label });
    input.addEventListener("change", () => options.write(option.value));
    return { input, option };
  });
  const element = h(
    "fieldset",
    { class: "field field-choice", testid: options.testid },
    h("legend", { class: "field-label", title: options.about }, options.label),
    h("div", { class: "choices" }, ...inputs.map(({ input, option }) => h("label", { class: "choice" }, input, option.mark ?? null, h("span", {}, option.label)))),
  );
  return {
    element,
    show(value) {
      for (const { input, option } of inputs) {
        input.checked = option.value === value;
        const off = typeof option.disabled === "function" ? option.disabled() : option.disabled;
        input.disabled = value === null || off === true;
      }
    },
  };
}

export function selectField<T extends string>(options: FieldOptions & { readonly options: readonly (readonly [T, string])[]; write(value: T): void }): Field<T> {
  const id = freshId(options.testid);
  const input = h("select", { id, class: "select", testid: options.testid, title: options.about },
    ...options.options.map(([value, label]) => h("option", { value }, label)),
  );
  input.addEventListener("change", () => {
    const chosen = options.options.find(([value]) => value === input.value);
    if (chosen !== undefined) options.write(chosen[0]);
  });
  return {
    element: h("div", { class: "field" }, labelFor(id, options), input),
    show(value) {
      input.disabled = value === null;
      if (value !== null) input.value = value;
    },
  };
}
