/**
 * Keeps the drawing over a reload or a crash. Every tab writes under its own session, in two generations that take
 * turns, each with a checksum: a torn or damaged write opens the other one, and no tab can overwrite another's work.
 */
import type { DemoState } from "../../document/document.ts";
import { writeState } from "../../document/file/write.ts";
import { letGo, takeUp } from "./database.ts";
import { keep, makeRoom } from "./keeping.ts";
import { statePieces } from "./pieces.ts";
import { seal, type Unsealed } from "./seal.ts";
import { sealPieces } from "./sealed.ts";
import { keepAtOnce, rememberTab } from "./store.ts";

const delayMs = 1000;

export interface AutosaveOptions {
  read(): DemoState;
  /** True while a gesture is open: what is half done is not kept. */
  busy(): boolean;
  /** Takes it back. */
  abandon(): void;
  /** Told when keeping begins to fail, and when it works again. */
  failing(failed: boolean): void;
  readonly until: AbortSignal;
}

export interface Autosave {
  /** Something changed: it is kept within a second. */
  touch(): void;
}

type Work = Unsealed & { readonly state: DemoState };

export function createAutosave(session: string, { read, busy, abandon, failing, until }: AutosaveOptions): Autosave {
  let generation = 0;
  let timer: ReturnType<typeof setTimeout> | null = null;
  let failed = false;
  /** Writes come one after the other; of those that wait, the newest is enough. */
  let writing = makeRoom(session);
  /** The newest that is not kept yet, and the last that was to be. */
  let newest: Work | null = null;
  let last: Work | null = null;

  const writeNewest = async (): Promise<void> => {
    if (newest === null) return;
    const next = newest;
    const now = !(await keep(await sealPieces(next, statePieces(next.state), resting())));
    if (newest === next) newest = null;
    if (now !== failed) failing(now);
    failed = now;
  };
  const take = (): void => {
    if (timer === null) return;
    clearTimeout(timer);
    timer = null;
    if (busy()) return touch();
    generation += 1;
    rememberTab(session);
    newest = last = { session, generation, time: Date.now(), state: read() };
    writing = writing.then(writeNewest);
  };
  /** Says whether all of it is kept: a page that is being left may not live until the database has answered. */
  const leave = (): boolean => {
    take();
    return newest === null || keepNow(newest);
  };
  const touch = (): void => {
    // From the first change that is not kept yet, so that steady work is kept every second, not never. The very first
    // has waited for this part of the page already, and until it is kept there is nothing to come back to.
    timer ??= setTimeout(take, generation === 0 && !busy() ? 0 : delayMs);
  };
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && leave(), { signal: until });
  window.addEventListener("pagehide", () => {
    // What was done before it may not be kept yet.
    if (busy()) abandon();
    const isKept = leave();
    // Sessions of other tabs may have taken its place meanwhile: here, where it is wanted next, it is kept once more.
    if (newest === null && last !== null) keepNow(last);
    if (isKept) letGo();
  }, { signal: until });
  window.addEventListener("pageshow", takeUp, { signal: until });
  until.addEventListener("abort", () => timer !== null && clearTimeout(timer), { once: true });
  return { touch };
}

/** Before this call returns, if there is room. */
function keepNow({ state, ...what }: Work): boolean {
  return keepAtOnce(seal({ ...what, json: writeState(state) }));
}

/** Of a frame, what the writing of a large drawing takes before the page has its turn. */
const turnMs = 5;

/** Lets the page have its turn, once that is due. */
function resting(): () => Promise<void> | null {
  let since = performance.now();
  return () => {
    if (performance.now() - since < turnMs) return null;
    return new Promise((go) => {
      setTimeout(() => {
        since = performance.now();
        go();
      });
    });
  };
}
