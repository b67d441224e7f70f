import { fitSamples, samplePoints, type FitSample } from "../../document/fit/fit-samples.ts";
import { strokesOf } from "../../document/fit/fit.ts";
import type { EditorState } from "../../editor/editor.ts";
import { boxOf, openFitSample } from "../../editor/fit/fit-edits.ts";
import { h, svg } from "../controls/dom.ts";
import { mountEmptyStage, sampleCards } from "../mode/empty-stage.ts";
import type { Shell } from "../shell.ts";

/** The sample's points as they are opened. */
function fitThumbnail(sample: FitSample): SVGSVGElement {
  const drawn = samplePoints(sample, sample.settings.noise, sample.settings.seed);
  const box = boxOf(drawn.data) ?? { minX: 0, minY: 0, maxX: 1, maxY: 1 };
  const scale = Math.max((box.maxX - box.minX) / 3, (box.maxY - box.minY) / 2) * 1.2;
  const viewBox = [(box.minX + box.maxX) / 2 - 1.5 * scale, (box.minY + box.maxY) / 2 - scale, 3 * scale, 2 * scale].map((value) => value.toFixed(1)).join(" ");
  const step = Math.max(1, Math.floor(drawn.data.length / 220));
  const path = strokesOf(drawn).map(({ from, to }) =>
    drawn.data.slice(from, to).filter((_, i) => i % step === 0).map(([x, y]) => `M${x.toFixed(1)} ${y.toFixed(1)}h.01`).join("")).join("");
  return svg("svg", { class: "thumbnail thumbnail-dots", viewBox, "aria-hidden": "true" }, svg("path", { d: path }));
}

export function fitSampleCards({ editor }: Shell, done: () => void, samples: readonly FitSample[] = fitSamples): HTMLElement[] {
  const { mode, fit } = editor.state.value;
  return sampleCards(samples, mode === "fit" ? fit.sample : undefined, fitThumbnail, (id) => {
    done();
    openFitSample(editor, id);
  });
}

/** No points: an invitation to draw, a squiggle as an example, and samples. */
export function mountEmptyFit(shell: Shell): void {
  const isEmpty = ({ mode, fit, fitView }: EditorState): boolean => mode === "fit" && fit.data.length === 0 && fit.sample === undefined && fitView.stroke.length === 0;
  mountEmptyStage(shell, isEmpty, () => {
    const squiggle = svg(
      "svg",
      { class: "empty-squiggle", viewBox: "0 0 240 60", "aria-hidden": "true" },
      svg("path", { d: "M8 40C28 4 48 4 64 30S100 62 120 30 158 4 176 30s34 24 56-8" }),
    );
    return h("div", { class: "empty empty-curve empty-fit", testid: "empty-fit" },
      h("h2", {}, "Draw a line here"), squiggle, h("p", { class: "quiet" }, "or paste x,y rows, drop an SVG, or start from a sample"),
      h("div", { class: "samples" }, ...fitSampleCards(shell, () => undefined, fitSamples.slice(0, 3))));
  });
}
