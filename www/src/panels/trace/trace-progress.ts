import { traceLimits } from "../../document/trace/trace.ts";
import type { EditorState } from "../../editor/editor.ts";
import { setTrace } from "../../editor/trace/trace-edits.ts";
import type { TraceFailure, TraceProgress } from "../../editor/trace/trace-state.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import type { Shell } from "../shell.ts";

/** Over the stage: how far the tracer has come, with a way to stop it; or why there is nothing to see, with a way on. */

/** What is done sooner needs no bar; what takes longer gets words and a way out. */
const [barAfterMs, wordsAfterMs] = [150, 300];

const names: Readonly<Record<TraceProgress["stage"], string>> = {
  decoding: "Decoding", edges: "Edges", contours: "Contours", corners: "Corners", splines: "Splines", refinement: "Refinement", layers: "Layers", measuring: "Measuring",
};

export function progressText({ stage, value, done, total }: TraceProgress): string {
  const part = total > 1 ? ` ${done} of ${total}` : "";
  return `${names[stage]}${part} · ${Math.round(100 * value)} %`;
}

export function mountTraceProgress(shell: Shell): void {
  const { editor, regions, until } = shell;
  const words = h("span", { class: "num" });
  const fill = h("div", { class: "trace-fill" });
  const cancel = h("button", { class: "small-button", type: "button", title: "Stop; the outlines before stay.", click: () => editor.actions.run("trace-cancel") },
    "Cancel",
  );
  const bar = h("div", { class: "trace-progress", testid: "progress", role: "progressbar", "aria-label": "Tracing", "aria-valuemin": "0", "aria-valuemax": "100" },
    fill,
    words,
  );
  const box = h("div", { class: "trace-busy", hidden: true }, bar, cancel);
  const notice = h("div", { class: "trace-notice", hidden: true });
  regions.stage.append(box, notice);
  let timer: ReturnType<typeof setTimeout> | undefined;
  let said: TraceFailure | null = null;

  const show = ({ mode, traceRun }: EditorState): void => {
    clearTimeout(timer);
    const { since, progress, failure } = traceRun;
    const waited = since === null || mode !== "trace" ? 0 : performance.now() - since;
    box.hidden = waited < barAfterMs;
    const worded = waited >= wordsAfterMs;
    words.hidden = cancel.hidden = !worded;
    if (since !== null && mode === "trace" && !worded) timer = setTimeout(() => show(editor.state.value), 60);
    if (progress !== null) {
      const percent = Math.round(100 * progress.value);
      setText(words, progressText(progress));
      setAttribute(bar, "aria-valuenow", String(percent));
      setAttribute(bar, "aria-valuetext", progressText(progress));
      fill.style.transform = `scaleX(${progress.value.toFixed(3)})`;
    }
    const shown = mode === "trace" && since === null ? failure : null;
    if (shown === said) return;
    said = shown;
    notice.hidden = shown === null;
    notice.replaceChildren(...(shown === null ? [] : sayingOf(shell, shown)));
  };
  editor.state.subscribe((state, before) => {
    if (state.traceRun !== before.traceRun || state.mode !== before.mode) show(state);
  }, { until });
  until.addEventListener("abort", () => clearTimeout(timer), { once: true });
  show(editor.state.value);
}

function sayingOf({ editor }: Shell, failure: TraceFailure): HTMLElement[] {
  const offer = (label: string, run: () => void, testid: string): HTMLElement =>
    h("button", { class: "button", type: "button", testid, click: run }, h("span", {}, label));
  const offers: HTMLElement[] = [];
  if (failure.id === "trace-none") offers.push(offer("Invert", () => editor.actions.run("trace-invert"), "offer-invert"));
  if (failure.id === "trace-photo") {
    offers.push(offer("Trace anyway", () => editor.actions.run("trace-anyway"), "offer-anyway"));
    const { speckle = 0 } = failure;
    if (isOffered(speckle)) offers.push(offer(`Speckle ${speckle} px²`, () => setTrace(editor, "Speckle", { speckle }), "offer-speckle"));
  }
  if (failure.id === "engine") offers.push(offer("Try again", () => editor.actions.run("trace-run"), "offer-again"));
  return [
    h("p", { testid: "error", "data-error": failure.id, role: "alert" }, icon("warn"), h("span", {}, textOf(failure))),
    ...(offers.length === 0 ? [] : [h("div", { class: "field-row" }, ...offers)]),
  ];
}

/** Whether the slider goes so far. */
const isOffered = (speckle: number): boolean => speckle > 0 && speckle <= traceLimits.speckle;

function textOf({ id, count = 0, speckle = 0, code = "unknown" }: TraceFailure): string {
  switch (id) {
    case "trace-none":
      return "No edges found. Raise Blur, change Threshold, or try Invert.";
    case "trace-photo":
      return `This looks like a photograph: ${count} contours. ${isOffered(speckle) ? `Raise Speckle to about ${speckle}` : "Raise Speckle"}, or trace anyway.`;
    case "image-broken":
      return "The picture could not be decoded. It may be incomplete.";
    case "engine":
      return `The engine stopped (${code}). Your picture is safe; the engine was restarted.`;
  }
}
