import { traceLimits } from "../../document/trace/trace.ts";
import type { EditorState } from "../../editor/editor.ts";
import { setTrace } from "../../editor/trace/trace-edits.ts";
import type { TraceFailure, TraceProgress } from "../../editor/trace/trace-state.ts";
import { h } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import { mountBusy } from "../mode/busy.ts";
import type { Shell } from "../shell.ts";

/** Over the stage: how far the tracer has come, with a way to stop it; or why there is nothing to see, with a way on. */

const names: Readonly<Record<TraceProgress["stage"], string>> = {
  decoding: "Decoding", edges: "Edges", contours: "Contours", corners: "Corners", splines: "Splines", refinement: "Refinement", layers: "Layers", measuring: "Measuring",
};

export function progressText({ stage, value, done, total }: TraceProgress): string {
  const part = total > 1 ? ` ${done} of ${total}` : "";
  return `${names[stage]}${part} · ${Math.round(100 * value)} %`;
}

export function mountTraceProgress(shell: Shell): void {
  const { editor, regions, until } = shell;
  const busy = mountBusy(shell, { label: "Tracing", about: "Stop and keep the previous outlines.", testid: "trace-stop", stop: () => editor.actions.run("trace-cancel") });
  const notice = h("div", { class: "trace-notice", hidden: true });
  regions.stage.append(notice);
  let said: TraceFailure | null = null;

  const show = ({ mode, traceRun, traceProgress: progress }: EditorState): void => {
    const { since, failure } = traceRun;
    busy.show(mode !== "trace" || since === null || progress === null ? null : { since, value: progress.value, text: progressText(progress) });
    const shown = mode === "trace" && since === null ? failure : null;
    if (shown === said) return;
    said = shown;
    notice.hidden = shown === null;
    notice.replaceChildren(...(shown === null ? [] : sayingOf(shell, shown)));
  };
  editor.state.subscribe((state, before) => {
    if (state.traceRun !== before.traceRun || state.traceProgress !== before.traceProgress || state.mode !== before.mode) show(state);
  }, { until });
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
