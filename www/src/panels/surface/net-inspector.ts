import type { EditorState } from "../../editor/editor.ts";
import type { DragAxis } from "../../editor/surface/solid.ts";
import { nudgeNet, nudgeUnit, patchSolid, placeNet, shownPoint } from "../../editor/surface/surface-edits.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import { numberField, selectField } from "../controls/fields.ts";
import { icon, type IconName } from "../controls/icons.ts";
import { nothingSelected, type Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

const axes: readonly (readonly [DragAxis, string])[] = [
  ["view", "View plane"],
  ["x", "X"],
  ["y", "Y"],
  ["z", "Z"],
  ["normal", "Normal"],
];

const names = ["x", "y", "z"] as const;
const about = (axis: number): string => `${names[axis]?.toUpperCase() ?? ""} of the control point; a typed value is exact.`;

const limit = 1e6;

/** As many decimals as a third of the panel has room for. */
function formatPlace(value: number): string {
  const before = Math.floor(Math.log10(Math.max(1, Math.abs(value))));
  return String(Number(value.toFixed(Math.max(0, 4 - before))) + 0);
}

/** The chosen control point in numbers, and how drags and nudges move it. */
export function netInspector(shell: Shell): Section {
  const { editor } = shell;
  const fields = names.map((name, axis) => numberField({
    label: name.toUpperCase(), testid: `surf-${name}`, about: about(axis),
    least: -limit, most: limit, step: 0.01, format: formatPlace,
    write: (value) => value !== null && placeNet(editor, axis === 0 ? 0 : axis === 1 ? 1 : 2, value),
  }));
  const axis = selectField({
    label: "Drag in",
    testid: "surf-axis",
    about: "Direction in which a drag moves the point. While dragging, press X, Y or Z for an axis, Shift for the normal.",
    options: axes,
    write: (value) => patchSolid(editor, { axis: value }),
    reset: () => patchSolid(editor, { axis: "view" }),
  });
  const pad = nudgePad(shell);
  const which = h("span", { class: "section-note num" });
  const none = h("p", { class: "quiet" });
  const triple = h("div", { class: "triple" }, ...fields.map((field) => field.element));
  const element = h("section", { class: "section", "aria-label": "Selected" },
    h("div", { class: "section-head" }, h("h3", { class: "section-title" }, "Selected"), which), none, triple, axis.element, pad.element);
  return {
    element,
    update(state: EditorState) {
      const { chosen, surface, solid } = state;
      const [ref] = chosen;
      const point = ref === undefined || chosen.length > 1 ? undefined : shownPoint(surface, ref);
      none.hidden = chosen.length > 0;
      setText(none, nothingSelected(state, "a control point"));
      triple.hidden = chosen.length === 0;
      pad.element.hidden = chosen.length === 0;
      setText(which, chosen.length > 1
        ? `${chosen.length} points`
        : ref === undefined ? "" : `${ref.detail === undefined ? "" : "finer "}point ${ref.u + 1}, ${ref.v + 1}`);
      fields.forEach((field, k) => {
        const value = point?.at[k];
        field.show(value ?? null);
        setAttribute(field.input, "title", value === undefined ? about(k) : `${value}. ${about(k)}`);
      });
      axis.show(solid.axis);
      pad.show(nudgeUnit(surface));
    },
  };
}

/** Moving without dragging, in the screen's directions or along the axis of drags. */
function nudgePad({ editor }: Shell): { readonly element: HTMLElement; show(unit: number): void } {
  const directions: readonly (readonly [string, IconName, number, number])[] = [
    ["left", "left", -1, 0],
    ["up", "up", 0, 1],
    ["down", "down", 0, -1],
    ["right", "right", 1, 0],
  ];
  const buttons = directions.map(([name, shape, right, up]) =>
    h("button", {
      class: "icon-button", type: "button", testid: `nudge-${name}`, "aria-label": `Nudge ${name}`,
      click: (event: MouseEvent) => {
        const by = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
        nudgeNet(editor, right * by, up * by);
      },
    }, icon(shape)));
  return {
    element: h("div", { class: "field nudge", role: "group", "aria-label": "Nudge" },
      h("span", { class: "field-label" }, "Nudge"),
      h("span", { class: "nudge-pad" }, ...buttons),
    ),
    show(unit) {
      buttons.forEach((button, i) => setAttribute(button, "title", `Move ${directions[i]?.[0] ?? ""} by ${unit}; with Shift by ${10 * unit}, with Alt by ${unit / 10}`));
    },
  };
}
