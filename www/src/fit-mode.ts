import { registerFitActions } from "./editor/fit/fit-actions.ts";
import { boxOf, chooseFitTool } from "./editor/fit/fit-edits.ts";
import { fitHint, fitSummary } from "./editor/fit/fit-hint.ts";
import { turned } from "./editor/pointer/camera.ts";
import { createFitRunner } from "./editor/fit/fit-runner.ts";
import { connectFit } from "./editor/fit/freehand.ts";
import { editInCurve, fittedDrawing } from "./editor/fit/hand-over.ts";
import { sampleFit } from "./kernel/fit/outcome.ts";
import type { ModeParts } from "./modes.ts";
import { fitSampleCards, mountEmptyFit } from "./panels/fit/empty-fit.ts";
import { fitMetrics } from "./panels/fit/fit-metrics.ts";
import { fitProgram } from "./panels/fit/fit-program.ts";
import { fitPanel } from "./panels/fit/fit-panel.ts";
import { mountFitProgress } from "./panels/fit/fit-progress.ts";
import { createFitPainter } from "./render/fit/fit-painter.ts";
import { createKnotProxies } from "./render/fit/knot-proxies.ts";
import { createFitTool } from "./tools/fit/fit-tool.ts";

/** Fit mode, put together when it is first opened. */
export function mountFitMode({ editor, frame, stage, surface, proxies, panels, contract, until }: ModeParts): void {
  registerFitActions(editor);
  const runner = createFitRunner(editor, connectFit(until), () => performance.now(), until);
  editor.actions.register({ id: "fit-cancel", label: "Stop fitting", group: "Edit", keys: [], enabled: ({ mode }) => mode === "fit", run: () => runner.cancel() });
  editor.actions.register({ id: "fit-again", label: "Fit again", group: "Edit", keys: [], enabled: ({ mode }) => mode === "fit", run: () => runner.again() });
  editor.actions.register({
    id: "fit-edit",
    label: "Edit the fit in Curve",
    group: "Fit",
    keys: [],
    enabled: ({ mode, fitRun }) => mode === "fit" && fitRun.outcome !== null,
    run: editInCurve,
  });
  editor.modes.set("fit", {
    label: "Points to fit", tool: createFitTool(editor), hint: fitHint, summary: fitSummary, drawing: fittedDrawing, program: fitProgram,
    box: ({ fit }) => boxOf(fit.data),
  });
  panels.shell.samples.set("fit", (done) => fitSampleCards(panels.shell, done));
  stage.painters.set("fit", createFitPainter(stage.repaint, () => performance.now()));
  createKnotProxies(editor, frame, surface, proxies, until);
  panels.addMode("fit", { panel: fitPanel(panels.shell), metrics: fitMetrics });
  mountEmptyFit(panels.shell);
  mountFitProgress(panels.shell);
  contract.fit = {
    sample: (count, stroke) => (editor.state.value.fitRun.outcome === null ? null : sampleFit(editor.state.value.fitRun.outcome, count, stroke)),
    result() {
      const { outcome } = editor.state.value.fitRun;
      return outcome === null ? null : { knots: outcome.knots.map(({ x, y, type }) => ({ x, y, type })), rms: outcome.rms, max: outcome.max };
    },
    lastJobMs: () => editor.state.value.fitRun.lastMs,
    working: () => runner.idle(),
  };
  editor.state.subscribe(({ mode, fit, view }) => {
    const up = mode === "fit" && fit.up === true;
    if (up !== (view.up ?? false)) editor.patch({ view: turned(view, up) });
  }, { until, now: true });
  let was = editor.state.value.mode;
  editor.state.subscribe(({ mode, tool, fitView }, before) => {
    if (mode !== was) {
      was = mode;
      // The rail's buttons stand for Fit's tools while Fit is open.
      if (mode === "fit") chooseFitTool(editor, fitView.tool);
    } else if (mode === "fit" && tool !== before.tool) {
      if (tool === "draw" && fitView.tool !== "draw") chooseFitTool(editor, "draw");
      if (tool === "pen" && fitView.tool !== "points") chooseFitTool(editor, "points");
    }
  }, { until });
  if (was === "fit") chooseFitTool(editor, editor.state.value.fitView.tool);
  stage.repaint();
}
