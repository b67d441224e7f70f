import assert from "node:assert/strict";
import { test } from "node:test";
import { commandsOf, evaluatePath } from "./path-oracle.ts";
import { assertSame, useBrowser, Demo, type Pair, type Place } from "./page.ts";

/** Ellipses and rectangles drawn by mouse, keys and fingers, and measured in the path data that goes out. */

const { open, context } = useBrowser();
const clipboard = { permissions: ["clipboard-read", "clipboard-write"] };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** An empty drawing at 100 %, without snapping. */
async function empty(demo: Demo): Promise<Demo> {
  // On a phone the sheet is over the panel's buttons.
  await demo.page.evaluate(async () => {
    const state = window.explineDemo.getState();
    const { sample: _, ...curve } = state.curve;
    await window.explineDemo.setState({ ...state, curve: { ...curve, contours: [] } });
    (document.querySelector("[data-testid=snap]") as HTMLInputElement).click();
  });
  await demo.focusStage();
  await demo.press("0");
  return demo;
}

async function exported(demo: Demo): Promise<string> {
  await demo.byId("btn-export").click();
  const d = await demo.copied(() => demo.byId("export-d").click());
  await demo.press("Escape");
  return d;
}

/** Goes down at one place of the drawing and on to another, with the button held. */
async function pressAndMove(demo: Demo, from: Pair, to: Pair): Promise<void> {
  const [a, b] = [await demo.toScreen(...from), await demo.toScreen(...to)];
  await demo.page.mouse.move(a.x, a.y);
  await demo.page.mouse.down();
  await demo.page.mouse.move(b.x, b.y, { steps: 6 });
  await demo.idle();
}

async function letGo(demo: Demo): Promise<void> {
  await demo.page.mouse.up();
  await demo.idle();
}

/** The box of what a path draws. */
function boxOf(d: string): number[] {
  const points = evaluatePath(d).flatMap((subpath) => subpath.points);
  const [x, y] = [points.map(([px]) => px), points.map(([, py]) => py)];
  return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)].map((value) => Math.round(1000 * value) / 1000);
}

const letters = (d: string): string => commandsOf(d).map(({ letter }) => letter).join("");

test("a drag with the Ellipse tool goes out as two arcs of that ellipse, and the status says that it is one", async (t) => {
  const demo = await empty(await open(t, "", clipboard));
  await demo.press("l");
  assert.equal(await demo.byId("tool-ellipse").getAttribute("aria-pressed"), "true");
  await pressAndMove(demo, [250, 180], [490, 340]);
  assert.match(await demo.textOf("hint"), /^240 × 160\b/u, "said while it is drawn");
  await letGo(demo);
  assert.match(await demo.textOf("hint"), /^Ellipse, 240 × 160\./u);
  assert.ok(await demo.metric("m-error") <= 1e-9);
  const d = await exported(demo);
  assert.equal(letters(d), "MAAZ");
  assert.deepEqual(boxOf(d), [250, 180, 490, 340]);
  for (const [x, y] of await demo.sample(500)) assert.ok(Math.abs(((x - 370) / 120) ** 2 + ((y - 260) / 80) ** 2 - 1) < 1e-12);
  assert.equal(await demo.byId("tool-ellipse").getAttribute("aria-pressed"), "true", "it stays up, as the pen does");
  assert.deepEqual(demo.complaints, []);
});

test("a drag with the Rectangle tool goes out as lines", async (t) => {
  const demo = await empty(await open(t, "", clipboard));
  await demo.click("tool-rectangle");
  await pressAndMove(demo, [490, 340], [250, 180]);
  await letGo(demo);
  assert.equal(await exported(demo), "M250 180H490V340H250Z");
});

test("Shift and Alt count at once, with the pointer at rest, and Space moves what is being drawn", async (t) => {
  const demo = await empty(await open(t, "", clipboard));
  const { keyboard } = demo.page;
  const box = async (): Promise<number[]> => {
    await demo.idle();
    const points = await demo.points();
    const [x, y] = [points.map((point) => point.x), points.map((point) => point.y)];
    return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)];
  };
  await demo.press("m");
  await pressAndMove(demo, [400, 300], [500, 340]);
  assert.deepEqual(await box(), [400, 300, 500, 340]);
  await keyboard.down("Shift");
  assert.deepEqual(await box(), [400, 300, 500, 400]);
  await keyboard.down("Alt");
  assert.deepEqual(await box(), [300, 200, 500, 400]);
  await keyboard.up("Shift");
  assert.deepEqual(await box(), [300, 260, 500, 340]);
  await keyboard.up("Alt");
  assert.deepEqual(await box(), [400, 300, 500, 340]);
  await keyboard.down(" ");
  const at = await demo.toScreen(480, 360);
  await demo.page.mouse.move(at.x, at.y, { steps: 4 });
  assert.deepEqual(await box(), [380, 320, 480, 360]);
  await keyboard.up(" ");
  await letGo(demo);
  assert.equal(await exported(demo), "M380 320H480V360H380Z");
});

test("Escape leaves all as it was; one undo takes back a whole drag", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  const { curve } = await demo.state();
  await demo.focusStage();
  await demo.press("l");
  await pressAndMove(demo, [60, 60], [160, 130]);
  assert.equal((await demo.state()).curve.contours.length, 2, "it is seen while it is drawn");
  await demo.press("Escape");
  await letGo(demo);
  assertSame((await demo.state()).curve, curve);
  assert.equal(await demo.byId("btn-undo").isDisabled(), true);
  await pressAndMove(demo, [60, 60], [160, 130]);
  await letGo(demo);
  assert.match((await demo.byId("btn-undo").getAttribute("title")) ?? "", /^Undo: Ellipse/u);
  await demo.press("Control+z");
  assertSame((await demo.state()).curve, curve);
  assert.equal(await demo.byId("btn-undo").isDisabled(), true);
});

test("by keys alone: the tool, Enter for one in the middle of what is seen, then arrows move it", async (t) => {
  const demo = await empty(await open(t, "", clipboard));
  // The tool is on its way when Enter is pressed.
  await demo.page.keyboard.press("l");
  await demo.press("Enter");
  assert.match(await demo.textOf("live"), /^Ellipse, 100 × 100\./u);
  const box = await demo.byId("stage").boundingBox();
  assert.ok(box !== null);
  const middle = await demo.toDoc(box.x + box.width / 2, box.y + box.height / 2);
  const [left = 0, top = 0, right = 0, bottom = 0] = boxOf(await exported(demo));
  assert.ok(Math.hypot((left + right) / 2 - middle.x, (top + bottom) / 2 - middle.y) <= 1, "to a round number");
  await demo.focusStage();
  await demo.press("ArrowRight", "Shift+ArrowDown");
  assert.deepEqual(boxOf(await exported(demo)), [left + 1, top + 10, right + 1, bottom + 10]);
});

test("on a phone a finger draws, a tap makes a circle, and two fingers move the view and draw nothing", async (t) => {
  const demo = await empty(await open(t, "#/curve?sample=heart", { ...phone, ...clipboard }));
  await demo.byId("tool-ellipse").tap();
  await demo.idle();
  const doc = async ({ x, y }: Place): Promise<{ x: number; y: number }> => demo.toDoc(x, y);
  const [from, to] = [{ x: 60, y: 160 }, { x: 260, y: 300 }];
  await demo.touch("touchStart", from);
  for (let i = 1; i <= 5; i += 1) await demo.touch("touchMove", { x: 60 + 40 * i, y: 160 + 28 * i });
  await demo.touch("touchEnd");
  await demo.idle();
  const [a, b] = [await doc(from), await doc(to)];
  const near = (values: readonly number[], wanted: readonly number[]): boolean => values.every((value, i) => Math.abs(value - (wanted[i] ?? NaN)) < 2e-3);
  const box = (points: readonly { x: number; y: number }[]): number[] => [Math.min(...points.map(({ x }) => x)), Math.min(...points.map(({ y }) => y)), Math.max(...points.map(({ x }) => x)), Math.max(...points.map(({ y }) => y))];
  assert.ok(near(box(await demo.points()), [a.x, a.y, b.x, b.y]));
  assert.doesNotMatch(await demo.textOf("hint"), /press v|shift|\balt\b/iu);
  await demo.page.waitForTimeout(450);
  const place = { x: 150, y: 420 };
  await demo.tap([place]);
  const { points } = (await demo.state()).curve.contours[1] ?? { points: [] };
  const [left = 0, top = 0, right = 0, bottom = 0] = box(points);
  assert.ok(near([(left + right) / 2, (top + bottom) / 2], [(await doc(place)).x, (await doc(place)).y]) && Math.abs(right - left - (bottom - top)) < 1e-9);
  const before = await demo.state();
  await demo.touch("touchStart", { x: 150, y: 250 }, { x: 200, y: 250 });
  for (let i = 1; i <= 5; i += 1) await demo.touch("touchMove", { x: 150 - 12 * i, y: 250 }, { x: 200 + 12 * i, y: 250 });
  await demo.touch("touchEnd");
  await demo.idle();
  const after = await demo.state();
  assertSame(after.curve, before.curve);
  assert.ok(after.view.zoom > 1.5 * before.view.zoom);
});

test("every tool is as large as a finger, on the page, and under nothing, on phones of every shape and with large text", async (t) => {
  const sizes = [[390, 844], [320, 568], [480, 320], [511, 383], [512, 383], [568, 320], [320, 256]] as const;
  for (const [width, height] of sizes) {
    // A page that is zoomed to 400 % has large text already.
    const isZoomed = height < 288;
    for (const text of isZoomed ? ["100%"] : ["100%", "200%"]) {
      const demo = await open(t, "#/curve?sample=heart", { ...phone, viewport: { width, height } });
      await demo.page.evaluate((size) => { document.documentElement.style.fontSize = size; }, text);
      await demo.still();
      const tools = await demo.page.locator(".rail .tool:visible").evaluateAll((all) => all.map((tool) => {
        const { left, top, right, bottom, width: across, height: down } = tool.getBoundingClientRect();
        const found = [left + 4, right - 4].flatMap((x) => [top + 4, bottom - 4].map((y) => tool.contains(document.elementFromPoint(x, y))));
        return { name: tool.ariaLabel, across, down, isFree: found.every(Boolean) };
      }));
      const where = `${width} × ${height}, ${text}: ${JSON.stringify(tools)}`;
      assert.deepEqual(tools.map(({ name }) => name), ["Select and edit", "Pen", "Draw", "Ellipse", "Rectangle", "Pan"], where);
      assert.ok(tools.every(({ isFree }) => isFree), where);
      const least = isZoomed ? 24 : Math.min(44, 0.14 * Math.min(width, height));
      assert.ok(tools.every(({ across, down }) => across >= least - 0.01 && down >= least - 0.01), where);
    }
  }
});

test("what was drawn comes back after a reload, and with a link", async (t) => {
  const demo = await empty(await open(t, "", clipboard));
  await demo.press("l");
  await pressAndMove(demo, [250, 180], [490, 340]);
  await letGo(demo);
  const drawn = await demo.kept();
  const url = new URL(await demo.copied(() => demo.byId("btn-share").click()));
  await demo.page.reload();
  await demo.page.evaluate(() => window.explineDemo.ready);
  assertSame((await demo.state()).curve, drawn);
  const other = new Demo(await (await context(t)).newPage());
  await other.load(url.hash);
  assertSame((await other.state()).curve, drawn);
  assert.ok(await other.metric("m-error") <= 1e-9);
});

test("Fit has its own tools, and those of shapes are there again in Curve", async (t) => {
  const demo = await open(t);
  await demo.focusStage();
  await demo.press("m", "2");
  for (const id of ["tool-ellipse", "tool-rectangle", "tool-select"]) assert.equal(await demo.byId(id).isVisible(), false, id);
  assert.equal(await demo.byId("tool-draw").getAttribute("aria-pressed"), "true");
  await demo.press("l", "1");
  assert.equal(await demo.byId("tool-select").getAttribute("aria-pressed"), "true");
  assert.equal(await demo.byId("tool-ellipse").isVisible(), true);
});

test("an empty drawing's card makes way for a tool that draws", async (t) => {
  const demo = await empty(await open(t));
  await demo.byId("empty-curve").waitFor();
  for (const key of ["l", "m", "d", "p"]) {
    await demo.press(key);
    assert.equal(await demo.byId("empty-curve").count(), 0, key);
    await demo.press(key === "m" ? "h" : "v");
    await demo.byId("empty-curve").waitFor();
  }
});
