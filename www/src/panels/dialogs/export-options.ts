import type { ExportOptions, ExportSegments } from "../../kernel/paths/export.ts";
import { numberField, selectField, toggleField } from "../controls/fields.ts";

/** How the path is written. */

/** Chosen once, kept for the next time the dialog opens. */
let chosen: ExportOptions = { segments: "arcs", tolerance: 0.02, decimals: 3, relative: false };

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
    about: "What the path is made of.",
    options: kinds,
    write: (segments) => choose({ segments }),
  });
  field.show(chosen.segments);
  return field.element;
}

function toleranceField(choose: Choose): HTMLElement {
  const field = numberField({
    label: "Tolerance",
    testid: "export-tolerance",
    about: "Largest distance from the curve, 0.001 to 1 units.",
    least: 0.001,
    most: 1,
    step: 0.001,
    format: String,
    write(tolerance) {
      if (tolerance === null) return;
      choose({ tolerance });
      field.show(tolerance);
    },
  });
  field.show(chosen.tolerance);
  return field.element;
}

function decimalsField(choose: Choose): HTMLElement {
  const field = numberField({
    label: "Decimals",
    testid: "export-decimals",
    about: "Digits after the point, 0 to 6.",
    least: 0,
    most: 6,
    step: 1,
    format: String,
    write(value) {
      if (value === null) return;
      const decimals = Math.round(value);
      choose({ decimals });
      field.show(decimals);
    },
  });
  field.show(chosen.decimals);
  return field.element;
}

function relativeField(choose: Choose): HTMLElement {
  const field = toggleField({
    label: "Relative commands",
    testid: "export-relative",
    about: "Lower-case commands: shorter text, the same curve.",
    write: (relative) => choose({ relative }),
  });
  field.show(chosen.relative);
  return field.element;
}
