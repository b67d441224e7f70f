import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser } from "./page.ts";

const { open } = useBrowser();

function percentile(values: readonly number[], part: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))] ?? 0;
}

const MOVES = 120;

/**
 * Times are printed beside the budget and not asserted: a busy neighbour says nothing about the page. Work is asserted.
 */
test("V28 dragging in 64 points with the comb on paints at most once in a frame and ends under the pointer", async (t) => {
  const demo = await open(t, "#/curve?sample=net-64");
  await demo.withoutSnap();
  await demo.byId("ov-comb").check();
  await demo.idle();
  const { page } = demo;
  const at = await demo.centre("pt-0-5");
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.evaluate(() => {
    const times: number[] = [];
    const note = (time: number): void => {
      times.push(time);
      if (times.length < 4000) requestAnimationFrame(note);
    };
    Reflect.set(window, "frameClock", times);
    requestAnimationFrame(note);
  });
  const painted = (await demo.stats()).frameMs.length;
  let to = at;
  for (let i = 0; i < MOVES; i += 1) {
    to = { x: at.x + 60 * Math.sin(i / 12), y: at.y + 40 * Math.sin(i / 9) };
    await page.mouse.move(to.x, to.y);
  }
  await page.mouse.up();
  await demo.idle();
  const frameMs = (await demo.stats()).frameMs.slice(painted);
  const clock = await page.evaluate(() => Reflect.get(window, "frameClock") as number[]);
  const intervals = clock.slice(1).map((time, i) => time - (clock[i] ?? time));
  t.diagnostic(`net-64 with comb: frame p95 ${percentile(frameMs, 0.95).toFixed(2)} ms of 12, interval p95 ${percentile(intervals, 0.95).toFixed(1)} ms of 40`);
  const place = await demo.point(5).then(({ x, y }) => demo.toScreen(x, y));
  assert.ok(Math.hypot(place.x - to.x, place.y - to.y) <= 0.5);
  assert.ok(frameMs.length > 0 && frameMs.length <= clock.length + 2, `painted ${frameMs.length} times in ${clock.length} frames`);
});
