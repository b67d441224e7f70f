/** Long work in short tasks. */
import { ExplineError } from "./core.js";

/** What of the host is asked for: Node's own way to the next turn, which browsers have not. */
interface Host {
  setImmediate?: (task: () => void) => unknown;
}

/**
 * The next turn of the event loop: rendering, input, timers and messages come first.
 *
 * `scheduler.yield` would come back before other messages, and so before the one that asks a worker to stop.
 */
export function nextTurn(): Promise<void> {
  const { setImmediate } = globalThis as Host;
  if (setImmediate !== undefined) return new Promise((resolve) => void setImmediate(resolve));
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
export function checkSignal(op: string, signal: AbortSignal | undefined): void {
  if (signal?.aborted === true) throw new ExplineError("E_CANCELLED", op, "the signal was aborted", { cause: signal.reason });
}
