import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { letGo, takeUp } from "../src/io/keeping/database.ts";
import { allKept, keep } from "../src/io/keeping/keeping.ts";
import { seal } from "../src/io/keeping/seal.ts";

/** A database that another page, which the browser has frozen, keeps from answering. */

const local = new Map<string, string>();
const storage = {
  get length() { return local.size; },
  key: (i: number) => [...local.keys()][i] ?? null,
  getItem: (key: string) => local.get(key) ?? null,
  setItem: (key: string, text: string) => void local.set(key, text),
  removeItem: (key: string) => void local.delete(key),
};

interface Transaction {
  aborted: boolean;
  onabort?: () => void;
  oncomplete?: () => void;
  abort(): void;
  objectStore(): object;
}

const texts = new Map<string, string>();
const begun: Transaction[] = [];
/** Whether what was begun ends. */
let answering = false;
let opens = false;

function transaction(): Transaction {
  const request = (result: unknown): object => ({ result });
  const made: Transaction = {
    aborted: false,
    abort() {
      made.aborted = true;
      queueMicrotask(() => made.onabort?.());
    },
    objectStore: () => ({
      put: (text: string, key: string) => texts.set(key, text),
      get: (key: string) => request(texts.get(key)),
      getAll: () => request([...texts.values()]),
      getAllKeys: () => request([...texts.keys()]),
    }),
  };
  if (answering) queueMicrotask(() => queueMicrotask(() => made.oncomplete?.()));
  begun.push(made);
  return made;
}

const settled = async (): Promise<void> => {
  for (let i = 0; i < 50; i++) await Promise.resolve();
};

const host = globalThis as { window?: unknown; indexedDB?: unknown };
before(() => {
  const open = (): object => {
    const request: { result: object; onsuccess?: () => void } = { result: { transaction } };
    if (opens) queueMicrotask(() => request.onsuccess?.());
    return request;
  };
  Object.assign(host, { window: { localStorage: storage }, indexedDB: { open } });
});
after(() => {
  delete host.window;
  delete host.indexedDB;
});

const work = (generation: number): { key: string; text: string } => seal({ session: "own", generation, time: generation, json: "{}" });

for (const what of ["cannot be opened", "does not end what was begun"]) {
  test(`a database that ${what} is waited for a while: work is kept in the local store, and the page opens without the last session`, async (t) => {
    t.mock.timers.enable({ apis: ["setTimeout"] });
    [opens, answering] = [what !== "cannot be opened", false];
    const [kept, all] = [keep(work(1)), allKept()];
    await settled();
    assert.equal(local.size, 0, "not yet given up");
    t.mock.timers.tick(10_000);
    await settled();
    assert.equal(await kept, true);
    assert.deepEqual(await all, []);
    assert.equal(local.get(work(1).key), work(1).text);
    assert.ok(begun.every(({ aborted }) => aborted), "what was begun is not left behind");
    local.clear();
  });
}

test("a page that is left holds nothing of the database, and begins nothing there before it is back", async () => {
  [opens, answering] = [true, false];
  begun.length = 0;
  const write = keep(work(2));
  await settled();
  assert.deepEqual(begun.map(({ aborted }) => aborted), [false], "a write is under way");
  letGo();
  assert.equal(await write, true);
  assert.deepEqual(begun.map(({ aborted }) => aborted), [true]);
  assert.equal(local.get(work(2).key), work(2).text);
  assert.equal(await keep(work(3)), true);
  assert.equal(begun.length, 1);
  assert.equal(local.get(work(3).key), work(3).text);

  takeUp();
  answering = true;
  assert.equal(await keep(work(4)), true);
  assert.equal(texts.get(work(4).key), work(4).text);
  assert.ok(!local.has(work(4).key));
});
