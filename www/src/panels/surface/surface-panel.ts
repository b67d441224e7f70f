import "../../styles/buttons.css";
import "../../styles/surface.css";
import { surfaceSamples, surfaceTitle } from "../../document/surface/surface-samples.ts";
import type { Editor, EditorState } from "../../editor/editor.ts";
import type { Shade } from "../../editor/surface/solid.ts";
import { turn } from "../../editor/surface/surface-actions.ts";
import { openSurfaceSample, patchSolid, setNetSize, setSurfaceLevels, turnView } from "../../editor/surface/surface-edits.ts";
import { netSize } from "../../kernel/surface/surface-net.ts";
import { h, setText } from "../controls/dom.ts";
import { numberField, selectField, sliderField, toggleField } from "../controls/fields.ts";
import { glyph, icon } from "../controls/icons.ts";
import type { ModePanel, Section } from "../mode/panel-parts.ts";
import { stackedPanel } from "../mode/stacked-panel.ts";
import type { Shell } from "../shell.ts";
import { netInspector } from "./net-inspector.ts";

/** Surface mode's properties. */
export function surfacePanel(shell: Shell): ModePanel {
  const shape = shapeSection(shell);
  const sections = [shape, netInspector(shell), showSection(shell), legendSection()];
  return stackedPanel(
    "surface-panel",
    sections,
    { peek: shape.level, note: ({ surface }) => surfaceTitle(surface.sample), ready: ({ surface }) => surface.net.length > 0 },
  );
}

function shapeSection(shell: Shell): Section & { readonly level: HTMLElement } {
  const { editor } = shell;
  const sample = selectField({
    label: "Shape", testid: "surf-sample", about: "A surface to start from. Undo restores the previous one.",
    options: surfaceSamples.map(({ id, title }) => [id, title] as const),
    write: (id) => { openSurfaceSample(editor, id); },
  });
  const size = (which: "u" | "v", label: string) => numberField({
    label, testid: `surf-${which}`, about: `Control points in ${which}, 3 to 32. Exact for the samples, measured for anything else.`,
    least: 3, most: 32, step: 1, format: String, write: (value) => value !== null && setNetSize(editor, which, value),
  });
  const [sizeU, sizeV] = [size("u", "U"), size("v", "V")];
  const net = h("div", { class: "field net-size", role: "group", "aria-label": "Net size" },
    h("span", { class: "field-label" }, "Net size"),
    h("span", { class: "pair" }, sizeU.element, sizeV.element),
  );
  const level = (which: "u" | "v") => sliderField({
    label: `Level ${which.toUpperCase()}`, testid: `surf-level-${which}`, about: `Doubles the points in ${which} without moving the surface.`,
    least: 0, most: 3, step: 1, direction: "finer", print: String,
    write: (value) => {
      const { levelU, levelV } = editor.state.value.surface;
      setSurfaceLevels(editor, which === "u" ? value : levelU, which === "v" ? value : levelV);
    },
    reset: () => setSurfaceLevels(editor, which === "u" ? 0 : editor.state.value.surface.levelU, which === "v" ? 0 : editor.state.value.surface.levelV),
    edits: editor.surfaceEdits,
  });
  const [levelU, levelV] = [level("u"), level("v")];
  const badge = h("span", { class: "badge num", testid: "surf-badge" });
  const refine = h("button", {
    class: "button",
    type: "button",
    testid: "surf-refine",
    title: "Adds control points around the selection only (Enter)",
    click: () => editor.actions.run("surface-refine"),
  }, h("span", {}, "Refine here"));
  const element = h("section", { class: "section", "aria-label": "Surface" }, sample.element, net, levelU.element, levelV.element, h("div", { class: "field-row" },
    refine,
    badge,
  ));
  return {
    element,
    level: levelU.element,
    update(state: EditorState) {
      const { surface } = state;
      sample.show(surface.sample);
      const refined = surface.levelU + surface.levelV > 0 || surface.details !== undefined;
      const [u, v] = netSize(surface);
      sizeU.show(refined ? null : u);
      sizeV.show(refined ? null : v);
      // What is shown while it cannot be changed.
      if (refined) [sizeU.input.value, sizeV.input.value] = [String(u), String(v)];
      levelU.show(surface.levelU);
      levelV.show(surface.levelV);
      refine.disabled = state.chosen.length === 0;
      const places = surface.details?.length ?? 0;
      setText(badge, places === 0 ? `${surface.patches} patches` : `${surface.patches} patches + ${places} refined ${places === 1 ? "area" : "areas"}`);
    },
  };
}

const shadings: readonly (readonly [Shade, string])[] = [
  ["solid", "Solid"],
  ["wire", "Wire"],
  ["normals", "Normals"],
  ["curvature", "Curvature"],
  ["zebra", "Zebra"],
];

const shadeNotes: Readonly<Record<Shade, string>> = {
  solid: "Outside and inside in different colours",
  wire: "Lines of constant parameter",
  normals: "The normal's direction as colour",
  curvature: "Gaussian: bowl warm, saddle cool, flat pale",
  zebra: "Stripes kink where the curvature jumps",
};

function showSection(shell: Shell): Section {
  const { editor } = shell;
  const shade = selectField({
    label: "Shading",
    testid: "surf-shade",
    about: "What the colours mean.",
    options: shadings,
    write: (value) => patchSolid(editor, { shade: value }),
    reset: () => patchSolid(editor, { shade: "solid" }),
  });
  const note = h("p", { class: "field-note" });
  const sides = sliderField({
    label: "Tessellation", testid: "surf-tess", about: "Triangles per patch side when drawn; the surface itself is exact.",
    least: 4, most: 64, step: 1, direction: "smoother", print: String,
    write: (value) => patchSolid(editor, { tessellation: value }), reset: () => patchSolid(editor, { tessellation: 16 }),
  });
  const switches = ([
    ["net", "ov-net", "Net", "Lines between neighbouring control points."],
    ["iso", "ov-iso", "Iso-lines", "Lines on the surface where segments meet."],
    ["handles", "ov-handles", "Points", "The control points."],
    ["weights", "ov-weights", "Weights", "How strongly the selected point acts, along the two lines through it."],
  ] as const)
    .map(([name, testid, label, about]) => ({ name, field: toggleField({ label, testid, about, write: (on) => patchSolid(editor, { [name]: on }) }) }));
  const views = (["front", "side", "top"] as const).map((side) =>
    h("button", { class: "button", type: "button", testid: `surf-${side}`, title: `Look from the ${side}`, click: () => editor.actions.run(`surface-look-${side}`) },
      h("span", {}, side === "front" ? "Front" : side === "side" ? "Side" : "Top"),
    ));
  const element = h("section", { class: "section", "aria-label": "Show" },
    h("div", { class: "section-head" }, h("h3", { class: "section-title" }, "Show")),
    h("div", { class: "field surf-views", role: "group", "aria-label": "Look from" },
      h("span", { class: "field-label" }, "Look from"),
      h("span", { class: "button-group" }, ...views),
    ),
    turnPad(editor), shade.element, note, sides.element, h("div", { class: "toggles" }, ...switches.map(({ field }) => field.element)));
  return {
    element,
    update({ solid }) {
      shade.show(solid.shaded ? solid.shade : null);
      setText(note, solid.shaded ? shadeNotes[solid.shade] : "Drawn in lines, without WebGL 2");
      sides.show(solid.tessellation);
      for (const { name, field } of switches) field.show(solid[name]);
    },
  };
}

/** Turning without dragging. */
function turnPad(editor: Editor): HTMLElement {
  const buttons = ([["left", -1, 0], ["up", 0, -1], ["down", 0, 1], ["right", 1, 0]] as const).map(([name, right, down]) =>
    h("button", {
      class: "icon-button", type: "button", testid: `surf-turn-${name}`, "aria-label": `Turn ${name}`,
      title: `Turn the view ${name} by ${turn}°; with Alt by 1°. Arrow keys do it while nothing is selected.`,
      click: ({ altKey }: MouseEvent) => {
        const by = altKey ? 1 : turn;
        turnView(editor, right * by, down * by);
      },
    }, icon(name)));
  return h("div", { class: "field nudge", role: "group", "aria-label": "Turn" }, h("span", { class: "field-label" }, "Turn"), h("span", { class: "nudge-pad" }, ...buttons));
}

function legendSection(): Section {
  const row = (mark: Node, text: string): HTMLElement => h("li", { class: "legend-line" }, mark, h("span", {}, text));
  const element = h("section", { class: "section", "aria-label": "Legend" },
    h("div", { class: "section-head" }, h("h3", { class: "section-title" }, "Legend")),
    h("ul", { class: "legend-lines" },
      row(glyph("point"), "On the surface"),
      row(glyph("vertex"), "Near it: finer levels and open ends"),
      row(glyph("handle"), "Hollow: facing away")));
  return { element, update: () => undefined };
}
