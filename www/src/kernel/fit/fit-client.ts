import { createDesk, createWaiters, type LossCode } from "../worker-desk.ts";
import type { FitAnswer, FitRequest, FitStrength, FitSubject, PlainFit } from "./job.ts";

/**
 * Fits in a worker: the newest request counts, one is under way at a time, and an older result never replaces a newer one.
 * A worker that dies is replaced once for a request; what it was asked for is known here.
 */

export interface FitHandlers {
  /** How much of the fit that is under way is done, from 0 to 1. */
  progress(value: number): void;
  /** What was asked for is named by the very objects that it was asked with. */
  fitted(fits: readonly PlainFit[], subject: FitSubject, ms: number, strength: FitStrength): void;
  /** Not told of a request that another has followed, no more than that it failed. */
  stopped(): void;
  failed(code: string, message: string): void;
  chart(point: { smoothing: number; knots: number; rms: number }): void;
  /** The worker died and another one has taken its place. */
  restarted(): void;
}

export interface FitClient {
  /** The newest request: what was asked for before is dropped. */
  fit(subject: FitSubject, strength: FitStrength, live: boolean): void;
  /** Fills the chart of a subject when nothing is asked for. */
  chart(subject: FitSubject, at: readonly number[]): void;
  cancel(): void;
  /** Resolves when nothing is under way or waiting; the chart does not count. */
  idle(): Promise<void>;
  readonly busy: boolean;
}

/** Whether a failure says that there are too few different points, and nothing of the engine. */
export function isTooFew(code: string): boolean {
  return code === "E_TOO_FEW_POINTS" || code === "E_DEGENERATE";
}

interface Asked {
  readonly id: number;
  readonly strength: FitStrength;
  readonly live: boolean;
  readonly what: FitSubject;
}

export function createFitClient(start: () => Worker, handlers: FitHandlers): FitClient {
  let subject = 0;
  let known: FitSubject | null = null;
  let serial = 0;
  let running: Asked | null = null;
  let waiting: Asked | null = null;
  let retried = 0;
  const desk = createDesk<FitRequest, FitAnswer>(start, { receive, died: replace });
  const { post } = desk;
  const { idle, settle } = createWaiters(() => running === null && waiting === null);

  /** The next worker has to be told what is fitted. */
  function dismiss(): void {
    desk.dismiss();
    known = null;
  }

  /** A dead worker's request is tried once more in a new one. Where it only filled the chart, the fit that is shown stands. */
  function replace(code: LossCode, message: string): void {
    dismiss();
    const lost = waiting ?? running;
    running = null;
    waiting = null;
    // What never began is not restarted.
    if (code === "E_WORKER") handlers.restarted();
    if (lost === null) return settle();
    if (lost.id !== retried) {
      retried = lost.id;
      begin(lost);
    } else {
      handlers.failed(code, message);
      settle();
    }
  }

  /** Says what is fitted, if it was something else before. */
  function tell(what: FitSubject): void {
    if (known === what) return;
    known = what;
    subject += 1;
    post({ kind: "subject", subject, what });
  }

  function begin(asked: Asked): void {
    running = asked;
    tell(asked.what);
    post({ kind: "fit", subject, id: asked.id, strength: asked.strength, live: asked.live });
  }

  function receive(answer: FitAnswer): void {
    if (answer.kind === "chart") {
      if (answer.subject === subject && running === null) handlers.chart(answer);
      return;
    }
    if (running === null || answer.id !== running.id) return;
    if (answer.kind === "progress") return handlers.progress(answer.value);
    const [done, next] = [running, waiting];
    running = waiting = null;
    // An engine that did not start is started anew with the next request.
    if (answer.kind === "failed" && answer.code === "E_INIT") dismiss();
    // Before anybody hears of the one that is done: whoever asks then whether there is more to come is told.
    if (next !== null) begin(next);
    if (answer.kind === "fitted") handlers.fitted(answer.fits, done.what, answer.ms, done.strength);
    else if (next !== null) return;
    else if (answer.kind === "failed") handlers.failed(answer.code, answer.message);
    else handlers.stopped();
    settle();
  }

  return {
    get busy() {
      return running !== null;
    },
    fit(what, strength, live) {
      serial += 1;
      const asked = { id: serial, strength, live, what };
      if (running === null) return begin(asked);
      // A step of a drag waits for the one before, so that something is always to be seen; a settled request does not wait.
      waiting = asked;
      if (!live || running.what !== what) post({ kind: "stop" });
    },
    chart(what, at) {
      if (running !== null) return;
      tell(what);
      post({ kind: "chart", subject, at });
    },
    cancel() {
      waiting = null;
      // With nothing under way it is the chart that stops.
      if (desk.staffed) post({ kind: "stop" });
    },
    idle,
  };
}
