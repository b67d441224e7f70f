import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser } from "./page.ts";

const { open } = useBrowser();

test("V18 the stage follows while the slider is dragged", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  const box = await demo.byId("fit-smoothing").boundingBox();
  assert.ok(box !== null);
  const { mouse } = demo.page;
  await mouse.move(box.x + 0.2 * box.width, box.y + box.height / 2);
  await mouse.down();
  const pictures = new Set<string>();
  for (let i = 0; i <= 30; i += 1) {
    await mouse.move(box.x + (0.2 + 0.02 * i) * box.width, box.y + box.height / 2);
    await demo.page.waitForTimeout(40);
    pictures.add(await demo.pixels());
  }
  await mouse.up();
  await demo.idle();
  assert.ok(pictures.size >= 5, `${pictures.size} pictures before the release`);
});

test("undo takes back a stroke and a slider drag, one entry each; the points survive a visit to Curve", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-circle");
  const before = (await demo.state()).fit;
  await demo.slide("fit-smoothing", 60);
  await demo.click("btn-undo");
  assert.equal((await demo.state()).fit.smoothing, before.smoothing);
  await demo.byId("tab-curve").click();
  await demo.byId("tab-fit").click();
  await demo.idle();
  assert.deepEqual((await demo.state()).fit.data, before.data);
  assert.deepEqual(demo.complaints, []);
});

test("a shared link holds the sample by its name, its noise and its seed", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-circle");
  await demo.slide("fit-noise", 4);
  const { data } = (await demo.state()).fit;
  const hash = await demo.page.evaluate(async () => {
    let copied = "";
    Object.defineProperty(navigator, "clipboard", { configurable: true, value: { writeText: async (text: string) => void (copied = text) } });
    document.querySelector<HTMLElement>('[data-testid="btn-share"]')?.click();
    await new Promise((resolve) => setTimeout(resolve, 300));
    return new URL(copied).hash;
  });
  assert.ok(hash.startsWith("#s=") && hash.length < 1500, `${hash.length} characters`);
  const other = await open(t, hash);
  assert.deepEqual((await other.state()).fit.data, data);
});
