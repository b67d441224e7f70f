import assert from "node:assert/strict";
import { afterEach, test } from "node:test";
import { keep } from "../src/io/keeping/keeping.ts";
import { seal } from "../src/io/keeping/sealed.ts";

/** What is kept where the database does not do as it should. */

/** The local store of a browser, in memory. */
class Store {
  readonly #items = new Map<string, string>();
  get length(): number {
    return this.#items.size;
  }
  key(i: number): string | null {
    return [...this.#items.keys()][i] ?? null;
  }
  getItem(key: string): string | null {
    return this.#items.get(key) ?? null;
  }
  setItem(key: string, text: string): void {
    this.#items.set(key, text);
  }
  removeItem(key: string): void {
    this.#items.delete(key);
  }
}

const host = globalThis as { window?: unknown; indexedDB?: unknown };

afterEach(() => {
  delete host.window;
  delete host.indexedDB;
});

/** A database that cannot be opened, and says why. */
function broken(name: string): { open(): object } {
  return {
    open() {
      const request = { error: Object.assign(new Error(name), { name }), onerror: (): void => undefined };
      queueMicrotask(() => request.onerror());
      return request;
    },
  };
}

const work = (session: string, time: number): { key: string; text: string } => seal({ session, generation: 1, time, json: "{}" });

for (const [name, left] of [["InvalidStateError", 3], ["QuotaExceededError", 0]] as const) {
  test(`a database that fails with ${name} costs ${left === 0 ? "the other sessions their room" : "no other session its work"}`, async () => {
    const store = new Store();
    Object.assign(host, { window: { localStorage: store }, indexedDB: broken(name) });
    const others = ["one", "two", "three"].map((session, i) => work(session, i));
    for (const { key, text } of others) store.setItem(key, text);
    assert.equal(await keep(work("own", 9)), true, "in the local store");
    assert.equal(others.filter(({ key }) => store.getItem(key) !== null).length, left);
  });
}
