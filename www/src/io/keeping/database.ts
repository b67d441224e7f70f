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

/** Resolves when what was asked for has been written, or read. */
async function within<T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => () => T): Promise<T> {
  const database = await opened();
  return new Promise<T>((resolve, reject) => {
    const transaction = database.transaction(table, mode, { durability: "strict" });
    const fail = (): void => reject(transaction.error ?? new Error("the database gave up"));
    transaction.onerror = fail;
    transaction.onabort = fail;
    const result = work(transaction.objectStore(table));
    transaction.oncomplete = () => resolve(result());
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
