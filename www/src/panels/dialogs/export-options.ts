import type { ExportOptions, ExportSegments } from "../../kernel/paths/export.ts";
import { numberField, selectField, toggleField } from "../controls/fields.ts";

/** How the path is written. */

/** Chosen once, kept for the next time the dialog opens. */
let chosen: ExportOptions = { segments: "arcs", tolerance: 0.02, decimals: 3, relative: false };

/** Lines or areas: what was chosen, else what suits the drawing. */
let look: "lines" | "areas" | null = null;

export function drawsAreas(natural: boolean): boolean {
  return look === null ? natural : look === "areas";
}

/** Lines or areas, of a drawing that can be either; with lines of its own, those are there beside the areas. */
export function lookField(natural: boolean, hasLines: boolean, changed: () => void): HTMLElement {
  const field = selectField<"lines" | "areas">({
    label: "Drawn as",
    testid: "export-look",
    about: "What the SVG and PNG show: lines, or areas with holes.",
    options: [["lines", "Lines"], ["areas", hasLines ? "As painted" : "Filled areas"]],
    write(value) {
      look = value;
      changed();
    },
  });
  field.show(drawsAreas(natural) ? "areas" : "lines");
  return field.element;
}

export function chosenOptions(): ExportOptions {
  return chosen;
}

const kinds: readonly (readonly [ExportSegments, string])[] = [
  ["arcs", "Arcs where exact + cubics"],
  ["cubics", "Cubics only"],
  ["polyline", "Polyline"],
];

/** `changed` is told when something else has been chosen. */
export function optionFields(changed: () => void): readonly HTMLElement[] {
  const choose = (part: Partial<ExportOptions>): void => {
    chosen = { ...chosen, ...part };
    changed();
  };
  return [segmentsField(choose), toleranceField(choose), decimalsField(choose), relativeField(choose)];
}

type Choose = (part: Partial<ExportOptions>) => void;

function segmentsField(choose: Choose): HTMLElement {
  const field = selectField({
    label: "Segments",
    testid: "export-segments",
    about: "The kinds of segment in the path.",
    options: kinds,
    write: (segments) => choose({ segments }),
  });
  field.show(chosen.segments);
  return field.element;
}

function toleranceField(choose: Choose): HTMLElement {
  const about = "Largest distance from the curve, 0.001 to 1 unit.";
  return numberOf("tolerance", { label: "Tolerance", testid: "export-tolerance", about, least: 0.001, most: 1, step: 0.001 }, choose);
}

function decimalsField(choose: Choose): HTMLElement {
  const about = "Digits after the point, 0 to 6.";
  return numberOf("decimals", { label: "Decimals", testid: "export-decimals", about, least: 0, most: 6, step: 1 }, choose, Math.round);
}

type NumberSpec = Omit<Parameters<typeof numberField>[0], "format" | "write">;

/** A number that cannot be left empty; `rounded` is what becomes of one that was typed. */
function numberOf(name: "tolerance" | "decimals", spec: NumberSpec, choose: Choose, rounded = (value: number) => value): HTMLElement {
  const field = numberField({
    ...spec,
    format: String,
    write(typed) {
      if (typed === null) return;
      const value = rounded(typed);
      choose({ [name]: value });
      field.show(value);
    },
  });
  field.show(chosen[name]);
  return field.element;
}

function relativeField(choose: Choose): HTMLElement {
  const field = toggleField({
    label: "Relative commands",
    testid: "export-relative",
    about: "Lower-case commands: shorter text, same curve.",
    write: (relative) => choose({ relative }),
  });
  field.show(chosen.relative);
  return field.element;
}
