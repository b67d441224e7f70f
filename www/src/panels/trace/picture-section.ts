import type { EditorState } from "../../editor/editor.ts";
import { whenLoaded } from "../../editor/loading.ts";
import { traceViews } from "../../editor/trace/trace-actions.ts";
import { canView, setTraceView } from "../../editor/trace/trace-edits.ts";
import type { TraceViewId } from "../../editor/trace/trace-state.ts";
import type { ShownPicture } from "../../kernel/trace/outcome.ts";
import { h, setText } from "../controls/dom.ts";
import { choiceField, sliderField } from "../controls/fields.ts";
import { icon } from "../controls/icons.ts";
import { holdButton } from "../mode/hold-button.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

/** The picture: where it comes from, what is seen of it. */

const accepted = "image/png,image/jpeg,image/webp,image/avif,image/gif,image/bmp,image/*";

export function pictureSection(shell: Shell): Section {
  const { editor } = shell;
  const file = pictureField(shell);
  const name = h("p", { class: "trace-name", testid: "trace-source" });
  const size = h("p", { class: "field-note num" });
  const preview = h("canvas", { class: "trace-preview", width: 96, height: 72, "aria-hidden": "true", hidden: true });
  const samples = h("button", { class: "button", type: "button", testid: "trace-samples", title: "Start from a sample", click: () => editor.actions.run("samples") },
    h("span", {}, "Samples"),
  );
  const view = choiceField<TraceViewId>({
    label: "View", testid: "trace-view", about: "What the stage shows (W for next).",
    options: traceViews.map(([value, label, about]) => ({ value, label, about, disabled: () => !canView(editor.state.value, value) })),
    write: (value) => setTraceView(editor, { view: value }),
  });
  const alpha = sliderField({
    label: "Opacity", testid: "trace-alpha", about: "How strongly the picture shows beneath the outlines.", least: 0, most: 100, step: 1, print: (value) => `${value} %`,
    write: (value) => setTraceView(editor, { alpha: value }), reset: () => setTraceView(editor, { alpha: 35 }),
  });
  const hold = holdButton(shell, "Hold to see the source", "Hold to see only the picture (O)");
  let drawn: ShownPicture | null = null;
  return {
    element: h("section", { class: "section", "aria-label": "Picture" }, file,
      h("div", { class: "trace-picture" }, preview, h("div", { class: "trace-about" }, name, size)),
      h("div", { class: "field-row" }, samples, hold), view.element, alpha.element),
    update(state) {
      const { picture } = state.traceRun;
      setText(name, picture?.name ?? state.trace.kept?.name ?? "No picture yet");
      setText(size, sizeText(state));
      view.show(state.traceView.view);
      alpha.show(state.traceView.alpha);
      alpha.input.disabled = state.trace.kept !== undefined;
      hold.disabled = picture === null;
      if (picture === drawn) return;
      drawn = picture;
      preview.hidden = picture === null;
      drawPreview(preview, picture);
    },
  };
}

/** A native file field under a place that looks as if things could be dropped there, which they can be everywhere. */
export function pictureField(shell: Shell, testid = "trace-file"): HTMLElement {
  const file = h("input", {
    class: "file-field",
    testid,
    type: "file",
    accept: accepted,
    "aria-label": "Choose a picture",
    title: "A PNG, JPEG, WebP, AVIF, GIF or BMP file; it stays on this device.",
  });
  file.addEventListener("change", () => {
    const [chosen] = file.files ?? [];
    if (chosen !== undefined) whenLoaded(shell.editor, import("../files/file-work.ts"), ({ receiveFiles }) => receiveFiles(shell, [chosen]));
    file.value = "";
  });
  return h("label", { class: "file-drop trace-drop" }, icon("plus"), h("span", {}, shell.editor.state.value.touch ? "Choose a picture…" : "Drop, paste or choose…"), file);
}

function sizeText({ trace, traceRun }: EditorState): string {
  const { picture } = traceRun;
  if (picture === null) return trace.kept === undefined ? "" : `${trace.kept.width} × ${trace.kept.height} px. Only the outlines were saved; drop the picture again to retrace it.`;
  const [columns, rows] = picture.analysed;
  const own = `${picture.width} × ${picture.height} px`;
  return columns === picture.width && rows === picture.height ? own : `${own}, analysed at ${columns} × ${rows}`;
}

function drawPreview(canvas: HTMLCanvasElement, picture: ShownPicture | null): void {
  const context = canvas.getContext("2d");
  if (context === null) return;
  context.clearRect(0, 0, canvas.width, canvas.height);
  if (picture === null || picture.source.width === 0) return;
  const scale = Math.min(canvas.width / picture.width, canvas.height / picture.height);
  const [width, height] = [picture.width * scale, picture.height * scale];
  context.imageSmoothingQuality = "high";
  context.drawImage(picture.source, (canvas.width - width) / 2, (canvas.height - height) / 2, width, height);
}
