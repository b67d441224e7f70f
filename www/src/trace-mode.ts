import { isEmptyTrace, type TraceDocument } from "./document/trace/trace.ts";
import type { EditorState } from "./editor/editor.ts";
import { tracedDrawing, tracedLayers } from "./editor/trace/hand-over.ts";
import { registerTraceActions } from "./editor/trace/trace-actions.ts";
import { drawingOf, shownOf, sizeOf } from "./editor/trace/trace-edits.ts";
import { traceHint, traceSummary } from "./editor/trace/trace-hint.ts";
import { createTraceRunner } from "./editor/trace/trace-runner.ts";
import { samplePoints } from "./kernel/curve/samples.ts";
import { cornersIn, inkedContours } from "./kernel/trace/outcome.ts";
import { endingWith } from "./kernel/worker-desk.ts";
import { createTraceClient, pageClock } from "./kernel/trace/trace-client.ts";
import type { ModeParts } from "./modes.ts";
import { report } from "./panels/files/report.ts";
import { mountEmptyTrace, traceSampleCards } from "./panels/trace/empty-trace.ts";
import { traceMetrics } from "./panels/trace/trace-metrics.ts";
import { tracePanel } from "./panels/trace/trace-panel.ts";
import { traceProgram } from "./panels/trace/trace-program.ts";
import { mountTraceProgress } from "./panels/trace/trace-progress.ts";
import { Problem, type ProblemDetails, type ProblemId } from "./document/problem.ts";
import { createPointProxies } from "./render/trace/point-proxies.ts";
import { createTracePainter } from "./render/trace/trace-painter.ts";
import { createTraceTool } from "./tools/trace/trace-tool.ts";

/** Pictures are not kept and not sent: of one's own, what is saved is its outlines. */
function savedTrace(state: EditorState): TraceDocument {
  const { trace, traceRun } = state;
  const { picture, ...rest } = trace;
  const shown = shownOf(state);
  if (picture === undefined || shown === null || traceRun.picture?.key !== picture.key) return rest;
  const { name, width, height } = picture;
  return { ...rest, corners: [], kept: { name, width, height, contours: inkedContours(shown) } };
}

function resultOf(state: EditorState): object | null {
  const shown = shownOf(state);
  if (shown === null) return null;
  const { drawing, holes, segments, rms, max, iou, colors } = shown;
  return {
    contours: drawing.contours.length, holes: holes.filter((hole) => hole).length, cusps: cornersIn(drawing).map(({ x, y }) => ({ x, y })),
    segments: segments === null ? 0 : segments.lines + segments.arcs + segments.curves, rms, max, iou,
    ...(colors.length === 0 ? {} : { colors }),
  };
}

/** What is still there when another picture could not be opened. */
function keptPicture({ state }: ModeParts["editor"]): ProblemDetails {
  const { picture, sample } = state.value.trace;
  const kept = picture?.name ?? sample;
  return kept === undefined ? {} : { kept };
}

/** What is said of a picture that could not be opened, by what the tracer says. */
const refusals: Readonly<Record<string, ProblemId>> = { E_BLANK: "image-blank", E_IMAGE: "image-broken", E_INIT: "part-missing" };

/** Trace mode, put together when it is first opened. */
export function mountTraceMode({ editor, frame, stage, surface, proxies, panels, contract, until }: ModeParts): void {
  const { shell } = panels;
  const start = endingWith(until, () => new Worker(new URL("./kernel/trace/trace-worker.ts", import.meta.url), { type: "module" }));
  const runner = createTraceRunner({
    editor, until, clock: pageClock, now: () => performance.now(),
    connect: (handlers) => createTraceClient(start, handlers),
    refuse(name, code) {
      const id = refusals[code] ?? "engine";
      report(shell, new Problem(id, id === "engine" ? { code: code === "" ? "unknown" : code } : { name, ...keptPicture(editor) }));
    },
  });
  registerTraceActions(editor, runner);
  editor.modes.set("trace", {
    label: "Picture and its outlines", tool: createTraceTool(editor), hint: traceHint, summary: traceSummary, drawing: tracedDrawing, layers: tracedLayers, program: traceProgram, saved: savedTrace,
    box(state) {
      const size = sizeOf(state);
      return size === null ? null : { minX: 0, minY: 0, maxX: size.width, maxY: size.height };
    },
  });
  shell.samples.set("trace", (done) => traceSampleCards(shell, done));
  stage.painters.set("trace", createTracePainter(() => stage.repaint()));
  createPointProxies(editor, frame, surface, proxies, until);
  panels.addMode("trace", { panel: tracePanel(shell), metrics: traceMetrics });
  mountEmptyTrace(shell);
  mountTraceProgress(shell);
  contract.trace = {
    sample(count, contour) {
      const drawing = drawingOf(editor.state.value);
      const shape = drawing?.contours[contour];
      return drawing === null || shape === undefined ? null : samplePoints(drawing, shape, count);
    },
    result: () => (isEmptyTrace(editor.state.value.trace) ? null : resultOf(editor.state.value)),
    lastJobMs: () => editor.state.value.traceRun.lastMs,
    working: () => runner.idle(),
  };
  editor.state.subscribe(({ mode }, before) => {
    if (mode !== before.mode && before.mode === "trace") editor.patch({ cursor: "default" });
  }, { until });
  stage.repaint();
}
