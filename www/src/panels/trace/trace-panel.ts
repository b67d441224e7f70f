import "../../styles/buttons.css";
import "../../styles/dialogs.css";
import "../../styles/gallery.css";
import "../../styles/trace.css";
import { traceSample } from "../../document/trace/trace-samples.ts";
import { toleranceOf, traceLimits } from "../../document/trace/trace.ts";
import { h } from "../controls/dom.ts";
import { formatDeviation } from "../controls/format.ts";
import type { ModePanel, Section } from "../mode/panel-parts.ts";
import { stackedPanel } from "../mode/stacked-panel.ts";
import type { Shell } from "../shell.ts";
import { colorSection } from "./color-section.ts";
import { imageSection } from "./image-section.ts";
import { pictureSection } from "./picture-section.ts";
import { resultSection } from "./result-section.ts";
import { area, settingSlider } from "./setting-slider.ts";

/** Trace mode's properties. */
export function tracePanel(shell: Shell): ModePanel {
  const settings = settingsSection(shell);
  const sections = [pictureSection(shell), asksTracer(settings), asksTracer(colorSection(shell)), resultSection(shell), asksTracer(imageSection(shell))];
  return stackedPanel("trace-panel", sections, { peek: settings.detail, note: ({ trace }) => traceSample(trace.sample ?? "")?.title ?? "" });
}

/**
 * Controls of the tracer show how outlines were found; where those came back without their picture, there is nothing to
 * be asked.
 */
function asksTracer(section: Section): Section {
  return {
    element: section.element,
    update(state) {
      section.update(state);
      if (state.trace.kept === undefined) return;
      for (const control of section.element.querySelectorAll<HTMLInputElement | HTMLSelectElement>("input, select")) control.disabled = true;
    },
  };
}

function settingsSection(shell: Shell): Section & { readonly detail: HTMLElement } {
  const detail = settingSlider(shell, {
    name: "detail", label: "Detail", testid: "trace-detail", about: "How far outlines may stray from the picture's edges.",
    most: traceLimits.detail, step: 1, direction: "smoother", print: (value) => `${value} · ${formatDeviation(toleranceOf(value))} px`,
  });
  const corner = settingSlider(shell, {
    name: "corner", label: "Corner angle", testid: "trace-corner", about: "Turns sharper than this stay corners.",
    most: traceLimits.corner, step: 1, direction: "fewer corners", print: (value) => `${value}°`,
  });
  const speckle = settingSlider(shell, {
    name: "speckle", label: "Speckle", testid: "trace-speckle", about: "Contours with a smaller area are dropped.",
    most: 100, step: 1, direction: "cleaner", print: (position) => `${area.toValue(position)} px²`, scale: area,
  });
  return {
    detail: detail.element,
    element: h("section", { class: "section", "aria-label": "Trace" }, detail.element, corner.element, speckle.element),
    update({ trace }) {
      const { settings } = trace;
      detail.show(settings.detail);
      corner.show(settings.corner);
      speckle.show(area.toPosition(settings.speckle));
    },
  };
}
