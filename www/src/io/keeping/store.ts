/**
 * The browser's small local store, as far as this page uses it: it says whether there is anything in the database, and
 * takes what has to be written at once, when the page is being left.
 */
import type { KeptText } from "./database.ts";

export const prefix = "expline.kept.";
/** There is something in the database. */
const mark = "expline.kept";

export function keysOf(storage: Storage): string[] {
  return Array.from({ length: storage.length }, (_, i) => storage.key(i) ?? "").filter((key) => key.startsWith(prefix));
}

/** Whether anything may have been kept here before. */
export function hasKept(storage: Storage | null): boolean {
  try {
    return storage === null || storage.getItem(mark) !== null || keysOf(storage).length > 0;
  } catch {
    return true;
  }
}

/** Written before this call returns, if there is room. */
export function keepAtOnce({ key, text }: KeptText): boolean {
  const storage = localStore();
  try {
    storage?.setItem(key, text);
    return storage?.getItem(key) === text;
  } catch {
    return false;
  }
}

/** From now on there is something in the database. */
export function markKept(storage: Storage | null): void {
  try {
    storage?.setItem(mark, "1");
  } catch {
    // Then the page looks into the database at its next visit only if it cannot look here either.
  }
}

const tabKey = "expline.tab";

/**
 * What this tab shows, for when it is loaded again: the session that keeps its work, or the link that it was opened
 * with.
 */
export function rememberTab(what: string): void {
  try {
    sessionStorage.setItem(tabKey, what);
  } catch {
    // Then the newest work of all opens.
  }
}

export function tabShows(): string | null {
  try {
    return sessionStorage.getItem(tabKey);
  } catch {
    return null;
  }
}

/** The page's local store, or null where the browser keeps none. */
export function localStore(): Storage | null {
  try {
    return window.localStorage;
  } catch {
    return null;
  }
}
