import type { Axis, Part } from "../../../document/curve/aligning.ts";
import { align, distribute } from "../../../editor/curve/aligning.ts";
import type { Editor } from "../../../editor/editor.ts";
import { h, svg } from "../../controls/dom.ts";
import type { Section } from "../../mode/panel-parts.ts";
import { sizeRows } from "./size-rows.ts";

/** Buttons that bring what is chosen in line. Loaded when several points are chosen first. */

/** 16 × 16, as the icons of the page are. */
const drawings: Readonly<Record<Axis, Readonly<Record<Part | "spread", string>>>> = {
  across: {
    start: "M2.5 2v12M5.5 4h8v3h-8zM5.5 9h5v3h-5z",
    middle: "M8 2v2M8 7v2M8 12v2M3.5 4h9v3h-9zM5.5 9h5v3h-5z",
    end: "M13.5 2v12M2.5 4h8v3h-8zM5.5 9h5v3h-5z",
    spread: "M2.5 2v12M13.5 2v12M6.5 4.5h3v7h-3z",
  },
  down: {
    start: "M2 2.5h12M4 5.5v8h3v-8zM9 5.5v5h3v-5z",
    middle: "M2 8h2M7 8h2M12 8h2M4 3.5v9h3v-9zM9 5.5v5h3v-5z",
    end: "M2 13.5h12M4 2.5v8h3v-8zM9 5.5v5h3v-5z",
    spread: "M2 2.5h12M2 13.5h12M4.5 6.5v3h7v-3z",
  },
};

const names: Readonly<Record<Axis, Readonly<Record<Part | "spread", string>>>> = {
  across: { start: "Align left", middle: "Align horizontal centres", end: "Align right", spread: "Distribute horizontally" },
  down: { start: "Align top", middle: "Align vertical centres", end: "Align bottom", spread: "Distribute vertically" },
};

function row(editor: Editor, axis: Axis, label: string): HTMLElement {
  const buttons = (["start", "middle", "end", "spread"] as const).map((part) =>
    h("button", {
      class: "icon-button",
      type: "button",
      testid: `align-${axis}-${part}`,
      "aria-label": names[axis][part],
      title: names[axis][part],
      click: () => (part === "spread" ? distribute(editor, axis) : align(editor, axis, part)),
    }, svg("svg", { class: "icon", viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("path", { d: drawings[axis][part] }))),
  );
  return h("div", { class: "field nudge", role: "group", "aria-label": label }, h("span", { class: "field-label" }, label), h("span", { class: "nudge-pad" }, ...buttons));
}

/** Place and size above, then what brings the selection in line. */
export function alignSection(editor: Editor): Section {
  const size = sizeRows(editor);
  return {
    element: h("div", { class: "inspector" }, size.element, row(editor, "across", "Align across"), row(editor, "down", "Align down")),
    update: size.update,
  };
}
