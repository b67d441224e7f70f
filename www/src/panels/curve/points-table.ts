import { whenLoaded } from "../../editor/loading.ts";
import { h } from "../controls/dom.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

/** A part of the panel that is folded away, and loaded when it is first unfolded. */
export function folded(shell: Shell, title: string, testid: string, load: () => Promise<Section>): Section {
  let part: Section | null = null;
  let asked = false;
  const details = h("details", { class: "section disclosure", testid }, h("summary", { class: "section-title" }, title));
  details.addEventListener("toggle", () => {
    part?.update(shell.editor.state.value);
    if (!details.open || asked) return;
    asked = true;
    whenLoaded(shell.editor, load(), (loaded) => {
      part = loaded;
      details.append(loaded.element);
      loaded.update(shell.editor.state.value);
    });
  });
  return {
    element: details,
    update(state) {
      if (details.open) part?.update(state);
    },
  };
}

/** The model without the picture: every point's place and kind, to read and to edit. */
export function pointsTableSection(shell: Shell): Section {
  return folded(shell, "Points table", "points-fold", async () => (await import("./points-rows.ts")).pointsTable(shell));
}

/** Why a point acts near by only: the functions that its curve is made of. */
export function generatorSection(shell: Shell): Section {
  return folded(shell, "Generator", "generator-fold", async () => (await import("./generator-plot.ts")).generatorPlot());
}
