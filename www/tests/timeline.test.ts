import assert from "node:assert/strict";
import { test } from "node:test";
import { createTimeline, type Timeline } from "../src/editor/history/timeline.ts";

interface Page {
  readonly text: string;
  readonly caret: number;
}

function timeline(): { edits: Timeline<Page>; page: () => Page; wait: (ms: number) => void } {
  let page: Page = { text: "", caret: 0 };
  let time = 0;
  const edits = createTimeline<Page>({ read: () => page, write: (next) => { page = next; }, same: (a, b) => a.text === b.text, changed: () => undefined, now: () => time });
  return { edits, page: () => page, wait: (ms) => { time += ms; } };
}

const typed = (letter: string) => (page: Page): Page => ({ text: page.text + letter, caret: page.caret + 1 });

test("undo brings back the drawing and what was selected, redo brings both again", () => {
  const { edits, page } = timeline();
  edits.dispatch("A", typed("a"));
  edits.dispatch("B", typed("b"));
  edits.undo();
  assert.deepEqual(page(), { text: "a", caret: 1 });
  assert.deepEqual([edits.past, edits.future], ["A", "B"]);
  edits.redo();
  assert.deepEqual(page(), { text: "ab", caret: 2 });
});

test("a quick run of one kind is one entry, a slow one is not", () => {
  const { edits, page, wait } = timeline();
  edits.dispatch("Type", typed("a"), "type");
  wait(100);
  edits.dispatch("Type", typed("b"), "type");
  wait(1000);
  edits.dispatch("Type", typed("c"), "type");
  edits.undo();
  assert.equal(page().text, "ab");
  edits.undo();
  assert.equal(page().text, "");
});

test("a gesture is one entry from its start, and undo during it takes back the gesture alone", () => {
  const { edits, page } = timeline();
  edits.dispatch("A", typed("a"));
  edits.begin("Drag");
  edits.preview(typed("x"));
  edits.preview(typed("y"));
  assert.equal(page().text, "ay");
  edits.undo();
  assert.equal(page().text, "a");
  edits.begin("Drag");
  edits.preview(typed("z"));
  edits.commit();
  assert.equal(edits.past, "Drag");
  edits.undo();
  assert.equal(page().text, "a");
});

test("what is left of a gesture that was taken back does nothing and leaves no entry", () => {
  const { edits, page } = timeline();
  edits.dispatch("A", typed("a"));
  edits.begin("Drag");
  edits.preview(typed("x"));
  edits.undo();
  edits.preview(typed("y"));
  edits.commit();
  assert.equal(page().text, "a");
  assert.deepEqual([edits.past, edits.future], ["A", null]);
});

test("a gesture that changed nothing leaves no entry", () => {
  const { edits } = timeline();
  edits.begin("Drag");
  edits.commit();
  assert.equal(edits.past, null);
});
