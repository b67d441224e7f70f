import type { EditorState, OverlayId } from "../../editor/editor.ts";
import { selectKind } from "../../editor/curve/edits.ts";
import { unitOf } from "../../kernel/unit.ts";
import { measureCurve } from "../../kernel/curve/measuring/measure.ts";
import { h } from "../controls/dom.ts";
import { numberField, sliderField, toggleField } from "../controls/fields.ts";
import { legendRow } from "../controls/legend.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

const overlays: readonly (readonly [OverlayId, string, string, string])[] = [
  ["handles", "ov-handles", "Handles", "Handles of the selected points and their neighbours."],
  ["polygon", "ov-polygon", "Polygon", "The control polygon of the generalised Bézier points."],
  ["knots", "ov-knots", "Knots", "A tick where segments meet."],
  ["comb", "ov-comb", "Comb", "Curvature, as teeth along the curve (K)."],
  ["subdivision", "ov-subdiv", "Subdivision", "The polygons of the subdivision scheme, step by step."],
  ["weights", "ov-weights", "Weights", "How strongly the selected point acts along the curve."],
  ["fill", "ov-fill", "Fill", "A light wash inside closed contours."],
  ["grid", "ov-grid", "Grid", "A background grid (G)."],
  ["bezier", "ov-bezier", "Compare with Bézier", "The best Bézier through the same points, dashed behind the curve."],
];

/** What is drawn beside the curve. None of it changes the curve. */
export function showSection(shell: Shell): Section {
  const { editor } = shell;
  const toggles = overlays.map(([id, testid, label, about]) => ({ id, field: toggleField({ label, testid, about, write: (on) => editor.setOverlay(id, on) }) }));
  const elements = toggles.map(({ field }) => field.element);
  const snap = toggleField({
    label: "Snap",
    testid: "snap",
    about: "Snaps to points and alignments while dragging. Hold Ctrl to switch it off.",
    write: (on) => editor.setSettings({ snap: on }),
  });
  const comb = sliderField({
    label: "Comb scale",
    testid: "comb-scale",
    about: "Length of the comb's teeth, 0.1 to 10 times.",
    least: -1,
    most: 1,
    step: 0.05,
    print: (position) => `×${Number((10 ** position).toPrecision(2))}`,
    write: (position) => editor.setSettings({ combScale: Number((10 ** position).toPrecision(3)) }),
    reset: () => editor.setSettings({ combScale: 1 }),
  });
  const subdivision = sliderField({
    label: "Steps",
    testid: "subdiv",
    about: "How many subdivision steps to draw.",
    least: 0,
    most: 8,
    step: 1,
    print: (position) => (position === 0 ? "off" : String(position)),
    write: (position) => {
      editor.setSettings({ subdivisionSteps: position });
      if (position > 0 && !editor.state.value.settings.overlays.subdivision) editor.setOverlay("subdivision", true);
    },
    reset: () => editor.setSettings({ subdivisionSteps: 0 }),
  });
  const unit = (): number => unitOf(editor.state.value.curve);
  const grid = numberField({
    label: "Grid step",
    testid: "grid-step",
    about: "Distance between grid lines. Points snap to them.",
    get least() { return unit(); },
    get most() { return 100 * unit(); },
    get step() { return unit(); },
    format: (value) => String(Number(value.toPrecision(6))),
    write: (value) => value !== null && editor.setSettings({ gridStep: value / unit() }),
    reset: () => editor.setSettings({ gridStep: 10 }),
  });
  const element = h(
    "section",
    { class: "section", "aria-label": "Show" },
    h("div", { class: "section-head" }, h("h3", { class: "section-title" }, "Show")),
    h("div", { class: "toggles" }, ...elements.slice(0, -1), snap.element, ...elements.slice(-1)),
    comb.element,
    grid.element,
    subdivision.element,
  );
  return {
    element,
    update({ settings }) {
      for (const { id, field } of toggles) field.show(settings.overlays[id]);
      snap.show(settings.snap);
      comb.show(Math.log10(settings.combScale));
      comb.element.hidden = !settings.overlays.comb;
      grid.show(settings.gridStep * unit());
      grid.element.hidden = !settings.overlays.grid;
      subdivision.show(settings.subdivisionSteps);
    },
  };
}

/** The marks and how many there are; a press selects them all. */
export function legendSection(shell: Shell): Section {
  const { editor } = shell;
  const rows = ([["point", "Points", "Select every point"], ["cusp", "Cusps", "Select every cusp"]] as const).map(([name, label, about]) =>
    ({ name, ...legendRow(name, label, about, () => selectKind(editor, name)) }));
  const element = h(
    "section",
    { class: "section", "aria-label": "Legend" },
    h("div", { class: "section-head" }, h("h3", { class: "section-title" }, "Legend")),
    h("div", { class: "legend" }, ...rows.map(({ row }) => row)),
  );
  return {
    element,
    update(state: EditorState) {
      const measures = measureCurve(state.curve);
      for (const { name, show } of rows) show(name === "point" ? measures.points : measures.cusps);
    },
  };
}
