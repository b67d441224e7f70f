import { differentPoints, firstFitSample, fitDefaults, isJoined, strokesOf, type FitDocument } from "../../document/fit/fit.ts";
import { fitSample, samplePoints } from "../../document/fit/fit-samples.ts";
import type { FitClient, FitHandlers } from "../../kernel/fit/fit-client.ts";
import type { FitInput, FitStrength, FitSubject } from "../../kernel/fit/job.ts";
import { outcomeOf, smoothingLike, type ChartPoint } from "../../kernel/fit/outcome.ts";
import type { Editor } from "../editor.ts";
import { opened, sampleZoom, showData, showSmoothing } from "./fit-edits.ts";
import { noFitRun, type FitRun } from "./fit-state.ts";

/** Keeps the curve up to date with the document: asks for fits, and puts what comes back into the state. */

/** Fewer different points than this are no stroke to be fitted. */
const leastPoints = 4;
export const chartAt: readonly number[] = Array.from({ length: 21 }, (_, i) => 5 * i);

const degrees = { linear: 1, cubic: 3, hybrid: [1, 3] } as const;

/** What is to be fitted, or null where no stroke has enough points. */
function subjectOf(fit: FitDocument): FitSubject | null {
  const strokes: FitInput[] = [];
  for (const stroke of strokesOf(fit)) {
    if (differentPoints(fit, stroke, leastPoints) < leastPoints) continue;
    strokes.push({ points: Float64Array.from(fit.data.slice(stroke.from, stroke.to).flat()), closed: isJoined(fit, stroke) });
  }
  return strokes.length === 0 ? null : { strokes, degree: degrees[fit.model], mix: fit.mix / 100, corners: fit.corners };
}

function strengthOf(fit: FitDocument): FitStrength {
  switch (fit.target) {
    case "off":
      return { by: "smoothing", smoothing: fit.smoothing / 100 };
    case "knots":
      return { by: "knots", knots: fit.targetKnots };
    case "error":
      return { by: "error", tolerance: fit.targetError };
  }
}

/** A sample that is only named is opened; a name that is none gives way to the first. */
export function ensureFit(editor: Editor): void {
  const { fit } = editor.state.value;
  if (fit.data.length > 0 || fit.sample === undefined) return;
  const sample = fitSample(fit.sample) ?? fitSample(firstFitSample);
  if (sample === undefined) return;
  if (sample.id !== fit.sample) editor.notify({ kind: "toast", text: `There is no sample named ${fit.sample}.` });
  // An address names it and nothing else: then its own settings are what it is to be seen with. A shared link has settings.
  const named = Object.entries(fitDefaults).every(([key, value]) => fit[key as keyof typeof fitDefaults] === value);
  editor.fitEdits.amend(() => ({ fit: named ? opened(sample) : { ...fit, sample: sample.id, ...samplePoints(sample, fit.noise, fit.seed) } }));
  showData(editor, sampleZoom);
  editor.patch({ hint: sample.note });
}

export interface FitRunner {
  /** Resolves when no fit is under way. */
  idle(): Promise<void>;
  cancel(): void;
}

export function createFitRunner(editor: Editor, connect: (handlers: FitHandlers) => FitClient, now: () => number, until: AbortSignal): FitRunner {
  let subject: FitSubject | null = null;
  /** What the subject was made of. */
  let made: Pick<FitDocument, "data" | "starts" | "closing" | "model" | "mix" | "corners"> | null = null;
  /** The fit that is on the stage or under way is of a drag, and is to be done again from nothing. */
  let unsettled = false;

  const run = (change: Partial<FitRun>): void => editor.patch({ fitRun: { ...editor.state.value.fitRun, ...change } });

  const client = connect({
    fitted(fits, what, ms) {
      if (what !== subject) return;
      const outcome = outcomeOf(what.strokes, fits);
      const { fitView } = editor.state.value;
      const same = outcome.knots.length === editor.state.value.fitRun.outcome?.knots.length;
      editor.patch({
        fitRun: { ...editor.state.value.fitRun, outcome, failure: null, since: client.busy ? editor.state.value.fitRun.since : null, lastMs: ms },
        fitView: same ? fitView : { ...fitView, chosen: [], over: null },
      });
      follow();
      if (!client.busy && !unsettled) fillChart();
    },
    stopped() {
      run({ since: null });
    },
    failed(code, message) {
      const few = code === "E_TOO_FEW_POINTS" || code === "E_DEGENERATE";
      run({ since: null, outcome: null, failure: few
        ? { id: "points-few", details: { count: editor.state.value.fit.data.length } }
        : { id: "engine", details: { code: code === "" ? message.slice(0, 60) : code } } });
    },
    chart(point) {
      if (subject === null) return;
      const chart = [...editor.state.value.fitRun.chart.filter(({ smoothing }) => smoothing !== point.smoothing), point];
      run({ chart: chart.sort((a, b) => a.smoothing - b.smoothing) });
      follow();
    },
    restarted() {
      editor.notify({ kind: "error", id: "engine", text: "The engine that fits stopped and was started again. Your drawing is safe." });
    },
  });

  /** The slider shows where a target has led. */
  function follow(): void {
    const { fit, fitRun } = editor.state.value;
    if (fit.target === "off" || fitRun.outcome === null) return;
    const place = fitRun.outcome.smoothing ?? smoothingLike(fitRun.chart, fitRun.outcome.rms);
    if (place !== null) showSmoothing(editor, place);
  }

  function fillChart(): void {
    const missing = chartAt.filter((smoothing) => !editor.state.value.fitRun.chart.some((point: ChartPoint) => point.smoothing === smoothing));
    if (missing.length > 0) client.chart(missing);
  }

  function ask(fit: FitDocument, live: boolean): void {
    const same = made !== null && made.data === fit.data && made.starts === fit.starts && made.closing === fit.closing && made.model === fit.model && made.mix === fit.mix
      && made.corners === fit.corners;
    if (!same) {
      made = fit;
      subject = subjectOf(fit);
      run({ chart: [] });
    }
    if (subject === null) {
      client.cancel();
      const count = new Set(fit.data.map(String)).size;
      editor.patch({ fitRun: { ...noFitRun, failure: fit.data.length === 0 ? null : { id: "points-few", details: { count } } } });
      return;
    }
    unsettled = live;
    run({ since: editor.state.value.fitRun.since ?? now(), failure: null });
    client.fit(subject, strengthOf(fit), live);
  }

  let asked: FitDocument | null = null;
  const update = (): void => {
    const { mode, fit } = editor.state.value;
    if (mode !== "fit") return;
    ensureFit(editor);
    const wanted = editor.state.value.fit;
    const live = editor.fitEdits.inGesture;
    // What a target sets the slider to is no new question.
    const changed = asked === null || !sameQuestion(asked, wanted);
    if (!changed && !(unsettled && !live)) return;
    asked = wanted;
    if (fit.data.length === 0 && wanted.data.length === 0) subject = null;
    ask(wanted, live);
  };
  editor.state.subscribe((state, before) => {
    if (state.fit !== before.fit || state.mode !== before.mode || (unsettled && !editor.fitEdits.inGesture)) update();
  }, { until });
  update();
  return { idle: () => client.idle(), cancel: () => client.cancel() };
}

function sameQuestion(a: FitDocument, b: FitDocument): boolean {
  if (a === b) return true;
  const same = a.data === b.data && a.starts === b.starts && a.closing === b.closing && a.model === b.model && a.mix === b.mix && a.corners === b.corners
    && a.target === b.target;
  if (!same) return false;
  return a.target === "off" ? a.smoothing === b.smoothing : a.target === "knots" ? a.targetKnots === b.targetKnots : a.targetError === b.targetError;
}
