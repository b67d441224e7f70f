import { writeState } from "../../document/file/write.ts";
import { curveSample } from "../../document/curve/samples.ts";
import type { CurveDocument } from "../../document/document.ts";
import type { Editor } from "../../editor/editor.ts";
import { whenLoaded } from "../../editor/loading.ts";
import { documentBounds } from "../../kernel/curve/samples.ts";
import { writePath } from "../../kernel/paths/export.ts";
import { snippetFor } from "../code/snippets.ts";
import { button, openDialog } from "../controls/dialog.ts";
import { h } from "../controls/dom.ts";
import { layersOf, lookOf } from "../files/look.ts";
import type { FileLook } from "../page-io.ts";
import { printedKey, type Shell } from "../shell.ts";
import { chosenOptions, drawsAreas, lookField, optionFields } from "./export-options.ts";
import { pngGroup } from "./export-png.ts";
import { exportResult, type Box } from "./export-result.ts";

/** The drawing as text and files, with a preview, its size, and the deviation measured on the text itself. */
export function openExport(shell: Shell): void {
  const curve = drawingOnStage(shell.editor);
  if (curve === null || curve.contours.length === 0) return shell.toasts.say("There is nothing to export yet. Draw something, or open a sample.");
  const box = documentBounds(curve);
  // Written once for each choice of options, however many ask for it.
  let written: FileLook | null = null;
  const look = (): FileLook => (written ??= fileLook(shell.editor, curve));
  const result = exportResult(shell, curve, box, look);
  const { mode } = shell.editor.state.value;
  const stem = curve.sample ?? "expline";
  const png = pngGroup(shell, { stem, d: result.d, box, look, asOnStage: () => mode !== "trace" && look().filled !== true });
  const refresh = (): void => {
    written = null;
    result.refresh();
    png.refresh();
  };
  // What was traced is what it was in the picture.
  const looks = mode === "trace" ? [] : [lookField(lookOf(curve, mode).filled, curve.contours.some(({ line }) => line !== undefined), refresh)];
  const dialog = openDialog(
    { title: "Export", testid: "export-dialog", wide: true },
    h("div", { class: "export" },
      h("div", { class: "export-options" }, result.picture, ...looks, ...optionFields(curve, refresh)),
      h("div", { class: "export-result" }, ...result.rows, ...turnedNote(shell.editor)),
    ),
  );
  dialog.foot.append(
    button("Copy path", { class: "primary", testid: "export-d", title: "Copy the path data (d)", click: () => copy(shell, result.d(), "the path") }),
    svgButton(shell, stem, curve, box, result.d, look),
    jsonButton(shell, stem),
    button("TypeScript", {
      testid: "export-ts",
      title: "Copy TypeScript that makes this drawing",
      click: () => copy(shell, snippetFor("vanilla", curve, chosenOptions(curve)), "TypeScript"),
    }),
    png.element,
  );
  refresh();
  dialog.body.scrollTop = 0;
}

/** What is written is a drawing: of a chart, whose y points up, every y is turned over. */
function turnedNote({ state }: Editor): readonly HTMLElement[] {
  const { mode, fit } = state.value;
  return mode === "fit" && fit.up === true ? [h("p", { class: "quiet", testid: "export-turned" }, "In a drawing y points down: every y of your data is written with the other sign. JSON keeps the numbers.")] : [];
}

/** Of another mode than Curve what it made, and never Curve's drawing in place of that. */
function drawingOnStage({ modes, state }: Editor): CurveDocument | null {
  const { mode, curve } = state.value;
  return mode === "curve" ? curve : modes.get(mode)?.drawing?.(state.value) ?? null;
}

function copy({ editor, io, toasts }: Shell, text: string, what: string): void {
  void io.copyText(text).then((done) => {
    if (done) toasts.say(`Copied ${what}.`);
    else whenLoaded(editor, import("../controls/by-hand.ts"), ({ offerByHand }) => offerByHand(text, printedKey("Mod+C")));
  });
}

function jsonButton({ editor, io }: Shell, stem: string): HTMLElement {
  return button("JSON", {
    testid: "export-json",
    title: "Download the drawing to reopen it here",
    click: () => io.download(`${stem}.json`, new Blob([writeState(editor.getState())], { type: "application/json" })),
  });
}

/** Colours, ink or lines; the paths of colours are written with the options that are chosen now. */
function fileLook(editor: Editor, curve: CurveDocument): FileLook {
  const { mode } = editor.state.value;
  const natural = lookOf(curve, mode);
  const filled = mode === "trace" ? natural.filled : drawsAreas(natural.filled);
  const layers = filled ? layersOf(editor, curve) : [];
  return { ...natural, filled, layers: layers.map(({ drawing, ...color }) => ({ ...color, d: writePath(drawing, chosenOptions(curve)) })) };
}

function svgButton({ editor, io }: Shell, stem: string, curve: CurveDocument, box: Box, d: () => string, look: () => FileLook): HTMLElement {
  const title = curveSample(curve.sample ?? "")?.title ?? "expline drawing";
  const save = (text: string): void => io.download(`${stem}.svg`, new Blob([text], { type: "image/svg+xml" }));
  const write = (): void => whenLoaded(editor, io.writeSvg({ title, d: d(), box, ...look() }), save);
  return button("SVG", { testid: "export-svg", title: "Download an SVG file", click: write });
}
