import assert from "node:assert/strict";
import { test } from "node:test";
import { translated } from "../src/document/curve/contours.ts";
import { curveSample } from "../src/document/curve/samples.ts";
import type { Contour } from "../src/document/document.ts";
import { degreesOf } from "../src/editor/curve/edits.ts";
import { measuresOf, setMeasure, type Measure } from "../src/editor/curve/sizing.ts";
import { Hand, handOf, largestDistance } from "./harness.ts";

/** Place and size of a selection in numbers. The oracle is what is known of circles: radius 160 around (400, 300). */

const measures = (hand: Hand): Readonly<Record<Measure, number | null>> => measuresOf(hand.editor.state.value);

function near(actual: Readonly<Record<Measure, number | null>>, ...[x, y, width, height]: (number | null)[]): void {
  for (const [name, expected] of Object.entries({ x, y, width, height })) {
    const found = actual[name as Measure];
    if (expected === null || expected === undefined || found === null) assert.equal(found, expected, name);
    else assert.ok(Math.abs(found - expected) < 1e-9, `${name}: ${found} is not ${expected}`);
  }
}

function twoCircles(): Contour[] {
  const circle = curveSample("circle-8")?.curve.contours[0];
  assert.ok(circle !== undefined);
  return [circle, translated(circle, 500, 40)];
}

test("whole contours are as large as their curves, not as their points, and go where the numbers say", () => {
  // The two points of this circle lie on one line: only the curve has a height.
  const hand = new Hand("circle-2").run("select-all");
  near(measures(hand), 240, 140, 320, 320);
  const before = hand.sample(400);
  setMeasure(hand.editor, "x", 100);
  setMeasure(hand.editor, "y", -20.5);
  near(measures(hand), 100, -20.5, 320, 320);
  assert.ok(largestDistance(hand.sample(400), before.map((value, i) => value - (i % 2 === 0 ? 140 : 160.5))) < 1e-9, "it moves as it is");
});

test("a typed width scales from the left edge, a typed height from the top, exactly and each by itself", () => {
  const hand = new Hand("circle-2").run("select-all");
  setMeasure(hand.editor, "width", 500);
  near(measures(hand), 240, 140, 500, 320);
  setMeasure(hand.editor, "height", 80);
  near(measures(hand), 240, 140, 500, 80);
  const samples = hand.sample(400);
  for (let i = 0; i < samples.length; i += 2) {
    const [u, v] = [((samples[i] ?? 0) - 490) / 250, ((samples[i + 1] ?? 0) - 180) / 40];
    assert.ok(Math.abs(Math.hypot(u, v) - 1) < 1e-9, "an exact ellipse");
  }
});

test("several contours keep their places to each other", () => {
  const hand = handOf(twoCircles()).run("select-all");
  near(measures(hand), 240, 140, 820, 360);
  setMeasure(hand.editor, "width", 410);
  near(measures(hand), 240, 140, 410, 360);
  const [left] = hand.sample(8, 1);
  assert.ok(left !== undefined && Math.abs(left - (240 + 0.5 * (1060 - 240))) < 1e-9, "the second one's rightmost point is the box's right");
});

test("some points of a contour have the box of these points; the others stay", () => {
  const hand = handOf(twoCircles());
  hand.editor.patch({ selection: { points: [{ contour: 0, index: 0 }, { contour: 0, index: 2 }], handle: null } });
  near(measures(hand), 400, 300, 160, 160);
  setMeasure(hand.editor, "y", 310);
  assert.deepEqual([hand.point(0).y, hand.point(2).y], [310, 470]);
  near({ x: hand.point(4).x, y: hand.point(4).y, width: null, height: null }, 240, 300, null, null);
});

test("what has no width offers none to be changed, and a single point has no box", () => {
  const hand = handOf(twoCircles());
  hand.editor.patch({ selection: { points: [{ contour: 0, index: 0 }, { contour: 0, index: 4 }], handle: null } });
  assert.equal(measures(hand).height, null);
  const before = hand.curve;
  setMeasure(hand.editor, "height", 10);
  assert.equal(hand.curve, before);
  hand.editor.patch({ selection: { points: [{ contour: 0, index: 0 }], handle: null } });
  assert.deepEqual(measures(hand), { x: null, y: null, width: null, height: null });
});

test("a run of typed steps is one entry of the history, another number is another", () => {
  const hand = new Hand("circle-2").run("select-all");
  const before = hand.curve;
  for (const x of [241, 242, 243]) setMeasure(hand.editor, "x", x);
  setMeasure(hand.editor, "width", 300);
  hand.run("undo");
  near(measures(hand), 243, 140, 320, 320);
  hand.run("undo");
  assert.deepEqual(hand.curve, before);
});

test("a handle that points to the left has an angle of 180°, whatever rounding says of it", () => {
  for (const dy of [0, -0, 1e-15, -1e-15]) assert.equal(degreesOf({ dx: -5, dy }).toFixed(2), "180.00");
  assert.equal(degreesOf({ dx: 0, dy: 3 }), -90);
  assert.equal(degreesOf({ dx: 2, dy: -2 }), 45);
  assert.ok(degreesOf({ dx: -100, dy: 0.05 }) < -179.9, "a little lower is a little lower");
});
