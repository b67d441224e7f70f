/** The browser's database, as far as this page uses it: one table of texts by their keys. */

export interface KeptText {
  readonly key: string;
  readonly text: string;
}

const [name, version, table] = ["expline", 1, "kept"] as const;

let opening: Promise<IDBDatabase> | null = null;

/** Rejects where there is none, or where it is blocked; the next call tries again. */
function opened(): Promise<IDBDatabase> {
  opening ??= new Promise<IDBDatabase>((resolve, reject) => {
    const request = indexedDB.open(name, version);
    request.onupgradeneeded = () => request.result.createObjectStore(table);
    request.onerror = () => reject(request.error ?? new Error("no database"));
    request.onblocked = () => reject(new Error("the database is blocked"));
    request.onsuccess = () => {
      const database = request.result;
      // Another tab may want a newer form of it, and the browser may take it away: the next call opens it again.
      database.onversionchange = () => {
        database.close();
        opening = null;
      };
      database.onclose = () => (opening = null);
      resolve(database);
    };
  }).catch((error: unknown) => {
    opening = null;
    throw error;
  });
  return opening;
}

/**
 * How long one answer may take. Another page that was frozen in the middle of a write can hold the database for good.
 */
const limitMs = 5000;

/** What gives up each piece of work that is under way. */
const underWay = new Set<() => void>();

let left = false;

/**
 * The page is being left, and the browser may freeze it and keep it for the Back button. What it has begun would then
 * keep every later page from the database, in WebKit for as long as it is frozen: so it is given up, and rejects.
 */
export function letGo(): void {
  left = true;
  for (const giveUp of underWay) giveUp();
}

/** The page is back. */
export function takeUp(): void {
  left = false;
}

/**
 * Resolves when what was asked for has been written, or read; rejects when that takes too long, or the page is left
 * meanwhile.
 */
function within<T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => () => T): Promise<T> {
  return new Promise<T>((resolve, reject) => {
    let transaction: IDBTransaction | null = null;
    const end = (): void => {
      clearTimeout(timer);
      underWay.delete(giveUp);
    };
    const fail = (error: unknown): void => {
      end();
      reject(error instanceof Error ? error : new Error("the database gave up"));
    };
    const giveUp = (): void => {
      fail(new Error("the database was given up"));
      // One that does not open is asked again.
      if (transaction === null) opening = null;
      try {
        transaction?.abort();
      } catch {
        // It has just ended.
      }
    };
    const timer = setTimeout(giveUp, limitMs);
    underWay.add(giveUp);
    if (left) return giveUp();
    opened().then((database) => {
      if (!underWay.has(giveUp)) return;
      const begun = (transaction = database.transaction(table, mode, { durability: "strict" }));
      begun.onabort = () => fail(begun.error);
      const result = work(begun.objectStore(table));
      begun.oncomplete = () => {
        end();
        resolve(result());
      };
    }).catch(fail);
  });
}

export function readAll(): Promise<KeptText[]> {
  return within("readonly", (store) => {
    const [keys, texts] = [store.getAllKeys(), store.getAll()];
    return () => keys.result.flatMap((key, i) => {
      const text: unknown = texts.result[i];
      return typeof key === "string" && typeof text === "string" ? [{ key, text }] : [];
    });
  });
}

/** Writes one text and reads it back. */
export async function write({ key, text }: KeptText): Promise<boolean> {
  await within("readwrite", (store) => {
    store.put(text, key);
    return () => undefined;
  });
  return within("readonly", (store) => {
    const back = store.get(key);
    return () => back.result === text;
  });
}

export function remove(keys: readonly string[]): Promise<void> {
  return within("readwrite", (store) => {
    for (const key of keys) store.delete(key);
    return () => undefined;
  });
}
