import assert from "node:assert/strict";
import { test, type TestContext } from "node:test";
import type { BrowserContextOptions } from "playwright-core";
import { lowContrast, namesAndTargets } from "./looked-at.ts";
import { commandsOf } from "./path-oracle.ts";
import { useBrowser, type Demo, type Pair, type Place } from "./page.ts";

/** Corners rounded by mouse, keys, menu and fingers, and measured in the curve and in the path data that goes out. */

const { open } = useBrowser();
const clipboard = { permissions: ["clipboard-read", "clipboard-write"] };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

const [left, top, right, bottom] = [250, 150, 550, 350];

/** A rectangle of 300 × 200 at 100 %, selected as a whole. */
async function rectangle(t: TestContext, options: BrowserContextOptions = {}): Promise<Demo> {
  const demo = await open(t, "", options);
  await demo.page.evaluate(async ([x0, y0, x1, y1]) => {
    const state = window.explineDemo.getState();
    const { sample: _, ...curve } = state.curve;
    const corner = (x: number, y: number, ix: number, iy: number, ox: number, oy: number) => ({ x, y, kind: "cusp" as const, in: { dx: ix, dy: iy }, out: { dx: ox, dy: oy } });
    const points = [corner(x0, y0, 0, 60, 90, 0), corner(x1, y0, -90, 0, 0, 60), corner(x1, y1, 0, -60, -90, 0), corner(x0, y1, 90, 0, 0, -60)];
    await window.explineDemo.setState({ ...state, curve: { ...curve, contours: [{ family: "hermite", closed: true, points, omega: [0, 0, 0, 0] }] } });
  }, [left, top, right, bottom] as const);
  await demo.focusStage();
  await demo.press("f", "Control+a");
  return demo;
}

/** How far every place of a rounded rectangle is from where it should be: on a side, or on the circle in a corner. */
function astray(samples: readonly Pair[], radius: number): number {
  const middle = { x: (left + right) / 2, y: (top + bottom) / 2 };
  return Math.max(...samples.map(([x, y]) => {
    // One quarter stands for all: how far beyond the centre of the corner's circle a place is.
    const [dx, dy] = [Math.abs(x - middle.x) - ((right - left) / 2 - radius), Math.abs(y - middle.y) - ((bottom - top) / 2 - radius)];
    const away = dx > 0 && dy > 0 ? Math.hypot(dx, dy) : Math.max(dx, dy);
    return Math.abs(away - radius);
  }));
}

async function exported(demo: Demo): Promise<string> {
  await demo.byId("btn-export").click();
  const d = await demo.copied(() => demo.byId("export-d").click());
  await demo.press("Escape");
  return d;
}

/** The grip in the corner at the top left, `away` pixels from it along the diagonal. */
async function gripAt(demo: Demo, away: number): Promise<Place> {
  const { x, y } = await demo.toScreen(left, top);
  return { x: x + away * Math.SQRT1_2, y: y + away * Math.SQRT1_2 };
}

test("keys alone: Shift+C rounds the corners exactly, the radius is typed and stepped, and undo goes back all the way", async (t) => {
  const demo = await rectangle(t, clipboard);
  await demo.press("Shift+c");
  assert.match(await demo.textOf("hint"), /^4 corners rounded, radius 50\.$/u);
  assert.ok(astray(await demo.sample(2000), 50) < 1e-11);
  const field = demo.byId("corner-radius");
  await field.focus();
  await demo.press("Control+a");
  await demo.page.keyboard.type("30");
  await demo.press("Enter");
  assert.ok(astray(await demo.sample(2000), 30) < 1e-11);
  await demo.page.waitForTimeout(700);
  await demo.press("ArrowUp", "ArrowUp");
  assert.equal(await field.inputValue(), "32.00");
  assert.ok(astray(await demo.sample(2000), 32) < 1e-11);
  const d = await exported(demo);
  assert.deepEqual(commandsOf(d).flatMap(({ letter, values }) => (letter === "A" ? [values.slice(0, 2)] : [])), [[32, 32], [32, 32], [32, 32], [32, 32]]);
  assert.match(d, /^M[^C]*Z$/u, "lines and arcs, and no Bézier");
  await demo.focusStage();
  await demo.press("Control+z", "Control+z", "Control+z");
  assert.equal((await demo.points()).length, 4);
  await demo.press("Control+y");
  assert.ok(astray(await demo.sample(2000), 50) < 1e-11, "and redo brings it back");
  assert.deepEqual(demo.complaints, []);
});

test("more than there is room for is limited in the field, and said; 0 makes corners sharp again", async (t) => {
  const demo = await rectangle(t);
  const field = demo.byId("corner-radius");
  await field.fill("5000");
  await field.press("Enter");
  await demo.idle();
  assert.equal(await field.inputValue(), "100.00");
  assert.match(await demo.textOf("hint"), /radius 100; there is no room for more/u);
  assert.ok(astray(await demo.sample(2000), 100) < 1e-11);
  assert.equal((await demo.points()).length, 6, "where the short sides were, two arcs meet in one point");
  for (const odd of ["-3", "NaN", "1e999", ""]) {
    await field.fill(odd);
    await field.press("Enter");
    await demo.idle();
    assert.ok(astray(await demo.sample(500), 100) < 1e-11, odd);
  }
  await field.fill("0");
  await field.press("Enter");
  await demo.idle();
  assert.deepEqual((await demo.points()).map(({ x, y }) => [x, y]), [[left, top], [right, top], [right, bottom], [left, bottom]]);
});

test("the menu of a corner rounds it alone, and of a smooth point or a round corner there is nothing to round", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  const menu = async (id: string): Promise<number> => {
    const { x, y } = await demo.centre(id);
    await demo.page.mouse.click(x, y, { button: "right" });
    await demo.byId("context-menu").waitFor();
    return demo.byId("menu-round-corners").count();
  };
  assert.equal(await menu("pt-0-1"), 0);
  await demo.press("Escape");
  assert.equal(await menu("pt-0-3"), 1);
  await demo.byId("menu-round-corners").click();
  await demo.idle();
  assert.match(await demo.textOf("hint"), /^Corner rounded, radius [\d.]+\.$/u);
  assert.equal((await demo.points()).length, 7);
  const radius = Number(await demo.byId("corner-radius").inputValue());
  // Three places of the arc tell its circle: it is the segment between the two points that are selected.
  const [, , , from, to] = await demo.points();
  assert.ok(from && to && Math.abs(Math.hypot(from.out.dx, from.out.dy) - Math.hypot(to.in.dx, to.in.dy)) < 1e-9);
  const angle = (3 * Math.hypot(from.out.dx, from.out.dy)) / radius;
  assert.ok(Math.abs(Math.hypot(to.x - from.x, to.y - from.y) - 2 * radius * Math.sin(angle / 2)) < 1e-9, "the chord of an arc of that radius");
  assert.equal(await menu("pt-0-3"), 0);
  await demo.press("Escape");
});

test("a mouse drags the grip inside a corner: all selected corners follow, the hint has the radius, Escape gives up", async (t) => {
  const demo = await rectangle(t);
  const { zoom } = (await demo.state()).view;
  const from = await gripAt(demo, 24);
  await demo.page.mouse.move(from.x, from.y);
  await demo.idle();
  assert.match(await demo.textOf("hint"), /^Drag to round the selected corners/u);
  await demo.page.mouse.down();
  await demo.page.mouse.move(from.x + 20 * zoom, from.y + 20 * zoom, { steps: 5 });
  await demo.idle();
  assert.equal(await demo.textOf("hint"), "radius 20");
  await demo.press("Escape");
  await demo.page.mouse.up();
  assert.equal((await demo.points()).length, 4);
  await demo.dragFrom(from, 20 * zoom, 20 * zoom);
  assert.ok(astray(await demo.sample(2000), 20) < 1e-11);
  await demo.focusStage();
  await demo.press("Control+z");
  assert.equal((await demo.points()).length, 4, "one step");
});

test("a finger drags the grip of a corner on a phone", async (t) => {
  const demo = await rectangle(t, phone);
  await demo.page.touchscreen.tap(20, 120);
  const corner = await demo.toScreen(left, top);
  await demo.tap([corner]);
  await demo.page.waitForTimeout(450);
  assert.equal(await demo.byId("corner-radius").count(), 1);
  const from = await gripAt(demo, 44);
  await demo.touch("touchStart", from);
  for (let i = 1; i <= 8; i += 1) await demo.touch("touchMove", { x: from.x + 3 * i, y: from.y + 3 * i });
  await demo.touch("touchEnd");
  await demo.idle();
  assert.equal((await demo.points()).length, 5, "the corner that was tapped is round");
  await demo.press("Control+z");
  assert.equal((await demo.points()).length, 4);
});

test("a reload keeps the arcs, whose radius can be changed again", async (t) => {
  const demo = await rectangle(t, clipboard);
  await demo.press("Shift+c");
  const before = await demo.kept();
  await demo.page.reload();
  await demo.page.evaluate(() => window.explineDemo.ready);
  await demo.idle();
  assert.deepEqual((await demo.state()).curve, before);
  await demo.focusStage();
  await demo.press("Control+a");
  await demo.byId("corner-radius").fill("10");
  await demo.byId("corner-radius").press("Enter");
  await demo.idle();
  assert.ok(astray(await demo.sample(2000), 10) < 1e-11);
});

test("the radius has a name, a size to press and enough contrast, on light and dark paper and at the width of a phone", async (t) => {
  for (const options of [{}, { colorScheme: "dark" }, { viewport: { width: 320, height: 568 } }] as const) {
    const demo = await rectangle(t, options);
    assert.deepEqual(await namesAndTargets(demo.page), []);
    assert.deepEqual(await lowContrast(demo.page), []);
    assert.ok(await demo.page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  }
});
