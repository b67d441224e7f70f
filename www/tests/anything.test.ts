import assert from "node:assert/strict";
import { test } from "node:test";
import { parseState, writeState } from "../src/document/file/file.ts";
import type { Modifiers, ToolId } from "../src/editor/editor.ts";
import { Hand } from "./harness.ts";

/**
 * Whatever is done in whatever order, undo brings back the start and redo the end. Each seed is a sequence of its own,
 * the same every time.
 */

/** Numbers in [0, 1) that look like chance, by a linear congruence of full period. */
function chance(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Drawing is fitted by a worker: its test is another. */
const tools: readonly ToolId[] = ["select", "select", "select", "pen"];
const endings = ["release", "release", "release", "escape", "undo", "lost"] as const;
/** They end or begin a history, or show another mode's. */
const outside = /^(?:undo|redo|mode-|simplify|tool-draw)/u;

class Monkey {
  readonly hand: Hand;
  readonly #next: () => number;

  constructor(sample: string, seed: number) {
    this.hand = new Hand(sample);
    this.#next = chance(seed);
    for (let i = 0; i < 8; i += 1) this.#next();
  }

  #of<T>(list: readonly T[]): T {
    const one = list[Math.floor(this.#next() * list.length)];
    assert.ok(one !== undefined);
    return one;
  }

  #between(from: number, to: number): number {
    return from + (to - from) * this.#next();
  }

  /** On a point or a handle, or anywhere. */
  #place(): { x: number; y: number } {
    const { contours } = this.hand.curve;
    if (contours.length === 0 || this.#next() < 0.3) return { x: this.#between(100, 700), y: this.#between(50, 550) };
    const { x, y, out } = this.#of(this.#of(contours).points);
    return this.#next() < 0.7 ? { x, y } : { x: x + out.dx, y: y + out.dy };
  }

  /** What is there after a drag that was not let go is what was there before; the pen's Escape finishes a path. */
  #drag(): void {
    const { hand } = this;
    const held: Partial<Modifiers> = { shift: this.#next() < 0.2, alt: this.#next() < 0.2, mod: this.#next() < 0.2 };
    const [from, ending] = [this.#place(), this.#of(endings)];
    const [before, { tool }] = [hand.curve, hand.editor.state.value];
    hand.wait().keys(held).moveTo(from.x, from.y).press();
    for (let i = 0; i < 3; i += 1) hand.moveTo(from.x + this.#between(-200, 200), from.y + this.#between(-150, 150));
    if (this.#next() < 0.3) hand.keys({ shift: true });
    if (ending === "release") hand.release();
    else if (ending === "lost") hand.input.lost(1);
    else hand.input.cancel();
    hand.keys({});
    if (ending !== "release" && tool === "select") assert.equal(hand.curve, before, ending);
  }

  async step(): Promise<string> {
    const { editor } = this.hand;
    const kind = this.#next();
    let name = "drag";
    if (kind < 0.4) this.#drag();
    else if (kind < 0.5) {
      const { x, y } = this.#place();
      this.hand.doubleClick(x, y);
      name = "double-click";
    } else if (kind < 0.6) editor.patch({ tool: this.#of(tools) });
    else {
      name = this.#of(editor.actions.all().filter(({ id, enabled }) => !outside.test(id) && enabled?.(editor.state.value) !== false)).id;
      this.hand.wait().run(name);
    }
    while (editor.loading.size > 0) await Promise.allSettled(editor.loading);
    return name;
  }
}

for (const sample of ["circle-8", "heart", "blob-16", "cycloid", "glyph"]) {
  test(`whatever is done to ${sample}, undo brings back the start, redo every state since, and files hold it`, async () => {
    for (let seed = 1; seed <= 12; seed += 1) {
      const monkey = new Monkey(sample, seed);
      const { editor } = monkey.hand;
      const start = monkey.hand.curve;
      const done: string[] = [];
      for (let i = 0; i < 60; i += 1) {
        done.push(await monkey.step());
        // Points double with a level, and copies with each copy.
        if (monkey.hand.curve.contours.reduce((sum, { points }) => sum + points.length, 0) > 300) break;
      }
      const told = `${sample}, seed ${seed}: ${done.join(", ")}`;
      const end = editor.getState();
      assert.deepEqual(parseState(writeState(end)).state.curve, JSON.parse(JSON.stringify(end.curve)), told);
      // A pen that is still in the hand has steps of its own.
      monkey.hand.input.finish();
      monkey.hand.input.cancel();
      const last = monkey.hand.curve;
      const back = [last];
      while (editor.state.value.canUndo) {
        editor.undo();
        back.push(monkey.hand.curve);
      }
      assert.equal(back.at(-1), start, told);
      for (const state of back.reverse().slice(1)) {
        editor.redo();
        assert.equal(monkey.hand.curve, state, told);
      }
      assert.equal(editor.state.value.canRedo, false, told);
    }
  });
}
