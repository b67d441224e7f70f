import { traceSamples, type TraceSample } from "../../document/trace-samples.ts";
import { isEmptyTrace } from "../../document/trace.ts";
import type { EditorState } from "../../editor/editor.ts";
import { openTraceSample } from "../../editor/trace/trace-edits.ts";
import { drawSample, imageOf } from "../../kernel/trace/raster.ts";
import { h } from "../dom.ts";
import type { Shell } from "../shell.ts";
import { pictureField } from "./picture-section.ts";

/** A sample in small: drawn as it is drawn in large. */
function pictureOf(sample: TraceSample): HTMLCanvasElement {
  const drawn = drawSample(sample, 168);
  const canvas = h("canvas", { class: "thumbnail thumbnail-picture", width: drawn.width, height: drawn.height, "aria-hidden": "true" });
  canvas.getContext("2d")?.putImageData(imageOf(drawn), 0, 0);
  return canvas;
}

export function traceSampleCards(shell: Shell, done: () => void, samples: readonly TraceSample[] = traceSamples): HTMLElement[] {
  const present = shell.editor.state.value.mode === "trace" ? shell.editor.state.value.trace.sample : undefined;
  return samples.map((sample) =>
    h("button", { class: "sample", type: "button", testid: `sample-${sample.id}`, title: sample.note, "aria-current": sample.id === present ? "true" : null, click: () => { done(); openTraceSample(shell.editor, sample.id); } },
      pictureOf(sample), h("span", { class: "sample-title" }, sample.title), h("span", { class: "sample-note quiet" }, sample.note)));
}

/** No picture: a place to drop one, and four to start from. */
export function mountEmptyTrace(shell: Shell): void {
  const { editor, regions, until } = shell;
  let card: HTMLElement | null = null;
  const build = (): HTMLElement =>
    h("div", { class: "empty empty-curve empty-trace", testid: "empty-trace" },
      h("h2", {}, "Drop a picture, paste one, or try"),
      pictureField(shell, "empty-file"),
      h("div", { class: "samples" }, ...traceSampleCards(shell, () => undefined, traceSamples.slice(0, 4))),
      h("p", { class: "quiet" }, "Pictures stay on this device: nothing is sent anywhere."));
  const update = ({ mode, trace, incoming }: EditorState): void => {
    const empty = mode === "trace" && incoming === null && isEmptyTrace(trace);
    if (!empty) {
      card?.remove();
      card = null;
    } else if (card === null) {
      card = build();
      regions.stage.append(card);
    }
  };
  editor.state.subscribe(update, { now: true, until });
}
