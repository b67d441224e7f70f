/** Long work in short tasks. */
import { ExplineError, type Signal, wrong } from "../core.js";

/** What of the host is asked for: Node's own way to the next turn, which browsers have not. */
interface Host {
  setImmediate?: (task: () => void) => unknown;
}

/**
 * The next turn of the event loop: rendering, input, timers and messages come first.
 *
 * `scheduler.yield` would come back before other messages, and so before the one that asks a worker to stop.
 */
function nextTurn(): Promise<void> {
  const { setImmediate } = globalThis as Host;
  if (setImmediate !== undefined) return new Promise((resolve) => void setImmediate(resolve));
  // jsdom has neither; its timers wait no longer than they are asked to.
  if (typeof MessageChannel !== "function") return new Promise((resolve) => void setTimeout(resolve));
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(0);
  });
}

/** Throws once the caller has given up. */
export function checkSignal(op: string, signal: Signal | undefined): void {
  if (signal?.aborted === true) throw new ExplineError("E_CANCELLED", op, "the signal was aborted", { cause: signal.reason });
}

/** How work is watched and stopped. @internal */
export interface Watch<Progress> {
  readonly signal: Signal | undefined;
  readonly onProgress: ((progress: Progress) => void) | undefined;
}

/** Who watches. @internal */
export function watch<Progress>(op: string, own: { readonly signal?: unknown; readonly onProgress?: unknown }): Watch<Progress> {
  const { signal, onProgress } = own;
  if (signal !== undefined && !isSignal(signal)) throw wrong("E_TYPE", op, "signal", signal, "AbortSignal");
  if (onProgress !== undefined && typeof onProgress !== "function") throw wrong("E_TYPE", op, "onProgress", onProgress, "a function");
  return { signal, onProgress: onProgress as Watch<Progress>["onProgress"] };
}

function isSignal(value: unknown): value is Signal {
  return typeof value === "object" && value !== null && typeof (value as { aborted?: unknown }).aborted === "boolean";
}

/** Work in one go. @internal */
export function inOneGo<R>(work: Generator<void, R>): R {
  for (;;) {
    const { done, value } = work.next();
    if (done === true) return value;
  }
}

/** A task lasts about this many milliseconds, and one step more. */
const TASK = 6;

/** Work in short tasks; between two of them everybody else has his turn. @internal */
export async function inTasks<R>(op: string, signal: Signal | undefined, work: Generator<void, R>): Promise<R> {
  for (;;) {
    const end = performance.now() + TASK;
    do {
      const { done, value } = work.next();
      // What watches the progress may have given up, at the last step as well.
      checkSignal(op, signal);
      if (done === true) return value;
    } while (performance.now() < end);
    await nextTurn();
    checkSignal(op, signal);
  }
}
