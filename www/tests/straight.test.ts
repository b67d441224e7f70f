import assert from "node:assert/strict";
import { test } from "node:test";
import { placePoint } from "../src/document/curve/commands.ts";
import type { ControlPoint, Offset } from "../src/document/document.ts";
import { loadCurve } from "../src/editor/curve/edits.ts";
import { Hand } from "./harness.ts";

/** Lines of a drawing when points of them are moved. */

/** Coordinates of a few hundred units: an ulp is 6e-14, and a line takes a dozen roundings. */
const rounding = 2e-12;

type Pair = readonly [number, number];

function offset(x: number, y: number): Offset {
  return { dx: x, dy: y };
}

/** Lines as they come out of a file: handles a third of the way, corners between. */
function lines(places: readonly Pair[], closed: boolean): readonly ControlPoint[] {
  return places.map(([x, y], i) => {
    const toward = (k: number): Offset => {
      const [toX, toY] = places[(k + places.length) % places.length] ?? [x, y];
      return !closed && (k < 0 || k === places.length) ? offset(0, 0) : offset((toX - x) / 3, (toY - y) / 3);
    };
    return { x, y, kind: "cusp", in: toward(i - 1), out: toward(i + 1) };
  });
}

function opened(points: readonly ControlPoint[], closed = false): Hand {
  const hand = new Hand("circle-2");
  const omega = Array.from({ length: points.length - (closed ? 0 : 1) }, () => 0);
  loadCurve(hand.editor, "Open", { ...hand.curve, contours: [{ family: "hermite", closed, points, support: 1, omega }] });
  return hand;
}

/** How far a segment is from the line between its ends. */
function sag(hand: Hand, segment: number): number {
  const shape = hand.curve.contours[0];
  assert.ok(shape !== undefined, "a contour");
  const [from, to] = [hand.point(segment), hand.point((segment + 1) % shape.points.length)];
  const count = shape.points.length - (shape.closed ? 0 : 1);
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const points = hand.sample(64 * count + (shape.closed ? 0 : 1)).subarray(128 * segment, 128 * (segment + 1));
  let worst = 0;
  for (let i = 0; i < points.length; i += 2) {
    const [x, y] = [(points[i] ?? NaN) - from.x, (points[i + 1] ?? NaN) - from.y];
    worst = Math.max(worst, Math.abs(x * (to.y - from.y) - y * (to.x - from.x)) / length);
  }
  return worst;
}

test("the sides of a rectangle stay straight, whichever of its corners is dragged", () => {
  for (const corner of [0, 1, 2, 3]) {
    const hand = opened(lines([[100, 100], [400, 100], [400, 300], [100, 300]], true), true);
    hand.drag(hand.point(corner), 37, -61);
    for (const side of [0, 1, 2, 3]) assert.ok(sag(hand, side) < rounding, `${corner}: ${side}`);
    const opposite = (corner + 2) % 4;
    assert.equal(hand.point(opposite).x, corner === 1 || corner === 2 ? 100 : 400, "others stay where they were");
  }
});

test("a line's open end, a corner that is placed by numbers, and several points at once: lines stay lines", () => {
  const hand = opened(lines([[100, 100], [200, 180], [400, 120], [420, 300]], false));
  hand.drag(hand.point(0), -30, 55);
  hand.editor.dispatch(placePoint({ contour: 0, index: 2 }, { x: 350 }));
  hand.editor.patch({ selection: { points: [{ contour: 0, index: 2 }, { contour: 0, index: 3 }], handle: null } });
  hand.drag(hand.point(3), 20, 44);
  for (const segment of [0, 1, 2]) assert.ok(sag(hand, segment) < rounding, String(segment));
});

test("where a line goes on smoothly into an arc, the arc keeps its tangent", () => {
  const [start, , end] = lines([[100, 100], [300, 100], [350, 150]], false);
  assert.ok(start !== undefined && end !== undefined, "three points");
  const joint: ControlPoint = { x: 300, y: 100, kind: "smooth", in: offset(-200 / 3, 0), out: offset(30, 0) };
  const hand = opened([start, joint, { ...end, in: offset(0, -30) }]);
  hand.drag(joint, 12, -9);
  assert.deepEqual(hand.curve.contours[0]?.points, [start, { ...joint, x: 312, y: 91 }, { ...end, in: offset(0, -30) }]);
});

test("a corner between a line and a curve turns the line alone, and a loop that ends where it begins is no line", () => {
  const [start, corner] = lines([[100, 100], [300, 100]], false);
  assert.ok(start !== undefined && corner !== undefined, "two points");
  const loop: ControlPoint = { x: 300, y: 300, kind: "cusp", in: offset(-100, 0), out: offset(100, -80) };
  const hand = opened([start, { ...corner, out: offset(80, 80) }, loop, { ...loop, in: offset(-100, -80) }]);
  hand.drag(hand.point(1), 40, -25);
  assert.ok(sag(hand, 0) < rounding, "the line");
  assert.deepEqual(hand.point(1).out, offset(80, 80));
  hand.editor.dispatch(placePoint({ contour: 0, index: 3 }, { x: 330 }));
  assert.deepEqual([hand.point(2).out, hand.point(3).in], [offset(100, -80), offset(-100, -80)]);
});
