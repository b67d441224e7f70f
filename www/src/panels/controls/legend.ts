import { h, setAttribute, setText } from "./dom.ts";
import { glyph } from "./icons.ts";

/** A mark, what it stands for, and how many there are of it; a press finds them. */
export interface LegendRow {
  readonly row: HTMLElement;
  show(count: number): void;
}

export function legendRow(kind: Parameters<typeof glyph>[0], label: string, about: string, find: () => void): LegendRow {
  const number = h("b", { class: "num" });
  const row = h("button", { class: "legend-row", type: "button", testid: `legend-${kind}`, title: about, click: find }, glyph(kind), h("span", {}, label), number);
  return {
    row,
    show(count) {
      setText(number, String(count));
      setAttribute(row, "data-value", String(count));
      row.disabled = count === 0;
    },
  };
}
