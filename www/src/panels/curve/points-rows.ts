import "../../styles/points.css";
import type { Contour, Kind } from "../../document/document.ts";
import { activeContour, setKind, setPoint } from "../../editor/curve/edits.ts";
import { decimalsIn } from "../../document/unit.ts";
import { unitOf } from "../../kernel/unit.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import { formatCoordinate, parseTyped } from "../controls/format.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

const mostRows = 256;
const kinds: readonly Kind[] = ["symmetric", "smooth", "cusp"];

interface Row {
  readonly element: HTMLTableRowElement;
  readonly x: HTMLInputElement;
  readonly y: HTMLInputElement;
  readonly kind: HTMLSelectElement;
}

/** The table itself, loaded when it is first opened. */
export function pointsTable(shell: Shell): Section {
  const { editor } = shell;
  const body = h("tbody");
  const caption = h("caption", { class: "field-note" });
  const head = h("tr", {}, ...["#", "X", "Y", "Kind"].map((label) => h("th", { scope: "col" }, label)));
  const table = h("table", { class: "points-table", testid: "points-table", "aria-label": "Points" }, caption, h("thead", {}, head), body);
  const element = h("div", { class: "table-scroll" }, table);
  const rows: Row[] = [];
  let shown: Contour | undefined;

  const makeRow = (index: number): Row => {
    const ref = (): { contour: number; index: number } => ({ contour: activeContour(editor), index });
    const cell = (axis: "x" | "y"): HTMLInputElement => {
      const input = h("input", { class: "number", type: "text", inputmode: "decimal", autocomplete: "off", "aria-label": `${axis.toUpperCase()} of point ${index + 1}` });
      input.addEventListener("change", () => {
        const value = parseTyped(input.value, -1e9, 1e9);
        if (value !== null) setPoint(editor, ref(), { [axis]: value }, `table-${axis}-${index}`);
        shown = undefined;
        refresh();
      });
      return input;
    };
    const x = cell("x");
    const y = cell("y");
    const kind = h("select", { class: "select", "aria-label": `Kind of point ${index + 1}` }, ...kinds.map((value) => h("option", { value }, value)));
    kind.addEventListener("change", () => {
      const chosen = kinds.find((value) => value === kind.value);
      if (chosen === undefined) return;
      editor.patch({ selection: { points: [ref()], handle: null } });
      setKind(editor, chosen);
    });
    const number = h("button", {
      class: "row-number num",
      type: "button",
      "aria-label": `Select point ${index + 1}`,
      click: () => editor.patch({ selection: { points: [ref()], handle: null } }),
    }, String(index + 1));
    return { element: h("tr", {}, h("th", { scope: "row" }, number), h("td", {}, x), h("td", {}, y), h("td", {}, kind)), x, y, kind };
  };

  const refresh = (): void => {
    const { curve, selection } = editor.state.value;
    const contour = curve.contours[activeContour(editor)];
    // Of a drawing's several contours it shows one.
    setText(caption, `Contour ${activeContour(editor) + 1} of ${curve.contours.length}`);
    caption.hidden = curve.contours.length < 2;
    const count = Math.min(mostRows, contour?.points.length ?? 0);
    while (rows.length > count) rows.pop()?.element.remove();
    while (rows.length < count) {
      const row = makeRow(rows.length);
      rows.push(row);
      body.append(row.element);
    }
    const chosen = new Set(selection.points.filter((ref) => ref.contour === activeContour(editor)).map((ref) => ref.index));
    const decimals = decimalsIn(unitOf(curve), 2);
    rows.forEach((row, i) => {
      setAttribute(row.element, "aria-selected", chosen.has(i) ? "true" : null);
      const point = contour?.points[i];
      if (point === undefined || contour === shown) return;
      if (document.activeElement !== row.x) row.x.value = formatCoordinate(point.x, decimals);
      if (document.activeElement !== row.y) row.y.value = formatCoordinate(point.y, decimals);
      row.kind.value = point.kind;
      row.kind.disabled = contour?.family === "interpolating";
    });
    if (contour !== shown) table.style.setProperty("--digits", String(Math.max(6, ...rows.map(({ x, y }) => Math.max(x.value.length, y.value.length)))));
    shown = contour;
  };
  return { element, update: refresh };
}
