import assert from "node:assert/strict";
import { test } from "node:test";
import { HermiteCurve } from "expline/slim";
import { createFreehand } from "../src/editor/fit/freehand.ts";
import type { FitClient, FitHandlers } from "../src/kernel/fit/fit-client.ts";
import type { FitStrength, FitSubject } from "../src/kernel/fit/job.ts";
import { createDrawTool } from "../src/tools/draw/draw-tool.ts";
import { createPointerInput } from "../src/editor/pointer/pointer-input.ts";
import { createTools } from "../src/tools/tools.ts";
import { toScreen } from "../src/editor/pointer/camera.ts";
import { Hand } from "./harness.ts";

/** Drawing by hand in Curve, with a fit that answers when it is told to. */
function drawing(): { hand: Hand; asked: { subject: FitSubject; strength: FitStrength }[]; answer(count: number): void; fail(code: string): void; draw(...places: readonly [number, number][]): void } {
  const hand = new Hand("circle-2");
  const { editor } = hand;
  const asked: { subject: FitSubject; strength: FitStrength }[] = [];
  let handlers: FitHandlers | undefined;
  const freehand = createFreehand(editor, (given): FitClient => {
    handlers = given;
    return { fit: (subject, strength) => void asked.push({ subject, strength }), chart: () => undefined, cancel: () => undefined, idle: () => Promise.resolve(), busy: false };
  });
  const input = createPointerInput(editor, createTools(editor, new AbortController().signal, undefined, createDrawTool(editor, freehand)));
  editor.patch({ tool: "draw" });
  let time = 0;
  return {
    hand, asked,
    draw(...places) {
      const record = ([x, y]: readonly [number, number]) => {
        const { view, stage } = editor.state.value;
        time += 16;
        return { id: 1, kind: "mouse" as const, button: 0, screen: toScreen(view, stage, { x, y }), modifiers: { shift: false, alt: false, mod: false }, time };
      };
      const [first, ...rest] = places.map(record);
      assert.ok(first !== undefined);
      input.down(first);
      for (const each of rest) input.move(each);
      input.up(rest.at(-1) ?? first);
    },
    answer(count) {
      const { subject, strength } = asked.at(-1) ?? assert.fail("nothing was asked for");
      assert.ok(handlers !== undefined);
      const points = Array.from({ length: count }, (_, i) => [100 + 50 * i, 500]).flat();
      const curve = new HermiteCurve({ points, tangents: points.map((_, i) => (i % 2 === 0 ? 50 : 0)), closed: false, omega: 0 }).toJSON();
      handlers.fitted([{ curve, parts: [], knots: [], parameters: new Float64Array(0), rms: 0, maxError: 1, lambda: [], gap: 0, status: "converged" }], subject, 5, strength);
    },
    fail(code) {
      handlers?.failed(code, "");
    },
  };
}

const line = (y: number): [number, number][] => Array.from({ length: 20 }, (_, i) => [100 + 10 * i, y]);

test("a stroke becomes a contour beside what is there, as one entry; the line stays until the curve is there", () => {
  const { hand, asked, answer, draw } = drawing();
  draw(...line(500));
  const { state } = hand.editor;
  assert.equal(state.value.curve.contours.length, 1);
  assert.equal(state.value.sketch.stroke.length, 20);
  assert.equal(asked.length, 1);
  // A pixel and a half of the screen, whatever that is in the drawing; a hand that turns by less than half a radian
  // made no corner.
  assert.deepEqual(asked[0]?.strength, { by: "error", tolerance: 1.5 / state.value.view.zoom });
  assert.equal(asked[0]?.subject.corners, 0.5);
  answer(3);
  assert.equal(state.value.sketch.stroke.length, 0);
  assert.equal(state.value.curve.contours.length, 2);
  assert.equal(state.value.curve.contours[1]?.points.length, 3);
  assert.equal(state.value.undoName, "Draw");
  hand.run("undo");
  assert.equal(state.value.curve.contours.length, 1);
});

test("what was drawn last is selected, so that the panel and the keys are about it; with another tool the selection stays", () => {
  const { hand, answer, draw } = drawing();
  draw(...line(500));
  answer(3);
  assert.deepEqual(hand.selected, ["1:0", "1:1", "1:2"]);
  draw(...line(540));
  hand.run("tool-select");
  const kept = hand.click(hand.point(0).x, hand.point(0).y).selected;
  answer(4);
  assert.deepEqual(hand.selected, kept);
});

test("strokes drawn faster than they are fitted wait for each other, and none is lost", () => {
  const { hand, asked, answer, draw } = drawing();
  draw(...line(500));
  draw(...line(540));
  draw(...line(580));
  assert.equal(asked.length, 1);
  for (const [i, count] of [2, 3, 4].entries()) {
    answer(count);
    assert.equal(asked.length, Math.min(3, i + 2));
  }
  assert.deepEqual(hand.curve.contours.map(({ points }) => points.length), [2, 2, 3, 4]);
});

test("a stroke that no engine could fit is not called too short: what went wrong is said, and the next stroke is tried", () => {
  const { hand, asked, fail, draw } = drawing();
  const said: string[] = [];
  hand.editor.notices.subscribe((notice) => notice?.kind === "error" && said.push(notice.text));
  draw(...line(500));
  draw(...line(540));
  fail("E_WORKER");
  assert.doesNotMatch(hand.editor.state.value.hint, /too short/);
  assert.match(said.join(), /^The stroke could not become a curve \(E_WORKER\)/);
  assert.equal(asked.length, 2);
});

test("a curve that comes while a point is dragged is there when the drag is over, whether it was done or cancelled", () => {
  for (const end of ["release", "cancel", "rest"] as const) {
    const { hand, answer, draw } = drawing();
    draw(...line(500));
    hand.run("tool-select");
    const { x, y } = hand.point(0);
    hand.wait().moveTo(x, y).press().moveTo(x + 10, y + 5);
    if (end === "rest") hand.moveTo(x, y);
    assert.ok(hand.editor.inGesture);
    answer(3);
    if (end !== "rest") hand.moveTo(x + 20, y + 10);
    if (end === "cancel") hand.input.cancel();
    else hand.release();
    assert.deepEqual(hand.curve.contours.map(({ points }) => points.length), [2, 3], end);
    assert.equal(hand.point(0).x, end === "release" ? x + 20 : x);
    // Two things were done, and each is taken back by itself.
    hand.run("undo");
    assert.equal(hand.curve.contours.length, 1, end);
  }
});

test("the line that is being drawn stays in sight when the one before has become a curve", () => {
  const { hand, answer, draw } = drawing();
  draw(...line(500));
  draw(...line(540));
  const { stroke } = hand.editor.state.value.sketch;
  answer(3);
  assert.equal(hand.editor.state.value.sketch.stroke, stroke);
  answer(4);
  assert.equal(hand.editor.state.value.sketch.stroke.length, 0);
});

test("a stroke that no curve can be made of is said to be none, and the next one is fitted all the same", () => {
  const { hand, asked, answer, fail, draw } = drawing();
  draw(...line(500));
  draw(...line(540));
  fail("E_DEGENERATE");
  assert.match(hand.editor.state.value.hint, /too short for a curve/);
  assert.equal(asked.length, 2);
  answer(2);
  assert.equal(hand.curve.contours.length, 2);
});

test("a press without a stroke, and one of three places, draw nothing and ask for nothing", () => {
  const { hand, asked, draw } = drawing();
  draw([100, 500]);
  draw([100, 500], [110, 500], [120, 500]);
  assert.equal(asked.length, 0);
  assert.equal(hand.curve.contours.length, 1);
  assert.equal(hand.editor.state.value.sketch.stroke.length, 0);
});
