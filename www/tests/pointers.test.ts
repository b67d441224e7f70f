import assert from "node:assert/strict";
import { test } from "node:test";
import { chordOf } from "../src/editor/actions/keymap.ts";
import { parseRoute, printRoute } from "../src/editor/route.ts";
import { constrained, snapHandle, snapPlace, turnedBySteps } from "../src/editor/pointer/snapping.ts";
import { fitted, toPage, toScreen, zoomedAt } from "../src/editor/pointer/camera.ts";
import type { PointerRecord } from "../src/editor/pointer/pointer-record.ts";
import { nothingSelected } from "../src/document/document.ts";
import { Hand, spread, touch } from "./harness.ts";

const none = { shift: false, alt: false, mod: false };

test("two fingers pinch about their middle, and edit nothing", () => {
  const hand = new Hand("circle-8");
  const { input, editor } = hand;
  const before = editor.state.value;
  const anchor = toPage(before.view, before.stage, { x: 300, y: 300 });
  spread(input, 0);
  input.up(touch(1, 240, 300, 400));
  input.up(touch(2, 360, 300, 410));
  const { view, stage, curve } = editor.state.value;
  assert.ok(Math.abs(view.zoom / before.view.zoom - 3) < 1e-9);
  const now = toScreen(view, stage, anchor);
  assert.ok(Math.hypot(now.x - 300, now.y - 300) < 1e-6);
  assert.equal(curve, before.curve);
});

test("a tap with two fingers is undo, with three redo, and never a zoom", () => {
  const hand = new Hand("circle-8");
  hand.drag(hand.point(1), 20, 20);
  const { input, editor } = hand;
  const { view, curve } = editor.state.value;
  const tap = (fingers: number, from: number): void => {
    for (let id = 1; id <= fingers; id += 1) input.down(touch(id, 200 + 40 * id, 300, from + id));
    for (let id = 1; id <= fingers; id += 1) input.move(touch(id, 202 + 40 * id, 301, from + 30 + id));
    for (let id = 1; id <= fingers; id += 1) input.up(touch(id, 202 + 40 * id, 301, from + 60 + id));
  };
  tap(2, 5000);
  assert.notEqual(editor.state.value.curve, curve);
  assert.equal(editor.state.value.canUndo, false);
  tap(3, 6000);
  assert.equal(editor.state.value.curve, curve);
  assert.equal(editor.state.value.view, view);
});

test("a second finger that comes at once cancels what the first had begun; a late one is ignored while a point is dragged", () => {
  const hand = new Hand("circle-8");
  const { input, editor } = hand;
  const start = editor.state.value.curve;
  const { x, y } = toScreen(editor.state.value.view, editor.state.value.stage, hand.point(0));
  input.down(touch(1, x, y, 0));
  input.move(touch(1, x + 30, y, 50));
  input.flush();
  assert.notEqual(editor.state.value.curve, start);
  input.down(touch(2, x + 90, y, 100));
  assert.equal(editor.state.value.curve, start);
  input.up(touch(1, x + 30, y, 500));
  input.up(touch(2, x + 90, y, 900));
  input.down(touch(1, x, y, 2000));
  input.move(touch(1, x + 30, y, 2100));
  input.flush();
  input.down(touch(2, x + 90, y, 2400));
  input.up(touch(2, x + 90, y, 2500));
  input.move(touch(1, x + 60, y, 2600));
  input.up(touch(1, x + 60, y, 2700));
  assert.ok(Math.abs(hand.point(0).x - (start.contours[0]?.points[0]?.x ?? 0) - 60) < 1e-9);
});

test("the middle button and the space bar pan with any tool, and the history does not hear of it", () => {
  const hand = new Hand("circle-8");
  const { input, editor } = hand;
  const from = toScreen(editor.state.value.view, editor.state.value.stage, { x: 400, y: 300 });
  const mouse = (x: number, y: number, button: number): PointerRecord => ({ id: 1, kind: "mouse", button, screen: { x, y }, modifiers: none, time: 0 });
  input.down(mouse(100, 100, 1));
  input.move(mouse(160, 130, 1));
  input.up(mouse(160, 130, 1));
  input.space(true);
  input.down(mouse(100, 100, 0));
  input.move(mouse(140, 120, 0));
  input.up(mouse(140, 120, 0));
  input.space(false);
  const to = toScreen(editor.state.value.view, editor.state.value.stage, { x: 400, y: 300 });
  assert.deepEqual([to.x - from.x, to.y - from.y], [100, 50]);
  assert.equal(editor.state.value.canUndo, false);
});

test("the hand stays a hand after the space bar", () => {
  const { input, editor } = new Hand("circle-8");
  for (const [tool, cursor] of [["hand", "grab"], ["select", "default"]] as const) {
    editor.patch({ tool });
    input.space(true);
    assert.equal(editor.state.value.cursor, "grab");
    input.space(false);
    assert.equal(editor.state.value.cursor, cursor);
  }
});

test("once a pen has been seen, fingers pan", () => {
  const hand = new Hand("circle-8");
  const { input, editor } = hand;
  const before = editor.state.value.curve;
  input.down({ ...touch(7, 10, 10, 0), kind: "pen" });
  input.up({ ...touch(7, 10, 10, 20), kind: "pen" });
  const { x, y } = toScreen(editor.state.value.view, editor.state.value.stage, hand.point(0));
  input.down(touch(1, x, y, 1000));
  input.move(touch(1, x + 40, y, 1100));
  input.up(touch(1, x + 40, y, 1200));
  assert.equal(editor.state.value.curve, before);
  assert.notEqual(editor.state.value.view.x, 400);
});

test("zooming keeps the document under the pointer, within its limits", () => {
  const stage = { left: 0, top: 0, width: 900, height: 700 };
  let view = { zoom: 1, x: 400, y: 300 };
  const at = { x: 123, y: 456 };
  const page = toPage(view, stage, at);
  for (let i = 0; i < 300; i += 1) view = zoomedAt(view, stage, at, view.zoom * 1.1, null);
  assert.equal(view.zoom, 64);
  const now = toScreen(view, stage, page);
  assert.ok(Math.hypot(now.x - at.x, now.y - at.y) < 1e-6);
  const whole = fitted({ minX: -5, minY: 0, maxX: 5, maxY: 80 }, stage, 20, 64);
  const corner = toScreen(whole, stage, { x: 5, y: 80 });
  assert.ok(corner.y <= 680 + 1e-9 && corner.x <= 880);
});

test("snapping draws to points first, then to columns and rows, and names what it drew to", () => {
  const { curve } = new Hand("circle-8");
  const moving = { points: [{ contour: 0, index: 0 }], handle: null };
  const onto = snapPlace(curve, moving, { x: 403, y: 458 }, 1, null);
  assert.equal(onto.to, "on point 3");
  assert.ok(Math.abs(onto.value.x - 400) < 1e-9 && Math.abs(onto.value.y - 460) < 1e-9);
  const level = snapPlace(curve, moving, { x: 300, y: 457 }, 1, null);
  assert.match(level.to ?? "", /level with point 3/);
  assert.equal(level.guides.length, 1);
  assert.equal(snapPlace(curve, moving, { x: 563, y: 303 }, 1, null).to, "level with point 5", "not to the dragged point's own old place");
  assert.deepEqual(snapPlace(curve, nothingSelected, { x: 331, y: 222 }, 1, 10).value, { x: 330, y: 220 });
  assert.equal(snapPlace(curve, moving, { x: 403, y: 458 }, 4, null).to, null, "6 px of the screen, at any zoom");
});

test("a handle is drawn into its point, straight with its partner, level and upright", () => {
  const point = { x: 0, y: 0, kind: "cusp" as const, in: { dx: -30, dy: -30 }, out: { dx: 30, dy: 26 } };
  assert.deepEqual(snapHandle(point, { dx: 3, dy: 2 }, point.in, 1).value, { dx: 0, dy: 0 });
  const straight = snapHandle(point, point.out, point.in, 1).value;
  assert.ok(Math.abs(straight.dx - straight.dy) < 1e-12 && straight.dx > 0);
  assert.equal(snapHandle(point, { dx: 50, dy: 4 }, null, 1).value.dy, 0);
  assert.equal(snapHandle(point, { dx: 50, dy: 14 }, null, 1).to, null);
});

test("constraints hold exactly", () => {
  assert.deepEqual(constrained(80, 22), { dx: 80, dy: 0 });
  assert.deepEqual(constrained(-3, 90), { dx: 0, dy: 90 });
  assert.deepEqual(constrained(-60, 55), { dx: -57.5, dy: 57.5 });
  assert.deepEqual(turnedBySteps({ dx: 0.3, dy: -40 }), { dx: 0, dy: -Math.hypot(0.3, 40) });
});

test("keys are named as they are printed", () => {
  assert.equal(chordOf({ key: "z", shift: true, alt: false, mod: true }), "Mod+Shift+Z");
  assert.equal(chordOf({ key: "?", shift: true, alt: false, mod: false }), "?");
  assert.equal(chordOf({ key: "}", shift: true, alt: false, mod: false }), "}");
  assert.equal(chordOf({ key: "Delete", shift: true, alt: false, mod: false }), "Shift+Delete");
  assert.equal(chordOf({ key: "ArrowUp", shift: false, alt: true, mod: false }), "Alt+ArrowUp");
});

test("routes are read and printed, and what is no route is none", () => {
  assert.deepEqual(parseRoute(""), { mode: "curve", sample: null });
  assert.deepEqual(parseRoute("#/fit?sample=fit-star"), { mode: "fit", sample: "fit-star" });
  assert.equal(printRoute({ mode: "fit", sample: "fit-star" }), "#/fit?sample=fit-star");
  assert.equal(parseRoute("#/nonsense"), null);
  assert.equal(parseRoute("#s=abc"), null);
});

test("over a point or a handle the cursor says what a press would do, and changes with Alt alone", () => {
  const hand = new Hand("circle-8");
  const cursor = (): string => hand.editor.state.value.cursor;
  hand.moveTo(hand.point(2).x, hand.point(2).y);
  assert.equal(cursor(), "move");
  hand.keys({ alt: true });
  assert.equal(cursor(), "crosshair");
  hand.keys({});
  assert.equal(cursor(), "move");
  hand.click(hand.point(2).x, hand.point(2).y);
  const end = hand.handle(2, "out");
  hand.moveTo(end.x, end.y).keys({ alt: true });
  assert.equal(cursor(), "alias");
  // Away from everything a key changes nothing.
  hand.keys({}).moveTo(400, 300).keys({ alt: true });
  assert.equal(cursor(), "default");
});
