import { traceLimits } from "../../document/trace/trace.ts";
import { losesColors, setTrace, usualColors } from "../../editor/trace/trace-edits.ts";
import { h, setText } from "../controls/dom.ts";
import { toggleField } from "../controls/fields.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";
import { settingSlider } from "./setting-slider.ts";

/** A picture of a few flat colours: how many are looked for, and which were found. */
export function colorSection(shell: Shell): Section {
  const { editor } = shell;
  let last = usualColors;
  const on = toggleField({
    label: "Flat colours", testid: "trace-flat", about: "Each colour becomes a layer. Off, there is only ink and paper.",
    write: (flat) => setTrace(editor, "Flat colours", { colors: flat ? last : 0 }),
  });
  const count = settingSlider(shell, {
    name: "colors", label: "Colours", testid: "trace-colors", about: "The largest number of colours to look for.",
    least: 2, most: traceLimits.colors, step: 1, direction: "more colours", print: (value) => `≤ ${value}`,
  });
  const swatches = h("ul", { class: "swatches", testid: "trace-palette", "aria-label": "Colours found, lowest layer first" });
  const note = h("p", { class: "field-note num" });
  let shown: readonly string[] = [];
  return {
    element: h("section", { class: "section", "aria-label": "Colours" }, on.element, count.element, swatches, note),
    update(state) {
      const { trace, traceRun } = state;
      const { colors } = trace.settings;
      if (colors > 0) last = colors;
      on.show(colors > 0);
      count.element.hidden = colors === 0;
      count.show(last);
      const found = colors === 0 ? [] : (traceRun.outcome?.colors ?? []);
      swatches.hidden = found.length === 0;
      const text = found.length > 0
        ? `${found.length} ${found.length === 1 ? "layer" : "layers"}, stacked without gaps`
        : losesColors(state) ? "This picture has several colours; only what is dark is traced." : "";
      note.hidden = text === "";
      setText(note, text);
      if (found === shown) return;
      shown = found;
      swatches.replaceChildren(...found.map(swatch));
    },
  };
}

function swatch(color: string): HTMLElement {
  const field = h("span", { class: "swatch", "aria-hidden": "true" });
  field.style.backgroundColor = color;
  return h("li", { title: color }, field, h("span", { class: "visually-hidden" }, color));
}
