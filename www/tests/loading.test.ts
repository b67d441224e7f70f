import assert from "node:assert/strict";
import { test } from "node:test";
import { createEditor } from "../src/editor/create-editor.ts";
import type { Editor, Notice } from "../src/editor/editor.ts";
import { late, onDemand, whenLoaded } from "../src/editor/loading.ts";

/** What is said of parts of the page that do not come, and how long it stands. */

/** An editor, and the message about missing parts that a user of it would see. */
function listening(): { editor: Editor; standing: () => string | null } {
  const editor = createEditor(() => 0);
  let text: string | null = null;
  editor.notices.subscribe((notice: Notice | null) => {
    if (notice?.kind === "error" && notice.id === "part-missing") text = notice.text;
    if (notice?.kind === "well" && (notice.of === undefined || notice.of === "part-missing")) text = null;
  });
  return { editor, standing: () => text };
}

const lost = (): Promise<never> => Promise.reject(new Error("no network"));

/** Something on its way, and how it comes. */
function onItsWay<T>(): { promise: Promise<T>; come: (it: T) => void } {
  let come: (it: T) => void = () => undefined;
  const promise = new Promise<T>((resolve) => (come = resolve));
  return { promise, come };
}

/** Everything that is on its way has come, or has not. */
async function settled(editor: Editor): Promise<void> {
  while (editor.loading.size > 0) await Promise.allSettled(editor.loading);
}

test("what did not come is said, and no more once what was asked for after it came", async () => {
  const { editor, standing } = listening();
  whenLoaded(editor, lost(), () => assert.fail("nothing came"));
  await settled(editor);
  assert.match(standing() ?? "", /could not be loaded \(no network\)/);
  whenLoaded(editor, Promise.resolve(1), () => undefined);
  await settled(editor);
  assert.equal(standing(), null);
});

test("what was on its way already says nothing of what did not come, however late it is", async () => {
  const { editor, standing } = listening();
  const { promise, come } = onItsWay<number>();
  let came = 0;
  whenLoaded(editor, promise, (it) => (came = it));
  whenLoaded(editor, lost(), () => undefined);
  await new Promise((done) => setTimeout(done));
  assert.ok(standing());
  come(7);
  await settled(editor);
  assert.equal(came, 7);
  assert.ok(standing(), "the message stands");
});

test("of two things that do not come the second is said when the first is asked for in vain again", async () => {
  const { editor, standing } = listening();
  whenLoaded(editor, Promise.reject(new Error("first")), () => undefined);
  await settled(editor);
  const again = onItsWay<number>();
  whenLoaded(editor, again.promise, () => undefined);
  whenLoaded(editor, Promise.reject(new Error("second")), () => undefined);
  await new Promise((done) => setTimeout(done));
  again.come(1);
  await settled(editor);
  assert.match(standing() ?? "", /second/, "what came was asked for before that was said");
});

test("work and parts that come when they are wanted take back what was said before", async () => {
  const { editor, standing } = listening();
  let isThere = false;
  const work = onDemand(() => (isThere ? Promise.resolve(3) : lost()));
  work(editor, () => undefined);
  await settled(editor);
  assert.ok(standing());
  isThere = true;
  work(editor, () => undefined);
  await settled(editor);
  assert.equal(standing(), null);

  whenLoaded(editor, lost(), () => undefined);
  await settled(editor);
  assert.ok(standing());
  const part = late(editor, () => true, () => Promise.resolve("a part"));
  await settled(editor);
  assert.deepEqual([part(), standing()], ["a part", null]);
});
