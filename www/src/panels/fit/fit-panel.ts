import "../../styles/buttons.css";
import "../../styles/fit.css";
import { fitSample } from "../../document/fit/fit-samples.ts";
import type { FitClosing, FitModel, FitTarget } from "../../document/fit/fit.ts";
import { unitIn } from "../../document/unit.ts";
import type { EditorState } from "../../editor/editor.ts";
import { boxOf, chooseFitTool, describeData, setClosing, setCorners, setMix, setModel, setNoise, setSmoothing, setTarget, setTargetValue, setUp } from "../../editor/fit/fit-edits.ts";
import { choosesCorners } from "../../editor/fit/fit-question.ts";
import type { FitTool } from "../../editor/fit/fit-state.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import { choiceField, numberField, selectField, sliderField, toggleField } from "../controls/fields.ts";
import type { ModePanel, Section } from "../mode/panel-parts.ts";
import { stackedPanel } from "../mode/stacked-panel.ts";
import type { Shell } from "../shell.ts";
import { chartSection } from "./fit-chart.ts";
import { readingSection, showSection } from "./fit-show.ts";

/** Fit mode's properties. */
export function fitPanel(shell: Shell): ModePanel {
  const smoothing = smoothingSection(shell);
  const sections = [dataSection(shell), smoothing, modelSection(shell), readingSection(shell), showSection(shell)];
  return stackedPanel("fit-panel", sections, { peek: smoothing.slider, note: ({ fit }) => fitSample(fit.sample ?? "")?.title ?? "" });
}

function dataSection(shell: Shell): Section {
  const { editor } = shell;
  const tool = choiceField<FitTool>({
    label: "Tool", testid: "fit-tool", about: "What the pointer does on the stage.",
    options: [
      { value: "draw", label: "Draw", about: "Drag to draw a stroke (D)." },
      { value: "points", label: "Points", about: "Click to place points (P)." },
      { value: "erase", label: "Erase", about: "Drag over points to erase them (E)." },
    ],
    write: (value) => chooseFitTool(editor, value),
  });
  const data = h("p", { class: "field-note fit-data num" });
  const noise = sliderField({
    label: "Noise σ", testid: "fit-noise", about: "Standard deviation of the sample's noise, in document units.",
    least: 0, most: 20, step: 0.5, print: (value) => `${value} px`,
    write: (value) => setNoise(editor, value, editor.state.value.fit.seed),
    reset: () => setNoise(editor, fitSample(editor.state.value.fit.sample ?? "")?.settings.noise ?? 0, editor.state.value.fit.seed),
    edits: editor.fitEdits,
  });
  const seed = numberField({
    label: "Seed", testid: "fit-seed", about: "Changes the noise, not its strength.", least: 0, most: 9999, step: 1, format: String,
    write: (value) => value !== null && setNoise(editor, editor.state.value.fit.noise, Math.round(value)),
  });
  const axis = choiceField<"up" | "down">({
    label: "Y axis", testid: "fit-up", about: "Which way y points. The numbers stay the same.",
    options: [
      { value: "up", label: "Up", about: "As in charts." },
      { value: "down", label: "Down", about: "As in drawings and pictures." },
    ],
    write: (value) => setUp(editor, value === "up"),
  });
  const actions = h("div", { class: "field-row fit-actions" },
    h("button", { class: "button", type: "button", testid: "fit-redraw", title: "Clear everything and draw again.", click: () => editor.actions.run("fit-redraw") },
      h("span", {}, "Redraw"),
    ),
    h("button", { class: "button", type: "button", testid: "fit-samples", title: "Samples to start from", click: () => editor.actions.run("samples") },
      h("span", {}, "Samples"),
    ));
  return {
    element: h("section", { class: "section", "aria-label": "Data" }, tool.element, data, axis.element, noise.element, seed.element, actions),
    update({ fit, fitView }) {
      tool.show(fitView.tool);
      setText(data, describeData(fit));
      axis.element.hidden = fit.sample !== undefined || fit.data.length === 0;
      axis.show(fit.up === true ? "up" : "down");
      noise.element.hidden = fit.sample === undefined;
      seed.element.hidden = fit.sample === undefined;
      noise.show(fit.noise);
      seed.show(fit.seed);
    },
  };
}

function smoothingSection(shell: Shell): Section & { readonly slider: HTMLElement } {
  const { editor } = shell;
  const smoothing = sliderField({
    label: "Smoothing", testid: "fit-smoothing", about: "How much to simplify: the cost of a knot, independent of the drawing's size.",
    least: 0, most: 100, step: 0.5, direction: "fewer knots", print: (value) => String(value),
    write: (value) => setSmoothing(editor, value),
    reset: () => setSmoothing(editor, fitSample(editor.state.value.fit.sample ?? "")?.settings.smoothing ?? 40),
    edits: editor.fitEdits,
  });
  const chart = chartSection(shell);
  const target = selectField<FitTarget>({
    label: "Target", testid: "fit-target", about: "Sets the smoothing from a number of knots or a largest error.",
    options: [["off", "Off"], ["knots", "Number of knots"], ["error", "Largest error"]],
    write: (value) => setTarget(editor, value), reset: () => setTarget(editor, "off"),
  });
  const write = (value: number | null): void => {
    if (value !== null) setTargetValue(editor, value);
  };
  const unit = (): number => unitIn(boxOf(editor.state.value.fit.data));
  const most = {
    knots: numberField({ label: "At most", testid: "fit-target-value", about: "Knots: places where the curve changes.", least: 2, most: 1000, step: 1, format: String, write }),
    error: numberField({
      label: "At most", testid: "fit-target-value", about: "How far a point may be from the curve, in document units.",
      get least() { return 0.01 * unit(); },
      get most() { return Math.max(1000, editor.state.value.fit.targetError); },
      get step() { return unit(); },
      format: (value) => String(Number(value.toPrecision(4))), write,
    }),
  };
  const value = h("div", { class: "fit-target-value" });
  const beyond = h("p", { class: "field-note", testid: "fit-target-note", role: "status" });
  return {
    slider: smoothing.element,
    element: h("section", { class: "section", "aria-label": "Smoothing" }, smoothing.element, chart.element, target.element, value, beyond),
    update(state: EditorState) {
      const { fit } = state;
      smoothing.show(fit.smoothing);
      smoothing.input.disabled = fit.data.length === 0;
      chart.update(state);
      target.show(fit.target);
      const field = fit.target === "off" ? null : most[fit.target];
      if (value.firstChild !== (field?.element ?? null)) value.replaceChildren(...(field === null ? [] : [field.element]));
      most.knots.show(fit.targetKnots);
      most.error.show(fit.targetError);
      const text = beyondTarget(state);
      beyond.hidden = text === "";
      setText(beyond, text);
    },
  };
}

/** What is said where more knots are left than were asked for, once a fit has tried. */
function beyondTarget({ fit, fitRun: { outcome, since } }: EditorState): string {
  if (fit.target !== "knots" || outcome === null || since !== null || outcome.knots.length <= fit.targetKnots) return "";
  return `No fewer than ${outcome.knots.length} knots will fit these points with this model.`;
}

function modelSection(shell: Shell): Section {
  const { editor } = shell;
  const model = choiceField<FitModel>({
    label: "Model", testid: "fit-model", about: "What the curve is made of.",
    options: [
      { value: "linear", label: "Linear", about: "Straight pieces between corners." },
      { value: "cubic", label: "Cubic", about: "A smooth curve without corners." },
      { value: "hybrid", label: "Hybrid", about: "Both at once: corners where needed, smooth elsewhere." },
    ],
    write: (value) => setModel(editor, value),
  });
  const mix = sliderField({
    label: "Mix", testid: "fit-mix", about: "Whether to prefer straight or smooth pieces.", least: 0, most: 100, step: 1, direction: "smooth", print: String,
    write: (value) => setMix(editor, value), reset: () => setMix(editor, 50),
    edits: editor.fitEdits,
  });
  const corners = toggleField({
    label: "Keep corners",
    testid: "fit-corners",
    about: "Sharp corners stay sharp. Turn off for a curve that is smooth everywhere (C).",
    write: (on) => setCorners(editor, on),
  });
  const closing = choiceField<FitClosing>({
    label: "Closed", testid: "fit-closed", about: "Whether the ends are joined. Auto joins ends within 3 % of the size.",
    options: [
      { value: "auto", label: "Auto", about: "Joined if the ends are close together." },
      { value: "open", label: "Open", about: "The ends are free." },
      { value: "closed", label: "Closed", about: "The last point is joined to the first." },
    ],
    write: (value) => setClosing(editor, value),
  });
  return {
    element: h("section", { class: "section", "aria-label": "Model" }, model.element, mix.element, corners.element, closing.element),
    update({ fit }) {
      model.show(fit.model);
      mix.element.hidden = fit.model !== "hybrid";
      mix.show(fit.mix);
      corners.show(choosesCorners(fit) ? fit.corners : null);
      closing.show(fit.closing);
      setAttribute(mix.input, "aria-label", "Mix, from straight to smooth");
    },
  };
}
