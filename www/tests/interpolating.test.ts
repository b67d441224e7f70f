import assert from "node:assert/strict";
import { test } from "node:test";
import { baseCount, omegaOf } from "../src/document/document.ts";
import { affectedSegments, rootsOf } from "../src/document/curve/roots.ts";
import { parseState, writeState } from "../src/document/file/file.ts";
import { refineCurveHere, setFamily, setOrder, setOmega } from "../src/editor/curve/family-edits.ts";
import { insertAt, resample, reverse, setClosed, startHere } from "../src/editor/curve/contour-edits.ts";
import { setLevel } from "../src/editor/curve/level-edits.ts";
import { teethOf } from "../src/kernel/curve/overlays/comb.ts";
import { segmentPolygon } from "../src/kernel/curve/samples.ts";
import { commandsOf } from "../src/kernel/paths/export.ts";
import { ellipseIn } from "../src/document/curve/drawing/shapes.ts";
import { addContours } from "../src/document/curve/whole/commands.ts";
import { loadCurve, setSpace } from "../src/editor/curve/edits.ts";
import { Hand, largestDistance } from "./harness.ts";

/** A point of the drawing as the only chosen one. */
function choose(hand: Hand, index: number): void {
  hand.editor.patch({ selection: { points: [{ contour: 0, index }], handle: null } });
}

function contourOf(hand: Hand): NonNullable<Hand["curve"]["contours"][number]> {
  const [contour] = hand.curve.contours;
  assert.ok(contour);
  return contour;
}

test("the roots follow from space, frequency and order, closed under conjugation and negation", () => {
  const hand = new Hand("blob-16");
  const roots = rootsOf(hand.curve, contourOf(hand));
  assert.deepEqual(roots, [{ re: 0, im: 0 }, { re: 0, im: Math.PI / 8 }, { re: 0, im: -Math.PI / 8 }]);
  setOrder(hand.editor, 4);
  assert.deepEqual(rootsOf(hand.curve, contourOf(hand)).slice(0, 2), [{ re: 0, im: 0 }, { re: 0, im: 0 }]);
  assert.equal(contourOf(hand).support, 3);
});

test("a point changes its support's segments, over the seam as well, and a refined one fewer", () => {
  const hand = new Hand("blob-16");
  assert.deepEqual(affectedSegments(hand.curve, contourOf(hand), 5), [3, 4, 5, 6]);
  assert.deepEqual(affectedSegments(hand.curve, contourOf(hand), 0), [14, 15, 0, 1]);
  setLevel(hand.editor, 2);
  assert.ok(affectedSegments(hand.curve, contourOf(hand), 21).length <= 4);
});

test("every level up to the sixth is the same curve, and the way down gives the very points back", () => {
  const hand = new Hand("blob-16");
  const [before, contour] = [hand.sample(999), contourOf(hand)];
  setLevel(hand.editor, 6);
  assert.equal(contourOf(hand).points.length, 1024);
  assert.ok(largestDistance(hand.sample(999), before) < 1e-10);
  setLevel(hand.editor, 0);
  assert.deepEqual(contourOf(hand), contour);
});

test("a curve that came from a file at a finer level comes down by least squares, exactly where nothing finer was edited", () => {
  const hand = new Hand("blob-16");
  const before = hand.sample(500);
  setLevel(hand.editor, 2);
  hand.editor.setState(parseState(writeState(hand.editor.getState())).state);
  setLevel(hand.editor, 1);
  assert.equal(contourOf(hand).points.length, 32);
  assert.ok(largestDistance(hand.sample(500), before) < 1e-9);
  setLevel(hand.editor, 0);
  assert.equal(contourOf(hand).points.length, 16);
  assert.ok(largestDistance(hand.sample(500), before) < 1e-9);
});

test("a circle is the same curve in both families", () => {
  const hand = new Hand("circle-8");
  const before = hand.sample(400);
  setFamily(hand.editor, "interpolating");
  assert.ok(largestDistance(hand.sample(400), before) < 1e-10);
  setFamily(hand.editor, "hermite");
  assert.ok(largestDistance(hand.sample(400), before) < 1e-10);
});

for (const [what, setting] of [
  ["a frequency that was set", { space: "trigonometric", omega: 0.7 }],
  ["the polynomial space", { space: "polynomial", omega: "auto" }],
] as const) {
  test(`an ellipse that was drawn in a drawing of ${what} stays one in the other family and on the way back, through a file, too`, () => {
    const hand = new Hand();
    loadCurve(hand.editor, "Open", { ...setting, level: 0, contours: [] });
    const drawn = ellipseIn(hand.curve, { minX: 100, minY: 100, maxX: 400, maxY: 260 });
    hand.editor.dispatch(addContours("Ellipse", [drawn], true));
    const before = hand.sample(400);
    setFamily(hand.editor, "interpolating");
    // Four roundings of 400 px, summed over the points that a place depends on.
    assert.ok(largestDistance(hand.sample(400), before) < 1e-10);
    hand.editor.setState(parseState(writeState(hand.editor.getState())).state);
    setLevel(hand.editor, 1);
    setLevel(hand.editor, 0);
    assert.ok(largestDistance(hand.sample(400), before) < 1e-10);
    setFamily(hand.editor, "hermite");
    assert.ok(largestDistance(hand.sample(400), before) < 1e-10);
    for (let segment = 0; segment < 4; segment += 1) assert.ok(Math.abs(omegaOf(hand.curve, contourOf(hand), segment) - Math.PI / 2) < 1e-15);
    // The frequency that is set for the drawing is that of every contour.
    setFamily(hand.editor, "interpolating");
    setSpace(hand.editor, "trigonometric");
    setOmega(hand.editor, hand.editor.state.value.selection, 0.4);
    assert.equal(rootsOf(hand.curve, contourOf(hand))[1]?.im, 0.4);
  });
}

test("refining one place leaves the curve, and the points on it take the finer ones along", () => {
  const hand = new Hand("blob-16");
  const before = hand.sample(800);
  choose(hand, 5);
  refineCurveHere(hand.editor);
  const refined = contourOf(hand);
  assert.equal(baseCount(refined), 16);
  assert.ok(refined.points.length > 18);
  // Another way of summing the same terms: the last bits may differ.
  assert.ok(largestDistance(hand.sample(800), before) < 1e-11);
  const fine = refined.points.findIndex((_, i) => i >= 16 + 3);
  hand.drag(hand.point(fine), 6, -4);
  assert.ok(Math.hypot(hand.point(fine).x - (refined.points[fine]?.x ?? 0) - 6, hand.point(fine).y - (refined.points[fine]?.y ?? 0) + 4) < 1e-9);
  const detail = hand.point(fine);
  hand.drag(hand.point(5), 40, 10);
  assert.ok(Math.abs((hand.point(fine).moved?.dx ?? 0) - (detail.moved?.dx ?? NaN)) < 1e-9);
  assert.ok(hand.point(fine).x > detail.x + 5);
  const { state } = parseState(writeState(hand.editor.getState()));
  assert.deepEqual(state.curve, hand.curve);
  hand.run("undo").run("undo").run("undo");
  assert.deepEqual(contourOf(hand).places, undefined);
});

test("deleting a finer point takes its place away and says how far the curve moved", () => {
  const hand = new Hand("blob-16");
  const contour = contourOf(hand);
  choose(hand, 5);
  refineCurveHere(hand.editor);
  choose(hand, 18);
  hand.run("delete");
  assert.deepEqual(contourOf(hand), contour);
});

test("refining a place of a Hermite contour is exact insertion around the chosen point", () => {
  const hand = new Hand("circle-8");
  const before = hand.sample(640);
  choose(hand, 2);
  refineCurveHere(hand.editor);
  assert.equal(contourOf(hand).points.length, 10);
  assert.ok(largestDistance(hand.sample(640), before) < 1e-9);
});

test("a refined contour that is opened is drawn, dragged and brought down again as one that was opened first", () => {
  const hand = new Hand("blob-16");
  setLevel(hand.editor, 1);
  setClosed(hand.editor, false);
  const first = new Hand("blob-16");
  setClosed(first.editor, false);
  assert.ok(largestDistance(hand.sample(500), first.sample(500)) < 1e-12);
  const { curve } = hand;
  assert.ok(teethOf(curve, contourOf(hand), 8));
  assert.equal(segmentPolygon(curve, contourOf(hand), 0, 8).length, 18);
  setLevel(hand.editor, 0);
  assert.equal(contourOf(hand).points.length, 16);
  assert.equal(contourOf(hand).grid, undefined);
  setClosed(hand.editor, true);
  assert.equal(contourOf(hand).points.length, 16);
});

test("turned round or begun elsewhere at a finer level a curve comes down as it is, and nothing is said to move", () => {
  for (const [name, edit] of [["reverse", reverse], ["start here", startHere]] as const) {
    for (const index of [1, 2, 5]) {
      const hand = new Hand("blob-16");
      setLevel(hand.editor, 1);
      choose(hand, index);
      const before = hand.sample(2000);
      edit(hand.editor);
      setLevel(hand.editor, 0);
      assert.equal(hand.editor.state.value.sketch.proposal, null, `${name} ${index}`);
      assert.equal(contourOf(hand).points.length, 16);
      const after = hand.sample(20);
      for (let i = 0; i < after.length; i += 2) {
        let nearest = Infinity;
        for (let k = 0; k < before.length; k += 2) nearest = Math.min(nearest, Math.hypot((after[i] ?? 0) - (before[k] ?? 0), (after[i + 1] ?? 0) - (before[k + 1] ?? 0)));
        assert.ok(nearest < 1, `${name} ${index}: on the curve, as closely as 2000 points tell`);
      }
    }
  }
});

test("a contour that came with many points gets one more and one fewer, and a point where it is asked for", () => {
  const hand = new Hand("blob-16");
  const points = Array.from({ length: 300 }, (_, i) => ({ x: i, y: 10 * Math.sin(i / 9), kind: "smooth", in: { dx: 0, dy: 0 }, out: { dx: 0, dy: 0 } }) as const);
  const open = (): void => hand.editor.dispatch({ name: "Open", apply: (curve) => ({ ...curve, contours: [{ ...contourOf(hand), closed: false, points }] }) });
  for (const count of [301, 299]) {
    open();
    resample(hand.editor, count);
    assert.equal(contourOf(hand).points.length, count);
  }
  open();
  insertAt(hand.editor, 0, 7.5);
  assert.equal(contourOf(hand).points.length, 301);
});

test("commands are counted, not letters", () => {
  assert.equal(commandsOf("M0 0l1 1 2-2.5.5 3h1 2zM1e-3 2A40 40 0 0 1 90 50 40 40 0 0 1 10 50"), 1 + 3 + 2 + 1 + 1 + 2);
});
