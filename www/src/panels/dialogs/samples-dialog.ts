import type { Mode } from "../../document/document.ts";
import { curveSamples } from "../../document/curve/samples.ts";
import { openSample } from "../../editor/route.ts";
import { openDialog } from "../controls/dialog.ts";
import { h } from "../controls/dom.ts";
import { thumbnail } from "../curve/thumbnail.ts";
import type { Shell } from "../shell.ts";

/**
 * The gallery: every sample as it will look, with a sentence on what it is for. While a mode is on its way, its samples
 * are.
 */
export function openSamples(shell: Shell): void {
  const { mode } = shell.editor.state.value;
  if (mode === "curve" || shell.samples.has(mode)) open(shell);
  else openWhenThere(shell, mode);
}

/** Nobody who has gone elsewhere meanwhile is offered them, nor anybody twice. */
function openWhenThere(shell: Shell, mode: Mode): void {
  const waiting = new AbortController();
  shell.editor.state.subscribe((state) => {
    const isThere = shell.samples.has(mode);
    if (!isThere && state.mode === mode) return;
    waiting.abort();
    if (state.mode === mode && document.querySelector("dialog[open]") === null) open(shell);
  }, { until: waiting.signal });
}

function open(shell: Shell): void {
  const present = shell.editor.state.value.curve.sample;
  const cards = curveSamples.map((sample) =>
    h(
      "button",
      {
        class: "sample",
        type: "button",
        testid: `sample-${sample.id}`,
        "aria-current": sample.id === present ? "true" : null,
        click: () => { dialog.close(); choose(shell, sample.id); },
      },
      thumbnail(sample.curve),
      h("span", { class: "sample-title" }, sample.title),
      h("span", { class: "sample-note quiet" }, sample.note),
    ),
  );
  const own = shell.samples.get(shell.editor.state.value.mode)?.(() => dialog.close());
  const dialog = openDialog({ title: "Samples", testid: "samples-dialog", wide: true }, h("div", { class: "samples" }, ...(own ?? cards)));
}

/** In Curve, in view, as one step of the history. */
export function choose({ editor }: Shell, id: string): void {
  if (editor.state.value.mode !== "curve") editor.actions.run("mode-curve");
  openSample(editor, id);
}
