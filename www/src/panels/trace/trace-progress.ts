import { traceLimits } from "../../document/trace/trace.ts";
import type { EditorState } from "../../editor/editor.ts";
import { setTrace } from "../../editor/trace/trace-edits.ts";
import type { TraceFailure, TraceProgress } from "../../editor/trace/trace-state.ts";
import { mountBusy } from "../mode/busy.ts";
import { engineFailure, mountNotice, type Offer, type Said } from "../mode/notice.ts";
import type { Shell } from "../shell.ts";

/**
 * Over the stage: how far the tracer has come, with a way to stop it; or why there is nothing to see, with a way on.
 */

const names: Readonly<Record<TraceProgress["stage"], string>> = {
  decoding: "Decoding", edges: "Edges", contours: "Contours", corners: "Corners", splines: "Splines", refinement: "Refinement", layers: "Layers", measuring: "Measuring",
};

export function progressText({ stage, value, done, total }: TraceProgress): string {
  const part = total > 1 ? ` ${done} of ${total}` : "";
  return `${names[stage]}${part} · ${Math.round(100 * value)} %`;
}

export function mountTraceProgress(shell: Shell): void {
  const { editor, until } = shell;
  const busy = mountBusy(shell, { label: "Tracing", about: "Stop and keep the previous outlines.", testid: "trace-stop", stop: () => editor.actions.run("trace-cancel") });
  const say = mountNotice(shell);
  let said: TraceFailure | null = null;

  const show = ({ mode, traceRun, traceProgress: progress }: EditorState): void => {
    const { since, failure } = traceRun;
    busy.show(mode !== "trace" || since === null || progress === null ? null : { since, value: progress.value, text: progressText(progress) });
    const shown = mode === "trace" && since === null ? failure : null;
    if (shown === said) return;
    said = shown;
    say(shown === null ? null : sayingOf(shell, shown));
  };
  editor.state.subscribe((state, before) => {
    if (state.traceRun !== before.traceRun || state.traceProgress !== before.traceProgress || state.mode !== before.mode) show(state);
  }, { until });
  show(editor.state.value);
}

function sayingOf({ editor }: Shell, { id, count = 0, speckle = 0, code }: TraceFailure): Said {
  switch (id) {
    case "trace-none":
      return { id, text: "No edges found. Raise Blur, change Threshold, or try Invert.", offers: [{ label: "Invert", testid: "offer-invert", run: () => editor.actions.run("trace-invert") }] };
    case "trace-photo": {
      const anyway: Offer = { label: "Trace anyway", testid: "offer-anyway", run: () => editor.actions.run("trace-anyway") };
      const cleaner: Offer = { label: `Speckle ${speckle} px²`, testid: "offer-speckle", run: () => setTrace(editor, "Speckle", { speckle }) };
      const text = `This looks like a photograph: ${count} contours. ${isOffered(speckle) ? `Raise Speckle to about ${speckle}` : "Raise Speckle"}, or trace anyway.`;
      return { id, text, offers: isOffered(speckle) ? [anyway, cleaner] : [anyway] };
    }
    case "image-broken":
      return { id, text: "The picture could not be decoded. It may be incomplete.", offers: [] };
    case "engine":
      return engineFailure(code, "Your picture is safe; the engine was restarted.", () => editor.actions.run("trace-run"));
  }
}

/** Whether the slider goes so far. */
const isOffered = (speckle: number): boolean => speckle > 0 && speckle <= traceLimits.speckle;
