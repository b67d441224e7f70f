import { createDesk, createWaiters, type Desk, type LossCode } from "../worker-desk.ts";
import type { PictureSource, TraceAnswer, TraceHow, TraceRequest, TraceResult, TraceStage } from "./job.ts";
import { Probes, type PictureSize } from "./probes.ts";

/**
 * Traces in a worker. The newest request counts: what was under way before is stopped, and its answers are heard no
 * more. A worker that does not stop in time, or dies, gives way to a new one.
 */

export type PictureAnswer = Extract<TraceAnswer, { kind: "picture" }>;

export interface TraceHandlers {
  progress(stage: TraceStage, value: number, done: number, total: number): void;
  picture(shown: PictureAnswer, of: PictureSource): void;
  traced(result: TraceResult, ms: number): void;
  photo(count: number, speckle: number): void;
  failed(code: string, message: string): void;
  /** The worker died and another one has taken its place. */
  restarted(): void;
}

export interface TraceClient {
  trace(picture: PictureSource, how: TraceHow): void;
  /** Ends what is under way; says whether anything was. */
  cancel(): boolean;
  /** @throws ProbeError with the code of what is wrong with the picture. */
  probe(picture: PictureSource): Promise<PictureSize>;
  readonly busy: boolean;
  /** Resolves when nothing is under way. */
  idle(): Promise<void>;
}

export interface Clock {
  after(ms: number, task: () => void): () => void;
}

export const pageClock: Clock = {
  after(ms, task) {
    const timer = setTimeout(task, ms);
    return () => clearTimeout(timer);
  },
};

export function createTraceClient(start: () => Worker, handlers: TraceHandlers, clock: Clock = pageClock): TraceClient {
  return new Client(start, handlers, clock);
}

/** A picture that nobody will see gives its pixels back at once. */
function discard({ source, edges }: PictureAnswer): void {
  source.close();
  edges.close();
}

/** A worker has this long to say that it has stopped, in milliseconds. */
const patience = 300;

/** Stopped jobs whose last word has not come yet. */
class Leaving {
  readonly #ids = new Set<number>();
  readonly #clock: Clock;
  readonly #late: () => void;
  #giveUp: (() => void) | null = null;

  /** `late` is called when a word has not come in time. */
  constructor(clock: Clock, late: () => void) {
    this.#clock = clock;
    this.#late = late;
  }

  add(id: number): void {
    this.#ids.add(id);
    this.#giveUp ??= this.#clock.after(patience, this.#late);
  }

  heard(id: number): void {
    if (this.#ids.delete(id) && this.#ids.size === 0) this.forget();
  }

  forget(): void {
    this.#ids.clear();
    this.#giveUp?.();
    this.#giveUp = null;
  }
}

class Client implements TraceClient {
  readonly #handlers: TraceHandlers;
  readonly #desk: Desk<TraceRequest>;
  readonly #leaving: Leaving;
  readonly #probes: Probes;
  readonly #waiters = createWaiters(() => this.#running === null && this.#probes.none);
  #serial = 0;
  #running: Extract<TraceRequest, { kind: "trace" }> | null = null;
  /** The request that was under way when the last worker died. */
  #retried = 0;

  constructor(start: () => Worker, handlers: TraceHandlers, clock: Clock) {
    this.#handlers = handlers;
    this.#desk = createDesk<TraceRequest, TraceAnswer>(start, { receive: (answer) => this.#receive(answer), died: (code, message) => this.#died(code, message) });
    this.#leaving = new Leaving(clock, () => this.#replace());
    this.#probes = new Probes(this.#desk.post);
  }

  get busy(): boolean {
    return this.#running !== null;
  }

  trace(picture: PictureSource, how: TraceHow): void {
    if (this.#running !== null) this.#leaving.add(this.#running.id);
    this.#serial += 1;
    this.#running = { kind: "trace", id: this.#serial, picture, how };
    this.#desk.post(this.#running);
  }

  cancel(): boolean {
    if (this.#running === null) return false;
    this.#leaving.add(this.#running.id);
    this.#running = null;
    this.#desk.post({ kind: "stop" });
    this.#waiters.settle();
    return true;
  }

  probe(picture: PictureSource): Promise<PictureSize> {
    this.#serial += 1;
    return this.#probes.begin(this.#serial, picture);
  }

  idle(): Promise<void> {
    return this.#waiters.idle();
  }

  #receive(answer: TraceAnswer): void {
    if (this.#probes.receive(answer)) return this.#waiters.settle();
    const running = this.#running;
    const isLast = answer.kind !== "progress" && answer.kind !== "picture";
    if (running?.id !== answer.id) {
      if (isLast) this.#leaving.heard(answer.id);
      if (answer.kind === "picture") discard(answer);
      return;
    }
    if (isLast) this.#running = null;
    this.#tell(answer, running.picture);
    if (isLast) this.#waiters.settle();
  }

  #tell(answer: TraceAnswer, picture: PictureSource): void {
    switch (answer.kind) {
      case "progress":
        return this.#handlers.progress(answer.stage, answer.value, answer.done, answer.total);
      case "picture":
        return this.#handlers.picture(answer, picture);
      case "traced":
        return this.#handlers.traced(answer.result, answer.ms);
      case "photo":
        return this.#handlers.photo(answer.count, answer.speckle);
      case "failed":
        // An engine that did not start is started anew with the next request.
        if (answer.code === "E_INIT") this.#dismiss();
        return this.#handlers.failed(answer.code, answer.message);
      case "probed":
      case "stopped":
    }
  }

  #died(code: LossCode, message: string): void {
    // What never began is not restarted.
    if (code === "E_WORKER") this.#handlers.restarted();
    // Which of its requests a worker died of nobody knows: each is tried once more.
    const lost = this.#running?.id === this.#retried;
    if (lost) this.#running = null;
    this.#retried = this.#running?.id ?? 0;
    this.#probes.died(code, lost);
    this.#replace();
    if (lost) this.#handlers.failed(code, message);
    this.#waiters.settle();
  }

  /** A new worker in the old one's place, which goes on with what is still wanted. */
  #replace(): void {
    this.#dismiss();
    this.#probes.askAgain();
    if (this.#running !== null) this.#desk.post(this.#running);
  }

  #dismiss(): void {
    this.#desk.dismiss();
    this.#leaving.forget();
  }
}
