import assert from "node:assert/strict";
import { test } from "node:test";
import { createEditor } from "../src/editor/create-editor.ts";
import { createFrame } from "../src/editor/frame.ts";
import { late, lazyTool, onDemand } from "../src/editor/loading.ts";
import { createSignal } from "../src/editor/signal.ts";
import type { PointerSample, Tool } from "../src/editor/tool.ts";

/** What the page runs on: values, frames, and parts that come later. */

test("a value that a listener sets in turn comes after the one it heard of, for everybody", () => {
  const signal = createSignal(0);
  const [first, second]: number[][] = [[], []];
  signal.subscribe((value) => {
    first?.push(value);
    if (value === 1) signal.set(2);
  });
  signal.subscribe((value, before) => {
    second?.push(before, value);
    assert.equal(signal.value, 2, "what is read is the newest");
  });
  signal.set(1);
  assert.deepEqual([first, second], [[1, 2], [0, 1, 1, 2]]);
});

test("a listener that throws is heard of, and the next value is told as ever", () => {
  const signal = createSignal(0);
  const heard: number[] = [];
  signal.subscribe((value) => {
    if (value === 1) throw new Error("a fault");
    heard.push(value);
  });
  assert.throws(() => signal.set(1), /a fault/);
  signal.set(2);
  assert.deepEqual(heard, [2]);
});

test("a task that throws stops neither the other tasks nor the frames to come, and those who wait are told", async () => {
  const due: (() => void)[] = [];
  const faults: unknown[] = [];
  const frame = createFrame((callback) => due.push(callback), () => 0, (error) => faults.push(error));
  let painted = 0;
  for (const phase of ["input", "paint"] as const) frame.add(phase, () => {
    throw new Error(phase);
  });
  frame.add("paint", () => (painted += 1));
  for (let i = 1; i <= 2; i += 1) {
    frame.request();
    const idle = frame.idle();
    due.shift()?.();
    await idle;
    assert.equal(painted, i);
  }
  assert.deepEqual(faults.map(String), ["Error: input", "Error: paint", "Error: input", "Error: paint"]);
});

/** A loader that fails as often as it is told to. */
function failing<T>(times: number, loaded: T): { load: () => Promise<T>; asked: () => number } {
  let asked = 0;
  const load = (): Promise<T> => {
    asked += 1;
    return asked <= times ? Promise.reject(new Error("no connection")) : Promise.resolve(loaded);
  };
  return { load, asked: () => asked };
}

const turn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

test("a part of the page that did not come is said to be missing, and asked for again when it is wanted anew", async () => {
  const editor = createEditor(() => 0);
  const said: string[] = [];
  editor.notices.subscribe((notice) => notice?.kind === "error" && said.push(notice.text));
  const { load, asked } = failing(1, "pen");
  const there = late(editor, ({ tool }) => tool === "pen", load);
  editor.patch({ tool: "pen" });
  await turn();
  editor.patch({ hint: "" });
  assert.deepEqual([asked(), there(), said.length], [1, null, 1], "not with every change");
  assert.match(said[0] ?? "", /could not be loaded \(no connection\)/);
  editor.patch({ tool: "select" });
  editor.patch({ tool: "pen" });
  await turn();
  assert.deepEqual([asked(), there(), said.length], [2, "pen", 1]);
  const more = failing(1, "work");
  const work = onDemand(more.load);
  const done: string[] = [];
  for (let i = 0; i < 2; i += 1) {
    work(editor, (loaded) => done.push(loaded));
    await turn();
  }
  assert.deepEqual([done, said.length], [["work"], 2]);
});

test("that something did not come is said no more once something does", async () => {
  const editor = createEditor(() => 0);
  const said: string[] = [];
  editor.notices.subscribe((notice) => notice !== null && said.push(notice.kind));
  const work = onDemand(failing(1, "work").load);
  for (let i = 0; i < 3; i += 1) {
    work(editor, () => undefined);
    await turn();
  }
  const wanted = failing(1, "pen");
  late(editor, ({ tool }) => tool === "pen", wanted.load);
  for (const tool of ["pen", "select", "pen"] as const) {
    editor.patch({ tool });
    await turn();
  }
  assert.deepEqual(said, ["error", "well", "error", "well"], "and not of what always came");
});

test("what was done with a tool that never came is not done when it comes later", async () => {
  const editor = createEditor(() => 0);
  const done: string[] = [];
  const said = (name: string) => (): boolean => done.push(name) > 0;
  const pen: Tool = { hover: said("hover"), press: said("press"), drag: said("drag"), release: said("release"), cancel: () => false, finish: () => false };
  const tool = lazyTool(editor, () => editor.state.value.tool === "pen", failing(1, pen).load);
  const at = { screen: { x: 1, y: 1 } } as PointerSample;
  editor.patch({ tool: "pen" });
  tool.press(at);
  await turn();
  tool.release(at);
  editor.patch({ tool: "select" });
  editor.patch({ tool: "pen" });
  tool.hover(at);
  tool.hover(at);
  tool.press(at);
  await turn();
  tool.release(at);
  assert.deepEqual(done, ["hover", "press", "release"], "of two places passed by the last one");
});
