import { endingWith } from "../worker-desk.ts";

/** Starts workers that fit; they end with the page. */
export function fitWorkers(until: AbortSignal): () => Worker {
  return endingWith(until, () => new Worker(new URL("./fit-worker.ts", import.meta.url), { type: "module" }));
}
