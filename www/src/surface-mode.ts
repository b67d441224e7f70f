import { whenLoaded } from "./editor/loading.ts";
import { registerSurfaceActions } from "./editor/surface/surface-actions.ts";
import { ensureSurface } from "./editor/surface/surface-edits.ts";
import { surfaceChosen, surfaceHint, surfaceSummary } from "./editor/surface/surface-hint.ts";
import { surfaceView } from "./editor/surface/surface-view.ts";
import { meshPoints, surfaceSample } from "./kernel/surface/surface.ts";
import { startSurfaceEngine } from "./kernel/surface/surface-engine.ts";
import type { ModeParts } from "./modes.ts";
import type { Shell } from "./panels/shell.ts";
import { surfaceCards } from "./panels/surface/surface-gallery.ts";
import { surfaceMetrics } from "./panels/surface/surface-metrics.ts";
import { surfacePanel } from "./panels/surface/surface-panel.ts";
import { surfaceProgram } from "./panels/surface/surface-program.ts";
import { createNetProxies } from "./render/surface/net-proxies.ts";
import { createSurfaceStage } from "./render/surface/surface-stage.ts";
import { createSurfaceTool } from "./tools/surface/surface-tool.ts";

/** Export means the surface's own files while the surface is shown. */
function exportOf(shell: Shell): void {
  const action = shell.editor.actions.get("export");
  if (action === undefined) return;
  shell.editor.actions.register({
    ...action,
    run(editor) {
      if (editor.state.value.mode !== "surface") return action.run(editor);
      whenLoaded(editor, import("./panels/surface/surface-export.ts"), ({ openSurfaceExport }) => openSurfaceExport(shell));
    },
  });
}

/** Surface mode, put together when it is first opened. */
export async function mountSurfaceMode({ editor, frame, stage, surface, panels, contract, until }: ModeParts): Promise<void> {
  await startSurfaceEngine();
  ensureSurface(editor);
  const tool = createSurfaceTool(editor);
  registerSurfaceActions(editor, (axis) => tool.hold(axis));
  const { painter } = await createSurfaceStage(editor, frame, surface, until);
  createNetProxies(editor, frame, surface, until);
  editor.modes.set("surface", {
    label: "Surface", tool, view: surfaceView(editor), hint: surfaceHint, summary: surfaceSummary, chosen: surfaceChosen,
    program: surfaceProgram,
    sample: ({ surface: shown }) => (shown === surfaceSample(shown.sample) ? shown.sample : null),
  });
  stage.painters.set("surface", painter);
  panels.addMode("surface", { panel: surfacePanel(panels.shell), metrics: surfaceMetrics });
  panels.shell.samples.set("surface", (done) => surfaceCards(panels.shell, done));
  exportOf(panels.shell);
  contract.mesh = (rows, cols) => meshPoints(editor.state.value.surface, rows, cols);
  // Undo may go back to a sample that was only named.
  editor.state.subscribe(({ mode }) => {
    if (mode === "surface") ensureSurface(editor);
  }, { until, now: true });
  stage.repaint();
}
