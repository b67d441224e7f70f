import assert from "node:assert/strict";
import { test } from "node:test";
import { curveSamples } from "../src/document/curve/samples.ts";
import type { EditorState, Target } from "../src/editor/editor.ts";
import { framing } from "../src/editor/curve/on-demand.ts";
import { hintFor } from "../src/editor/hint.ts";
import { Hand } from "./harness.ts";

/** Whoever has no mouse is told nothing of clicks and of keys that are held. */
const ofMouse = /click|\balt\b|shift|enter\b|esc\b/iu;

const targets: readonly Target[] = [
  { kind: "empty" },
  { kind: "point", point: { contour: 0, index: 1 } },
  { kind: "handle", handle: { contour: 0, index: 1, side: "out" } },
  { kind: "curve", contour: 0, t: 0.5, x: 0, y: 0 },
];

function hint(sample: string, state: Partial<EditorState>): string {
  const hand = new Hand(sample);
  hand.editor.patch({ hint: "", ...state });
  return hintFor(hand.editor.state.value);
}

for (const sample of ["heart", "circle-8", "blob-16"]) {
  test(`a finger is told what a finger can do, and a mouse of its clicks: ${sample}`, () => {
    for (const tool of ["select", "pen"] as const) {
      for (const hover of targets) {
        const touch = hint(sample, { tool, hover, touch: true });
        assert.doesNotMatch(touch, ofMouse, `${tool}, ${hover.kind}`);
        assert.notEqual(touch, "", `${tool}, ${hover.kind}`);
      }
    }
    assert.match(hint(sample, { hover: { kind: "curve", contour: 0, t: 0.5, x: 0, y: 0 }, touch: false }), /Double-click/u);
  });
}

test("what samples say holds for fingers, too", () => {
  for (const { id, note } of curveSamples) assert.doesNotMatch(note, ofMouse, id);
});

test("while the pen pulls handles the hint is about handles, and no longer than that", () => {
  for (const kind of ["mouse", "touch"] as const) {
    const hand = new Hand("heart");
    hand.run("clear").run("tool-pen");
    hand.kind = kind;
    hand.wait().moveTo(100, 100).press().moveTo(150, 130);
    assert.match(hintFor(hand.editor.state.value), /shape the handles/u);
    if (kind === "touch") assert.doesNotMatch(hintFor(hand.editor.state.value), ofMouse);
    hand.release();
    assert.doesNotMatch(hintFor(hand.editor.state.value), /shape/u);
    hand.wait().moveTo(300, 100).press().moveTo(350, 130);
    hand.input.cancel();
    assert.doesNotMatch(hintFor(hand.editor.state.value), /shape/u, "after Esc");
  }
});

const now = (hand: Hand): string => hintFor(hand.editor.state.value);

test("what the hint promises of choosing holds: a double-click for a shape, E for its contour, a drag for all that is chosen, Shift for more", async () => {
  await framing.load();
  const hand = new Hand("glyph");
  hand.editor.patch({ hint: "" });
  assert.match(now(hand), /Double-click inside a shape for all of it/u);
  const { x, y } = hand.point(0);
  hand.doubleClick(x + 30, y + 200);
  assert.equal(hand.selected.length, hand.curve.contours.reduce((sum, { points }) => sum + points.length, 0), "with the hole, which is a part of it");
  hand.run("select-none");
  hand.click(x, y).wait().moveTo(5, 5);
  assert.equal(now(hand), "Alt-drag a handle to make a cusp. Press E to select the whole contour.");
  hand.run("select-contour");
  assert.equal(hand.selected.length, hand.curve.contours[0]?.points.length);
  assert.equal(now(hand), "Drag a selected point to move them all. Shift-click to add or remove points.");
  const before = hand.curve.contours[0]?.points ?? [];
  hand.drag({ x, y }, 30, 20);
  assert.deepEqual(hand.curve.contours[0]?.points.map((point, i) => [point.x - (before[i]?.x ?? 0), point.y - (before[i]?.y ?? 0)]), before.map(() => [30, 20]));
  hand.held = { shift: true, alt: false, mod: false };
  hand.click(x + 30, y + 20);
  assert.equal(hand.selected.length, before.length - 1);
});

test("each tool says what a press would do, and so does what lies under the pointer", () => {
  const point = (index: number): Target => ({ kind: "point", point: { contour: 0, index } });
  const curve = (t: number): Target => ({ kind: "curve", contour: 0, t, x: 0, y: 0 });
  const alt = { modifiers: { shift: false, alt: true, mod: false } };
  const all: readonly (readonly [string, Partial<EditorState>, RegExp])[] = [
    ["heart", { tool: "hand" }, /^Drag to pan\. Press V to edit again\.$/u],
    ["heart", { tool: "draw" }, /^Drag to draw freehand\./u],
    ["heart", { tool: "pen" }, /^Click to place the first point, or drag to pull its handles\.$/u],
    ["heart", { hover: point(0) }, /^Point 1 of 6, cusp, .*: drag to move, double-click for smooth$/u],
    ["circle-8", { hover: point(0) }, /^Point 1 of 8, symmetric, .* double-click for a cusp$/u],
    ["circle-8", { hover: point(0), ...alt }, /drag to pull out new handles$/u],
    ["sine", { hover: point(0) }, /drag to move, or onto another end to join$/u],
    ["blob-16", { hover: point(0) }, /drag to move; only nearby segments change$/u],
    ["circle-8", { hover: { kind: "handle", handle: { contour: 0, index: 1, side: "out" } } }, /^Leaving handle of point 2 .*: drag to turn, Alt to break, Shift for 15° steps$/u],
    ["circle-8", { hover: { kind: "handle", handle: { contour: 0, index: 1, side: "in" } }, ...alt }, /drag to break it into a cusp$/u],
    ["circle-8", { hover: curve(0.5) }, /^Drag to bend the curve, Alt-drag to move this segment\. Double-click to insert a point without changing the curve\.$/u],
    ["glyph", { hover: curve(0.5) }, /^Drag to move this line, Alt-drag to bend it\./u],
    ["blob-16", { hover: curve(0.5) }, /^Drag to move this segment\. Double-click to insert a point; you see how far the curve moves\.$/u],
    ["blob-16", {}, /^Drag a point: only nearby segments change\. Drag across empty space to select\.$/u],
  ];
  for (const [sample, state, says] of all) assert.match(hint(sample, state), says);
});

test("whoever moves points by clicks is told of the second click, and not of drags", () => {
  const hand = new Hand("circle-8");
  hand.editor.setSettings({ moveByClicks: true });
  hand.editor.patch({ hint: "" });
  const { x, y } = hand.point(2);
  hand.click(x, y).wait().moveTo(5, 5);
  assert.equal(now(hand), "Click where it should go.");
  hand.click(x + 40, y + 30).wait().moveTo(5, 5);
  assert.deepEqual([hand.point(2).x, hand.point(2).y], [x + 40, y + 30]);
  hand.run("select-none");
  hand.moveTo(6, 6);
  assert.doesNotMatch(now(hand), /where it should go/u);
});
