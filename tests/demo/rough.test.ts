import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser } from "./page.ts";

const { open } = useBrowser();

/** What a careless hand, a small window or a strange screen does to the page. */

test("DM-010 undo during a drag cancels the drag, and the rest of the drag does nothing", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const before = (await demo.state()).curve;
  const { x, y } = await demo.centre("pt-0-1");
  const { mouse } = demo.page;
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + 50, y + 30, { steps: 4 });
  await demo.press("Control+z");
  await mouse.move(x + 80, y + 60, { steps: 4 });
  await mouse.up();
  await demo.idle();
  assert.deepEqual((await demo.state()).curve, before);
  assert.deepEqual(demo.complaints, []);
});

test("DM-011 deleting the point that is being dragged deletes it, and the drag ends", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.click("pt-0-1");
  const { x, y } = await demo.centre("pt-0-1");
  const { mouse } = demo.page;
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + 50, y + 30, { steps: 4 });
  await demo.press("Delete");
  await mouse.move(x + 80, y + 60, { steps: 4 });
  await mouse.up();
  await demo.idle();
  assert.equal((await demo.points()).length, 7);
  assert.deepEqual(demo.complaints, []);
});

test("a drag goes on over the panel and outside the window", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.withoutSnap();
  const before = await demo.point(0);
  const from = await demo.centre("pt-0-0");
  const { mouse } = demo.page;
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(1200, 400, { steps: 5 });
  await mouse.move(1400, 900, { steps: 5 });
  await mouse.up();
  await demo.idle();
  const after = await demo.point(0);
  assert.ok(Math.abs(after.x - before.x - (1400 - from.x)) <= 0.5 && Math.abs(after.y - before.y - (900 - from.y)) <= 0.5);
});

test("DM-014 events made by a script, without pressure, places between and a pointer to capture, drag as a hand does", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.withoutSnap();
  const before = await demo.point(1);
  const { x, y } = await demo.centre("pt-0-1");
  await demo.page.evaluate(([px, py]) => {
    const surface = document.querySelector('[data-testid="stage"]');
    const send = (type: string, dx: number): void => {
      surface?.dispatchEvent(new PointerEvent(type, { pointerId: 77, pointerType: "mouse", clientX: px + dx, clientY: py, button: 0, bubbles: true, cancelable: true }));
    };
    send("pointerdown", 0);
    send("pointermove", 20);
    send("pointermove", 40);
    send("pointerup", 40);
  }, [x, y] as const);
  await demo.idle();
  assert.ok(Math.abs((await demo.point(1)).x - before.x - 40) <= 0.5);
  assert.deepEqual(demo.complaints, []);
});

test("DM-012 a hundred thousand pointer moves between two frames are one move", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.withoutSnap();
  const { x, y } = await demo.centre("pt-0-1");
  const before = await demo.point(1);
  await demo.page.mouse.move(x, y);
  await demo.page.mouse.down();
  const frames = await demo.page.evaluate(async ([px, py]) => {
    const surface = document.querySelector('[data-testid="stage"]');
    const start = window.explineDemo.stats().frameMs.length;
    for (let i = 1; i <= 100_000; i += 1) {
      surface?.dispatchEvent(new PointerEvent("pointermove", { pointerId: 1, pointerType: "mouse", clientX: px + i / 2500, clientY: py, bubbles: true }));
    }
    await window.explineDemo.idle();
    return window.explineDemo.stats().frameMs.length - start;
  }, [x, y] as const);
  await demo.page.mouse.move(x + 40, y);
  await demo.page.mouse.up();
  await demo.idle();
  assert.ok(frames <= 3, `${frames} frames`);
  assert.ok(Math.abs((await demo.point(1)).x - before.x - 40) <= 0.5);
});

test("DM-015 a stage of no size draws nothing and comes back", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const picture = await demo.pixels();
  const size = (): Promise<number> => demo.page.evaluate(() => document.querySelector("canvas")?.width ?? NaN);
  const wide = await size();
  await demo.page.evaluate(() => {
    const surface = document.querySelector<HTMLElement>('[data-testid="stage"]');
    if (surface !== null) surface.style.width = "0";
  });
  await demo.until(size, (width) => width < wide, "the canvas follows the stage");
  await demo.press("f");
  await demo.press("0");
  const { view } = await demo.state();
  assert.ok([view.zoom, view.x, view.y].every(Number.isFinite));
  await demo.page.evaluate(() => {
    const surface = document.querySelector<HTMLElement>('[data-testid="stage"]');
    if (surface !== null) surface.style.width = "";
  });
  await demo.until(size, (width) => width === wide, "the canvas is as it was");
  await demo.idle();
  assert.equal((await demo.pixels()).length, picture.length);
  assert.deepEqual(demo.complaints, []);
});

test("DM-016 zooming out and in far beyond the limits leaves a view of numbers", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.wheel({ x: 640, y: 420 }, -200);
  await demo.wheel({ x: 640, y: 420 }, 200);
  const { view } = await demo.state();
  assert.ok([view.zoom, view.x, view.y].every(Number.isFinite));
  assert.deepEqual(demo.complaints, []);
});

test("DM-017 a screen of very many pixels gets a canvas that browsers can hold", async (t) => {
  const demo = await open(t, "", { viewport: { width: 3840, height: 2160 }, deviceScaleFactor: 3 });
  const pixels = await demo.page.evaluate(() => {
    const canvas = document.querySelector("canvas");
    return (canvas?.width ?? 0) * (canvas?.height ?? 0);
  });
  assert.ok(pixels > 1e6 && pixels <= 16_777_216, `${pixels} pixels`);
});

test("DM-033 a fit that a hidden tab holds up is done when the tab comes back, as if nothing had been", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-coast");
  await demo.slide("fit-smoothing", 55);
  const { fit } = await demo.state();
  await demo.slide("fit-smoothing", 20);
  const devtools = await demo.page.context().newCDPSession(demo.page);
  await demo.byId("fit-smoothing").fill("55");
  await devtools.send("Page.setWebLifecycleState", { state: "frozen" });
  // Whatever was to happen in this time happens afterwards.
  await demo.page.waitForTimeout(700);
  await devtools.send("Page.setWebLifecycleState", { state: "active" });
  await demo.idle();
  assert.deepEqual((await demo.state()).fit, fit);
  assert.deepEqual(demo.complaints, []);
});
