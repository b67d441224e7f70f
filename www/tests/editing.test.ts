import assert from "node:assert/strict";
import { test } from "node:test";
import type { CurveDocument } from "../src/document/document.ts";
import { loadCurve } from "../src/editor/curve/edits.ts";
import { Hand, largestDistance } from "./harness.ts";

/** Coordinates of a few hundred units: an ulp is 6e-14, a dozen roundings stay below this. */
const rounding = 2e-12;

function radiusError(points: Float64Array): number {
  let worst = 0;
  for (let i = 0; i < points.length; i += 2) worst = Math.max(worst, Math.abs(Math.hypot((points[i] ?? 0) - 400, (points[i + 1] ?? 0) - 300) - 160));
  return worst / 160;
}

test("the landing sample is a circle from two points", () => {
  const hand = new Hand("circle-2");
  assert.equal(hand.curve.contours[0]?.points.length, 2);
  assert.ok(radiusError(hand.sample(2000)) < 1e-14);
});

test("dragging either point of the two-point circle leaves an exact ellipse", () => {
  const hand = new Hand("circle-2");
  hand.drag(hand.point(0), 70, -40);
  hand.drag(hand.point(1), -30, 55);
  // An ellipse c + a cos θ + b sin θ: opposite points mirror each other at the centre.
  const points = hand.sample(1000);
  const centre = { x: (hand.point(0).x + hand.point(1).x) / 2, y: (hand.point(0).y + hand.point(1).y) / 2 };
  for (let i = 0; i < 500; i += 1) {
    assert.ok(Math.abs((points[2 * i] ?? 0) + (points[2 * i + 1000] ?? 0) - 2 * centre.x) < rounding);
    assert.ok(Math.abs((points[2 * i + 1] ?? 0) + (points[2 * i + 1001] ?? 0) - 2 * centre.y) < rounding);
  }
});

test("a press that does not move is a click and moves nothing", () => {
  const hand = new Hand("circle-8");
  const before = hand.curve;
  const { x, y } = hand.point(3);
  hand.wait().moveTo(x, y).press().moveTo(x + 2, y + 1).release();
  assert.equal(hand.curve, before);
  assert.deepEqual(hand.selected, ["0:3"]);
  assert.equal(hand.editor.state.value.canUndo, false);
});

test("a drag is one entry, and undo brings back values and selection", () => {
  const hand = new Hand("circle-8");
  const before = hand.editor.getState().curve;
  hand.click(hand.point(1).x, hand.point(1).y).drag(hand.point(1), 20, 10);
  assert.equal(hand.point(1).x, (before.contours[0]?.points[1]?.x ?? 0) + 20);
  hand.run("undo");
  assert.deepEqual(hand.curve, before);
  assert.deepEqual(hand.selected, ["0:1"]);
  assert.equal(hand.editor.state.value.canUndo, false);
});

test("a symmetric point's handles stay equal and opposite", () => {
  const hand = new Hand("circle-8");
  const place = hand.point(2);
  hand.click(place.x, place.y).drag(hand.handle(2, "out"), 30, 20);
  const point = hand.point(2);
  assert.deepEqual([point.x, point.y], [place.x, place.y]);
  assert.ok(Math.abs(point.in.dx + point.out.dx) + Math.abs(point.in.dy + point.out.dy) < rounding);
});

test("Alt breaks a handle while it is held, and letting go of it first links the handles again", () => {
  const hand = new Hand("circle-8");
  const before = hand.point(2);
  hand.click(before.x, before.y);
  const grip = hand.handle(2, "out");
  hand.wait().moveTo(grip.x, grip.y).press().moveTo(grip.x, grip.y + 70);
  hand.keys({ alt: true });
  assert.equal(hand.point(2).kind, "cusp");
  assert.deepEqual(hand.point(2).in, before.in);
  hand.keys({});
  assert.equal(hand.point(2).kind, "symmetric");
  assert.equal(hand.point(2).in.dy, -hand.point(2).out.dy);
  hand.keys({ alt: true }).release();
  assert.equal(hand.point(2).kind, "cusp");
  assert.deepEqual(hand.point(2).in, before.in);
});

test("double-clicking a cusp makes it smooth again", () => {
  const hand = new Hand("circle-8");
  const { x, y } = hand.point(2);
  hand.click(x, y).keys({ alt: true }).drag(hand.handle(2, "out"), 0, 70).keys({});
  hand.doubleClick(x, y);
  const point = hand.point(2);
  assert.notEqual(point.kind, "cusp");
  const cross = point.in.dx * point.out.dy - point.in.dy * point.out.dx;
  assert.ok(Math.abs(cross) < 1e-9 * Math.hypot(point.in.dx, point.in.dy) * Math.hypot(point.out.dx, point.out.dy));
});

test("a drag and a press at its first place soon after are not a double-click", () => {
  const hand = new Hand("circle-8");
  const before = hand.point(2);
  hand.click(before.x, before.y).drag(hand.handle(2, "out"), 30, 20);
  hand.editor.undo();
  const grip = hand.handle(2, "out");
  hand.moveTo(grip.x, grip.y).press().moveTo(grip.x, grip.y + 40).release();
  assert.equal(hand.point(2).out.dy, before.out.dy + 40);
});

test("a press right on a point means the point, however short its handles", () => {
  const hand = new Hand("net-64");
  const { x, y } = hand.point(5);
  hand.click(x, y).drag({ x, y }, 20, 10);
  assert.deepEqual([hand.point(5).x, hand.point(5).y], [x + 20, y + 10]);
});

test("Shift holds points to the compass and handles to steps of 15°", () => {
  const hand = new Hand("circle-8");
  const { x, y } = hand.point(3);
  hand.keys({ shift: true }).drag(hand.point(3), 80, 22);
  assert.deepEqual([hand.point(3).x - x, hand.point(3).y - y], [80, 0]);
  hand.run("undo").drag(hand.point(3), 60, 55);
  assert.ok(Math.abs(Math.abs(hand.point(3).x - x) - Math.abs(hand.point(3).y - y)) < rounding);
  hand.keys({}).run("undo").click(x, y).keys({ shift: true }).drag(hand.handle(3, "out"), 37, -12);
  const { dx, dy } = hand.point(3).out;
  const steps = (Math.atan2(dy, dx) * 12) / Math.PI;
  assert.ok(Math.abs(steps - Math.round(steps)) < 1e-9);
});

test("double-clicking the curve inserts a point without moving the curve", () => {
  const hand = new Hand("circle-8");
  const before = hand.sample(4000);
  const [x = 0, y = 0] = hand.sample(800).subarray(74, 76);
  hand.doubleClick(x, y);
  assert.equal(hand.curve.contours[0]?.points.length, 9);
  assert.deepEqual(hand.selected, ["0:1"]);
  assert.ok(largestDistance(before, hand.sample(4000)) < rounding);
});

test("delete heals a circle's gap to a thousandth of its diameter, and undo is exact", () => {
  const hand = new Hand("circle-8");
  const before = hand.editor.getState().curve;
  hand.click(hand.point(4).x, hand.point(4).y).run("delete");
  assert.equal(hand.curve.contours[0]?.points.length, 7);
  assert.equal(hand.curve.contours[0]?.closed, true);
  assert.ok(radiusError(hand.sample(2000)) < 2e-3);
  hand.run("undo");
  assert.deepEqual(hand.curve, before);
});

test("deleting stops at two points and says why", () => {
  const hand = new Hand("circle-8");
  for (let left = 8; left > 2; left -= 1) {
    hand.click(hand.point(left - 1).x, hand.point(left - 1).y).run("delete");
    assert.equal(hand.curve.contours[0]?.points.length, left - 1);
  }
  hand.click(hand.point(0).x, hand.point(0).y).run("delete");
  assert.equal(hand.curve.contours[0]?.points.length, 2);
  assert.match(hand.editor.state.value.hint, /two points/);
});

test("Shift+Delete opens a contour at the point that goes, and the rest keeps its shape", () => {
  const hand = new Hand("circle-8");
  hand.click(hand.point(4).x, hand.point(4).y).run("delete-open");
  const contour = hand.curve.contours[0];
  assert.equal(contour?.points.length, 7);
  assert.equal(contour?.closed, false);
  assert.ok(radiusError(hand.sample(2000)) < 1e-13);
});

test("levels double the points of the same curve, and going down gives the first points back", () => {
  const hand = new Hand("circle-8");
  const [before, first] = [hand.sample(3200), hand.curve.contours[0]?.points];
  hand.run("level-up").run("level-up");
  assert.equal(hand.curve.contours[0]?.points.length, 32);
  assert.ok(largestDistance(before, hand.sample(3200)) < rounding);
  hand.run("level-down").run("level-down");
  const points = hand.curve.contours[0]?.points ?? [];
  assert.equal(points.length, 8);
  points.forEach((point, i) => {
    const old = first?.[i];
    assert.ok(old !== undefined && Math.abs(point.x - old.x) + Math.abs(point.out.dx - old.out.dx) < 1e-9);
  });
});

test("the marquee takes the points inside, arrows move them together, and one undo takes back the drag only", () => {
  const hand = new Hand("circle-8");
  hand.wait().moveTo(600, 290).press().moveTo(500, 400).moveTo(380, 480).release();
  assert.deepEqual(hand.selected, ["0:0", "0:1", "0:2"]);
  const before = [0, 1, 2, 3].map((i) => hand.point(i));
  for (let i = 0; i < 3; i += 1) hand.editor.actions.run("nudge-right");
  hand.editor.actions.run("nudge-down-far");
  const nudged = [0, 1, 2].map((i) => hand.point(i));
  nudged.forEach((point, i) => assert.deepEqual([point.x, point.y], [(before[i]?.x ?? 0) + 3, (before[i]?.y ?? 0) + 10]));
  assert.deepEqual(hand.point(3), before[3]);
  hand.drag(hand.point(1), 12, 8);
  assert.ok([0, 1, 2].every((i) => Math.abs(hand.point(i).x - (nudged[i]?.x ?? 0) - 12) < rounding));
  hand.run("undo");
  assert.deepEqual([0, 1, 2].map((i) => hand.point(i)), nudged);
});

test("Esc during a drag leaves everything as it was before the press", () => {
  const hand = new Hand("circle-8");
  const before = hand.curve;
  hand.wait().moveTo(hand.point(1).x, hand.point(1).y).press().moveTo(500, 200);
  assert.notEqual(hand.curve, before);
  hand.input.cancel();
  assert.equal(hand.curve, before);
  hand.moveTo(450, 220).release();
  assert.equal(hand.curve, before);
  assert.equal(hand.editor.state.value.canUndo, false);
});

test("undo during a drag takes back the drag alone, and deleting the dragged point does no harm", () => {
  const hand = new Hand("circle-8");
  hand.drag(hand.point(5), 10, 10);
  const after = hand.curve;
  hand.wait().moveTo(hand.point(1).x, hand.point(1).y).press().moveTo(500, 200);
  hand.editor.undo();
  assert.equal(hand.curve, after);
  hand.input.cancel();
  hand.release().wait().moveTo(hand.point(1).x, hand.point(1).y).press().moveTo(500, 200);
  hand.editor.actions.run("delete");
  hand.moveTo(480, 190).release();
  assert.ok(hand.curve.contours[0]?.points.every((point) => Number.isFinite(point.x) && Number.isFinite(point.y)));
});

test("the pen draws what its rubber band showed, closes on the first point, and each point is one entry", () => {
  const hand = new Hand();
  hand.editor.patch({ tool: "pen" });
  hand.click(100, 100).click(300, 100);
  hand.wait().moveTo(300, 300).press().moveTo(260, 340).release();
  hand.wait().moveTo(100, 300);
  const rubber = hand.editor.state.value.sketch.rubber;
  assert.deepEqual(rubber?.contour.points[0]?.x, 300);
  hand.click(100, 100);
  const contour = hand.curve.contours[0];
  assert.equal(contour?.closed, true);
  assert.equal(contour?.points.length, 3);
  assert.equal(contour?.points[2]?.kind, "symmetric");
  for (let i = 0; i < 4; i += 1) hand.run("undo");
  assert.deepEqual(hand.curve.contours, []);
});

test("a document that the engine refuses is not taken, and the old one stays", () => {
  const hand = new Hand("circle-8");
  const before = hand.curve;
  hand.editor.dispatch({ name: "Nonsense", apply: (curve) => ({ ...curve, omega: 7 }) });
  assert.equal(hand.curve, before);
  assert.equal(hand.editor.notices.value?.kind, "error");
});

test("going down a level that finer edits were made on shows the change first, and makes it when asked again", () => {
  const hand = new Hand("circle-8");
  hand.run("level-up");
  hand.drag(hand.point(1), 6, 4);
  const finer = hand.curve;
  hand.run("level-down");
  assert.equal(hand.curve, finer);
  assert.equal(hand.editor.state.value.sketch.proposal?.level, 0);
  const notice = hand.editor.notices.value;
  assert.ok(notice?.kind === "toast" && notice.actionId === "apply-level");
  hand.run("apply-level");
  assert.equal(hand.curve.level, 0);
  assert.equal(hand.curve.contours[0]?.points.length, 8);
  assert.equal(hand.editor.state.value.sketch.proposal, null);
  hand.run("undo");
  assert.equal(hand.curve, finer);
});

test("the pen goes on from either end of an open contour", () => {
  const hand = new Hand("sine");
  const [first, count] = [hand.point(0), hand.curve.contours[0]?.points.length ?? 0];
  hand.editor.patch({ tool: "pen" });
  hand.click(first.x, first.y).click(first.x - 60, first.y - 80);
  const contour = hand.curve.contours[0];
  assert.equal(hand.curve.contours.length, 1);
  assert.equal(contour?.points.length, count + 1);
  assert.deepEqual([hand.point(count - 1).x, hand.point(count).x], [first.x, first.x - 60]);
});

test("DM-034 ten thousand paths are chosen, moved and taken back, exactly", () => {
  const hand = new Hand("circle-2");
  const [circle] = hand.curve.contours;
  assert.ok(circle);
  const at = (i: number): CurveDocument["contours"][number] => ({ ...circle, points: circle.points.map((point) => ({ ...point, x: point.x + 7 * (i % 100), y: point.y + 7 * Math.floor(i / 100) })) });
  loadCurve(hand.editor, "Open", { ...hand.curve, contours: Array.from({ length: 10_000 }, (_, i) => at(i)) });
  const before = hand.curve;
  hand.run("select-all");
  assert.equal(hand.selected.length, 20_000);
  hand.drag(hand.point(0, 5050), 12, -5);
  hand.curve.contours.forEach((contour, i) => {
    const old = before.contours[i]?.points[0];
    assert.ok(Math.abs((contour.points[0]?.x ?? NaN) - (old?.x ?? NaN) - 12) < 1e-9, `path ${i}`);
  });
  hand.run("undo");
  assert.equal(hand.curve, before, "the very document of before");
});

test("a path of one point that is given up takes nothing with it that was done since", () => {
  for (const since of [false, true]) {
    const hand = new Hand("circle-2");
    const { editor, curve } = hand;
    hand.run("tool-pen");
    hand.click(100, 100);
    const place = hand.point(0, 1);
    if (since) editor.dispatch({ name: "Move", apply: (now) => ({ ...now, contours: now.contours.map((contour) => ({ ...contour, points: contour.points.map((point) => ({ ...point, x: point.x + 8 })) })) }) });
    hand.input.cancel();
    assert.equal(hand.curve.contours.length, 1, "the lone point is gone");
    assert.equal(hand.point(0).x, (curve.contours[0]?.points[0]?.x ?? 0) + (since ? 8 : 0));
    assert.equal(editor.state.value.canUndo, since, "where nothing else was done, nothing is to be undone");
    if (!since) continue;
    hand.run("undo");
    assert.equal(hand.point(0, 1).x, place.x + 8, "one step back it is there again");
  }
});
