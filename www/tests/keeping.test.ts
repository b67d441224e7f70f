import assert from "node:assert/strict";
import { afterEach, test } from "node:test";
import { keep } from "../src/io/keeping/keeping.ts";
import { seal } from "../src/io/keeping/seal.ts";
import { sealPieces, unseal } from "../src/io/keeping/sealed.ts";
import { emptyCurve, type Contour, type DemoState } from "../src/document/document.ts";
import { statePieces } from "../src/io/keeping/pieces.ts";
import { writeState } from "../src/document/file/write.ts";
import { createEditor } from "../src/editor/create-editor.ts";

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

/** A database that takes everything. */
function working(): { open(): object } {
  const texts = new Map<string, string>();
  const answered = (result: unknown): object => {
    const request: { result: unknown; onsuccess?: () => void } = { result };
    queueMicrotask(() => request.onsuccess?.());
    return request;
  };
  const store = { put: (text: string, key: string) => texts.set(key, text), get: (key: string) => ({ result: texts.get(key) }) };
  const transaction = (): object => {
    const made: { objectStore(): object; oncomplete?: () => void } = { objectStore: () => store };
    setTimeout(() => made.oncomplete?.());
    return made;
  };
  return { open: () => answered({ transaction }) };
}

// One that was opened stays open.
for (const [what, database, isOutside] of [["the local store, for want of a database,", broken("InvalidStateError"), false], ["the database", working(), true]] as const) {
  test(`a write that ends late in ${what} leaves what a page that was left has kept since`, async () => {
    const store = new Store();
    Object.assign(host, { window: { localStorage: store }, indexedDB: database });
    const of = (generation: number): { key: string; text: string } => seal({ session: "own", generation, time: generation, json: "{}" });
    const [old, newer] = [of(3), of(5)];
    assert.equal(old.key, newer.key, "two generations take turns");
    store.setItem(newer.key, newer.text);
    assert.equal(await keep(old), true);
    assert.equal(store.getItem(newer.key), newer.text);
    assert.equal(await keep(newer), true);
    assert.equal(store.getItem(newer.key), isOutside ? null : newer.text);
  });
}

function contour(points: number, from = 0): Contour {
  const at = (i: number): number => Math.sin(from + i) * 1000;
  const handle = { dx: 1 / 3, dy: -0 };
  return { family: "hermite", closed: true, points: Array.from({ length: points }, (_, i) => ({ x: at(i), y: at(i + 0.5), kind: "smooth", in: handle, out: handle })) };
}

function stateOf(contours: readonly Contour[], others: object = {}): DemoState {
  return { ...createEditor(() => 0).getState(), curve: { ...emptyCurve, contours }, ...others };
}

const states: readonly (readonly [string, DemoState])[] = [
  ["nothing", stateOf([])],
  ["little", stateOf([contour(4)], { "a \"name\"\n": ["é\u2028", null, NaN, -0, 1e21, { a: undefined, b: [] }] })],
  ["one long contour", stateOf([{ ...contour(30_000), omega: Array.from({ length: 30_000 }, (_, i) => i / 7) }])],
  ["thousands of contours", stateOf(Array.from({ length: 5000 }, (_, i) => contour(3 + (i % 5), i)))],
  ["long ones among short ones", stateOf([contour(3), contour(9000), contour(4), contour(5), contour(12_000), contour(9000)])],
  ["lists of lists, and gaps in them", stateOf([], { x: [Array.from({ length: 5000 }, (_, i) => (i % 3 === 0 ? undefined : [i])), [[Array.from({ length: 4001 }, () => [])]], undefined] })],
];

for (const [what, state] of states) {
  test(`a drawing in pieces is the same text, and none of them is long: ${what}`, async () => {
    const pieces = [...statePieces(state)];
    const json = writeState(state);
    assert.ok(pieces.join("") === json);
    // 4,000 values of 20 characters and their names, which is about a millisecond's work.
    assert.ok(Math.max(...pieces.map(({ length }) => length)) < 160_000, "a piece is a small part");
    const head = { session: "own", generation: 7, time: 9 };
    let rests = 0;
    const sealed = await sealPieces(head, pieces, () => ((rests += 1) % 2 === 0 ? null : Promise.resolve()));
    assert.deepEqual(sealed, seal({ ...head, json }));
    assert.equal(rests, pieces.length);
    assert.ok(unseal(sealed)?.json === json);
  });
}
