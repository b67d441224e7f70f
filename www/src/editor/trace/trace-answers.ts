import { traceSample } from "../../document/trace/trace-samples.ts";
import type { TraceDocument } from "../../document/trace/trace.ts";
import { outcomeOf } from "../../kernel/trace/outcome.ts";
import type { TraceHandlers } from "../../kernel/trace/trace-client.ts";
import type { Editor } from "../editor.ts";
import { leftOutOf, losesColors, setTraceView } from "./trace-edits.ts";
import { leftOutText } from "./trace-hint.ts";
import type { TraceRun } from "./trace-state.ts";

/** Puts what the tracer answers into the state. */

function setTraceRun(editor: Editor, change: Partial<TraceRun>): void {
  editor.patch({ traceRun: { ...editor.state.value.traceRun, ...change } });
}

/** Nothing is under way any more. */
export function restTraceRun(editor: Editor, change: Partial<TraceRun> = {}): void {
  editor.patch({ traceRun: { ...editor.state.value.traceRun, ...change, since: null }, traceProgress: null });
}

/** A bitmap holds its pixels outside of the script's memory until it is closed. */
export function closePicture({ state }: Editor): void {
  const { picture } = state.value.traceRun;
  picture?.source.close();
  picture?.edges.close();
}

/** Once for a picture, and not in place of what matters more: its colours. */
function sayLeftOut(editor: Editor): void {
  const left = leftOutOf(editor.state.value);
  if (left === null || losesColors(editor.state.value)) return;
  editor.notify({ kind: "toast", text: leftOutText(left), actionId: "trace-keep-small" });
}

/** `settle` is called whenever a job is over; `asked` says what the last one was asked for with. */
export function traceAnswers(editor: Editor, settle: () => void, asked: () => TraceDocument | null): TraceHandlers {
  const over = (change: Partial<TraceRun>): void => restTraceRun(editor, change);
  return {
    progress(stage, value, done, total) {
      editor.patch({ traceProgress: { stage, value, done, total } });
    },
    picture({ width, height, analysed, source, edges, threshold, colored }, { key }) {
      const { trace, traceRun } = editor.state.value;
      const name = trace.picture?.name ?? traceSample(trace.sample ?? "")?.title ?? "";
      const other = traceRun.picture?.key !== key;
      closePicture(editor);
      setTraceRun(editor, { picture: { key, name, width, height, analysed, source, edges, threshold, colored }, ...(other ? { outcome: null, of: null, failure: null } : {}) });
      if (other && trace.picture !== undefined && losesColors(editor.state.value)) {
        editor.notify({ kind: "toast", text: "This picture has several colours. Its dark shapes are traced as one ink.", actionId: "trace-colors" });
      }
    },
    traced(result, ms) {
      if (result.outlines.length === 0) over({ outcome: null, of: null, failure: { id: "trace-none" }, lastMs: ms });
      else {
        const isFirst = editor.state.value.traceRun.outcome === null;
        over({ outcome: outcomeOf(result, editor.state.value.trace.sample), of: asked(), failure: null, lastMs: ms });
        if (isFirst) sayLeftOut(editor);
      }
      setTraceView(editor, { chosen: null, over: null });
      settle();
    },
    photo(count, speckle) {
      over({ failure: { id: "trace-photo", count, speckle } });
      settle();
    },
    failed(code) {
      over({ failure: code === "E_IMAGE" ? { id: "image-broken" } : { id: "engine", code: code === "" ? "unknown" : code } });
      settle();
    },
    restarted() {
      editor.notify({ kind: "error", id: "engine", text: "The tracing engine stopped and was restarted. Your picture is safe." });
    },
  };
}
