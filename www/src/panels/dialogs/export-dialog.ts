import { writeState } from "../../document/file/write.ts";
import { curveSample } from "../../document/curve/samples.ts";
import { exportPath, type ExportedPath, type ExportOptions, type ExportSegments } from "../../kernel/paths/export.ts";
import { documentBounds } from "../../kernel/curve/samples.ts";
import { snippetFor } from "../code/snippets.ts";
import { button, openDialog } from "../controls/dialog.ts";
import { h, setAttribute, setText, svg } from "../controls/dom.ts";
import { numberField, selectField, toggleField } from "../controls/fields.ts";
import { formatBytes, formatDeviation } from "../controls/format.ts";
import { asProblem, errorText } from "../messages/errors.ts";
import { problemText } from "../messages/file-errors.ts";
import type { Shell } from "../shell.ts";

/** Chosen once, kept for the next time the dialog opens. */
let chosen: ExportOptions = { segments: "arcs", tolerance: 0.02, decimals: 3, relative: false };
let scale = 2;
let onPaper = false;

const kinds: readonly (readonly [ExportSegments, string])[] = [
  ["arcs", "Arcs where exact + cubics"],
  ["cubics", "Cubics only"],
  ["polyline", "Polyline"],
];

/** The drawing as text and files, with a preview, its size, and the deviation measured on the text itself. */
export function openExport(shell: Shell): void {
  const { editor, io, toasts } = shell;
  const { curve: own, mode } = editor.state.value;
  const curve = editor.modes.get(mode)?.drawing?.(editor.state.value) ?? own;
  const box = documentBounds(curve);
  let exported: ExportedPath | null = null;

  const picture = h("div", { class: "export-picture" });
  const preview = h("textarea", { class: "code-field", testid: "export-preview", rows: "5", readonly: true, "aria-label": "Path data", spellcheck: "false" });
  const numbers = h("dl", { class: "export-numbers num" });
  const message = h("div", { class: "message-slot" });

  const refresh = (): void => {
    try {
      exported = exportPath(curve, chosen);
      message.replaceChildren();
    } catch (error) {
      const problem = asProblem(error);
      message.replaceChildren(h("p", { class: "message message-error", testid: "error", "data-error": problem.id, role: "alert" },
        problemText(problem.id, problem.details),
      ));
      return;
    }
    preview.value = exported.d;
    picture.replaceChildren(drawn(exported.d, box));
    void showNumbers(shell, numbers, exported);
  };
  const change = (part: Partial<ExportOptions>): void => {
    chosen = { ...chosen, ...part };
    refresh();
  };
  const segments = selectField({
    label: "Segments",
    testid: "export-segments",
    about: "What the path is made of.",
    options: kinds,
    write: (value) => change({ segments: value }),
  });
  const tolerance = numberField({
    label: "Tolerance",
    testid: "export-tolerance",
    about: "Largest distance from the curve, 0.001 to 1 units.",
    least: 0.001,
    most: 1,
    step: 0.001,
    format: String,
    write: (value) => { if (value !== null) { change({ tolerance: value }); tolerance.show(value); } },
  });
  const decimals = numberField({
    label: "Decimals",
    testid: "export-decimals",
    about: "Digits after the point, 0 to 6.",
    least: 0,
    most: 6,
    step: 1,
    format: String,
    write: (value) => { if (value !== null) { change({ decimals: Math.round(value) }); decimals.show(Math.round(value)); } },
  });
  const relative = toggleField({
    label: "Relative commands",
    testid: "export-relative",
    about: "Lower-case commands: shorter text, the same curve.",
    write: (on) => change({ relative: on }),
  });
  segments.show(chosen.segments);
  tolerance.show(chosen.tolerance);
  decimals.show(chosen.decimals);
  relative.show(chosen.relative);

  const dialog = openDialog(
    { title: "Export", testid: "export-dialog", wide: true },
    h("div", { class: "export" },
      h("div", { class: "export-options" }, picture, segments.element, tolerance.element, decimals.element, relative.element),
      h("div", { class: "export-result" }, preview, numbers, message),
    ),
  );
  // What was traced is ink, not lines.
  const filled = mode === "trace" && curve.contours.every(({ closed }) => closed);
  const colored = editor.modes.get(mode)?.layers?.(editor.state.value) ?? [];
  const svgText = (): Promise<string> => io.writeSvg({
    title, d: exported?.d ?? "", box, filled,
    layers: colored.map(({ color, drawing }) => ({ color, d: exportPath(drawing, chosen).d })),
  });
  const stem = curve.sample ?? "expline";
  const title = curveSample(curve.sample ?? "")?.title ?? "expline drawing";
  const copy = (text: string, what: string) => (): void => {
    void io.copyText(text).then((done) => (done ? toasts.say(`Copied ${what}.`) : toasts.error("clipboard", errorText("clipboard"))));
  };
  dialog.foot.append(
    button("Copy path", { class: "primary", testid: "export-d", title: "Copy the path's d", click: () => copy(exported?.d ?? "", "the path")() }),
    button("SVG", {
      testid: "export-svg",
      title: "Download an SVG file",
      click: () => void svgText().then((text) => io.download(`${stem}.svg`, new Blob([text], { type: "image/svg+xml" }))),
    }),
    button("JSON", {
      testid: "export-json",
      title: "Download the drawing, to open it here again",
      click: () => io.download(`${stem}.json`, new Blob([writeState(editor.getState())], { type: "application/json" })),
    }),
    pngGroup(shell, stem, () => exported?.d ?? "", box),
    button(
      "TypeScript",
      { testid: "export-ts", title: "Copy TypeScript that makes this drawing", click: () => copy(snippetFor("vanilla", curve, chosen), "TypeScript")() },
    ),
  );
  refresh();
  dialog.body.scrollTop = 0;
}

type Box = ReturnType<typeof documentBounds>;

function drawn(d: string, box: Box): SVGSVGElement {
  if (box === null) return svg("svg", { "aria-hidden": "true" });
  const margin = Math.max(box.maxX - box.minX, box.maxY - box.minY) * 0.06 + 1e-6;
  const viewBox = [box.minX - margin, box.minY - margin, box.maxX - box.minX + 2 * margin, box.maxY - box.minY + 2 * margin].join(" ");
  return svg("svg", { viewBox, role: "img", "aria-label": "Preview of the exported path" }, svg("path", { class: "thumbnail-curve", d }));
}

/** The numbers of a path, at once; what it weighs compressed takes its place in them when it is known. */
async function showNumbers({ io }: Shell, list: HTMLElement, exported: ExportedPath): Promise<void> {
  const raw = new TextEncoder().encode(exported.d).length;
  const row = (label: string, testid: string, text: string, value?: number): HTMLElement =>
    h("div", {}, h("dt", {}, label), h("dd", { testid, "data-value": value }, text));
  const unknown = row("Gzipped", "export-gzip", "…");
  list.replaceChildren(
    row("Deviation, measured", "export-deviation", formatDeviation(exported.deviation), exported.deviation),
    row("Commands", "export-commands", String(exported.commands), exported.commands),
    row("Size", "export-bytes", formatBytes(raw), raw),
    unknown,
  );
  const gzipped = await io.gzippedSize(exported.d);
  // Answers may come in any order: of a path that is no longer shown, the row is no longer there.
  unknown.replaceWith(row("Gzipped", "export-gzip", formatBytes(gzipped), gzipped));
}

/** The picture, its scale and what is under it; the size it will have is printed on the button. */
function pngGroup({ io, toasts }: Shell, stem: string, d: () => string, box: Box): HTMLElement {
  const save = button("PNG", { testid: "export-png", title: "Download a picture" });
  const label = save.querySelector("span");
  const show = (): void => {
    const size = io.pngSize(box, scale);
    if (label !== null) setText(label, size === null ? "PNG" : `PNG ${size.width} × ${size.height}`);
    setAttribute(save, "data-width", size === null ? null : String(size.width));
    setAttribute(save, "data-height", size === null ? null : String(size.height));
    save.disabled = size === null;
  };
  save.addEventListener("click", () => {
    const colour = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    const paper = onPaper ? colour("--canvas") : null;
    void io.writePng({ d: d(), box, scale, paper, ink: colour("--curve"), fill: colour("--point") }).then((blob) => {
      if (blob === null) toasts.say("This picture is larger than the browser can draw. Choose a smaller scale.");
      else io.download(`${stem}@${scale}x.png`, blob);
    });
  });
  const scales = h("select", { class: "select", testid: "export-png-scale", "aria-label": "Picture scale" },
    ...[1, 2, 4].map((each) => h("option", { value: each }, `${each}×`)),
  );
  scales.value = String(scale);
  scales.addEventListener("change", () => { scale = Number(scales.value); show(); });
  const papers = h("select", { class: "select", testid: "export-png-paper", "aria-label": "Picture background" },
    h("option", { value: "none" }, "transparent"),
    h("option", { value: "paper" }, "paper"),
  );
  papers.value = onPaper ? "paper" : "none";
  papers.addEventListener("change", () => { onPaper = papers.value === "paper"; });
  show();
  return h("span", { class: "button-group", role: "group", "aria-label": "Picture" }, save, scales, papers);
}
