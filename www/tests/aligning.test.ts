import assert from "node:assert/strict";
import { test } from "node:test";
import { translated } from "../src/document/curve/contours.ts";
import type { Axis, Part } from "../src/document/curve/aligning.ts";
import { curveSample } from "../src/document/curve/samples.ts";
import type { Contour, CurveDocument, PointRef } from "../src/document/document.ts";
import { align, distribute } from "../src/editor/curve/aligning.ts";
import { loadCurve } from "../src/editor/curve/edits.ts";
import { boundsOf, type Bounds } from "../src/kernel/curve/samples.ts";
import { Hand } from "./harness.ts";

/** Contours and points in line with each other. The oracle is the exact box of each contour. */

function three(): { curve: CurveDocument; contours: Contour[] } {
  const curve = curveSample("circle-8")?.curve;
  const circle = curve?.contours[0];
  assert.ok(curve !== undefined && circle !== undefined);
  return { curve, contours: [circle, translated(circle, 530, -45), translated(circle, 170, 610)] };
}

function chosen(curve: CurveDocument, contours: readonly Contour[], points: readonly PointRef[]): Hand {
  const hand = new Hand();
  loadCurve(hand.editor, "Open", { ...curve, contours });
  hand.editor.patch({ selection: { points, handle: null } });
  return hand;
}

const whole = (contours: readonly Contour[]): PointRef[] => contours.flatMap(({ points }, contour) => points.map((_, index) => ({ contour, index })));

function boxes({ curve }: Hand): Bounds[] {
  return curve.contours.map((contour) => {
    const box = boundsOf(curve, contour);
    assert.ok(box);
    return box;
  });
}

const edges: readonly (readonly [Axis, Part, (box: Bounds) => number, (all: readonly number[]) => number])[] = [
  ["across", "start", ({ minX }) => minX, (all) => Math.min(...all)],
  ["across", "end", ({ maxX }) => maxX, (all) => Math.max(...all)],
  ["down", "start", ({ minY }) => minY, (all) => Math.min(...all)],
  ["down", "end", ({ maxY }) => maxY, (all) => Math.max(...all)],
];

for (const [axis, part, edge, outermost] of edges) {
  test(`whole contours stand in line at their ${axis} ${part}, keep their shapes, and undo brings them back`, () => {
    const { curve, contours } = three();
    const hand = chosen(curve, contours, whole(contours));
    const line = outermost(boxes(hand).map(edge));
    align(hand.editor, axis, part);
    for (const [i, box] of boxes(hand).entries()) {
      assert.ok(Math.abs(edge(box) - line) < 1e-9, `${edge(box)} and ${line}`);
      const [from, to] = [contours[i]?.points ?? [], hand.curve.contours[i]?.points ?? []];
      for (const [k, point] of to.entries()) {
        assert.deepEqual([point.in, point.out], [from[k]?.in, from[k]?.out]);
        const other = axis === "across" ? "y" : "x";
        assert.equal(point[other], from[k]?.[other], "the other axis is as it was");
      }
    }
    hand.run("undo");
    assert.deepEqual(hand.curve.contours, contours);
  });
}

test("middles stand in line with the middle of all", () => {
  const { curve, contours } = three();
  const hand = chosen(curve, contours, whole(contours));
  const before = boxes(hand);
  const middle = (Math.min(...before.map(({ minX }) => minX)) + Math.max(...before.map(({ maxX }) => maxX))) / 2;
  align(hand.editor, "across", "middle");
  for (const { minX, maxX } of boxes(hand)) assert.ok(Math.abs((minX + maxX) / 2 - middle) < 1e-9);
});

test("gaps become equal, and the contours at both ends stay", () => {
  const { curve, contours } = three();
  const hand = chosen(curve, contours, whole(contours));
  distribute(hand.editor, "across");
  const [first, last, between] = boxes(hand);
  assert.ok(first !== undefined && last !== undefined && between !== undefined);
  assert.deepEqual(hand.curve.contours[0], contours[0]);
  assert.ok(Math.abs(hand.point(0, 1).x - (contours[1]?.points[0]?.x ?? NaN)) < 1e-9);
  assert.ok(Math.abs(between.minX - first.maxX - (last.minX - between.maxX)) < 1e-9);
});

test("points of one contour stand in line by themselves, and keep their handles", () => {
  const { curve, contours } = three();
  const [circle] = contours;
  assert.ok(circle);
  const hand = chosen(curve, [circle], [1, 2, 4].map((index) => ({ contour: 0, index })));
  const top = Math.min(...[1, 2, 4].map((index) => circle.points[index]?.y ?? NaN));
  align(hand.editor, "down", "start");
  for (const index of [1, 2, 4]) assert.deepEqual(hand.point(index), { ...circle.points[index], y: top });
  assert.deepEqual(hand.point(3), circle.points[3]);
  distribute(hand.editor, "across");
  const [a, b, c] = [1, 2, 4].map((index) => hand.point(index).x).sort((x, y) => x - y);
  assert.ok(Math.abs((a ?? 0) + (c ?? 0) - 2 * (b ?? 0)) < 1e-9);
});

test("one contour alone has nothing to stand in line with, and two have no gap to share: that is said", () => {
  const { curve, contours } = three();
  const one = contours.slice(0, 1);
  const hand = chosen(curve, one, whole(one));
  align(hand.editor, "across", "start");
  assert.match(hand.editor.state.value.hint, /several contours/);
  const two = contours.slice(0, 2);
  const pair = chosen(curve, two, whole(two));
  distribute(pair.editor, "down");
  assert.match(pair.editor.state.value.hint, /three/);
  assert.deepEqual([hand.curve.contours, pair.curve.contours], [one, two]);
});

test("the two points of a line can be levelled", () => {
  const line: Contour = {
    family: "hermite", closed: false, support: 1,
    points: [{ x: 10, y: 20 }, { x: 110, y: 50 }].map((place) => ({ ...place, kind: "cusp", in: { dx: 0, dy: 0 }, out: { dx: 0, dy: 0 } })),
  };
  const { curve } = three();
  const hand = chosen(curve, [line], whole([line]));
  align(hand.editor, "down", "middle");
  assert.deepEqual([hand.point(0).y, hand.point(1).y], [35, 35]);
});
