import { createDesk, createWaiters, type Desk, type LossCode } from "../worker-desk.ts";
import type { FitAnswer, FitRequest, FitStrength, FitSubject, PlainFit } from "./job.ts";

/**
 * Fits in a worker: the newest request counts, one is under way at a time, and an older result never replaces a newer
 * one. A worker that dies is replaced once for a request; what it was asked for is known here.
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
  return new Client(start, handlers);
}

class Client implements FitClient {
  readonly #handlers: FitHandlers;
  readonly #desk: Desk<FitRequest>;
  readonly #waiters = createWaiters(() => this.#running === null && this.#waiting === null);
  /** What the worker has been told that is fitted, and its number. */
  #known: FitSubject | null = null;
  #subject = 0;
  #serial = 0;
  #running: Asked | null = null;
  #waiting: Asked | null = null;
  /** The request that was under way when the last worker died. */
  #retried = 0;

  constructor(start: () => Worker, handlers: FitHandlers) {
    this.#handlers = handlers;
    this.#desk = createDesk<FitRequest, FitAnswer>(start, { receive: (answer) => this.#receive(answer), died: (code, message) => this.#replace(code, message) });
  }

  get busy(): boolean {
    return this.#running !== null;
  }

  fit(what: FitSubject, strength: FitStrength, live: boolean): void {
    this.#serial += 1;
    const asked = { id: this.#serial, strength, live, what };
    if (this.#running === null) return this.#begin(asked);
    // A step of a drag waits for the one before, so that something is always to be seen; a settled request does not
    // wait.
    this.#waiting = asked;
    if (!live || this.#running.what !== what) this.#desk.post({ kind: "stop" });
  }

  chart(what: FitSubject, at: readonly number[]): void {
    if (this.#running !== null) return;
    this.#tell(what);
    this.#desk.post({ kind: "chart", subject: this.#subject, at });
  }

  cancel(): void {
    this.#waiting = null;
    // With nothing under way it is the chart that stops.
    if (this.#desk.staffed) this.#desk.post({ kind: "stop" });
  }

  idle(): Promise<void> {
    return this.#waiters.idle();
  }

  #begin(asked: Asked): void {
    this.#running = asked;
    this.#tell(asked.what);
    this.#desk.post({ kind: "fit", subject: this.#subject, id: asked.id, strength: asked.strength, live: asked.live });
  }

  /** Says what is fitted, if it was something else before. */
  #tell(what: FitSubject): void {
    if (this.#known === what) return;
    this.#known = what;
    this.#subject += 1;
    this.#desk.post({ kind: "subject", subject: this.#subject, what });
  }

  #receive(answer: FitAnswer): void {
    if (answer.kind === "chart") {
      if (answer.subject === this.#subject && this.#running === null) this.#handlers.chart(answer);
      return;
    }
    if (this.#running === null || answer.id !== this.#running.id) return;
    if (answer.kind === "progress") return this.#handlers.progress(answer.value);
    const [done, next] = [this.#running, this.#waiting];
    this.#running = this.#waiting = null;
    // An engine that did not start is started anew with the next request.
    if (answer.kind === "failed" && answer.code === "E_INIT") this.#dismiss();
    // Before anybody hears of the one that is done: whoever asks then whether there is more to come is told.
    if (next !== null) this.#begin(next);
    if (answer.kind === "fitted") this.#handlers.fitted(answer.fits, done.what, answer.ms, done.strength);
    else if (next !== null) return;
    else if (answer.kind === "failed") this.#handlers.failed(answer.code, answer.message);
    else this.#handlers.stopped();
    this.#waiters.settle();
  }

  /**
   * A dead worker's request is tried once more in a new one. Where it only filled the chart, the fit that is shown
   * stands.
   */
  #replace(code: LossCode, message: string): void {
    this.#dismiss();
    const lost = this.#waiting ?? this.#running;
    this.#running = this.#waiting = null;
    // What never began is not restarted.
    if (code === "E_WORKER") this.#handlers.restarted();
    if (lost === null) return this.#waiters.settle();
    if (lost.id !== this.#retried) {
      this.#retried = lost.id;
      this.#begin(lost);
    } else {
      this.#handlers.failed(code, message);
      this.#waiters.settle();
    }
  }

  /** The next worker has to be told what is fitted. */
  #dismiss(): void {
    this.#desk.dismiss();
    this.#known = null;
  }
}
