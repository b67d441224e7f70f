import { curveSample } from "../../document/curve/samples.ts";
import { activeContours } from "../../editor/curve/edits.ts";
import { h } from "../controls/dom.ts";
import type { ModePanel, Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";
import { actionsRow, familyRow, frequencyRow, levelRow, orderRow, pointsRow, spaceRow } from "./curve-rows.ts";
import { inspectorSection } from "./inspector/inspector.ts";
import { generatorSection, pointsTableSection } from "./points-table.ts";
import { legendSection, showSection } from "./show.ts";

export function curvePanel(shell: Shell): ModePanel & { readonly peek: HTMLElement } {
  const curve = curveSection(shell);
  const sections = [curve, inspectorSection(shell), showSection(shell), legendSection(shell), generatorSection(shell), pointsTableSection(shell)];
  return {
    element: h("div", {}, ...sections.map(({ element }) => element)),
    peek: curve.level,
    // Points may be added to what was opened: only its name is still true then.
    note: (state) => curveSample(state.curve.sample ?? "")?.title.split(",")[0] ?? "",
    update(state) {
      if (state.engine.status === "ready") for (const section of sections) section.update(state);
    },
  };
}

/** Family, space, frequency, number of points, level, closed: what the curve is made of. */
function curveSection({ editor }: Shell): Section & { readonly level: HTMLElement } {
  const level = levelRow(editor);
  const rows = [familyRow(editor), spaceRow(editor), orderRow(editor), frequencyRow(editor), pointsRow(editor), level, actionsRow(editor)];
  return {
    element: h("section", { class: "section", "aria-label": "Curve" }, ...rows.flatMap(({ elements }) => elements)),
    level: level.element,
    update(state) {
      const contours = activeContours(state).flatMap((index) => state.curve.contours[index] ?? []);
      for (const row of rows) row.update(state, contours);
    },
  };
}
