/**
 * Keeps the drawing over a reload or a crash. Every tab writes under its own session, in two generations that take
 * turns, each with a checksum: a torn or damaged write opens the other one, and no tab can overwrite another's work.
 */
import type { DemoState } from "../document/document.ts";
import { writeState } from "../document/file/write.ts";
import { keysOf, prefix } from "./store.ts";

const delayMs = 1000;
/** Sessions that stay in the store; the oldest give way. */
const mostSessions = 4;

/** FNV-1a over the UTF-16 units: enough to tell a torn or flipped write from a whole one. */
function checksum(text: string): string {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i += 1) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, "0");
}

function seal(generation: number, time: number, json: string): string {
  const body = `${generation} ${time}\n${json}`;
  return `${checksum(body)} ${body}`;
}

/** A whole write: which generation it is, when it was made, and its text. */
export interface Sealed {
  readonly key: string;
  readonly session: string;
  readonly generation: number;
  /** Milliseconds since 1970. */
  readonly time: number;
  readonly json: string;
}

function unseal(key: string, text: string): Sealed | null {
  const space = text.indexOf(" ");
  const body = text.slice(space + 1);
  if (space !== 8 || checksum(body) !== text.slice(0, space)) return null;
  const line = body.indexOf("\n");
  const [generation, time] = body.slice(0, line).split(" ").map(Number);
  const session = key.slice(prefix.length).split(".")[0];
  if (generation === undefined || time === undefined || session === undefined) return null;
  return { key, session, generation, time, json: body.slice(line + 1) };
}

/** Every whole write of every session, newest first. Never throws: a blocked store is an empty one. */
export function sealedWrites(storage: Storage | null): Sealed[] {
  if (storage === null) return [];
  try {
    const all = keysOf(storage).flatMap((key) => unseal(key, storage.getItem(key) ?? "") ?? []);
    return all.sort((a, b) => b.time - a.time || b.generation - a.generation);
  } catch {
    return [];
  }
}

export interface AutosaveOptions {
  readonly storage: Storage | null;
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
  /** Keeps what is there at once. */
  flush(): void;
  /** Forgets this session's copies. */
  forget(): void;
}

export function createAutosave(options: AutosaveOptions): Autosave {
  const session = Math.random().toString(36).slice(2, 10).padEnd(8, "0");
  let generation = 0;
  let timer: ReturnType<typeof setTimeout> | null = null;
  let failed = false;

  const report = (now: boolean): void => {
    if (now !== failed) options.failing(now);
    failed = now;
  };
  const flush = (): void => {
    if (timer === null) return;
    clearTimeout(timer);
    timer = null;
    if (options.busy()) {
      touch();
      return;
    }
    generation += 1;
    const key = `${prefix}${session}.${generation % 2}`;
    report(!write(options.storage, key, seal(generation, Date.now(), writeState(options.read())), session));
  };
  const touch = (): void => {
    // From the first change that is not kept yet, so that steady work is kept every second, not never.
    timer ??= setTimeout(flush, delayMs);
  };
  const forget = (): void => {
    if (timer !== null) clearTimeout(timer);
    timer = null;
    if (options.storage !== null) removeSession(options.storage, session);
  };
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && flush(), { signal: options.until });
  window.addEventListener("pagehide", flush, { signal: options.until });
  return { touch, flush, forget };
}

/** Writes and reads back; makes room among the oldest sessions once. Says whether it is kept. */
function write(storage: Storage | null, key: string, text: string, session: string): boolean {
  if (storage === null) return false;
  for (const retry of [false, true]) {
    try {
      if (retry || storage.getItem(key) === null) prune(storage, session, retry ? 1 : mostSessions);
      storage.setItem(key, text);
      return storage.getItem(key) === text;
    } catch {
      // Full or blocked; the second turn has made all the room there is.
    }
  }
  return false;
}

function prune(storage: Storage, session: string, keep: number): void {
  const sessions = new Set(sealedWrites(storage).map((sealed) => sealed.session).filter((other) => other !== session));
  for (const old of [...sessions].slice(keep - 1)) removeSession(storage, old);
}

export function removeSession(storage: Storage, session: string): void {
  for (const key of keysOf(storage)) if (key.startsWith(`${prefix}${session}.`)) storage.removeItem(key);
}
