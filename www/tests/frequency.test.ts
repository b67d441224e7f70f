import assert from "node:assert/strict";
import { test } from "node:test";
import { rootsOf } from "../src/document/curve/roots.ts";
import type { Contour, PointRef } from "../src/document/document.ts";
import { loadCurve } from "../src/editor/curve/edits.ts";
import { setFamily, setOmega } from "../src/editor/curve/family-edits.ts";
import { contoursOfPath, Hand } from "./harness.ts";

/** Frequencies of what is chosen. */

const halfTurns = "M0 0a50 50 0 0 1 100 0";
/** A half circle, a cubic, a line: π, 0 and 0. */
const mixed = `${halfTurns}C120 40 60 90 0 200z`;

function opened(...paths: readonly string[]): Hand {
  const hand = new Hand("circle-2");
  loadCurve(hand.editor, "Open", { ...hand.curve, contours: paths.flatMap((path) => contoursOfPath(path)) });
  return hand;
}

function contourOf(hand: Hand, index = 0): Contour {
  const contour = hand.curve.contours[index];
  assert.ok(contour !== undefined, `no contour ${index}`);
  return contour;
}

function choose(hand: Hand, ...points: readonly (readonly [contour: number, index: number])[]): void {
  const refs = points.map(([contour, index]): PointRef => ({ contour, index }));
  hand.editor.patch({ selection: { points: refs, handle: null } });
}

test("a frequency goes to the segments whose two ends are chosen; all others keep their own, and Undo brings it back", () => {
  const hand = opened(mixed, `${halfTurns}z`);
  const before = hand.curve;
  const own = contourOf(hand).omega ?? [];
  assert.ok(new Set(own).size > 1, "segments of several frequencies");
  choose(hand, [0, 1], [0, 2]);
  setOmega(hand.editor, hand.editor.state.value.selection, 1.25);
  assert.deepEqual(contourOf(hand).omega, own.map((each, segment) => (segment === 1 ? 1.25 : each)));
  assert.equal(contourOf(hand, 1), before.contours[1]);
  assert.equal(hand.curve.omega, before.omega);
  hand.editor.actions.run("undo");
  assert.deepEqual(hand.curve, before);
});

test("with one point chosen, its contour gets the frequency; with nothing chosen, the drawing does", () => {
  const hand = opened(mixed, mixed);
  const second = contourOf(hand, 1);
  choose(hand, [0, 1]);
  setOmega(hand.editor, hand.editor.state.value.selection, 0.5);
  assert.deepEqual(contourOf(hand).omega, second.omega?.map(() => 0.5));
  assert.equal(contourOf(hand, 1), second);
  setOmega(hand.editor, hand.editor.state.value.selection, "auto");
  assert.equal(contourOf(hand).omega, undefined, "that of the drawing, which is automatic");
  choose(hand);
  setOmega(hand.editor, hand.editor.state.value.selection, 0.7);
  assert.equal(hand.curve.omega, 0.7);
  assert.deepEqual(hand.curve.contours.map(({ omega }) => omega), [undefined, undefined]);
});

test("one of several interpolating contours has a frequency of its own, and gives it back for an automatic one", () => {
  const round = `${halfTurns}a50 50 0 0 1 -50 50z`;
  const hand = opened(round, round);
  setFamily(hand.editor, "interpolating");
  choose(hand);
  setOmega(hand.editor, hand.editor.state.value.selection, "auto");
  const [first, second] = [contourOf(hand), contourOf(hand, 1)];
  choose(hand, [0, 0], [0, 1]);
  setOmega(hand.editor, hand.editor.state.value.selection, 0.4);
  assert.equal(rootsOf(hand.curve, contourOf(hand))[1]?.im, 0.4);
  assert.equal(contourOf(hand, 1), second);
  setOmega(hand.editor, hand.editor.state.value.selection, "auto");
  assert.deepEqual(contourOf(hand), first);
});
