import assert from "node:assert/strict";
import { test } from "node:test";
import { boxDiagonal, directedDistance, radiusError, useBrowser, type Demo, type Pair } from "./page.ts";

const { open } = useBrowser();

async function blob(t: Parameters<typeof open>[0]): Promise<Demo> {
  const demo = await open(t, "#/curve?sample=blob-16");
  await demo.withoutSnap();
  return demo;
}

function moves(a: readonly Pair[], b: readonly Pair[]): number[] {
  return a.map(([x, y], i) => Math.hypot(x - (b[i]?.[0] ?? NaN), y - (b[i]?.[1] ?? NaN)));
}

test("V04 a dragged point stays on the curve, and only its support follows", async (t) => {
  const demo = await blob(t);
  const contour = (await demo.state()).curve.contours[0];
  assert.ok(contour?.support !== undefined && contour.family === "interpolating");
  const { support } = contour;
  const before = await demo.sample(3200);
  const old = await demo.point(5);
  await demo.drag("pt-0-5", 60, -40);
  const now = await demo.point(5);
  assert.ok(Math.abs(now.x - old.x - 60) <= 0.5 && Math.abs(now.y - old.y + 40) <= 0.5);
  const after = await demo.sample(3200);
  const nearest = Math.min(...after.map(([x, y]) => Math.hypot(x - now.x, y - now.y)));
  assert.ok(nearest <= 0.2, `the curve passes at ${nearest}`);
  const step = moves(before, after);
  const isFar = (i: number): boolean => {
    const away = Math.abs((i / 3200) * 16 - 5);
    return Math.min(away, 16 - away) > support;
  };
  const far = step.filter((_, i) => isFar(i));
  assert.ok(far.length >= 800, `${far.length} samples lie outside`);
  assert.ok(Math.max(...far) <= 1e-8 * boxDiagonal(before));
  assert.ok(Math.max(...step.filter((_, i) => !isFar(i))) > 5);
  await demo.press("Control+z");
  assert.ok(Math.max(...moves(await demo.sample(3200), before)) <= 1e-12);
});

test("while a point is dragged, the hint names the segments that follow", async (t) => {
  const demo = await blob(t);
  const { x, y } = await demo.centre("pt-0-5");
  await demo.page.mouse.move(x, y);
  await demo.page.mouse.down();
  await demo.page.mouse.move(x + 30, y + 10, { steps: 4 });
  await demo.idle();
  assert.match(await demo.textOf("hint"), /affects segments 4–7 of 16/);
  await demo.page.mouse.up();
});

test("a long interpolating contour is measured by a worker, which ends with its answer", async (t) => {
  const demo = await blob(t);
  const state = await demo.state();
  const count = 5000;
  const points = Array.from({ length: count }, (_, i) => {
    const turn = (2 * Math.PI * i) / count;
    return { x: 400 + 160 * Math.cos(turn), y: 300 + 160 * Math.sin(turn), kind: "smooth" as const, in: { dx: 0, dy: 0 }, out: { dx: 0, dy: 0 } };
  });
  const started = demo.page.waitForEvent("worker");
  await demo.page.evaluate((next) => window.explineDemo.setState(next), { ...state, curve: { ...state.curve, contours: [{ family: "interpolating" as const, closed: true, points, support: 2 }] } });
  assert.match((await started).url(), /measure-worker/u);
  // The points of a circle give the circle, exactly.
  await demo.until(() => demo.metric("m-length"), (length) => Math.abs(length - 320 * Math.PI) < 1e-6, "the length of the circle");
  assert.ok(Math.abs((await demo.metric("m-area")) - Math.PI * 160 ** 2) < 1e-6);
  assert.ok((await demo.metric("m-bytes")) > 10);
  await demo.until(() => Promise.resolve(demo.page.workers().length), (workers) => workers === 0, "the worker has gone");
});

test("V07 a point inserted into an interpolating curve lies where the click was, and the move is stated", async (t) => {
  const demo = await blob(t);
  const [x, y] = (await demo.sample(1600))[337] ?? [0, 0];
  const at = await demo.toScreen(x, y);
  await demo.doubleClick(at.x, at.y);
  assert.equal((await demo.points()).length, 17);
  const { zoom } = (await demo.state()).view;
  const nearest = Math.min(...(await demo.sample(8000)).map(([a, b]) => Math.hypot(a - x, b - y)));
  assert.ok(nearest * zoom <= 1, `the curve passes at ${nearest}`);
  assert.match(await demo.textOf("toast"), /moved by at most [\d.e-]+/);
});

test("V09 levels double the points and leave the curve; back at level 0 they are the old ones", async (t) => {
  const demo = await blob(t);
  const start = await demo.points();
  const before = await demo.sample(3200);
  const tolerance = 1e-8 * boxDiagonal(before);
  for (const [level, count] of [[1, 32], [2, 64]] as const) {
    await demo.slide("level", level);
    assert.equal((await demo.points()).length, count);
    assert.ok(Math.max(...moves(await demo.sample(3200), before)) <= tolerance);
  }
  await demo.slide("level", 0);
  const back = await demo.points();
  assert.equal(back.length, 16);
  assert.ok(Math.max(...back.map((point, i) => Math.hypot(point.x - (start[i]?.x ?? NaN), point.y - (start[i]?.y ?? NaN)))) <= 1e-9);
});

/** The share of the parameter that a drag of one point moves. */
async function spanOfDrag(demo: Demo, id: string): Promise<number> {
  const before = await demo.sample(6400);
  await demo.drag(id, 20, 0);
  const after = await demo.sample(6400);
  await demo.press("Control+z");
  return moves(before, after).filter((move) => move > 1e-9).length / 6400;
}

test("V09 a point of level 2 moves at most half as much of the curve as one of level 0", async (t) => {
  const demo = await blob(t);
  const coarse = await spanOfDrag(demo, "pt-0-5");
  await demo.slide("level", 2);
  const fine = await spanOfDrag(demo, "pt-0-21");
  t.diagnostic(`a drag moves ${coarse} of the curve at level 0, ${fine} at level 2`);
  assert.ok(fine > 0 && fine <= coarse / 2, `${fine} against ${coarse}`);
});

test("going down a level that finer edits were made on shows the change first, and makes it when asked again", async (t) => {
  const demo = await blob(t);
  await demo.slide("level", 2);
  await demo.drag("pt-0-21", 25, 0);
  await demo.slide("level", 0);
  assert.equal((await demo.state()).curve.level, 2);
  assert.match(await demo.textOf("toast"), /would move the curve by up to/);
  await demo.byId("toast").getByRole("button", { name: "Apply level" }).click();
  await demo.idle();
  assert.equal((await demo.points()).length, 16);
});

test("V10 each subdivision step doubles the vertices and comes nearer to the curve", async (t) => {
  const demo = await blob(t);
  const curve = await demo.sample(6000);
  let last = { count: 0, distance: Infinity };
  for (let steps = 0; steps <= 6; steps += 1) {
    const polygon = await demo.page.evaluate((n) => window.explineDemo.subdivision(n), steps);
    const distance = directedDistance(polygon, curve, true);
    if (steps > 0) assert.equal(polygon.length, 2 * last.count);
    if (steps > 1) assert.ok(distance < last.distance, `step ${steps}: ${distance} after ${last.distance}`);
    last = { count: polygon.length, distance };
  }
  assert.ok(last.distance <= 0.5, `${last.distance} at the end`);
  await demo.byId("ov-subdiv").check();
  await demo.idle();
  const none = await demo.pixels();
  await demo.slide("subdiv", 3);
  assert.ok((await demo.changedPixels(none, await demo.pixels())) > 0);
});

test("V06 and V11 hold for interpolating points: Shift keeps to the compass, a marquee chooses, arrows nudge", async (t) => {
  const demo = await blob(t);
  const old = await demo.point(3);
  await demo.page.keyboard.down("Shift");
  await demo.drag("pt-0-3", 80, 22);
  const level = await demo.point(3);
  assert.ok(Math.abs(level.y - old.y) <= 0.01 && Math.abs(level.x - old.x - 80) <= 0.5);
  await demo.drag("pt-0-3", 60, 55);
  const slanted = await demo.point(3);
  assert.ok(Math.abs(Math.abs(slanted.x - level.x) - Math.abs(slanted.y - level.y)) <= 0.01);
  await demo.page.keyboard.up("Shift");
  await demo.press("Control+z", "Control+z");
  const start = await demo.points();
  const chosen = start.slice(0, 4);
  const [left, right] = [Math.min(...chosen.map(({ x }) => x)), Math.max(...chosen.map(({ x }) => x))];
  const [top, bottom] = [Math.min(...chosen.map(({ y }) => y)), Math.max(...chosen.map(({ y }) => y))];
  const [a, b] = [await demo.toScreen(left - 14, top - 14), await demo.toScreen(right + 14, bottom + 14)];
  await demo.dragFrom(a, b.x - a.x, b.y - a.y);
  await demo.press("ArrowRight", "ArrowRight", "ArrowRight", "Shift+ArrowDown");
  const inside = (point: { x: number; y: number }): boolean => point.x > left - 14 && point.x < right + 14 && point.y > top - 14 && point.y < bottom + 14;
  (await demo.points()).forEach((point, i) => {
    const before = start[i];
    assert.ok(before !== undefined);
    const [dx, dy] = inside(before) ? [3, 10] : [0, 0];
    assert.ok(Math.abs(point.x - before.x - dx) < 1e-9 && Math.abs(point.y - before.y - dy) < 1e-9, `point ${i}`);
  });
});

test("a circle changes its family without moving; a blob says how far it moved", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.byId("family").getByLabel("Interpolating").check();
  await demo.idle();
  assert.equal((await demo.state()).curve.contours[0]?.family, "interpolating");
  assert.match(await demo.textOf("toast"), /without moving the curve/);
  assert.ok((await demo.metric("m-error")) <= 1e-9);
  await demo.byId("family").getByLabel("Hermite").check();
  await demo.idle();
  assert.equal((await demo.state()).curve.contours[0]?.family, "hermite");
  assert.ok((await demo.metric("m-error")) <= 1e-9);
});

test("the first circle becomes an interpolating one of four points, which a closed contour of two cannot, and one undo takes it back", async (t) => {
  const demo = await open(t);
  const before = (await demo.state()).curve;
  await demo.byId("family").getByLabel("Interpolating").check();
  await demo.idle();
  const [contour] = (await demo.state()).curve.contours;
  assert.deepEqual([contour?.family, contour?.points.length], ["interpolating", 4]);
  // The circle of the sample: centre 400, 300 and radius 160.
  assert.ok(radiusError(await demo.sample(400)) <= 1e-12);
  assert.match(await demo.textOf("toast"), /without moving the curve.*2 more points/);
  assert.doesNotMatch(await demo.textOf("hint"), /two points/);
  assert.doesNotMatch(await demo.page.locator(".panel").innerText(), /2 points/);
  await demo.press("Control+z");
  assert.deepEqual((await demo.state()).curve, before);
});

test("a control whose change was refused shows what is", async (t) => {
  const demo = await open(t, "#/curve?sample=blob-16");
  await demo.click("pt-0-3");
  await demo.click("curve-refine");
  const { curve } = await demo.state();
  // Twice: the second refusal is the same as the first.
  for (let i = 0; i < 2; i += 1) {
    await demo.byId("family").getByLabel("Hermite").click();
    await demo.idle();
    assert.deepEqual((await demo.state()).curve, curve);
    assert.match(await demo.textOf("hint"), /refined areas/);
    assert.ok(await demo.byId("family").getByLabel("Interpolating").isChecked());
  }
});

test("the generator of the present roots is drawn on demand", async (t) => {
  const demo = await blob(t);
  await demo.byId("generator-fold").locator("summary").click();
  await demo.byId("generator-plot").waitFor();
  assert.match((await demo.byId("generator-plot").getAttribute("aria-label")) ?? "", /φ and β from −2 to 2/);
  await demo.byId("order").selectOption("5");
  await demo.idle();
  assert.match((await demo.byId("generator-plot").getAttribute("aria-label")) ?? "", /from −4 to 4/);
  assert.deepEqual(demo.complaints, []);
});

test("an interpolating drawing at a finer level goes through its file with every bit", async (t) => {
  const demo = await blob(t);
  await demo.slide("level", 2);
  await demo.drag("pt-0-9", 12, -7);
  const state = await demo.state();
  const before = await demo.sample(500);
  await demo.byId("btn-clear").click();
  await demo.page.evaluate((saved) => window.explineDemo.setState(saved), state);
  assert.deepEqual((await demo.state()).curve, state.curve);
  assert.deepEqual(await demo.sample(500), before);
});

test("the weights of the selected point stand on the curve, move with the selection, and change nothing", async (t) => {
  const demo = await blob(t);
  const curve = await demo.sample(200);
  await demo.click("pt-0-3");
  const plain = await demo.pixels();
  await demo.byId("ov-weights").check();
  await demo.idle();
  const third = await demo.pixels();
  assert.ok((await demo.changedPixels(plain, third)) > 500);
  await demo.focusStage();
  await demo.press("]");
  assert.ok((await demo.changedPixels(third, await demo.pixels())) > 500);
  assert.deepEqual(await demo.sample(200), curve);
});

test("a very long interpolating contour is shown where a key has moved it before anything of it is measured", async (t) => {
  const demo = await open(t);
  await demo.page.evaluate(async () => {
    const state = structuredClone(window.explineDemo.getState());
    const count = 12_000;
    const points = Array.from({ length: count }, (_, i) => {
      const [angle, radius] = [(2 * Math.PI * i) / count, 160 + 20 * Math.sin((80 * Math.PI * i) / count)];
      return { x: 400 + radius * Math.cos(angle), y: 300 + radius * Math.sin(angle), kind: "smooth" as const, in: { dx: 0, dy: 0 }, out: { dx: 0, dy: 0 } };
    });
    await window.explineDemo.setState({ ...state, curve: { space: "trigonometric", omega: "auto", level: 0, contours: [{ family: "interpolating", closed: true, points }] } });
  });
  const before = await demo.until(() => demo.metric("m-area"), (area) => Math.abs(area - Math.PI * (160 ** 2 + 20 ** 2 / 2)) < 1, "it is measured");
  await demo.focusStage();
  await demo.press("]");
  const inTheFrame = await demo.page.evaluate(async () => {
    document.activeElement?.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", code: "ArrowRight", shiftKey: true, bubbles: true, cancelable: true }));
    await window.explineDemo.idle();
    return [window.explineDemo.getState().curve.contours[0]?.points[0]?.x, Number(document.querySelector("[data-testid=m-area]")?.getAttribute("data-value"))];
  });
  assert.deepEqual(inTheFrame, [570, before]);
  await demo.until(() => demo.metric("m-area"), (area) => area !== before, "it is measured when it has been still");
});
