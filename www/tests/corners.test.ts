import assert from "node:assert/strict";
import { test } from "node:test";
import { arcAt } from "../src/document/curve/corners/corners.ts";
import { rectangleIn } from "../src/document/curve/drawing/shapes.ts";
import { lengthOf, type Contour, type ControlPoint, type CurveDocument } from "../src/document/document.ts";
import { hermiteOf } from "../src/kernel/curve/curve-cache.ts";
import { rounded, type Rounded } from "../src/kernel/curve/rounding/rounded.ts";
import { contoursOfPath } from "./harness.ts";

/**
 * Round corners of contours. The oracle knows nothing of tangents and angles of arcs: it samples the new curve, takes
 * the circle through three of the samples, and measures the old sides by places of their own.
 */

const paper: CurveDocument = { space: "trigonometric", omega: "auto", level: 0, contours: [] };
const rectangle = rectangleIn({ minX: 100, minY: 50, maxX: 300, maxY: 150 });

interface Place {
  readonly x: number;
  readonly y: number;
}

function pathOf(d: string): Contour {
  const [contour] = contoursOfPath(d);
  assert.ok(contour);
  return contour;
}

/** Places of one segment, from end to end. */
function along(contour: Contour, segment: number, count = 101, curve = paper): Place[] {
  const made = hermiteOf(curve, contour);
  assert.ok(made);
  let start = 0;
  for (let i = 0; i < segment; i += 1) start += lengthOf(contour, i);
  const [, end] = made.domain;
  const at = Array.from({ length: count }, (_, i) => Math.min(end, start + (lengthOf(contour, segment) * i) / (count - 1)));
  return at.map((t) => {
    const [x = NaN, y = NaN] = made.evaluate(t);
    return { x, y };
  });
}

function circleThrough([a, b, c]: readonly [Place, Place, Place]): Place & { readonly radius: number } {
  const [ux, uy, vx, vy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y];
  const [u, v, twice] = [ux * ux + uy * uy, vx * vx + vy * vy, 2 * (ux * vy - uy * vx)];
  const [x, y] = [(vy * u - uy * v) / twice, (ux * v - vx * u) / twice];
  return { x: a.x + x, y: a.y + y, radius: Math.hypot(x, y) };
}

const distance = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);

/** The circle of the arc that a segment is, to this part of its radius. */
function circleOf(contour: Contour, segment: number, within: number): Place & { readonly radius: number } {
  const places = along(contour, segment);
  const [first, middle, last] = [places[0], places[50], places[100]];
  assert.ok(first && middle && last);
  const circle = circleThrough([first, middle, last]);
  for (const place of places) assert.ok(Math.abs(distance(place, circle) / circle.radius - 1) <= within, `${distance(place, circle)} from the centre of an arc of ${circle.radius}`);
  return circle;
}

/** How near a segment comes to a place: the best of many places, and of many around that one. */
function nearestOf(contour: Contour, segment: number, to: Place): number {
  const curve = hermiteOf(paper, { ...contour, closed: contour.closed });
  assert.ok(curve);
  let start = 0;
  for (let i = 0; i < segment; i += 1) start += lengthOf(contour, i);
  const at = (x: number): number => {
    const [px = NaN, py = NaN] = curve.evaluate(Math.min(curve.domain[1], start + x * lengthOf(contour, segment)));
    return Math.hypot(px - to.x, py - to.y);
  };
  let [low, high] = [0, 1];
  for (let round = 0; round < 9; round += 1) {
    const step = (high - low) / 100;
    let best = low;
    for (let i = 0; i <= 100; i += 1) if (at(low + i * step) < at(best)) best = low + i * step;
    [low, high] = [Math.max(0, best - step), Math.min(1, best + step)];
  }
  return at((low + high) / 2);
}

/** How much the direction changes at a point, as its handles show it. */
function turn({ in: before, out: after }: ControlPoint): number {
  return Math.abs(Math.atan2(after.dx * before.dy - after.dy * before.dx, -(before.dx * after.dx + before.dy * after.dy)));
}

/** Every arc that was made is one, as round as it says, and goes on smoothly at both ends. */
function assertArcs(result: Rounded, within = 1e-12): void {
  for (const [corner, [from, to]] of result.made) {
    const circle = circleOf(result.contour, from, within);
    const radius = result.radii.get(corner) ?? NaN;
    assert.ok(Math.abs(circle.radius / radius - 1) <= within, `${circle.radius} is not ${radius}`);
    for (const index of [from, to]) {
      const point = result.contour.points[index];
      assert.ok(point && turn(point) <= 1e-9, `the curve turns by ${point && turn(point)} at the end of an arc`);
    }
  }
}

/** Seeded, so that a failure comes back. */
function random(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 48_271) % 2_147_483_647) / 2_147_483_647;
}

const placesOf = ({ points }: Contour): string[] => points.map(({ x, y }) => `${x},${y}`);

test("a rectangle's corners are exact arcs of the radius asked for, from where a circle touches the sides", () => {
  const result = rounded(paper, rectangle, [0, 1, 2, 3], 20);
  assert.deepEqual(placesOf(result.contour), ["100,70", "120,50", "280,50", "300,70", "300,130", "280,150", "120,150", "100,130"], "to the last bit");
  assertArcs(result);
  const centres = [...result.made.values()].map(([from]) => circleOf(result.contour, from, 1e-12));
  assert.deepEqual(centres.map(({ x, y }) => [Math.round(x * 1e9) / 1e9, Math.round(y * 1e9) / 1e9]), [[120, 70], [280, 70], [280, 130], [120, 130]]);
});

test("corners of any angle between lines get the radius to 1e-12 of it, and their centre is that far from both lines", () => {
  const next = random(7);
  for (let round = 0; round < 200; round += 1) {
    const [turnBy, first, second, size] = [0.05 + 3 * next(), 1 + 9 * next(), 1 + 9 * next(), 10 ** (4 * next() - 1)];
    const [start, side] = [6.28 * next(), next() < 0.5 ? -1 : 1];
    const corner = { x: size * next(), y: size * next() };
    const [a, b] = [
      { x: corner.x - size * first * Math.cos(start), y: corner.y - size * first * Math.sin(start) },
      { x: corner.x + size * second * Math.cos(start + side * turnBy), y: corner.y + size * second * Math.sin(start + side * turnBy) },
    ];
    const contour = pathOf(`M${a.x} ${a.y}L${corner.x} ${corner.y}L${b.x} ${b.y}`);
    const most = (size * Math.min(first, second)) / Math.tan(turnBy / 2);
    const asked = most * (0.02 + 1.5 * next());
    const result = rounded(paper, contour, [1], asked);
    const radius = result.radii.get(1) ?? NaN;
    assert.ok(Math.abs(radius / Math.min(asked, most) - 1) <= 1e-11, `${radius} of ${asked}, at most ${most}`);
    // Coordinates of a small arc far from the origin have few digits of it.
    const within = 1e-12 * Math.max(1, (20 * size) / (radius * turnBy));
    assertArcs(result, within);
    const circle = circleOf(result.contour, result.made.get(1)?.[0] ?? -1, within);
    for (const end of [a, b]) {
      const off = Math.abs((end.x - corner.x) * (circle.y - corner.y) - (end.y - corner.y) * (circle.x - corner.x)) / distance(end, corner);
      assert.ok(Math.abs(off / radius - 1) <= 1e3 * within, `the centre is ${off} from a side, not ${radius}`);
    }
  }
});

test("where both ends of a side are rounded at once each has half of it; one alone has all of it", () => {
  const both = rounded(paper, rectangle, [0, 1, 2, 3], 1e6);
  assert.deepEqual([...both.radii.values()].map((radius) => Math.round(radius * 1e9) / 1e9), [50, 50, 50, 50]);
  assert.deepEqual(placesOf(both.contour), ["100,100", "150,50", "250,50", "300,100", "250,150", "150,150"], "nothing is left of the short sides, and no point stands twice");
  assertArcs(both);
  const alone = rounded(paper, rectangle, [1], Infinity);
  assert.ok(Math.abs((alone.radii.get(1) ?? 0) - 100) < 1e-9);
  assert.deepEqual(placesOf(alone.contour), ["100,50", "200,50", "300,150", "100,150"]);
  assertArcs({ ...alone, made: new Map() });
  circleOf(alone.contour, 1, 1e-12);
});

test("a square with corners of half its side is a circle, to the last digits", () => {
  const square = rectangleIn({ minX: -80, minY: -80, maxX: 80, maxY: 80 });
  for (const radius of [80, Infinity]) {
    const { contour } = rounded(paper, square, [0, 1, 2, 3], radius);
    assert.equal(contour.points.length, 4);
    for (let i = 0; i < 4; i += 1) for (const { x, y } of along(contour, i)) assert.ok(Math.abs(Math.hypot(x, y) / 80 - 1) < 1e-14);
  }
});

test("the corner where a closed contour begins is rounded as all others, and the ends of an open one are none", () => {
  for (const index of [0, 3]) {
    const result = rounded(paper, rectangle, [index], 30);
    assertArcs(result);
    assert.equal(result.contour.points.length, 5);
  }
  const open = pathOf("M0 0L100 0L100 100");
  const ends = rounded(paper, open, [0, 2], 10);
  assert.deepEqual([...ends.refused], [[0, "room"], [2, "room"]]);
  assert.equal(ends.contour, open);
});

/** Corners between curves of which one at least is bent. */
const bent: readonly (readonly [string, string])[] = [
  ["two cubics", "M0 0C30 60 80 60 100 0C80 -20 20 -20 0 0Z"],
  ["a line and a cubic", "M0 0L100 0C90 40 60 70 20 80"],
  ["a cubic and a line", "M0 100C10 50 40 20 100 0L120 90"],
  ["a circle and a chord", "M0 0A60 60 0 0 1 90 0Z"],
  ["two arcs that bend to each other", "M0 0A80 80 0 0 1 100 0A120 120 0 0 1 20 90"],
  ["an ellipse and a cubic", "M0 0A80 40 20 0 1 100 0C100 30 80 60 30 70"],
  ["curves that bend away", "M0 0Q60 0 60 60Q70 0 140 10"],
];

for (const [name, d] of bent) {
  test(`a corner between ${name}: the arc touches both sides, and what is left of them does not move`, () => {
    const contour = pathOf(d);
    const [before, after] = [0, 1];
    const most = rounded(paper, contour, [1], Infinity).radii.get(1) ?? 0;
    assert.ok(most > 0, "a circle fits");
    for (const radius of [most / 1000, most / 7, most / 2, 0.9 * most, 5 * most]) {
      const result = rounded(paper, contour, [1], radius);
      const made = result.radii.get(1) ?? NaN;
      assert.ok(Math.abs(made / Math.min(radius, most) - 1) <= 1e-8, `${made} where ${radius} was asked for, of ${most}`);
      if (radius < most) assert.equal(made, radius);
      // What is solved for is the place of the centre, to the last digits of the coordinates.
      assertArcs(result, 1e-10 * Math.max(1, 1 / made));
      const [from = -1] = result.made.get(1) ?? [];
      const circle = circleOf(result.contour, from, 1e-9 * Math.max(1, 1 / made));
      for (const side of [before, after]) {
        const off = nearestOf(contour, side, circle);
        assert.ok(Math.abs(off - made) <= 1e-9 * (made + 1), `side ${side} is ${off} from the centre, not ${made}`);
      }
      const old = hermiteOf(paper, contour);
      for (const segment of result.contour.points.keys()) {
        if (segment === from || (!contour.closed && segment === result.contour.points.length - 1)) continue;
        for (const { x, y } of along(result.contour, segment, 33)) assert.ok((old?.nearest(x, y).distance ?? 1) <= 1e-10 * 200, "what is left lies on the old curve");
      }
    }
  });
}

test("random corners between cubics either get an arc that touches both sides, or stay as they were", () => {
  const next = random(11);
  let done = 0;
  for (let round = 0; round < 60; round += 1) {
    const at = (): string => `${(200 * next()).toFixed(3)} ${(200 * next()).toFixed(3)}`;
    const contour = pathOf(`M${at()}C${at()} ${at()} ${at()}C${at()} ${at()} ${at()}`);
    const result = rounded(paper, contour, [1], 0.5 + 60 * next());
    if (result.refused.size > 0) {
      assert.equal(result.contour, contour);
      continue;
    }
    done += 1;
    const made = result.radii.get(1) ?? NaN;
    const [from = -1] = result.made.get(1) ?? [];
    assertArcs(result, 1e-9 * Math.max(1, 1 / made));
    const circle = circleOf(result.contour, from, 1e-9 * Math.max(1, 1 / made));
    for (const side of [0, 1]) assert.ok(Math.abs(nearestOf(contour, side, circle) - made) <= 1e-9 * (made + 1), "it touches, and cuts nothing");
  }
  assert.ok(done >= 30, `${done} of 60 were rounded`);
});

test("what cannot be rounded is named: hyperbolic curves, sides that lie on each other, points on a straight line or at one place", () => {
  const corner = (d: string, space: CurveDocument["space"] = "trigonometric"): Rounded => rounded({ ...paper, space, omega: 1 }, pathOf(d), [1], 10);
  assert.deepEqual([...corner("M0 0L100 0L0 0.5").refused.values()], ["sharp"]);
  assert.deepEqual([...corner("M0 0L100 0L0 0").refused.values()], ["sharp"]);
  assert.deepEqual([...corner("M0 0L100 0L200 0").refused.values()], ["room"]);
  const bow: ControlPoint[] = [0, 1, 2].map((i) => ({ x: 50 * i, y: 40 * (i % 2), kind: "cusp", in: { dx: -10, dy: 20 }, out: { dx: 10, dy: 25 } }));
  const curved: Contour = { family: "hermite", closed: false, points: bow };
  assert.deepEqual([...rounded({ ...paper, space: "hyperbolic", omega: 1 }, curved, [1], 5).refused.values()], ["space"]);
  const lines: Contour = { ...pathOf("M0 0L100 0L100 100"), space: "hyperbolic", omega: [1, 1] };
  const freed = rounded({ ...paper, space: "hyperbolic" }, lines, [1], 5);
  assert.equal(freed.contour.space, "trigonometric", "lines are lines in any space");
  assertArcs(freed);
  const twice: Contour = { family: "hermite", closed: true, points: [{ ...bow[0], x: 5, y: 5 }, { ...bow[0], x: 5, y: 5, in: { dx: 0, dy: 0 }, out: { dx: 0, dy: 0 } }, { ...bow[0], x: 90, y: 5 }] as ControlPoint[] };
  assertFinite(rounded(paper, twice, [0, 1, 2], 10).contour);
});

function assertFinite({ points, omega = [], lengths = [] }: Contour): void {
  for (const { x, y, in: before, out: after } of points) for (const value of [x, y, before.dx, before.dy, after.dx, after.dy]) assert.ok(Number.isFinite(value));
  for (const value of [...omega, ...lengths]) assert.ok(Number.isFinite(value));
}

test("no radius and no contour makes numbers that are none", () => {
  const shapes = [rectangle, ...bent.map(([, d]) => pathOf(d)), pathOf("M0 0L0 0L10 0L10 10Z"), pathOf("M0 0L1e-9 0L1e-9 1e-9Z"), pathOf("M0 0L1e7 0L1e7 1e7Z")];
  for (const shape of shapes) {
    for (const radius of [0, -1, NaN, 1e-300, 1e-12, 1e300, Infinity]) {
      const result = rounded(paper, shape, [0, 1, 2], radius);
      assertFinite(result.contour);
      for (const made of result.radii.values()) assert.ok(made > 0 && made <= radius);
      assert.ok(hermiteOf(paper, result.contour), "the engine takes it");
    }
  }
});

test("an arc between lines tells its radius and its corner, turned and moved and stretched evenly, and nothing else does", () => {
  const { contour } = rounded(paper, rectangle, [0, 1, 2, 3], 20);
  const found = contour.points.map((_, segment) => arcAt(paper, contour, segment));
  assert.deepEqual(found.map((arc) => (arc === null ? null : Math.round(arc.radius * 1e9) / 1e9)), [20, null, 20, null, 20, null, 20, null]);
  assert.deepEqual([found[0]?.corner, found[2]?.corner], [{ x: 100, y: 50 }, { x: 300, y: 50 }]);
  const pill = rounded(paper, rectangle, [0, 1, 2, 3], 50).contour;
  assert.ok(pill.points.every((_, segment) => arcAt(paper, pill, segment) === null), "half a circle between two lines may have been one ever since");
  // Stretched in one direction its corners are no circles.
  const wide: Contour = { ...contour, points: contour.points.map((point) => ({ ...point, x: 2 * point.x, in: { dx: 2 * point.in.dx, dy: point.in.dy }, out: { dx: 2 * point.out.dx, dy: point.out.dy } })) };
  assert.ok(wide.points.every((_, segment) => arcAt(paper, wide, segment) === null));
  const circle = rounded(paper, rectangleIn({ minX: 0, minY: 0, maxX: 50, maxY: 50 }), [0, 1, 2, 3], 25).contour;
  assert.ok(circle.points.every((_, segment) => arcAt(paper, circle, segment) === null), "a circle has no corners");
  for (const [, d] of bent) assert.ok(pathOf(d).points.every((_, segment) => arcAt(paper, pathOf(d), segment) === null));
});
