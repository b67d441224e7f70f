/** The browser's own store, as far as this page uses it. */

export const prefix = "expline.kept.";

export function keysOf(storage: Storage): string[] {
  return Array.from({ length: storage.length }, (_, i) => storage.key(i) ?? "").filter((key) => key.startsWith(prefix));
}

/** Whether anything was kept here before. */
export function hasKept(storage: Storage | null): boolean {
  try {
    return storage !== null && keysOf(storage).length > 0;
  } catch {
    return false;
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
