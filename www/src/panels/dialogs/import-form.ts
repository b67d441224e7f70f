import type { Problem } from "../../document/problem.ts";
import { button } from "../controls/dialog.ts";
import { freshId, h } from "../controls/dom.ts";
import { choiceField } from "../controls/fields.ts";
import { icon } from "../controls/icons.ts";
import type { Destination, Placement } from "../files/load.ts";
import { problemText } from "../messages/file-errors.ts";

const accepted = ".svg,.svgz,.json,.geojson,.csv,.tsv,.dat,.xy,.txt,image/svg+xml,application/json,text/plain,text/csv,image/*";

/** The controls of the import: where the drawing comes from, where it goes, and what was wrong with it. */
export interface ImportForm {
  readonly body: readonly HTMLElement[];
  readonly foot: readonly HTMLElement[];
  readonly file: HTMLInputElement;
  readonly text: HTMLTextAreaElement;
  readonly apply: HTMLButtonElement;
  /** Takes what could be read; hidden unless something could. */
  readonly partly: HTMLButtonElement;
  destination(): Destination;
  placement(): Placement;
  complain(problem: Problem): void;
  /** No complaint any more. */
  calm(): void;
}

/** `replacesIn` says of a destination whether what is there gives way unless somebody says otherwise. */
export function importForm(natural: Destination, given: string, replacesIn: (to: Destination) => boolean): ImportForm {
  const text = textField(given);
  const file = h("input", { class: "file-field", testid: "import-file", type: "file", accept: accepted, "aria-label": "Choose a file" });
  const message = h("div", { class: "message-slot" });
  const replaces = h("input", { class: "check", type: "checkbox", id: freshId("replace"), testid: "import-replace" });
  let destination = natural;
  let isDecided = false;
  replaces.checked = replacesIn(natural);
  replaces.addEventListener("change", () => { isDecided = true; });
  const to = destinationField(natural, (value) => {
    destination = value;
    if (!isDecided) replaces.checked = replacesIn(value);
  });
  const partly = button("Import what was read", { testid: "import-partial", hidden: true });
  const apply = button("Import", { class: "primary", testid: "import-apply" });
  return {
    file, text, apply, partly,
    body: [
      h("p", { class: "quiet" },
        "An SVG file, path data, points as x,y rows, an expline JSON file, or a picture to trace. Arcs, lines and cubics are imported exactly.",
      ),
      h("label", { class: "file-drop" }, icon("plus"), h("span", {}, "Choose a file"), file),
      h("label", { class: "stacked-label", for: text.id }, "or paste it here"),
      text,
      to,
      message,
    ],
    foot: [
      h("span", { class: "field-check" }, replaces, h("label", { for: replaces.id }, "Replace the drawing")),
      h("span", { class: "space" }),
      partly,
      apply,
    ],
    destination: () => destination,
    placement: () => (replaces.checked ? "replace" : "add"),
    complain: (problem) => message.replaceChildren(complaint(problem)),
    calm: () => message.replaceChildren(),
  };
}

function textField(given: string): HTMLTextAreaElement {
  const text = h("textarea", {
    id: freshId("import"),
    class: "code-field",
    testid: "import-text",
    rows: "7",
    spellcheck: "false",
    autocomplete: "off",
    placeholder: "M10 10h80v40a20 20 0 0 1-20 20H10z\n\nor <svg>…</svg>, or rows of x,y",
  });
  text.value = given;
  return text;
}

function destinationField(natural: Destination, write: (to: Destination) => void): HTMLElement {
  const field = choiceField<Destination>({
    label: "Open it in", testid: "import-to", about: "Edit it as it is, or simplify it.",
    options: [
      { value: "curve", label: "Curve, to edit", about: "Every point and handle as it is." },
      { value: "fit", label: "Fit, to simplify", about: "A curve with fewer points." },
    ],
    write,
  });
  field.show(natural);
  return field.element;
}

function complaint({ id, details }: Problem): HTMLElement {
  return h("p", { class: "message message-error", testid: "error", "data-error": id, role: "alert" }, icon("warn"), h("span", {}, problemText(id, details)));
}
