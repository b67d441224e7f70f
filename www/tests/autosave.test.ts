import assert from "node:assert/strict";
import { test } from "node:test";
import { createEditor } from "../src/editor/create-editor.ts";
import { createAutosave } from "../src/io/keeping/autosave.ts";
import { unseal } from "../src/io/keeping/sealed.ts";

/** When a drawing is kept, in a browser without a database. */

const texts = new Map<string, string>();
const localStorage = {
  get length(): number {
    return texts.size;
  },
  key: (i: number): string | null => [...texts.keys()][i] ?? null,
  getItem: (key: string): string | null => texts.get(key) ?? null,
  setItem: (key: string, text: string): void => void texts.set(key, text),
  removeItem: (key: string): void => void texts.delete(key),
};
const heard = { addEventListener: (): void => undefined };
Object.assign(globalThis, { window: { localStorage, ...heard }, document: heard });

test("the first change is kept at once, and those after it within a second, together; what is half done waits", async (t) => {
  const asked: number[] = [];
  const real = globalThis.setTimeout;
  t.mock.method(globalThis, "setTimeout", (run: () => void, ms = 0) => {
    // Longer is how long the database is waited for.
    if (ms <= 1000) asked.push(ms);
    return real(run, ms === 1000 ? 10 : ms);
  });
  let isHalfDone = true;
  t.after(() => (isHalfDone = false));
  const autosave = createAutosave("own", {
    read: () => createEditor(() => 0).getState(), busy: () => isHalfDone, abandon: () => undefined, failing: () => undefined, until: new AbortController().signal,
  });
  const generations = (): number[] => [...texts].map(([key, text]) => unseal({ key, text })?.generation ?? 0).sort();
  const kept = async (wanted: number[]): Promise<void> => {
    for (let i = 0; i < 1000 && generations().join() !== wanted.join(); i += 1) await new Promise((go) => real(go, 5));
    assert.deepEqual(generations(), wanted);
  };
  autosave.touch();
  assert.deepEqual(asked, [1000], "a drag is looked at again in a second");
  isHalfDone = false;
  await kept([1]);
  asked.length = 0;
  autosave.touch();
  autosave.touch();
  await kept([1, 2]);
  assert.equal(asked.filter((ms) => ms === 1000).length, 1);

  const fresh = createAutosave("other", {
    read: () => createEditor(() => 0).getState(), busy: () => false, abandon: () => undefined, failing: () => undefined, until: new AbortController().signal,
  });
  asked.length = 0;
  fresh.touch();
  assert.deepEqual(asked, [0]);
  await kept([1, 1, 2]);
});
