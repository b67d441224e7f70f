import { createDesk, createWaiters } from "../worker-desk.ts";
import type { PictureSource, TraceAnswer, TraceHow, TraceRequest, TraceResult, TraceStage } from "./job.ts";

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
  /** Width and height of a picture. @throws Error with the code of what is wrong with it. */
  probe(picture: PictureSource): Promise<readonly [number, number]>;
  readonly busy: boolean;
  /** Resolves when nothing is under way. */
  idle(): Promise<void>;
}

/** What a picture that cannot be looked at is refused with. */
export class ProbeError extends Error {
  override readonly name = "ProbeError";
  constructor(readonly code: string) {
    super(code);
  }
}

/** A worker has this long to say that it has stopped, in milliseconds. */
const patience = 300;

interface Probing {
  readonly request: Extract<TraceRequest, { kind: "probe" }>;
  /** Whether a worker died with it already. */
  retried: boolean;
  resolve(size: readonly [number, number]): void;
  reject(error: Error): void;
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
  let serial = 0;
  let running: Extract<TraceRequest, { kind: "trace" }> | null = null;
  /** Stopped jobs whose last word has not come yet. */
  const leaving = new Set<number>();
  let giveUp: (() => void) | null = null;
  /** The request that was under way when the last worker died. */
  let retried = 0;
  const probing = new Map<number, Probing>();
  const desk = createDesk<TraceRequest, TraceAnswer>(start, { receive, died });
  const { post } = desk;
  const { idle, settle } = createWaiters(() => running === null && probing.size === 0);

  function dismiss(): void {
    desk.dismiss();
    leaving.clear();
    giveUp?.();
    giveUp = null;
  }

  /** A new worker in the old one's place, which goes on with what is still wanted. */
  function replace(): void {
    dismiss();
    for (const { request } of probing.values()) post(request);
    if (running !== null) post(running);
  }

  function died(message: string): void {
    handlers.restarted();
    // Which of its requests a worker died of nobody knows: each is tried once more.
    const lost = running?.id === retried;
    if (lost) running = null;
    retried = running?.id ?? 0;
    for (const [id, probe] of probing) {
      if (lost || probe.retried) {
        probing.delete(id);
        probe.reject(new ProbeError("E_WORKER"));
      }
      probe.retried = true;
    }
    replace();
    if (lost) handlers.failed("E_WORKER", message);
    settle();
  }

  function leave(id: number): void {
    leaving.add(id);
    giveUp ??= clock.after(patience, replace);
  }

  function heard(id: number): void {
    if (!leaving.delete(id) || leaving.size > 0) return;
    giveUp?.();
    giveUp = null;
  }

  function receive(answer: TraceAnswer): void {
    const { id } = answer;
    const asked = probing.get(id);
    if (asked !== undefined) {
      probing.delete(id);
      if (answer.kind === "probed") asked.resolve([answer.width, answer.height]);
      else asked.reject(new ProbeError(answer.kind === "failed" ? answer.code : ""));
      return settle();
    }
    const isLast = answer.kind !== "progress" && answer.kind !== "picture";
    if (running === null || id !== running.id) {
      if (isLast) heard(id);
      return;
    }
    const { picture } = running;
    if (isLast) running = null;
    switch (answer.kind) {
      case "progress":
        handlers.progress(answer.stage, answer.value, answer.done, answer.total);
        break;
      case "picture":
        handlers.picture(answer, picture);
        break;
      case "traced":
        handlers.traced(answer.result, answer.ms);
        break;
      case "photo":
        handlers.photo(answer.count, answer.speckle);
        break;
      case "failed":
        // An engine that did not start is started anew with the next request.
        if (answer.code === "E_INIT") dismiss();
        handlers.failed(answer.code, answer.message);
        break;
      case "probed":
      case "stopped":
        break;
    }
    if (isLast) settle();
  }

  return {
    get busy() {
      return running !== null;
    },
    trace(picture, how) {
      if (running !== null) leave(running.id);
      serial += 1;
      running = { kind: "trace", id: serial, picture, how };
      post(running);
    },
    cancel() {
      if (running === null) return false;
      leave(running.id);
      running = null;
      post({ kind: "stop" });
      settle();
      return true;
    },
    probe(picture) {
      serial += 1;
      const request = { kind: "probe", id: serial, picture } as const;
      return new Promise((resolve, reject) => {
        probing.set(request.id, { request, retried: false, resolve, reject });
        post(request);
      });
    },
    idle,
  };
}
