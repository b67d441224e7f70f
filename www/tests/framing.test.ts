import assert from "node:assert/strict";
import { test } from "node:test";
import { gripsOf } from "../src/editor/curve/framing.ts";
import type { Grip } from "../src/editor/state.ts";
import { hintFor } from "../src/editor/hint.ts";
import { toPage } from "../src/editor/pointer/camera.ts";
import { translated } from "../src/document/curve/contours.ts";
import { Hand, contoursOfPath, handOf, largestDistance } from "./harness.ts";

/** The frame around whole contours. The oracle is the map itself: the curve's own samples, mapped one by one. */

type Place = readonly [number, number];

function gripAt(hand: Hand, grip: Grip): { x: number; y: number } {
  const { value } = hand.editor.state;
  const found = gripsOf(value).find((each) => each.grip === grip);
  assert.ok(found !== undefined, `no grip ${grip}`);
  return toPage(value.view, value.stage, found);
}

function mapped(samples: Float64Array, map: (x: number, y: number) => Place): Float64Array {
  return samples.map((_, i) => map(samples[i - (i % 2)] ?? 0, samples[i - (i % 2) + 1] ?? 0)[i % 2] ?? 0);
}

function around(samples: Float64Array): { minX: number; minY: number } {
  return { minX: Math.min(...samples.filter((_, i) => i % 2 === 0)), minY: Math.min(...samples.filter((_, i) => i % 2 === 1)) };
}

const turned = (degrees: number, [cx, cy]: Place) => (x: number, y: number): Place => {
  const [cos, sin] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return [cx + cos * (x - cx) - sin * (y - cy), cy + sin * (x - cx) + cos * (y - cy)];
};

/** What keys and grips need comes when it is first wanted. */
async function loaded(hand: Hand): Promise<Hand> {
  await Promise.all(hand.editor.loading);
  return hand;
}

test("the frame is there when contours are chosen as a whole, and only with the tool that edits", async () => {
  const hand = new Hand("heart");
  assert.deepEqual(gripsOf(hand.editor.state.value), []);
  hand.run("select-all");
  assert.equal(gripsOf(hand.editor.state.value).length, 9);
  hand.run("tool-pen");
  assert.deepEqual(gripsOf(hand.editor.state.value), []);
  hand.run("tool-select");
  hand.click(hand.point(1).x, hand.point(1).y);
  assert.deepEqual(gripsOf(hand.editor.state.value), [], "one point of six");
  await loaded(hand.run("select-contour"));
  assert.equal(hand.editor.state.value.selection.points.length, 6);
  assert.equal(gripsOf(hand.editor.state.value).length, 9);
});

for (const sample of ["circle-2", "heart", "cycloid", "hyperbola", "glyph", "blob-16"] as const) {
  test(`a grip stretches every place of the curve alike, whatever the curve is made of: ${sample}`, async () => {
    const hand = new Hand(sample).run("select-all");
    await loaded(hand);
    const before = hand.sample(500);
    const xs = before.filter((_, i) => i % 2 === 0);
    const [left, right] = [Math.min(...xs), Math.max(...xs)];
    hand.keys({ mod: true }).drag(gripAt(hand, "e"), 60, 35).keys({});
    const after = hand.sample(500);
    const factor = ((after[100] ?? 0) - (after[0] ?? 0)) / ((before[100] ?? 0) - (before[0] ?? 0));
    // 500 places miss the outermost ones by a little.
    assert.ok(Math.abs(factor - (1 + 60 / (right - left))) < 0.01, `${factor}`);
    const fixed = ((after[0] ?? 0) - factor * (before[0] ?? 0)) / (1 - factor);
    assert.ok(Math.abs(fixed - left) < 2, "the other side stays");
    assert.ok(largestDistance(after, mapped(before, (x, y) => [fixed + factor * (x - fixed), y])) < 1e-9);
    hand.run("undo");
    assert.equal(largestDistance(hand.sample(500), before), 0);
  });

  test(`the curve turns as one, and a flip twice is none: ${sample}`, async () => {
    const hand = new Hand(sample).run("select-all");
    await loaded(hand);
    const before = hand.sample(500);
    const knob = gripAt(hand, "turn");
    const middle: Place = [knob.x, (gripAt(hand, "nw").y + gripAt(hand, "se").y) / 2];
    const [x, y] = turned(33, middle)(knob.x, knob.y);
    // To a step of 15°: a drag of 33° ends at 30°.
    hand.keys({ shift: true }).drag(knob, x - knob.x, y - knob.y).keys({});
    assert.ok(largestDistance(hand.sample(500), mapped(before, turned(30, middle))) < 1e-9);
    await loaded(hand.run("undo").run("flip-across"));
    assert.ok(largestDistance(hand.sample(500), mapped(before, (u, v) => [2 * middle[0] - u, v])) < 1e-9);
    await loaded(hand.run("flip-across"));
    assert.ok(largestDistance(hand.sample(500), before) < 1e-9);
  });
}

test("Shift keeps the proportions, Alt the middle, and both count at once on the way", async () => {
  const hand = new Hand("heart").run("select-all");
  await loaded(hand);
  const before = hand.sample(400);
  const grip = gripAt(hand, "se");
  const size = (samples: Float64Array, axis: 0 | 1): number => {
    const list = samples.filter((_, i) => i % 2 === axis);
    return Math.max(...list) - Math.min(...list);
  };
  const middle = (samples: Float64Array): number => (Math.max(...samples.filter((_, i) => i % 2 === 0)) + Math.min(...samples.filter((_, i) => i % 2 === 0))) / 2;
  hand.wait().moveTo(grip.x, grip.y).press().keys({ mod: true }).moveTo(grip.x + 80, grip.y + 10);
  const free = hand.sample(400);
  assert.ok(Math.abs(size(free, 0) / size(before, 0) - size(free, 1) / size(before, 1)) > 0.1);
  hand.keys({ mod: true, shift: true });
  const even = hand.sample(400);
  assert.ok(Math.abs(size(even, 0) / size(before, 0) - size(even, 1) / size(before, 1)) < 1e-9);
  hand.keys({ mod: true, alt: true });
  assert.ok(Math.abs(middle(hand.sample(400)) - middle(before)) < 1e-9);
  hand.release().keys({});
  assert.equal(hand.editor.state.value.undoName, "Stretch");
});

test("a drawing cannot be pressed flat: what was stretched can be stretched again", async () => {
  const hand = new Hand("heart").run("select-all");
  await loaded(hand);
  const [east, west] = [gripAt(hand, "e"), gripAt(hand, "w")];
  // To the very place that stays: the grips stand sixteen off on either side.
  hand.keys({ mod: true }).drag(east, west.x + 32 - east.x, 0).keys({});
  const xs = hand.sample(200).filter((_, i) => i % 2 === 0);
  assert.ok(Math.max(...xs) - Math.min(...xs) > 0.1);
});

test("four turns by keys are one entry of the history, and one point alone turns its handles", async () => {
  const hand = new Hand("heart").run("select-all");
  await loaded(hand);
  const before = hand.sample(300);
  for (let i = 0; i < 4; i += 1) hand.editor.actions.run("turn-right");
  for (let i = 0; i < 4; i += 1) hand.editor.actions.run("turn-left");
  await loaded(hand);
  assert.ok(largestDistance(hand.sample(300), before) < 1e-9);
  hand.run("undo");
  assert.equal(hand.editor.state.value.canUndo, false);
  hand.click(hand.point(1).x, hand.point(1).y).run("flip-down").run("turn-right");
  await loaded(hand);
  const { out, x, y } = hand.point(1);
  assert.deepEqual([x, y], [476, 160]);
  assert.ok(Math.abs(Math.atan2(out.dy, out.dx) - Math.PI / 12) < 1e-12);
});

test("what is chosen beside whole contours goes along, and nothing else moves", async () => {
  const hand = new Hand("heart").run("select-all").run("duplicate");
  const whole = hand.editor.state.value.selection.points;
  assert.ok(whole.length === 6 && whole.every(({ contour }) => contour === 1));
  const before = hand.curve.contours;
  const points = [...whole, { contour: 0, index: 2 }];
  hand.editor.patch({ selection: { points, handle: null } });
  await loaded(hand.run("flip-across"));
  const xs = points.map(({ contour, index }) => before[contour]?.points[index]?.x ?? NaN);
  const sum = Math.min(...xs) + Math.max(...xs);
  before.forEach((contour, c) => contour.points.forEach((point, index) => {
    const now = hand.point(index, c);
    if (!points.some((ref) => ref.contour === c && ref.index === index)) return assert.deepEqual(now, point);
    assert.ok(Math.abs(now.x - (sum - point.x)) < 1e-9 && now.y === point.y && Math.abs(now.out.dx + point.out.dx) < 1e-9, `point ${c}-${index}`);
  }));
});

/** A disc and a square on its right, by the path they are; the disc is chosen, and so the frame is around it. */
async function discChosen(): Promise<Hand> {
  const hand = handOf(contoursOfPath("M400 300A100 100 0 0 1 200 300A100 100 0 0 1 400 300ZM500 250H600V350H500Z"));
  hand.doubleClick(300, 300);
  await loaded(hand);
  assert.deepEqual([...new Set(hand.selected.map((ref) => ref[0]))], ["0"]);
  return hand;
}

test("what is chosen moves when it is dragged by its inside, as one step of the history, and nothing else does", async () => {
  const hand = await discChosen();
  const [disc, square] = [hand.sample(200), hand.sample(200, 1)];
  hand.drag({ x: 300, y: 340 }, 37, -21);
  assert.ok(largestDistance(hand.sample(200), mapped(disc, (x, y) => [x + 37, y - 21])) < 1e-9);
  assert.equal(largestDistance(hand.sample(200, 1), square), 0);
  assert.equal(hand.editor.state.value.undoName, "Move contours");
  hand.run("undo");
  assert.equal(largestDistance(hand.sample(200), disc), 0);
});

test("a drag that begins beside what is chosen selects, also inside of something else; a click inside chooses nothing", async () => {
  const hand = await discChosen();
  const before = hand.curve;
  hand.drag({ x: 550, y: 300 }, 70, 70);
  assert.deepEqual(hand.selected, ["1:2"], "the square's corner");
  hand.doubleClick(300, 300);
  await loaded(hand);
  hand.drag({ x: 210, y: 210 }, 20, 20);
  assert.deepEqual(hand.selected, [], "in the frame's corner");
  hand.doubleClick(300, 300);
  await loaded(hand);
  hand.click(300, 320);
  assert.deepEqual(hand.selected, []);
  assert.equal(hand.curve, before);
});

test("of all that is chosen, a double-click inside one shape leaves that one", async () => {
  const hand = await discChosen();
  await loaded(hand.run("select-all"));
  hand.doubleClick(550, 300);
  await loaded(hand);
  assert.deepEqual(hand.selected, ["1:0", "1:1", "1:2", "1:3"]);
});

test("a mark of another colour lies on what is chosen: a drag that begins on it does not move what is below", async () => {
  const hand = await discChosen();
  const [disc, square] = hand.curve.contours;
  assert.ok(disc !== undefined && square !== undefined);
  const mark = { ...translated(square, -250, 0), ink: "#b71c1c" };
  const marked = handOf([{ ...disc, ink: "#204080" }, mark]);
  marked.editor.patch({ selection: { points: disc.points.map((_, index) => ({ contour: 0, index })), handle: null } });
  await loaded(marked);
  const before = marked.curve;
  marked.drag({ x: 300, y: 300 }, 30, 0);
  assert.equal(marked.curve, before);
});

test("Alt drags copies of what is chosen, Shift keeps it level, and both count at once on the way", async () => {
  const hand = await discChosen();
  const disc = hand.sample(200);
  hand.wait().moveTo(300, 300).press().moveTo(340, 330);
  assert.equal(hand.editor.state.value.cursor, "move");
  hand.keys({ shift: true });
  assert.ok(largestDistance(hand.sample(200), mapped(disc, (x, y) => [x + 35, y + 35])) < 1e-9, "45°");
  hand.keys({ alt: true });
  assert.equal(hand.editor.state.value.cursor, "copy");
  assert.equal(largestDistance(hand.sample(200), disc), 0, "the disc is where it was");
  assert.ok(largestDistance(hand.sample(200, 2), mapped(disc, (x, y) => [x + 40, y + 30])) < 1e-9);
  hand.keys({});
  assert.equal(hand.curve.contours.length, 2);
  hand.keys({ alt: true }).release().keys({});
  assert.equal(hand.curve.contours.length, 3);
  assert.deepEqual([...new Set(hand.selected.map((ref) => ref[0]))], ["2"], "the copy is chosen");
  assert.equal(hand.editor.state.value.undoName, "Duplicate");
  hand.run("undo");
  assert.equal(hand.curve.contours.length, 2);
});

test("what is moved snaps by the corners and the middle of its box", async () => {
  for (const [from, to, by] of [["its left edge", 503, 500 - 200], ["its middle", 498, 500 - 300], ["its right edge", 497, 500 - 400]] as const) {
    const hand = await discChosen();
    const step = by + to - 500;
    hand.editor.setSettings({ snap: true });
    // High above the square, so that it is in line with it in no other way.
    hand.drag({ x: 300, y: 300 }, step, -217);
    const box = around(hand.sample(4000));
    assert.ok(Math.abs(box.minX - (200 + by)) < 1e-9 && Math.abs(box.minY - (200 - 217)) < 1e-4, `${from}: ${JSON.stringify(box)}`);
  }
});

test("a finger drags what is chosen by its inside, and pans beside it, as the hint says", async () => {
  const hand = await discChosen();
  hand.kind = "touch";
  hand.editor.patch({ touch: true, hover: { kind: "empty" }, hint: "" });
  assert.match(hintFor(hand.editor.state.value), /^Drag inside a selected shape to move it\. Drag elsewhere to move the view/u);
  hand.drag({ x: 300, y: 340 }, 30, 0);
  assert.equal(hand.point(0).x, 430);
  const { view } = hand.editor.state.value;
  hand.drag({ x: 100, y: 100 }, 30, 0);
  assert.equal(hand.point(0).x, 430);
  assert.notEqual(hand.editor.state.value.view.x, view.x);
});
