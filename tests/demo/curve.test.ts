import assert from "node:assert/strict";
import { test } from "node:test";
import { boxDiagonal, directedDistance, radiusError, useBrowser, type Demo, type Pair, type Place } from "./page.ts";

const { open } = useBrowser();

function angleBetween(a: { dx: number; dy: number }, b: { dx: number; dy: number }): number {
  return Math.abs(Math.atan2(a.dx * b.dy - a.dy * b.dx, a.dx * b.dx + a.dy * b.dy)) * (180 / Math.PI);
}

async function openWithoutSnap(t: Parameters<typeof open>[0], sample: string): Promise<Demo> {
  const demo = await open(t, `#/curve?sample=${sample}`);
  await demo.withoutSnap();
  return demo;
}

test("V03 two points are an exact circle, and the Bézier's error is measured beside it", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-2");
  const before = await demo.sample(2000);
  assert.ok(radiusError(before) <= 1e-9);
  assert.equal((await demo.points()).length, 2);
  assert.ok((await demo.metric("m-error")) <= 1e-9);
  const { bezierError, modelError } = await demo.stats();
  assert.ok(bezierError !== undefined && bezierError >= 1.5e-4 && bezierError <= 2.9e-4, `Bézier error ${bezierError}`);
  assert.equal(await demo.metric("m-bezier"), bezierError);
  t.diagnostic(`two-point circle: error ${modelError}, Bézier ${bezierError}`);
  const picture = await demo.pixels();
  await demo.byId("ov-bezier").uncheck();
  await demo.idle();
  assert.ok((await demo.changedPixels(picture, await demo.pixels())) > 0);
  assert.deepEqual(await demo.sample(2000), before);
});

test("V03 dragging a point of the two-point circle leaves an exact ellipse", async (t) => {
  const demo = await openWithoutSnap(t, "circle-2");
  await demo.drag("pt-0-0", 60, -45);
  assert.ok((await demo.metric("m-error")) <= 1e-9);
});

test("V05 a symmetric handle takes its partner along; Alt makes a cusp; a double-click smooths it", async (t) => {
  const demo = await openWithoutSnap(t, "circle-8");
  const place = await demo.point(2);
  await demo.click("pt-0-2");
  await demo.drag("hout-0-2", 30, 20);
  const turned = await demo.point(2);
  assert.ok(Math.abs(turned.in.dx + turned.out.dx) <= 0.01 && Math.abs(turned.in.dy + turned.out.dy) <= 0.01);
  assert.deepEqual([turned.x, turned.y], [place.x, place.y]);
  await demo.press("Control+z");
  assert.deepEqual(await demo.point(2), place);

  await demo.page.keyboard.down("Alt");
  await demo.drag("hout-0-2", 0, 70);
  await demo.page.keyboard.up("Alt");
  const cusp = await demo.point(2);
  assert.ok(Math.abs(cusp.in.dx - place.in.dx) <= 0.01 && Math.abs(cusp.in.dy - place.in.dy) <= 0.01);
  assert.equal(cusp.kind, "cusp");
  assert.ok(angleBetween({ dx: -cusp.in.dx, dy: -cusp.in.dy }, cusp.out) > 10);
  assert.equal((await demo.textOf("legend-cusp")).replace(/\D/g, ""), "1");
  assert.match((await demo.byId("pt-0-2").getAttribute("aria-label")) ?? "", /cusp/);

  const at = await demo.centre("pt-0-2");
  await demo.doubleClick(at.x, at.y);
  const smooth = await demo.point(2);
  assert.notEqual(smooth.kind, "cusp");
  assert.ok(angleBetween({ dx: -smooth.in.dx, dy: -smooth.in.dy }, smooth.out) < 1e-6);
});

test("V06 Shift holds points to the compass and handles to steps of 15°", async (t) => {
  const demo = await openWithoutSnap(t, "circle-8");
  const { x, y } = await demo.point(3);
  await demo.page.keyboard.down("Shift");
  await demo.drag("pt-0-3", 80, 22);
  const level = await demo.point(3);
  assert.ok(Math.abs(level.y - y) <= 0.01 && Math.abs(level.x - x - 80) <= 0.5);
  await demo.drag("pt-0-3", 60, 55);
  const slanted = await demo.point(3);
  assert.ok(Math.abs(Math.abs(slanted.x - level.x) - Math.abs(slanted.y - level.y)) <= 0.01);
  await demo.page.keyboard.up("Shift");
  await demo.click("pt-0-3");
  await demo.page.keyboard.down("Shift");
  await demo.drag("hout-0-3", 41, -17);
  await demo.page.keyboard.up("Shift");
  const { dx, dy } = (await demo.point(3)).out;
  const steps = (Math.atan2(dy, dx) * 12) / Math.PI;
  assert.ok(Math.abs(steps - Math.round(steps)) * 15 <= 0.01);
});

test("V07 inserting a point does not change the curve", async (t) => {
  const demo = await openWithoutSnap(t, "circle-8");
  const before = await demo.sample(2000);
  const [x, y] = (await demo.sample(800))[37] ?? [0, 0];
  const at = await demo.toScreen(x, y);
  await demo.doubleClick(at.x, at.y);
  assert.equal((await demo.points()).length, 9);
  const after = await demo.sample(2000);
  const tolerance = 1e-6 * boxDiagonal(before);
  // Both are the same circle; polygons of 2000 sides miss it by 2e-4, so the circle itself is the measure between them.
  assert.ok(radiusError(before) * 160 <= tolerance && radiusError(after) * 160 <= tolerance);
  assert.ok(directedDistance(after.slice(0, 200), before, true) < 3e-4);
  // The new point is the chosen one: an arrow moves it and nothing else.
  const placed = await demo.points();
  await demo.focusStage();
  await demo.press("ArrowUp");
  const nudged = await demo.points();
  assert.deepEqual(nudged.map((point, i) => point.y - (placed[i]?.y ?? 0) !== 0), placed.map((_, i) => i === 1));
});

test("V08 Delete heals the gap and says by how much; Shift+Delete opens; two points must stay", async (t) => {
  const demo = await openWithoutSnap(t, "circle-8");
  const before = await demo.state();
  await demo.click("pt-0-4");
  await demo.press("Delete");
  assert.equal((await demo.points()).length, 7);
  assert.equal((await demo.state()).curve.contours[0]?.closed, true);
  const deviation = radiusError(await demo.sample(2000)) * 160;
  assert.ok(deviation <= 1e-3 * 320, `healed to ${deviation}`);
  assert.match(await demo.textOf("toast"), /moved by at most [\d.e-]+/);
  await demo.press("Control+z");
  assert.deepEqual((await demo.state()).curve, before.curve);

  await demo.click("pt-0-4");
  await demo.press("Shift+Delete");
  const opened = (await demo.state()).curve.contours;
  assert.equal(opened[0]?.points.length, 7);
  assert.equal(opened[0]?.closed, false);
  await demo.press("Control+z");

  for (let left = 8; left > 2; left -= 1) {
    await demo.click(`pt-0-${left - 1}`);
    await demo.press("Delete");
    assert.equal((await demo.points()).length, left - 1);
  }
  await demo.click("pt-0-0");
  await demo.press("Delete");
  assert.equal((await demo.points()).length, 2);
  assert.match(await demo.textOf("hint"), /two points/);
});

test("V11 the marquee chooses, arrows nudge, a drag moves all, and one undo takes back the drag only", async (t) => {
  const demo = await openWithoutSnap(t, "circle-8");
  const start = await demo.points();
  const [a, b] = [await demo.toScreen(585, 290), await demo.toScreen(270, 480)];
  await demo.dragFrom(a, b.x - a.x, b.y - a.y);
  await demo.press("ArrowRight", "ArrowRight", "ArrowRight", "Shift+ArrowDown");
  const nudged = await demo.points();
  nudged.forEach((point, i) => {
    const old = start[i];
    assert.ok(old !== undefined);
    const moved = i <= 3 ? [3, 10] : [0, 0];
    assert.ok(Math.abs(point.x - old.x - (moved[0] ?? 0)) < 1e-9 && Math.abs(point.y - old.y - (moved[1] ?? 0)) < 1e-9, `point ${i}`);
  });
  await demo.page.waitForTimeout(650);
  await demo.drag("pt-0-1", 25, -15);
  const dragged = await demo.points();
  dragged.forEach((point, i) => {
    const old = nudged[i];
    assert.ok(old !== undefined && Math.abs(point.x - old.x - (i <= 3 ? 25 : 0)) < 0.5, `point ${i}`);
  });
  await demo.press("Control+z");
  assert.deepEqual(await demo.points(), nudged);
});

test("a line drawn by hand becomes a curve of few points beside what is there, and one undo takes it back", async (t) => {
  const demo = await openWithoutSnap(t, "circle-2");
  const { page } = demo;
  await demo.click("tool-draw");
  const stroke = Array.from({ length: 120 }, (_, i): Pair => [150 + 5 * i, 500 + 50 * Math.sin(i / 12)]);
  const [start = { x: 0, y: 0 }, ...rest] = await Promise.all(stroke.map(([x, y]) => demo.toScreen(x, y)));
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  for (const { x, y } of rest) await page.mouse.move(x, y);
  await page.mouse.up();
  await demo.idle();
  const { contours } = (await demo.state()).curve;
  assert.equal(contours.length, 2);
  assert.equal(contours[1]?.closed, false);
  // A wave and a half: an oracle with knots at its turns needs five points.
  assert.ok((contours[1]?.points.length ?? 99) <= 10, `${contours[1]?.points.length} points`);
  const curve = await demo.sample(2000, 1);
  const away = directedDistance(stroke, curve, false);
  assert.ok(away <= 2.01, `${away} px of the 2 that are asked for`);
  await demo.press("Control+z");
  assert.equal((await demo.state()).curve.contours.length, 1);
});

test("the grid has the step that is typed, and points snap to it", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  assert.equal(await demo.byId("grid-step").isVisible(), false);
  await demo.byId("ov-grid").check();
  const before = await demo.pixels();
  await demo.byId("grid-step").fill("25");
  await demo.press("Enter");
  assert.ok(await demo.changedPixels(before, await demo.pixels()) > 100);
  await demo.drag("pt-0-2", 71, 33);
  const { x, y } = await demo.point(2);
  assert.deepEqual([x % 25, y % 25], [0, 0], `${x}, ${y}`);
  await demo.byId("grid-step").fill("0");
  await demo.press("Enter");
  assert.equal(await demo.byId("error").getAttribute("data-error"), "number");
  assert.equal(await demo.byId("grid-step").inputValue(), "25");
});

test("the cursor announces what a press would do", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const cursorAt = async (x: number, y: number): Promise<string> => {
    await demo.page.mouse.move(x, y);
    await demo.idle();
    return demo.page.evaluate(([left, top]) => getComputedStyle(document.elementFromPoint(left, top) ?? document.body).cursor, [x, y] as const);
  };
  const { x, y } = await demo.centre("pt-0-2");
  assert.equal(await cursorAt(x, y), "move");
  await demo.page.keyboard.down("Alt");
  assert.equal(await cursorAt(x, y), "crosshair");
  await demo.page.keyboard.up("Alt");
  const on = await demo.toScreen(400 + 160 * Math.cos(0.4), 300 + 160 * Math.sin(0.4));
  assert.equal(await cursorAt(on.x, on.y), "grab");
  assert.equal(await cursorAt(x, y + 100), "default");
  await demo.byId("tool-hand").click();
  assert.equal(await cursorAt(x, y), "grab");
});

test("whole contours are stretched and turned by the grips of their frame, and a circle of two points stays an exact ellipse", async (t) => {
  const demo = await openWithoutSnap(t, "circle-2");
  await demo.focusStage();
  await demo.press("Control+a");
  // The frame stands 16 pixels off the circle around (400, 300).
  const east = await demo.toScreen(560, 300);
  await demo.dragFrom({ x: east.x + 16, y: east.y }, 80, 30);
  const stretched = await demo.sample(2000);
  const [centre, across, down] = [[440, 300], 200, 160] as const;
  const off = (places: readonly Pair[]): number => Math.max(...places.map(([x, y]) => Math.abs(Math.hypot((x - centre[0]) / across, (y - centre[1]) / down) - 1)));
  assert.ok(off(stretched) <= 1e-9, `${off(stretched)}`);
  const top = await demo.toScreen(440, 140);
  await demo.page.keyboard.down("Shift");
  // From above the ellipse to the right of it: a quarter turn, to the nearest 15°.
  await demo.dragFrom({ x: top.x, y: top.y - 40 }, 210, 195);
  await demo.page.keyboard.up("Shift");
  assert.ok(off((await demo.sample(2000)).map(([x, y]) => [440 + (y - 300), 300 - (x - 440)])) <= 1e-9);
  assert.ok((await demo.metric("m-error")) <= 1e-9);
  await demo.press("Control+z", "Control+z");
  assert.ok(radiusError(await demo.sample(2000)) <= 1e-12);
});

test("an end that is dropped on the other closes the contour it was cut from; points are brought in line, and shown large", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.click("pt-0-4");
  await demo.press("Shift+Delete");
  const [from, onto] = [await demo.centre("pt-0-0"), await demo.centre("pt-0-6")];
  const { mouse } = demo.page;
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(from.x + 20, from.y + 40, { steps: 4 });
  await demo.idle();
  await mouse.move(onto.x + 3, onto.y - 2, { steps: 8 });
  assert.match(await demo.textOf("hint"), /let go to join/);
  await mouse.up();
  await demo.idle();
  const [joined] = (await demo.state()).curve.contours;
  assert.deepEqual([joined?.closed, joined?.points.length], [true, 6]);
  await demo.press("Control+a");
  await demo.byId("align-down-start").click();
  await demo.idle();
  assert.match(await demo.textOf("hint"), /several contours/);
  await demo.click("pt-0-1");
  await demo.page.keyboard.down("Shift");
  await demo.click("pt-0-3");
  await demo.page.keyboard.up("Shift");
  await demo.byId("align-down-start").click();
  await demo.idle();
  const { zoom } = (await demo.state()).view;
  const points = await demo.points();
  assert.equal(points[1]?.y, points[3]?.y);
  await demo.focusStage();
  await demo.press("Shift+F");
  assert.ok((await demo.state()).view.zoom > zoom);
});

test("several points have a box that can be typed, and become of one kind when they are of several", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.focusStage();
  await demo.press("Control+a");
  assert.equal(await demo.byId("pt-x").isVisible(), false, "the numbers of one point");
  const kinds = demo.byId("pt-kind").locator("input");
  assert.deepEqual(await kinds.evaluateAll((all) => all.map((input) => (input as HTMLInputElement).checked)), [false, false, false]);
  await demo.byId("pt-kind").getByLabel("Smooth").check();
  await demo.idle();
  assert.ok((await demo.points()).every(({ kind }) => kind === "smooth"));
  await demo.byId("sel-w").fill("200");
  await demo.byId("sel-x").fill("50");
  await demo.byId("sel-x").press("Enter");
  await demo.idle();
  const xs = (await demo.sample(4000)).map(([x]) => x);
  assert.ok(Math.abs(Math.min(...xs) - 50) < 0.01 && Math.abs(Math.max(...xs) - 250) < 0.01, `${Math.min(...xs)} to ${Math.max(...xs)}`);
  assert.equal(await demo.byId("sel-w").inputValue(), "200.00");
});

test("on an empty stage nobody is told to click a point, or to step through points", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  const selected = demo.page.getByRole("region", { name: "Selected" });
  assert.match((await selected.textContent()) ?? "", /Click a point, or press \]/u);
  await demo.click("btn-clear");
  assert.match((await selected.textContent()) ?? "", /Nothing selected\.$/u);
});

test("an empty stage offers nobody to add points to a contour that is not there", async (t) => {
  const demo = await open(t);
  await demo.byId("btn-clear").click();
  await demo.idle();
  assert.ok(await demo.page.getByRole("button", { name: "One point more" }).isDisabled());
  await demo.byId("btn-undo").click();
  await demo.idle();
  assert.ok(await demo.page.getByRole("button", { name: "One point more" }).isEnabled());
});

test("a double-click inside a shape selects it with its holes, and a drag of one of its points moves it", async (t) => {
  const demo = await openWithoutSnap(t, "glyph");
  const { x, y } = await demo.toScreen(320, 400);
  await demo.doubleClick(x, y);
  await demo.until(() => demo.textOf("live"), (text) => text.includes("14 points selected"), "both contours are selected");
  const before = await Promise.all([demo.point(0, 0), demo.point(0, 1)]);
  await demo.drag("pt-0-0", 20, 10);
  const after = await Promise.all([demo.point(0, 0), demo.point(0, 1)]);
  const zoom = (await demo.toScreen(1, 0)).x - (await demo.toScreen(0, 0)).x;
  for (const [i, point] of after.entries()) assert.ok(Math.abs(point.x - (before[i]?.x ?? NaN) - 20 / zoom) < 0.5 / zoom);
});

test("the label of the comparison lies across no curve, wherever the drawing is looked at", async (t) => {
  for (const [sample, zoom] of [["circle-2", 0], ["circle-2", 4], ["ellipse", 0], ["heart", 0], ["heart", 6], ["sine", 0], ["glyph", 0], ["glyph", 4]] as const) {
    const demo = await open(t, `#/curve?sample=${sample}`);
    await demo.page.evaluate(() => {
      const write = CanvasRenderingContext2D.prototype.fillText;
      CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
        const { x: left, y: top } = this.canvas.getBoundingClientRect();
        Reflect.set(window, "written", { text, left: left + x, right: left + x + this.measureText(text).width, bottom: top + y });
        write.call(this, text, x, y);
      };
    });
    await demo.byId("ov-bezier").setChecked(false);
    await demo.byId("ov-bezier").setChecked(true);
    await demo.wheel(await demo.toScreen(480, 220), zoom);
    const written = await demo.page.evaluate(() => Reflect.get(window, "written") as { text: string; left: number; right: number; bottom: number });
    assert.match(written.text, /Bézier/u);
    const { length } = (await demo.state()).curve.contours;
    for (let contour = 0; contour < length; contour += 1) {
      const [origin, unit] = [await demo.toScreen(0, 0), await demo.toScreen(1, 1)];
      const across = (await demo.sample(4000, contour)).filter(([x, y]) => {
        const [left, top] = [origin.x + x * (unit.x - origin.x), origin.y + y * (unit.y - origin.y)];
        return left > written.left && left < written.right && top > written.bottom - 9 && top < written.bottom;
      });
      assert.deepEqual(across, [], `${sample} ${zoom}`);
    }
    const ends = await demo.page.locator("[data-testid^=hin-], [data-testid^=hout-]").evaluateAll((all) => all.map((each) => each.getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2]));
    const covered = ends.filter(([x = 0, y = 0]) => x > written.left && x < written.right && y > written.bottom - 9 && y < written.bottom);
    assert.deepEqual(covered, [], `${sample} ${zoom}: no handle, either`);
    await demo.page.close();
  }
});

test("the panel acts on all contours that are chosen, or on all, and says where they differ", async (t) => {
  const demo = await open(t, "#/curve?sample=glyph");
  const closedness = async (): Promise<boolean[]> => (await demo.state()).curve.contours.map(({ closed }) => closed);
  const counts = async (): Promise<number[]> => (await demo.state()).curve.contours.map(({ points }) => points.length);
  const before = await counts();
  assert.equal(await demo.byId("points").inputValue(), String(before.reduce((sum, each) => sum + each, 0)));
  assert.ok(await demo.byId("points").isDisabled(), "nobody could tell which of the two would change");
  assert.ok(await demo.page.getByText("Select one contour to change its points").isVisible());
  await demo.byId("closed").uncheck();
  await demo.idle();
  assert.deepEqual(await closedness(), [false, false]);
  await demo.click("pt-1-2");
  assert.equal(await demo.byId("points").inputValue(), String(before[1]));
  assert.ok(await demo.page.getByText("Select one contour to change its points").isHidden());
  await demo.byId("closed").check();
  await demo.idle();
  assert.deepEqual(await closedness(), [false, true]);
  await demo.focusStage();
  await demo.press("Escape");
  assert.ok(await demo.byId("closed").evaluate((box: HTMLInputElement) => box.indeterminate && !box.checked));
  await demo.byId("closed").check();
  await demo.idle();
  assert.deepEqual(await closedness(), [true, true]);
  await demo.press("Control+z");
  assert.deepEqual(await closedness(), [false, true], "one step");
  await demo.page.getByRole("radio", { name: "Interpolating" }).check();
  await demo.until(async () => (await demo.state()).curve.contours.map(({ family }) => family), (all) => all.every((each) => each === "interpolating"), "both contours are converted");
  await demo.press("Control+z");
  await demo.byId("points-fold").locator("summary").click();
  await demo.byId("points-table").getByText("Contour 1 of 2").waitFor();
});

test("the pen goes on from an end, joins the end of another path, and says so before", async (t) => {
  const demo = await open(t);
  await demo.byId("btn-clear").click();
  const shape = async (): Promise<(readonly [boolean, Pair[]])[]> =>
    (await demo.state()).curve.contours.map(({ closed, points }) => [closed, points.map(({ x, y }): Pair => [Math.round(x), Math.round(y)])] as const);
  const place = async ([x, y]: Pair): Promise<void> => {
    const at = await demo.toScreen(x, y);
    await demo.page.mouse.move(at.x, at.y);
    await demo.idle();
  };
  const press = async (at: Pair): Promise<void> => {
    await place(at);
    await demo.page.mouse.down();
    await demo.page.mouse.up();
    await demo.idle();
    // Two clicks of a test are never one double-click of a person.
    await demo.page.waitForTimeout(450);
  };
  const draw = async (...places: Pair[]): Promise<void> => {
    for (const each of places) await press(each);
    await demo.press("Enter");
  };
  await demo.press("p");
  await draw([300, 200], [400, 200]);
  await draw([400, 400], [300, 400]);
  await place([400, 200]);
  assert.equal(await demo.textOf("hint"), "Click to continue this path.");
  await press([400, 200]);
  await press([450, 300]);
  await place([400, 400]);
  assert.equal(await demo.textOf("hint"), "Click to join this path.");
  const alone = await shape();
  await press([400, 400]);
  assert.deepEqual(await shape(), [[false, [[300, 200], [400, 200], [450, 300], [400, 400], [300, 400]]]]);
  assert.match(await demo.textOf("hint"), /first point/u, "the path is finished");
  await demo.press("Control+z");
  assert.deepEqual(await shape(), alone, "one step");
  // Onto the last point of the other one, the other way round.
  await place([450, 300]);
  await press([450, 300]);
  await press([300, 400]);
  assert.deepEqual(await shape(), [[false, [[300, 200], [400, 200], [450, 300], [300, 400], [400, 400]]]]);
});

test("the menu of a point has what can be done with it, and nothing that would be refused", async (t) => {
  const demo = await open(t, "#/curve?sample=sine");
  const itemsAfter = async (opened: Promise<void>): Promise<string[]> => {
    await opened;
    await demo.byId("context-menu").waitFor();
    const items = await demo.byId("context-menu").getByRole("menuitem").evaluateAll((all) => all.map((each) => (each.getAttribute("data-testid") ?? "").replace("menu-", "")));
    await demo.press("Escape");
    return items;
  };
  const itemsAt = ({ x, y }: Place): Promise<string[]> => itemsAfter(demo.page.mouse.click(x, y, { button: "right" }));
  const itemsOf = async (id: string): Promise<string[]> => itemsAt(await demo.centre(id));
  const always = ["delete", "delete-open", "reverse", "select-contour", "copy", "duplicate"];
  const handles = ["smooth", "symmetric", "cusp", "reset-handles"];
  const sorted = (all: string[]): string[] => [...all].sort();
  const last = (await demo.points()).length - 1;
  assert.deepEqual(sorted(await itemsOf(`pt-0-${last}`)), sorted([...always, ...handles, "join"]));
  assert.deepEqual(sorted(await itemsOf("pt-0-1")), sorted([...always, ...handles]));
  await demo.page.evaluate(() => { window.location.hash = "#/curve?sample=blob-16"; });
  await demo.byId("pt-0-15").waitFor({ state: "attached" });
  await demo.idle();
  assert.deepEqual(sorted(await itemsOf("pt-0-0")), sorted(always));
  assert.deepEqual(sorted(await itemsOf("pt-0-3")), sorted([...always, "start-here"]));
  // Inside of what is chosen as a whole, what can be done with all of it; beside it, what can be done with the drawing.
  await demo.focusStage();
  await demo.press("Control+a");
  const stage = await demo.byId("stage").boundingBox();
  assert.ok(stage !== null);
  const whole = ["copy", "cut", "paste", "duplicate", "delete", "flip-across", "flip-down", "turn-right", "turn-left", "reverse", "zoom-chosen"];
  assert.deepEqual(await itemsAt(await demo.toScreen(400, 300)), whole);
  assert.deepEqual(await itemsAt({ x: stage.x + 20, y: stage.y + 20 }), ["paste", "copy", "zoom-fit", "select-all"]);
  await demo.focusStage();
  for (let i = 0; i < 40; i += 1) await demo.press("Shift+ArrowRight");
  assert.deepEqual(await itemsAfter(demo.press("Shift+F10")), whole, "the menu key is about what is chosen, wherever the pointer is");
});

test("the menu is in sight to its last item on a phone held across, without keys for who has none", async (t) => {
  const demo = await open(t, "#/curve?sample=sine", { viewport: { width: 640, height: 360 }, hasTouch: true, isMobile: true });
  const { x, y } = await demo.centre("pt-0-0");
  await demo.page.mouse.click(x, y, { button: "right" });
  await demo.byId("context-menu").waitFor();
  await demo.byId("menu-duplicate").scrollIntoViewIfNeeded();
  const box = await demo.byId("menu-duplicate").boundingBox();
  assert.ok(box !== null && box.y >= 0 && box.y + box.height <= 360, JSON.stringify(box));
  assert.equal(await demo.byId("context-menu").locator("kbd:visible").count(), 0);
});

test("the menu opens while its button is down, outlives the release, and closes at a press elsewhere, which does what it does", async (t) => {
  const demo = await open(t, "#/curve?sample=sine");
  const menu = demo.byId("context-menu");
  const [first, second] = [await demo.centre("pt-0-0"), await demo.centre("pt-0-1")];
  for (const round of ["its part of the page comes", "it is there at once"]) {
    await demo.page.mouse.move(first.x, first.y);
    await demo.page.mouse.down({ button: "right" });
    await menu.waitFor();
    await demo.page.mouse.up({ button: "right" });
    await demo.idle();
    // Firefox and Safari close every popover of theirs at such a release.
    await demo.page.evaluate(() => document.querySelectorAll<HTMLElement>(":popover-open").forEach((each) => each.popover === "auto" && each.hidePopover()));
    assert.ok(await menu.isVisible(), round);
    await demo.page.mouse.click(second.x, second.y);
    assert.equal(await menu.count(), 0);
    await demo.byId("pt-x").waitFor();
    await demo.idle();
    assert.equal(Number(await demo.byId("pt-x").inputValue()).toFixed(1), (await demo.point(1)).x.toFixed(1), "the press has chosen the other point");
    await demo.press("Escape");
  }
});

test("an area is one whichever way round its outline runs", async (t) => {
  const demo = await open(t, "#/curve?sample=glyph");
  const area = await demo.metric("m-area");
  await demo.focusStage();
  await demo.press("Control+a");
  const { x, y } = await demo.centre("pt-0-0");
  await demo.page.mouse.click(x, y, { button: "right" });
  await demo.byId("menu-reverse").click();
  await demo.until(() => demo.metric("m-area"), (now) => Math.abs(now - area) < 1e-6, "as large as before");
});

test("Reverse turns what the menu is over, or all that is chosen; Start here starts at the point under it; what is deleted is counted", async (t) => {
  const demo = await open(t, "#/curve?sample=glyph");
  const firsts = async (): Promise<string> => JSON.stringify((await demo.state()).curve.contours.map(({ points }) => points.slice(0, 2).map(({ x, y }) => [x, y])));
  const menu = async ({ x, y }: { x: number; y: number }, item: string): Promise<void> => {
    await demo.page.mouse.move(x, y);
    await demo.page.mouse.click(x, y, { button: "right" });
    await demo.byId(`menu-${item}`).click();
    await demo.idle();
  };
  const turned = async (before: string): Promise<boolean[]> => {
    const [then, now] = [JSON.parse(before) as unknown[], JSON.parse(await firsts()) as unknown[]];
    return now.map((each, i) => JSON.stringify(each) !== JSON.stringify(then[i]));
  };
  const start = await firsts();
  const [a, b] = [await demo.centre("pt-1-0"), await demo.centre("pt-1-1")];
  const between = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  await menu(between, "insert-here");
  await demo.until(async () => (await demo.points(1)).length, (count) => count === 6, "a point is inserted where the menu was opened");
  await demo.press("Control+z", "Escape");
  await menu(between, "select-contour");
  await demo.byId("sel-w").waitFor();
  assert.equal(await demo.byId("points").inputValue(), "5", "the inner contour is chosen");
  await demo.focusStage();
  await demo.press("Escape");
  await menu(between, "reverse");
  assert.deepEqual(await turned(start), [false, true], "the one under the pointer");
  await demo.press("Control+z");
  await demo.focusStage();
  await demo.press("Control+a");
  await menu(await demo.centre("pt-0-1"), "reverse");
  assert.deepEqual(await turned(start), [true, true]);
  await demo.press("Control+z");
  assert.equal(await firsts(), start, "one step");
  await demo.press("Control+a");
  const third = await demo.point(3);
  await menu(await demo.centre("pt-0-3"), "start-here");
  assert.deepEqual([(await demo.point(0)).x, (await demo.point(0)).y], [third.x, third.y]);
  await demo.focusStage();
  await demo.press("Home", "Shift+]", "Shift+Delete");
  assert.equal(await demo.textOf("toast"), "2 points deleted. The path is now open there.");
});

test("a click on an empty stage places the first point, as it says there, and the pen goes on from it", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.byId("btn-clear").click();
  await demo.byId("empty-curve").waitFor();
  await demo.still();
  for (const [x, y] of [[300, 200], [500, 260]] as const) {
    await demo.page.mouse.click(x, y);
    await demo.idle();
    await demo.page.waitForTimeout(450);
  }
  await demo.press("Enter");
  const [first, second] = await demo.points();
  assert.ok(first !== undefined && second !== undefined);
  for (const [point, x, y] of [[first, 300, 200], [second, 500, 260]] as const) {
    const place = await demo.toScreen(point.x, point.y);
    assert.ok(Math.hypot(place.x - x, place.y - y) < 1, JSON.stringify(place));
  }
  assert.equal(await demo.byId("empty-curve").count(), 0);
  // Where something is drawn, Select is for selecting.
  await demo.press("v");
  await demo.page.mouse.click(200, 500);
  await demo.idle();
  assert.equal((await demo.points()).length, 2);
});
