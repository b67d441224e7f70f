import type { CurveDocument } from "../../document/document.ts";
import { decimalsIn } from "../../document/unit.ts";
import { unitOf } from "../../kernel/unit.ts";
import type { ExportOptions, ExportSegments } from "../../kernel/paths/export.ts";
import { numberField, selectField, toggleField } from "../controls/fields.ts";

/** How the path is written. */

/**
 * Chosen once, kept for the next time the dialog opens; lengths and digits in the unit of whatever drawing it opens
 * with.
 */
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

export function chosenOptions(curve: CurveDocument): ExportOptions {
  const unit = unitOf(curve);
  return { ...chosen, tolerance: rounded(Math.min(1, chosen.tolerance * unit)), decimals: decimalsIn(unit, chosen.decimals) };
}

const rounded = (length: number): number => Number(length.toPrecision(6));

const kinds: readonly (readonly [ExportSegments, string])[] = [
  ["arcs", "Arcs where exact + cubics"],
  ["cubics", "Cubics only"],
  ["polyline", "Polyline"],
];

/** `changed` is told when something else has been chosen. */
export function optionFields(curve: CurveDocument, changed: () => void): readonly HTMLElement[] {
  const choose = (part: Partial<ExportOptions>): void => {
    chosen = { ...chosen, ...part };
    changed();
  };
  return [segmentsField(choose), toleranceField(curve, choose), decimalsField(curve, choose), relativeField(choose)];
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

function toleranceField(curve: CurveDocument, choose: Choose): HTMLElement {
  const unit = unitOf(curve);
  const least = rounded(0.001 * unit);
  const about = `Largest distance from the curve, ${least} to 1 unit.`;
  return numberOf({ label: "Tolerance", testid: "export-tolerance", about, least, most: 1, step: least }, chosenOptions(curve).tolerance, (typed) => {
    choose({ tolerance: typed / unit });
    return typed;
  });
}

function decimalsField(curve: CurveDocument, choose: Choose): HTMLElement {
  const more = decimalsIn(unitOf(curve), 0);
  const about = `Digits after the point, 0 to ${6 + more}.`;
  return numberOf({ label: "Decimals", testid: "export-decimals", about, least: 0, most: 6 + more, step: 1 }, chosenOptions(curve).decimals, (typed) => {
    choose({ decimals: Math.round(typed) - more });
    return Math.round(typed);
  });
}

type NumberSpec = Omit<Parameters<typeof numberField>[0], "format" | "write">;

/** A number that cannot be left empty; `choose` gives back what became of one that was typed. */
function numberOf(spec: NumberSpec, first: number, choose: (typed: number) => number): HTMLElement {
  const field = numberField({
    ...spec,
    format: String,
    write(typed) {
      if (typed !== null) field.show(choose(typed));
    },
  });
  field.show(first);
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
