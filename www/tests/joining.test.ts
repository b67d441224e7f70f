import assert from "node:assert/strict";
import { test } from "node:test";
import { translated } from "../src/document/curve/contours.ts";
import { openPart, reversedContour, withPinnedOmega } from "../src/document/curve/whole/rearranging.ts";
import { curveSample } from "../src/document/curve/samples.ts";
import type { Contour, CurveDocument, PointRef } from "../src/document/document.ts";
import { loadCurve } from "../src/editor/curve/edits.ts";
import { samplePoints } from "../src/kernel/curve/samples.ts";
import { Hand, largestDistance } from "./harness.ts";

/** Two ends are joined. The oracle is the contour that was cut: joined again it is what it was. */

function drawing(name: string): { curve: CurveDocument; whole: Contour } {
  const curve = curveSample(name)?.curve;
  const contour = curve?.contours[0];
  assert.ok(curve !== undefined && contour !== undefined);
  return { curve, whole: withPinnedOmega(curve, contour) };
}

async function join(curve: CurveDocument, contours: readonly Contour[], ends: readonly PointRef[]): Promise<Hand> {
  const hand = new Hand();
  loadCurve(hand.editor, "Open", { ...curve, contours });
  hand.editor.patch({ selection: { points: ends, handle: null } });
  hand.run("join");
  await Promise.all(hand.editor.loading);
  return hand;
}

for (const name of ["circle-8", "heart", "glyph"]) {
  test(`two parts that meet are the curve that was cut, whichever way each runs: ${name}`, async () => {
    const { curve, whole } = drawing(name);
    const expected = openPart(whole, 0, 4);
    const parts = [openPart(whole, 0, 2), openPart(whole, 2, 4)] as const;
    for (const turned of [[false, false], [true, false], [false, true], [true, true]]) {
      for (const order of [[0, 1], [1, 0]] as const) {
        const contours = parts.map((part, i) => (turned[i] === true ? reversedContour(part) : part));
        const end = (i: 0 | 1): PointRef => ({ contour: i, index: (i === 0) === (turned[i] === true) ? 0 : 2 });
        const hand = await join(curve, contours, order.map(end));
            assert.equal(hand.curve.contours.length, 1);
        const found = hand.curve.contours[0];
        assert.ok(found !== undefined && !found.closed && found.points.length === 5);
        const [first] = found.points;
        const same = first?.x === expected.points[0]?.x && first?.y === expected.points[0]?.y ? found : reversedContour(found);
        const off = largestDistance(samplePoints(hand.curve, same, 200), samplePoints(curve, expected, 200));
        assert.ok(off < 1e-9, `${off}`);
        assert.deepEqual(hand.selected, ["0:2"]);
        hand.run("undo");
        assert.equal(hand.curve.contours.length, 2);
      }
    }
  });
}

test("ends that are apart get a segment between them, and nothing else moves", async () => {
  const { curve, whole } = drawing("heart");
  const [one, other] = [openPart(whole, 0, 2), translated(openPart(whole, 2, 4), 40, 30)];
  const hand = await join(curve, [one, other], [{ contour: 0, index: 2 }, { contour: 1, index: 0 }]);
  const found = hand.curve.contours[0];
  assert.ok(found !== undefined && found.points.length === 6);
  for (const [part, from] of [[one, 0], [other, 3]] as const) {
    const off = largestDistance(samplePoints(hand.curve, openPart(found, from, from + 2), 100), samplePoints(curve, part, 100));
    assert.ok(off < 1e-9, `${off}`);
  }
});

test("both ends of one contour close it: at one point where they nearly meet, with a segment where they do not", async () => {
  const { curve, whole } = drawing("circle-8");
  const ends = [{ contour: 0, index: 0 }, { contour: 0, index: 7 }];
  const apart = await join(curve, [openPart(whole, 0, 7)], ends);
  assert.ok(apart.curve.contours[0]?.closed === true && apart.point(7) !== undefined);
  const [start] = whole.points;
  assert.ok(start !== undefined);
  const ring = { ...openPart(whole, 0, 7), points: [...whole.points, { ...start, x: start.x + 0.2 }], omega: whole.omega ?? [] };
  const met = await join(curve, [ring], [{ contour: 0, index: 0 }, { contour: 0, index: 8 }]);
  const [found] = met.curve.contours;
  assert.ok(found?.closed === true && found.points.length === 8);
  assert.ok(largestDistance(met.sample(200), samplePoints(curve, whole, 200)) < 1e-9);
});

test("what has no two open ends is left as it is, and why is said", async () => {
  const { curve, whole } = drawing("circle-8");
  const arc = openPart(whole, 0, 3);
  const others: readonly [readonly Contour[], readonly PointRef[]][] = [
    [[whole], [{ contour: 0, index: 0 }, { contour: 0, index: 7 }]],
    [[arc], [{ contour: 0, index: 0 }, { contour: 0, index: 2 }]],
    [[arc], [{ contour: 0, index: 0 }]],
    [[arc, { ...arc, space: "hyperbolic" }], [{ contour: 0, index: 3 }, { contour: 1, index: 0 }]],
  ];
  for (const [contours, ends] of others) {
    const hand = await join(curve, contours, ends);
    assert.deepEqual(hand.curve.contours, contours);
    assert.match(hand.editor.state.value.hint, /two open ends/);
  }
});

/** Drags an end onto a place, as a hand does, and stays there. */
async function carried(contours: readonly Contour[], curve: CurveDocument, end: PointRef, onto: PointRef, held = {}): Promise<Hand> {
  const hand = new Hand();
  loadCurve(hand.editor, "Open", { ...curve, contours });
  const [from, to] = [hand.point(end.index, end.contour), hand.point(onto.index, onto.contour)];
  hand.keys(held).wait().moveTo(from.x, from.y).press().moveTo(from.x + 5, from.y + 5);
  await Promise.all(hand.editor.loading);
  return hand.moveTo(to.x + 2, to.y - 1);
}

for (const [end, onto] of [[2, 0], [0, 2], [2, 2], [0, 0]] as const) {
  test(`an end that is dropped on an end of another contour is joined to it, at one point, in one step: ${end} on ${onto}`, async () => {
    const { curve, whole } = drawing("glyph");
    const parts = [openPart(whole, 0, 2), translated(openPart(whole, 2, 4), 200, 120)] as const;
    const hand = await carried(parts, curve, { contour: 0, index: end }, { contour: 1, index: onto });
    const place = parts[1].points[onto];
    assert.deepEqual(hand.editor.state.value.sketch.joint, place, "the ring");
    assert.match(hand.editor.state.value.drag?.snapped ?? "", /let go to join/);
    hand.release();
    const [found, ...others] = hand.curve.contours;
    assert.ok(found !== undefined && others.length === 0 && found.points.length === 5 && !found.closed);
    const seam = hand.point(2);
    assert.ok(Math.hypot(seam.x - (place?.x ?? 0), seam.y - (place?.y ?? 0)) < 1e-9);
    const first = found.points[0]?.x === parts[1].points[2 - onto]?.x;
    const other = first ? reversedContour(openPart(found, 0, 2)) : openPart(found, 2, 4);
    const expected = onto === 0 ? parts[1] : reversedContour(parts[1]);
    assert.ok(largestDistance(samplePoints(hand.curve, other, 100), samplePoints(curve, expected, 100)) < 1e-9, "the other contour stays where it is");
    hand.run("undo");
    assert.deepEqual(hand.curve.contours, parts);
    assert.equal(hand.editor.state.value.sketch.joint, null);
  });
}

test("an end that is dropped on the other end of its contour closes it", async () => {
  const { curve, whole } = drawing("heart");
  const arc = { ...openPart(whole, 0, 4) };
  const hand = (await carried([arc], curve, { contour: 0, index: 4 }, { contour: 0, index: 0 })).release();
  const [found] = hand.curve.contours;
  assert.ok(found?.closed === true && found.points.length === 4);
  assert.deepEqual(hand.point(0).out, arc.points[0]?.out);
  assert.deepEqual(hand.point(0).in, arc.points[4]?.in);
  hand.run("undo");
  assert.deepEqual(hand.curve.contours, [arc]);
});

test("nothing is joined where no snapping is wanted, on points that are no ends, of two points, and after Escape", async () => {
  const { curve, whole } = drawing("heart");
  const [arc, other] = [openPart(whole, 0, 2), translated(openPart(whole, 2, 4), 40, 30)];
  const end = { contour: 0, index: 2 };
  const free = await carried([arc, other], curve, end, { contour: 1, index: 0 }, { mod: true });
  assert.equal(free.release().curve.contours.length, 2);
  const middle = await carried([arc, other], curve, end, { contour: 1, index: 1 });
  assert.equal(middle.release().curve.contours.length, 2);
  const line = openPart(whole, 0, 1);
  const short = await carried([line], curve, { contour: 0, index: 1 }, { contour: 0, index: 0 });
  assert.equal(short.release().point(1).x, line.points[0]?.x);
  const given = await carried([arc, other], curve, end, { contour: 1, index: 0 });
  given.input.cancel();
  assert.deepEqual(given.curve.contours, [arc, other]);
  assert.equal(given.editor.state.value.sketch.joint, null);
});
