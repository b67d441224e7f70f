import { measuresOf, setMeasure, type Measure } from "../../../editor/curve/sizing.ts";
import type { Editor } from "../../../editor/editor.ts";
import { h } from "../../controls/dom.ts";
import type { Section } from "../../mode/panel-parts.ts";
import { lengthField } from "./length-field.ts";

/** Place and size of several selected points. Loaded when several are selected first. */

const fields: readonly (readonly [Measure, string, string, string, number?])[] = [
  ["x", "X", "sel-x", "Left edge of the selection; typing moves it."],
  ["y", "Y", "sel-y", "Top edge of the selection; typing moves it."],
  ["width", "W", "sel-w", "Width of the selection; typing scales it from the left edge.", 0.01],
  ["height", "H", "sel-h", "Height of the selection; typing scales it from the top edge.", 0.01],
];

export function sizeRows(editor: Editor): Section {
  const made = fields.map(([measure, label, testid, about, least]) => ({
    measure,
    field: lengthField(editor, {
      label, testid, about, ...(least === undefined ? {} : { least }),
      write(value) {
        if (value !== null) setMeasure(editor, measure, value);
      },
    }),
  }));
  const elements = made.map(({ field }) => field.element);
  return {
    element: h("div", { class: "inspector" }, h("div", { class: "pair" }, ...elements.slice(0, 2)), h("div", { class: "pair" }, ...elements.slice(2))),
    update(state) {
      if (state.selection.points.length < 2) return;
      const now = measuresOf(state);
      for (const { measure, field } of made) field.show(now[measure]);
    },
  };
}
