/**
 * What the page's workers have in common: they start when they are first needed, are heard, and give way to new ones
 * when they die.
 */

export interface Desk<Request> {
  /** Starts the worker if there is none. */
  post(request: Request): void;
  /** Ends the worker; the next request has a new one. */
  dismiss(): void;
  readonly staffed: boolean;
}

export interface DeskHandlers<Answer> {
  receive(answer: Answer): void;
  /**
   * It stopped by itself, or (`E_INIT`) never began: its program did not come. It is still there until it is dismissed.
   */
  died(code: LossCode, message: string): void;
}

export type LossCode = "E_INIT" | "E_WORKER";

export function createDesk<Request, Answer>(start: () => Worker, { receive, died }: DeskHandlers<Answer>): Desk<Request> {
  let worker: Worker | null = null;

  function listen(fresh: Worker): Worker {
    fresh.addEventListener("message", (event: MessageEvent<Answer>) => {
      if (fresh === worker) receive(event.data);
    });
    fresh.addEventListener("error", (event) => {
      event.preventDefault();
      // Only a program that runs has something to say.
      if (fresh === worker) died("message" in event ? "E_WORKER" : "E_INIT", event.message);
    });
    return fresh;
  }

  return {
    get staffed() {
      return worker !== null;
    },
    post(request) {
      worker ??= listen(start());
      worker.postMessage(request);
    },
    dismiss() {
      worker?.terminate();
      worker = null;
    },
  };
}

/** Starts workers, one at a time, of which the last one ends when its page does. */
export function endingWith(until: AbortSignal, start: () => Worker): () => Worker {
  let last: Worker | null = null;
  until.addEventListener("abort", () => last?.terminate(), { once: true });
  return () => (last = start());
}

/** Those who wait until nothing is under way. */
export interface Waiters {
  /** Resolves at once if nothing is. */
  idle(): Promise<void>;
  /** To be called whenever something ended. */
  settle(): void;
}

export function createWaiters(quiet: () => boolean): Waiters {
  let waiting: (() => void)[] = [];
  return {
    idle: () => (quiet() ? Promise.resolve() : new Promise((resolve) => waiting.push(resolve))),
    settle() {
      if (!quiet()) return;
      const settled = waiting;
      waiting = [];
      for (const resolve of settled) resolve();
    },
  };
}
