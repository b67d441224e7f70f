import type { EditorState } from "../../editor/editor.ts";
import { toggleFitOverlay } from "../../editor/fit/fit-actions.ts";
import { chooseKnots, setFitView } from "../../editor/fit/fit-edits.ts";
import { hasParts } from "../../editor/fit/fit-question.ts";
import type { Compare, FitOverlay } from "../../editor/fit/fit-state.ts";
import type { KnotType } from "../../kernel/fit/knots.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import { selectField, sliderField, toggleField } from "../controls/fields.ts";
import { formatChange, formatDeviation } from "../controls/format.ts";
import { legendRow } from "../controls/legend.ts";
import { unitName } from "./fit-metrics.ts";
import { holdButton } from "../mode/hold-button.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

/** What came of the fit: knots by kind, and the errors; then what is drawn of it. */

const rows: readonly (readonly [KnotType, string, string])[] = [
  ["linear", "Corners", "Select every corner"],
  ["cubic", "Smooth", "Select every smooth knot"],
  ["coincident", "Both", "Select every corner with a smooth knot"],
];

export function readingSection(shell: Shell): Section {
  const { editor } = shell;
  const legend = rows.map(([type, label, about]) => ({ type, ...legendRow(type, label, about, () => chooseKnots(editor, type)) }));
  const reduction = h("p", { class: "fit-reduction num", "aria-live": "off" });
  const errors = h("p", { class: "field-note num" });
  const failure = h("p", { class: "field-error", role: "alert" });
  const edit = h("button", {
    class: "button primary",
    type: "button",
    testid: "fit-edit",
    title: "Copy the curve to Curve, ready to edit.",
    click: () => editor.actions.run("fit-edit"),
  }, h("span", {}, "Edit in Curve"));
  return {
    element: h("section", { class: "section", "aria-label": "Result" },
      h("div", { class: "section-head" }, h("h3", { class: "section-title" }, "Knots")), failure, reduction,
      h("div", { class: "legend" }, ...legend.map(({ row }) => row)), errors, h("div", { class: "field-row fit-actions" }, edit)),
    update({ fit, fitRun }: EditorState) {
      const { outcome } = fitRun;
      for (const { type, show } of legend) show(outcome?.counts[type] ?? 0);
      const total = outcome?.knots.length ?? 0;
      setText(reduction, outcome === null ? "" : `${outcome.size} points → ${total} ${total === 1 ? "knot" : "knots"} (${formatChange(total / Math.max(1, outcome.size))})`);
      setText(errors, outcome === null
        ? ""
        : `rms ${formatDeviation(outcome.rms)}, max ${formatDeviation(outcome.max)}${unitName(fit)} (${formatDeviation((100 * outcome.max) / Math.max(outcome.diagonal, 1e-12))} %)`);
      edit.disabled = outcome === null;
      // That the engine failed is said on the stage.
      const few = fitRun.failure?.id === "points-few" ? fitRun.failure : null;
      const count = few?.details.count ?? 0;
      setText(failure, few === null ? "" : `Fitting needs at least 4 different points; there ${count === 1 ? "is" : "are"} ${count}.`);
      setAttribute(failure, "data-testid", few === null ? null : "error");
      setAttribute(failure, "data-error", few?.id ?? null);
    },
  };
}

const overlays: readonly (readonly [FitOverlay, string, string])[] = [
  ["data", "Data", "The original points."],
  ["knots", "Knots", "A mark at every knot, by kind."],
  ["residual", "Residuals", "A line from each point to the curve."],
  ["heat", "Error heat", "The curve coloured by its distance from the points."],
  ["parts", "Parts", "The straight part and the smooth part separately."],
  ["comb", "Comb", "Curvature, as teeth along the curve (K)."],
];

export function showSection(shell: Shell): Section {
  const { editor } = shell;
  const toggles = overlays.map(([id, label, about]) => ({ id, field: toggleField({ label, testid: `ov-${id}`, about, write: () => toggleFitOverlay(editor, id) }) }));
  const compare = selectField<Compare>({
    label: "Compare", testid: "compare", about: "Points and curve: overlaid, or side by side.",
    options: [["off", "Off"], ["onion", "Onion"], ["split", "Split"]],
    write: (value) => setFitView(editor, { compare: value }), reset: () => setFitView(editor, { compare: "off" }),
  });
  const split = sliderField({
    label: "Split at", testid: "compare-split", about: "Where the stage is divided.", least: 0, most: 100, step: 1, print: (value) => `${value} %`,
    write: (value) => setFitView(editor, { split: value / 100 }),
  });
  const hold = holdButton(shell, "Hold to see the points", "Hold to see only the points (O)");
  const least = h("span", { class: "num" }, "0");
  const most = h("span", { class: "num" });
  const ramp = h("div", { class: "heat-legend" }, least, h("span", { class: "heat-ramp", "aria-hidden": "true" }), most);
  return {
    element: h("section", { class: "section", "aria-label": "Show" },
      h("div", { class: "section-head" }, h("h3", { class: "section-title" }, "Show")),
      h("div", { class: "toggles" }, ...toggles.map(({ field }) => field.element)),
      ramp, compare.element, split.element, h("div", { class: "field-row fit-actions" }, hold)),
    update({ fitView, fitRun, fit }: EditorState) {
      for (const { id, field } of toggles) field.show(id === "parts" && !hasParts(fit) ? null : fitView.overlays[id]);
      compare.show(fitView.compare);
      split.element.hidden = fitView.compare !== "split";
      split.show(Math.round(100 * fitView.split));
      ramp.hidden = !fitView.overlays.heat;
      setText(most, `${formatDeviation(fitRun.outcome?.max ?? 0)}${unitName(fit)}`);
    },
  };
}
