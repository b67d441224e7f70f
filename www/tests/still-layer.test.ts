import assert from "node:assert/strict";
import { test } from "node:test";
import { initialState } from "../src/editor/initial-state.ts";
import { panned, toScreen, zoomedAt } from "../src/editor/pointer/camera.ts";
import { shiftBetween, uncovered } from "../src/render/trace/still-layer.ts";

/** What was drawn is laid down where the paper has moved to, and the rest is drawn anew. */

const stage = { left: 0, top: 0, width: 641, height: 480 };
const state = { ...initialState, stage };

test("a picture of one view, moved and made larger, has every place where another view has it", () => {
  const from = { zoom: 1.3, x: 412.25, y: 300 };
  for (const ratio of [1, 1.5, 2]) {
    for (const to of [panned(from, 17, -4), zoomedAt(from, stage, { x: 100, y: 77 }, 1.9, null), zoomedAt(from, stage, { x: 600, y: 3 }, 0.4, null)]) {
      const { x, y, scale } = shiftBetween({ state, ratio }, from, to);
      for (const place of [{ x: 0, y: 0 }, { x: 500, y: -33 }]) {
        const [before, after] = [toScreen(from, stage, place), toScreen(to, stage, place)];
        const off = Math.hypot(x + scale * ratio * before.x - ratio * after.x, y + scale * ratio * before.y - ratio * after.y);
        // Coordinates of hundreds, some roundings.
        assert.ok(off < 1e-11, `${off}`);
      }
    }
  }
});

test("what a moved picture leaves free is drawn anew, every pixel of it once and no pixel that it covers whole", () => {
  const [width, height] = [40, 30];
  for (const shift of [{ x: 3, y: -4, scale: 1 }, { x: -7, y: 0, scale: 1 }, { x: 2.5, y: 3.25, scale: 0.7 }, { x: -9, y: -9, scale: 1.6 }, { x: 50, y: 0, scale: 1 }, { x: 0, y: 0, scale: 1 }]) {
    const boxes = uncovered(width, height, shift);
    for (let x = 0; x < width; x += 1) {
      for (let y = 0; y < height; y += 1) {
        const times = boxes.filter((box) => x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height).length;
        const covered = x >= shift.x && x + 1 <= shift.x + shift.scale * width && y >= shift.y && y + 1 <= shift.y + shift.scale * height;
        assert.equal(times, covered ? 0 : 1, `${x}, ${y} of ${JSON.stringify(shift)}`);
      }
    }
  }
});
