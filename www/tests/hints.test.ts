import assert from "node:assert/strict";
import { test } from "node:test";
import { curveSamples } from "../src/document/curve/samples.ts";
import type { EditorState, Target } from "../src/editor/editor.ts";
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
