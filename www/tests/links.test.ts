import assert from "node:assert/strict";
import { test } from "node:test";
import { Problem } from "../src/document/problem.ts";
import { emptyTrace, traceDefaults } from "../src/document/trace/trace.ts";
import { readShareHash, shareLink } from "../src/io/link/share.ts";
import { Hand, longContour } from "./harness.ts";

/** What a link holds of a drawing, and of the modes that are not shown. */

const most = 32 * 1024;

/** A drawing in Curve, and one in Trace of so many points. */
function both(mode: "curve" | "trace", traced: number): ReturnType<Hand["editor"]["getState"]> {
  const state = new Hand("glyph").editor.getState();
  const kept = { name: "logo.png", width: 800, height: 600, contours: [longContour(traced)] };
  return { ...state, mode, trace: { settings: traceDefaults, corners: [], kept } };
}

test("a link holds what is in every mode", async () => {
  const state = both("curve", 40);
  const { hash, alone } = await shareLink(state);
  const { curve, trace } = await readShareHash(hash);
  assert.deepEqual([curve, trace, alone], [state.curve, state.trace, false]);
});

test("where that would be too long it holds what is in the mode that is shown, and says so", async () => {
  const state = both("curve", 2000);
  const { hash, alone } = await shareLink(state);
  const opened = await readShareHash(hash);
  assert.ok(alone && hash.length < most);
  assert.deepEqual([opened.mode, opened.curve, opened.trace], ["curve", state.curve, emptyTrace]);

  const beside = { ...both("trace", 40), curve: { ...state.curve, contours: [longContour(2000)] } };
  const other = await readShareHash((await shareLink(beside)).hash);
  assert.deepEqual([other.mode, other.trace, other.curve.contours], ["trace", beside.trace, []]);
});

test("a drawing that is too long by itself is refused, with its own size and not that of what it would have left out", async () => {
  const long = both("trace", 1500);
  const sizeOf = (state: typeof long): Promise<number> => shareLink(state).then(() => 0, (error: unknown) => (error instanceof Problem && error.id === "share-long" ? (error.details.kilobytes ?? 0) : 0));
  const own = await sizeOf({ ...long, curve: { ...long.curve, contours: [] } });
  assert.ok(own > most / 1024);
  assert.equal(await sizeOf({ ...long, curve: { ...long.curve, contours: [longContour(3000)] } }), own);
});
