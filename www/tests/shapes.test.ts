import assert from "node:assert/strict";
import { test } from "node:test";
import { translated } from "../src/document/curve/contours.ts";
import { curveSample } from "../src/document/curve/samples.ts";
import type { Contour } from "../src/document/document.ts";
import { transformPoints, stretching } from "../src/document/curve/affine.ts";
import { Hand, handOf } from "./harness.ts";

/** A double-click inside a shape selects all of it. The oracle is what people see. */

async function pressedTwice(hand: Hand, x: number, y: number): Promise<string[]> {
  hand.doubleClick(x, y);
  await Promise.all(hand.editor.loading);
  return [...new Set(hand.editor.state.value.selection.points.map(({ contour }) => String(contour)))];
}

const circle = ((): Contour => {
  const found = curveSample("circle-8")?.curve.contours[0];
  assert.ok(found !== undefined);
  return found;
})();

/** Of a radius, around (x, y). */
function disc(radius: number, x: number, y: number, ink?: string): Contour {
  const selection = { points: circle.points.map((_, index) => ({ contour: 0, index })), handle: null };
  const factor = radius / 160;
  const [small] = transformPoints("", selection, stretching({ x: 400, y: 300 }, factor, factor)).apply({ space: "trigonometric", omega: "auto", level: 0, contours: [circle] }).contours;
  assert.ok(small !== undefined);
  return { ...translated(small, x - 400, y - 300), ...(ink === undefined ? {} : { ink }) };
}

test("a letter is selected with its hole, whether it is pressed on its ink or in the hole, and every point of it is", async () => {
  const hand = new Hand("glyph");
  assert.deepEqual(await pressedTwice(hand, 320, 400), ["0", "1"], "in the stem");
  assert.equal(hand.editor.state.value.selection.points.length, 14);
  hand.run("select-none");
  assert.deepEqual(await pressedTwice(hand, 420, 230), ["0", "1"], "in the bowl");
});

test("beside every shape, and inside an open curve, nothing is selected", async () => {
  const hand = new Hand("glyph").run("select-all");
  assert.deepEqual(await pressedTwice(hand, 100, 560), []);
  assert.deepEqual(await pressedTwice(new Hand("sine"), 260, 280), []);
});

test("of two shapes the one that is pressed, and one that only lies in the other's box stays where it is", async () => {
  const discs = [disc(160, 400, 300), disc(20, 535, 165), disc(40, 380, 300)];
  assert.deepEqual(await pressedTwice(handOf(discs), 300, 250), ["0", "2"]);
  assert.deepEqual(await pressedTwice(handOf(discs), 535, 165), ["1"]);
});

test("a mark of another colour is a shape of its own, on whatever it lies", async () => {
  const discs = [disc(160, 400, 300, "#1b5e50"), disc(80, 400, 300, "#ffcc00"), disc(40, 400, 300, "#ffcc00")];
  assert.deepEqual(await pressedTwice(handOf(discs), 460, 300), ["1", "2"]);
  assert.deepEqual(await pressedTwice(handOf(discs), 520, 300), ["0"]);
});

test("where clicks move a point, two of them select no shape", async () => {
  const hand = new Hand("circle-8");
  hand.editor.setSettings({ moveByClicks: true });
  assert.deepEqual(await pressedTwice(hand, 420, 310), []);
});
