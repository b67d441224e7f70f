import { traceSamples, type TraceSample } from "../../document/trace/trace-samples.ts";
import { isEmptyTrace } from "../../document/trace/trace.ts";
import { openTraceSample } from "../../editor/trace/trace-edits.ts";
import { drawSample, imageOf } from "../../kernel/trace/raster.ts";
import { h } from "../controls/dom.ts";
import { mountEmptyStage, sampleCards } from "../mode/empty-stage.ts";
import type { Shell } from "../shell.ts";
import { pictureField } from "./picture-section.ts";

/** One of each kind: round shapes, corners, colours, lines. */
const offered = traceSamples.filter(({ id }) => ["trace-logo", "trace-postcard", "trace-lines", "trace-star"].includes(id));

/** A sample in small: drawn as it is drawn in large. */
function pictureOf(sample: TraceSample): HTMLCanvasElement {
  const drawn = drawSample(sample, 168);
  const canvas = h("canvas", { class: "thumbnail thumbnail-picture", width: drawn.width, height: drawn.height, "aria-hidden": "true" });
  canvas.getContext("2d")?.putImageData(imageOf(drawn), 0, 0);
  return canvas;
}

export function traceSampleCards({ editor }: Shell, done: () => void, samples: readonly TraceSample[] = traceSamples): HTMLElement[] {
  const { mode, trace } = editor.state.value;
  return sampleCards(samples, mode === "trace" ? trace.sample : undefined, pictureOf, (id) => {
    done();
    openTraceSample(editor, id);
  });
}

/** No picture: a place to drop one, and four to start from. */
export function mountEmptyTrace(shell: Shell): void {
  mountEmptyStage(shell, ({ mode, trace, incoming }) => mode === "trace" && incoming === null && isEmptyTrace(trace), () =>
    h("div", { class: "empty empty-curve empty-trace", testid: "empty-trace" },
      h("h2", {}, shell.editor.state.value.touch ? "Choose a picture, or try" : "Drop a picture, paste one, or try"),
      pictureField(shell, "empty-file"),
      h("div", { class: "samples" }, ...traceSampleCards(shell, () => undefined, offered)),
      h("p", { class: "quiet" }, "Pictures stay on this device. Nothing is uploaded.")));
}
