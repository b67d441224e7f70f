import { traceLimits, workSizes, type TraceSettings, type TraceSource } from "../../document/trace/trace.ts";
import { setTrace } from "../../editor/trace/trace-edits.ts";
import { h } from "../controls/dom.ts";
import { choiceField, selectField, toggleField } from "../controls/fields.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";
import { withAuto } from "./setting-slider.ts";

/** How the picture is looked at. */
export function imageSection(shell: Shell): Section {
  const { editor } = shell;
  const mode = choiceField<TraceSource>({
    label: "Edges from", testid: "trace-mode", about: "What the outlines follow.",
    options: [
      { value: "brightness", label: "Brightness", about: "The boundary between dark and light: for logos and drawings." },
      { value: "edges", label: "Edges", about: "The steepest changes: for shapes with little contrast." },
      { value: "lines", label: "Lines", about: "The centre of thin strokes: for line drawings." },
    ],
    write: (value) => setTrace(editor, "Edges from", { mode: value }),
  });
  const threshold = withAuto(shell, {
    name: "threshold", label: "Threshold", testid: "trace-threshold", about: "The shade that divides ink from paper. See it in the Edges view.",
    most: traceLimits.threshold, step: 1, print: (value) => String(value),
  }, ({ traceRun }) => Math.round(traceRun.picture?.threshold ?? 128));
  const blur = withAuto(shell, {
    name: "blur", label: "Blur σ", testid: "trace-blur", about: "Smooths out grain before finding edges.",
    most: traceLimits.blur, step: 0.1, print: (value) => `${value} px`,
  }, () => 1);
  const invert = toggleField({
    label: "Invert",
    testid: "trace-invert",
    about: "Light shapes on a dark background (I).",
    write: (on) => setTrace(editor, "Invert", { invert: on }),
  });
  const size = selectField<`${TraceSettings["size"]}`>({
    label: "Work size", testid: "trace-size", about: "Pixels along the longer side to analyse. Pictures are never enlarged.",
    options: workSizes.map((each) => [`${each}`, `${each} px`] as const),
    write: (value) => setTrace(editor, "Work size", { size: workSizes.find((each) => `${each}` === value) ?? 1024 }),
  });
  const body = h("div", { class: "trace-image" }, mode.element, threshold.element, blur.element, invert.element, size.element);
  return {
    element: h("section", { class: "section", "aria-label": "Image" },
      h("details", { class: "disclosure", open: true }, h("summary", {}, h("h3", { class: "section-title" }, "Image")), body),
    ),
    update(state) {
      const { settings } = state.trace;
      const inColor = settings.colors > 0;
      mode.show(inColor ? null : settings.mode);
      threshold.update(state);
      threshold.element.hidden = inColor || settings.mode !== "brightness";
      blur.update(state);
      invert.show(inColor ? null : settings.invert);
      size.show(`${settings.size}`);
    },
  };
}
