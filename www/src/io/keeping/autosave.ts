/**
 * Keeps the drawing over a reload or a crash. Every tab writes under its own session, in two generations that take
 * turns, each with a checksum: a torn or damaged write opens the other one, and no tab can overwrite another's work.
 */
import type { DemoState } from "../../document/document.ts";
import { writeState } from "../../document/file/write.ts";
import type { KeptText } from "./database.ts";
import { keep, keepAtOnce, makeRoom } from "./keeping.ts";
import { seal } from "./sealed.ts";
import { rememberTab } from "./store.ts";

const delayMs = 1000;

export interface AutosaveOptions {
  read(): DemoState;
  /** True while a gesture is open: what is half done is not kept. */
  busy(): boolean;
  /** Told when keeping begins to fail, and when it works again. */
  failing(failed: boolean): void;
  readonly until: AbortSignal;
}

export interface Autosave {
  /** Something changed: it is kept within a second. */
  touch(): void;
}

export function createAutosave({ read, busy, failing, until }: AutosaveOptions): Autosave {
  const session = Math.random().toString(36).slice(2, 10).padEnd(8, "0");
  let generation = 0;
  let timer: ReturnType<typeof setTimeout> | null = null;
  let failed = false;
  /** Writes come one after the other; of those that wait, the newest is enough. */
  let writing = makeRoom(session);
  let waiting: KeptText | null = null;

  const writeNewest = async (): Promise<void> => {
    if (waiting === null) return;
    const next = waiting;
    waiting = null;
    const now = !(await keep(next));
    if (now !== failed) failing(now);
    failed = now;
  };
  const flush = (leaving: boolean): void => {
    if (timer === null) return;
    clearTimeout(timer);
    timer = null;
    if (busy()) return touch();
    generation += 1;
    rememberTab(session);
    waiting = seal({ session, generation, time: Date.now(), json: writeState(read()) });
    // A page that is being left may not live until the database has answered.
    if (leaving) keepAtOnce(waiting);
    writing = writing.then(writeNewest);
  };
  const touch = (): void => {
    // From the first change that is not kept yet, so that steady work is kept every second, not never.
    timer ??= setTimeout(() => flush(false), delayMs);
  };
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && flush(true), { signal: until });
  window.addEventListener("pagehide", () => flush(true), { signal: until });
  until.addEventListener("abort", () => timer !== null && clearTimeout(timer), { once: true });
  return { touch };
}
