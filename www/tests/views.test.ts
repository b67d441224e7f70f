import assert from "node:assert/strict";
import { test } from "node:test";
import { fitted, panned, resized, toScreen, zoomedAt, type StageBox } from "../src/editor/pointer/camera.ts";
import { contoursOfPath, Hand } from "./harness.ts";

const desk: StageBox = { left: 40, top: 48, width: 936, height: 720 };
const phone: StageBox = { left: 0, top: 48, width: 390, height: 655 };
const halfPhone: StageBox = { ...phone, height: 310 };
const box = { minX: 240, minY: 140, maxX: 560, maxY: 460 };

/** How far the box stays from the stage's sides, the least of all four; negative where it is cut off. */
function room(view: Parameters<typeof toScreen>[0], stage: StageBox): number {
  const [first, last] = [toScreen(view, stage, { x: box.minX, y: box.minY }), toScreen(view, stage, { x: box.maxX, y: box.maxY })];
  return Math.min(first.x, first.y, stage.width - last.x, stage.height - last.y);
}

test("what was fitted stays in sight on a stage of another size, and comes back to where it was", () => {
  for (const stage of [desk, phone]) {
    const view = fitted(box, stage, 1);
    const small = resized(view, halfPhone);
    assert.ok(room(view, stage) >= 24 && room(small, halfPhone) >= 24, `${room(small, halfPhone)} px`);
    assert.deepEqual(resized(small, stage), view);
  }
});

test("what is fitted on a phone lies between the zoom box above and the tools with two lines of hint below", () => {
  for (const stage of [phone, { ...phone, width: 320, height: 373 }]) {
    const view = fitted(box, stage, 1);
    assert.ok(toScreen(view, stage, { x: box.minX, y: box.minY }).y >= 64 - 1e-9);
    assert.ok(toScreen(view, stage, { x: box.maxX, y: box.maxY }).y <= stage.height - 112 + 1e-9);
  }
});

test("a view that somebody has moved stays where it was put", () => {
  const moved = panned(fitted(box, desk, 1), 30, 0);
  assert.equal(resized(moved, phone), moved);
  const zoomed = zoomedAt(fitted(box, desk, 1), desk, { x: 10, y: 10 }, 2, null);
  assert.equal(resized(zoomed, phone), zoomed);
});

test("each mode is looked at from where it was left", () => {
  const { editor } = new Hand("heart");
  const own = { zoom: 3, x: 380, y: 250 };
  editor.patch({ view: own });
  editor.patch({ mode: "trace" });
  editor.patch({ view: { zoom: 0.5, x: 1024, y: 1024 } });
  editor.patch({ mode: "fit" });
  editor.patch({ mode: "curve" });
  assert.deepEqual(editor.state.value.view, own);
  editor.patch({ mode: "trace" });
  assert.deepEqual(editor.state.value.view, { zoom: 0.5, x: 1024, y: 1024 });
});

test("a drawing that came with a file opened in another mode is in sight when it is first looked at", () => {
  const { editor } = new Hand("heart");
  editor.patch({ stage: desk });
  editor.setState({ ...editor.getState(), mode: "trace", view: { zoom: 0.3, x: 4000, y: 4000 } });
  editor.patch({ mode: "curve" });
  const { view, curve } = editor.state.value;
  for (const point of curve.contours[0]?.points ?? []) {
    const { x, y } = toScreen(view, desk, point);
    assert.ok(x > 0 && y > 0 && x < desk.width && y < desk.height, `${x}, ${y}`);
  }
});

test("what is chosen fills the stage: a contour as a whole, or a point with the segments beside it", async () => {
  const { editor, curve } = new Hand("heart");
  const { stage } = editor.state.value;
  const seen = async (points: readonly number[]): Promise<{ x: number; y: number }[]> => {
    editor.patch({ selection: { points: points.map((index) => ({ contour: 0, index })), handle: null } });
    editor.actions.run("zoom-chosen");
    await Promise.all(editor.loading);
    const { view } = editor.state.value;
    return (curve.contours[0]?.points ?? []).map((point) => toScreen(view, stage, point));
  };
  const inside = ({ x, y }: { x: number; y: number }): boolean => x >= 0 && y >= 0 && x <= stage.width && y <= stage.height;
  const all = curve.contours[0]?.points.map((_, index) => index) ?? [];
  const whole = await seen(all);
  assert.ok(whole.every(inside));
  const zoomed = editor.state.value.view.zoom;
  const near = await seen([1]);
  assert.ok([0, 1, 2].every((index) => inside(near[index] ?? { x: NaN, y: NaN })) && editor.state.value.view.zoom > zoomed);
});

/** Pixels across that Chromium still draws in milliseconds; of ten times as many the outlines take it seconds. */
const drawable = 4e6;

test("the wheel brings nobody so near to a drawing that browsers take seconds for it, and still near enough for its parts", () => {
  for (const size of [1e-6, 1, 320, 1e5, 1e6, 2e7, 2e9]) {
    const all = { minX: -size / 2, minY: 0, maxX: size / 2, maxY: size / 3 };
    const { zoom } = zoomedAt(fitted(all, desk), desk, { x: 10, y: 10 }, Infinity, all);
    assert.ok(zoom * size <= drawable * (1 + 1e-9), `${size} is ${zoom * size} px`);
    assert.ok(zoom * size >= 16_000 * (1 - 1e-9) || zoom === 1e9, `${size} is only ${zoom * size} px`);
  }
});

test("a speck that is chosen is shown no nearer than the drawing that it is a part of can be drawn", async () => {
  const { editor } = new Hand("heart");
  editor.dispatch({ name: "Paste", apply: (curve) => ({ ...curve, contours: [...curve.contours, ...contoursOfPath("M400 300h0.00002v0.00001z")] }) });
  const speck = editor.state.value.curve.contours.length - 1;
  editor.patch({ selection: { points: [0, 1, 2].map((index) => ({ contour: speck, index })), handle: null } });
  editor.actions.run("zoom-chosen");
  await Promise.all(editor.loading);
  const { view, curve } = editor.state.value;
  const xs = curve.contours.flatMap(({ points }) => points.map(({ x }) => x));
  assert.ok(view.zoom * (Math.max(...xs) - Math.min(...xs)) <= drawable);
  assert.ok(view.zoom > 64, "as near as it can be");
});
