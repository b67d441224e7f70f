import { firstFitSample, fitDefaults, type FitDocument } from "../../document/fit/fit.ts";
import { fitSample, samplePoints } from "../../document/fit/fit-samples.ts";
import type { FitClient, FitHandlers } from "../../kernel/fit/fit-client.ts";
import type { FitStrength, FitSubject, PlainFit } from "../../kernel/fit/job.ts";
import { outcomeOf } from "../../kernel/fit/outcome.ts";
import type { Editor } from "../editor.ts";
import { setFitRun, showChartPoint, showFailure, showFit, showTooFew } from "./fit-answers.ts";
import { opened, sampleZoom, showData } from "./fit-edits.ts";
import { hasParts, sameQuestion, sameSubject, strengthOf, subjectOf } from "./fit-question.ts";

/** Keeps the curve up to date with the document: asks for fits whenever it asks something else. */

const chartAt: readonly number[] = Array.from({ length: 21 }, (_, i) => 5 * i);

export interface FitRunner {
  /** Resolves when no fit is under way. */
  idle(): Promise<void>;
  cancel(): void;
  /** Once more what has failed. */
  again(): void;
}

export function createFitRunner(editor: Editor, connect: (handlers: FitHandlers) => FitClient, now: () => number, until: AbortSignal): FitRunner {
  const runner = new Runner(editor, connect, now);
  editor.state.subscribe((state, before) => {
    if (state.fit !== before.fit || state.mode !== before.mode || state.fitView.overlays !== before.fitView.overlays || runner.owesFit) runner.update(state.mode !== before.mode);
  }, { until });
  runner.update();
  return runner;
}

class Runner implements FitRunner {
  readonly #editor: Editor;
  readonly #client: FitClient;
  readonly #now: () => number;
  /** The document that was asked for last, and what of it is fitted. */
  #asked: FitDocument | null = null;
  #subject: FitSubject | null = null;
  /** The documents that were asked for, by what the client names them by. */
  readonly #documents = new WeakMap<FitStrength, FitDocument>();
  /** The document whose fit is on the stage. */
  #shown: FitDocument | null = null;
  /** The fit that is on the stage or under way is of a drag, and is to be done again from nothing. */
  #unsettled = false;
  /** Somebody did not want to wait for the fit that is under way. */
  #cancelled = false;

  constructor(editor: Editor, connect: (handlers: FitHandlers) => FitClient, now: () => number) {
    this.#editor = editor;
    this.#now = now;
    this.#client = connect({
      fitted: (fits, what, ms, strength) => this.#fitted(fits, what, ms, strength),
      progress: (fitProgress) => editor.patch({ fitProgress }),
      stopped: () => this.#stopped(),
      failed: (code, message) => showFailure(editor, code, message),
      chart: (point) => this.#subject !== null && showChartPoint(editor, point),
      restarted: () => editor.notify({ kind: "error", id: "engine", text: "The fitting engine stopped and was restarted. Your drawing is safe." }),
    });
  }

  idle(): Promise<void> {
    return this.#client.idle();
  }

  cancel(): void {
    this.#cancelled = this.#client.busy;
    this.#client.cancel();
    if (this.#cancelled) this.#editor.notify({ kind: "toast", text: "Cancelled" });
  }

  /** A drag is over, and its fit has not been done again yet. */
  get owesFit(): boolean {
    return this.#unsettled && !this.#editor.fitEdits.inGesture;
  }

  again(): void {
    if (this.#subject !== null) this.#ask(this.#subject, this.#editor.state.value.fit);
  }

  /** The state is another; `hasCome` says that the mode is. */
  update(hasCome = false): void {
    if (this.#editor.state.value.mode !== "fit") return;
    ensureFit(this.#editor);
    const [before, { fit, fitView, fitRun }] = [this.#asked, this.#editor.state.value];
    const parts = fitView.overlays.parts && hasParts(fit);
    const sameParts = this.#subject === null || this.#subject.parts === parts;
    // A connection may have been lost for a moment: the next visit tries again.
    const isOwed = this.owesFit || (hasCome && fitRun.failure?.id === "engine");
    if (before !== null && sameQuestion(before, fit) && sameParts && !isOwed) return;
    this.#asked = fit;
    const same = before !== null && sameSubject(before, fit);
    if (!same || !sameParts) this.#subject = subjectOf(fit, parts);
    if (!same) setFitRun(this.#editor, { chart: [] });
    if (this.#subject === null) this.#giveUp(fit);
    else this.#ask(this.#subject, fit);
  }

  #giveUp(fit: FitDocument): void {
    this.#unsettled = false; // where nothing can be fitted nothing is owed, or saying so would ask again
    this.#client.cancel();
    showTooFew(this.#editor, fit);
  }

  #ask(subject: FitSubject, fit: FitDocument): void {
    const live = this.#editor.fitEdits.inGesture;
    this.#unsettled = live;
    setFitRun(this.#editor, { since: this.#editor.state.value.fitRun.since ?? this.#now(), failure: null });
    this.#editor.patch({ fitProgress: 0 });
    this.#cancelled = false;
    const strength = strengthOf(fit);
    this.#documents.set(strength, fit);
    this.#client.fit(subject, strength, live);
  }

  #fitted(fits: readonly PlainFit[], what: FitSubject, ms: number, strength: FitStrength): void {
    if (what !== this.#subject) return this.#client.busy ? undefined : this.#stopped();
    this.#shown = this.#documents.get(strength) ?? this.#asked;
    showFit(this.#editor, outcomeOf(what.strokes, fits), ms, this.#client.busy);
    if (this.#client.busy) return;
    if (this.#shown !== this.#asked) this.#keepShown();
    else if (!this.#unsettled) this.#fillChart();
  }

  #stopped(): void {
    setFitRun(this.#editor, { since: null });
    this.#keepShown();
  }

  /**
   * The curve before stays, and so does what was asked for it: of the same points, the settings are those of the curve
   * that is shown.
   */
  #keepShown(): void {
    const [shown, stopped, { fit }] = [this.#shown, this.#asked, this.#editor.state.value];
    if (!this.#cancelled || shown === null || shown.data !== fit.data) return;
    this.#asked = shown;
    if (stopped === null || !sameSubject(stopped, shown)) this.#subject = subjectOf(shown, this.#subject?.parts ?? false);
    this.#editor.fitEdits.amend(() => ({ fit: shown }));
    this.#fillChart();
  }

  #fillChart(): void {
    const { chart } = this.#editor.state.value.fitRun;
    const missing = chartAt.filter((smoothing) => !chart.some((point) => point.smoothing === smoothing));
    if (this.#subject !== null && missing.length > 0) this.#client.chart(this.#subject, missing);
  }
}

/** A sample that is only named is opened; a name that is none gives way to the first. */
function ensureFit(editor: Editor): void {
  const { fit } = editor.state.value;
  if (fit.data.length > 0 || fit.sample === undefined) return;
  const sample = fitSample(fit.sample) ?? fitSample(firstFitSample);
  if (sample === undefined) return;
  if (sample.id !== fit.sample) editor.notify({ kind: "toast", text: `There is no sample called ${fit.sample}.` });
  // An address names it and nothing else: then its own settings are what it is to be seen with. A shared link has
  // settings.
  const named = Object.entries(fitDefaults).every(([key, value]) => fit[key as keyof typeof fitDefaults] === value);
  editor.fitEdits.amend(() => ({ fit: named ? opened(sample) : { ...fit, sample: sample.id, ...samplePoints(sample, fit.noise, fit.seed) } }));
  showData(editor, sampleZoom);
  editor.patch({ hint: sample.note });
}
