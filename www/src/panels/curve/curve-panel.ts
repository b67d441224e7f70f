import { activeContour } from "../../editor/curve/edits.ts";
import { h } from "../controls/dom.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";
import { actionsRow, familyRow, frequencyRow, levelRow, orderRow, pointsRow, spaceRow } from "./curve-rows.ts";

/** Family, space, frequency, number of points, level, closed: what the curve is made of. */
export function curveSection({ editor }: Shell): Section & { readonly level: HTMLElement } {
  const level = levelRow(editor);
  const rows = [familyRow(editor), spaceRow(editor), orderRow(editor), frequencyRow(editor), pointsRow(editor), level, actionsRow(editor)];
  return {
    element: h("section", { class: "section", "aria-label": "Curve" }, ...rows.flatMap(({ elements }) => elements)),
    level: level.element,
    update(state) {
      const contour = state.curve.contours[activeContour(editor)];
      for (const row of rows) row.update(state, contour);
    },
  };
}
