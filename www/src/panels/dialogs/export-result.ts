import { sheetOf } from "../../document/artboard.ts";
import type { PaintedPath } from "../../document/paint-layers.ts";
import type { CurveDocument, Filling } from "../../document/document.ts";
import { whenLoaded } from "../../editor/loading.ts";
import { exportPath, type ExportedPath } from "../../kernel/paths/export.ts";
import type { documentBounds } from "../../kernel/curve/samples.ts";
import { h, svg } from "../controls/dom.ts";
import { formatBytes, formatDeviation, formatMeasure } from "../controls/format.ts";
import { asProblem } from "../messages/errors.ts";
import { problemText } from "../messages/file-errors.ts";
import type { FileLook } from "../page-io.ts";
import type { Shell } from "../shell.ts";
import { chosenOptions } from "./export-options.ts";

/** The path as it is written now: its text, a picture made of the text, and its numbers. */

export type Box = ReturnType<typeof documentBounds>;

export interface ExportResult {
  readonly picture: HTMLElement;
  /** The text and what is to be said of it. */
  readonly rows: readonly HTMLElement[];
  /** The last path that could be written; empty if none could. */
  d(): string;
  /** Writes it anew, with the options that are chosen. */
  refresh(): void;
}

export function exportResult(shell: Shell, curve: CurveDocument, box: Box, look: () => FileLook): ExportResult {
  const picture = h("div", { class: "export-picture" });
  const preview = h("textarea", { class: "code-field", testid: "export-preview", rows: "5", readonly: true, "aria-label": "Path data", spellcheck: "false" });
  const numbers = h("dl", { class: "export-numbers num" });
  const message = h("div", { class: "message-slot" });
  let exported: ExportedPath | null = null;
  return {
    picture,
    rows: [preview, numbers, message],
    d: () => exported?.d ?? "",
    refresh() {
      try {
        exported = exportPath(curve, chosenOptions(curve));
      } catch (error) {
        return message.replaceChildren(complaint(error));
      }
      message.replaceChildren();
      preview.value = exported.d;
      picture.replaceChildren(drawn(exported.d, box, look()));
      showNumbers(shell, numbers, exported, sheetText(curve, box));
    },
  };
}

function complaint(error: unknown): HTMLElement {
  const { id, details } = asProblem(error);
  return h("p", { class: "message message-error", testid: "error", "data-error": id, role: "alert" }, problemText(id, details));
}

/** What the file will show: what was traced as ink or in its colours, a drawing as its lines. */
function drawn(d: string, drawing: Box, { artboard, filled, filling, layers = [] }: FileLook): SVGSVGElement {
  const box = artboard === undefined ? drawing : sheetOf(artboard, drawing);
  if (box === null) return svg("svg", { "aria-hidden": "true" });
  const [width, height] = [box.maxX - box.minX, box.maxY - box.minY];
  const margin = Math.max(width, height) * 0.06 + 1e-6;
  const viewBox = [box.minX - margin, box.minY - margin, width + 2 * margin, height + 2 * margin].join(" ");
  const sheet = artboard === undefined ? [] : [svg("rect", { class: "export-sheet", x: box.minX, y: box.minY, width, height })];
  const area = (text: string, color: string | undefined): SVGPathElement =>
    svg("path", { d: text, "fill-rule": filling === "nonzero" ? filling : "evenodd", ...(color === undefined ? { class: "export-ink" } : { fill: color }) });
  const line = (text: string, how: Filling | undefined): SVGPathElement => {
    const path = svg("path", { class: "thumbnail-curve", d: text });
    if (how !== undefined) path.style[how === "none" ? "fill" : "fillRule"] = how;
    return path;
  };
  // As on the stage, only what is closed has a wash.
  const parts = d.split(/(?=M)/u);
  const washed = (isClosed: boolean): string => parts.filter((part) => /z\s*$/iu.test(part) === isClosed).join("");
  const layer = ({ d: text, color, isLine, line: along }: PaintedPath): SVGPathElement => {
    if (along === undefined) return isLine === true ? line(text, "none") : area(text, color);
    const path = area(text, color);
    if (isLine === true) path.style.fill = "none";
    const { width, color: stroke = "currentcolor", cap, join, dashes, dashOffset = 0 } = along;
    Object.assign(path.style, {
      stroke, strokeWidth: String(width), strokeLinecap: cap ?? "", strokeLinejoin: join ?? "",
      strokeDasharray: dashes?.join(" ") ?? "", strokeDashoffset: String(dashOffset),
    });
    return path;
  };
  const shapes = layers.length > 0 ? layers.map(layer) : filled === true ? [area(d, undefined)] : [line(washed(true), filling), line(washed(false), "none")];
  return svg("svg", { viewBox, role: "img", "aria-label": "Preview of the exported path" }, ...sheet, ...shapes);
}

/** The artboard, which files show as a whole, and whether the drawing reaches out of it; null where there is none. */
function sheetText({ artboard }: CurveDocument, box: Box): string | null {
  if (artboard === undefined) return null;
  const size = `${formatMeasure(artboard.width)} × ${formatMeasure(artboard.height)}`;
  const [own, sheet] = [sheetOf(artboard, null), sheetOf(artboard, box)];
  const isLarger = (["minX", "minY", "maxX", "maxY"] as const).some((side) => own[side] !== sheet[side]);
  return isLarger ? `${size}, grown to fit` : size;
}

/** The numbers of a path, at once; what it weighs compressed takes its place in them when it is known. */
function showNumbers({ editor, io }: Shell, list: HTMLElement, exported: ExportedPath, sheet: string | null): void {
  const raw = new TextEncoder().encode(exported.d).length;
  const row = (label: string, testid: string, text: string, value?: number): HTMLElement =>
    h("div", {}, h("dt", {}, label), h("dd", { testid, "data-value": value }, text));
  const unknown = row("Gzipped", "export-gzip", "…");
  list.replaceChildren(
    row("Deviation, measured", "export-deviation", formatDeviation(exported.deviation), exported.deviation),
    row("Commands", "export-commands", String(exported.commands), exported.commands),
    row("Size", "export-bytes", formatBytes(raw), raw),
    unknown,
    ...(sheet === null ? [] : [row("Artboard", "export-artboard", sheet)]),
  );
  // Answers may come in any order: of a path that is no longer shown, the row is no longer there.
  whenLoaded(editor, io.gzippedSize(exported.d), (gzipped) => unknown.replaceWith(row("Gzipped", "export-gzip", formatBytes(gzipped), gzipped)));
}
