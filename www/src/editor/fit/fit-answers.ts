import type { FitDocument } from "../../document/fit/fit.ts";
import { isTooFew } from "../../kernel/fit/fit-client.ts";
import { smoothingLike, type ChartPoint, type FitOutcome } from "../../kernel/fit/outcome.ts";
import type { Editor } from "../editor.ts";
import { showSmoothing } from "./fit-edits.ts";
import { mostDifferent } from "./fit-question.ts";
import { noFitRun, type FitFailure, type FitRun } from "./fit-state.ts";

/** Puts what the fitter answers into the state. */

export function setFitRun(editor: Editor, change: Partial<FitRun>): void {
  editor.patch({ fitRun: { ...editor.state.value.fitRun, ...change } });
}

/** `more` says that another fit is already under way. */
export function showFit(editor: Editor, outcome: FitOutcome, ms: number, more: boolean): void {
  const { fitRun, fitView } = editor.state.value;
  const same = outcome.knots.length === fitRun.outcome?.knots.length;
  editor.patch({
    fitRun: { ...fitRun, outcome, failure: null, since: more ? fitRun.since : null, lastMs: ms },
    fitView: same ? fitView : { ...fitView, chosen: [], over: null },
  });
  followTarget(editor);
}

export function showChartPoint(editor: Editor, point: ChartPoint): void {
  const others = editor.state.value.fitRun.chart.filter(({ smoothing }) => smoothing !== point.smoothing);
  setFitRun(editor, { chart: [...others, point].sort((a, b) => a.smoothing - b.smoothing) });
  followTarget(editor);
}

/** The slider shows where a target has led. */
function followTarget(editor: Editor): void {
  const { fit, fitRun } = editor.state.value;
  if (fit.target === "off" || fitRun.outcome === null) return;
  const place = fitRun.outcome.smoothing ?? smoothingLike(fitRun.chart, fitRun.outcome.rms);
  if (place !== null) showSmoothing(editor, place);
}

/** No stroke has enough points; with none at all there is nothing to complain of. */
export function showTooFew(editor: Editor, fit: FitDocument): void {
  editor.patch({ fitRun: { ...noFitRun, failure: fit.data.length === 0 ? null : { id: "points-few", details: { count: mostDifferent(fit) } } } });
}

export function showFailure(editor: Editor, code: string, message: string): void {
  setFitRun(editor, { since: null, outcome: null, failure: failureOf(editor.state.value.fit, code, message) });
}

function failureOf(fit: FitDocument, code: string, message: string): FitFailure {
  if (isTooFew(code)) return { id: "points-few", details: { count: mostDifferent(fit) } };
  return { id: "engine", details: { code: code === "" ? message.slice(0, 60) : code } };
}
