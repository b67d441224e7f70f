import { endingWith } from "../worker-desk.ts";

/** Starts a worker that fits; it ends with the page. */
export function startFitWorker(until: AbortSignal): Worker {
  return endingWith(until, new Worker(new URL("./fit-worker.ts", import.meta.url), { type: "module" }));
}
