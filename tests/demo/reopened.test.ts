import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test, type TestContext } from "node:test";
import { assertSame, directedDistance, useBrowser, type Demo } from "./page.ts";

/**
 * What was saved is opened again as anybody would: by the page's own file field, in a page that knows nothing of it.
 */

const { open } = useBrowser();

/** A file that the page hands out, under the name that it gives it. */
async function saved(t: TestContext, demo: Demo, save: () => Promise<unknown>): Promise<string> {
  const folder = await mkdtemp(join(tmpdir(), "expline-"));
  t.after(() => rm(folder, { recursive: true }));
  const [download] = await Promise.all([demo.page.waitForEvent("download"), save()]);
  const path = join(folder, download.suggestedFilename());
  await download.saveAs(path);
  return path;
}

async function reopened(t: TestContext, path: string): Promise<Demo> {
  const demo = await open(t);
  await demo.byId("btn-import").click();
  await demo.byId("import-file").setInputFiles(path);
  await demo.byId("toast").waitFor();
  await demo.idle();
  return demo;
}

/** Presses `]` so many times: what it reaches is chosen. */
async function choose(demo: Demo, steps: number): Promise<void> {
  await demo.focusStage();
  for (let i = 0; i < steps; i += 1) await demo.press("]");
}

async function typed(demo: Demo, id: string, value: string): Promise<void> {
  await demo.byId(id).fill(value);
  await demo.press("Enter");
}

const WORKS: readonly (readonly [name: string, hash: string, work: (demo: Demo) => Promise<void>])[] = [
  ["points at a finer level", "#/curve?sample=blob-16", async (demo) => {
    await demo.slide("level", 2);
    await choose(demo, 3);
    await demo.press("ArrowUp");
  }],
  ["finer points near one place", "#/curve?sample=blob-16", async (demo) => {
    await choose(demo, 2);
    await demo.page.getByRole("button", { name: "Refine here" }).click();
    await demo.idle();
  }],
  ["a curve of another space", "#/curve?sample=hyperbola", async (demo) => {
    await choose(demo, 1);
    await demo.press("ArrowUp", "c");
  }],
  ["a fit and how it was asked for", "#/fit?sample=fit-star", async (demo) => {
    await demo.slide("fit-smoothing", 63.5);
    await demo.slide("fit-mix", 70);
    await typed(demo, "fit-noise", "3");
  }],
  ["strokes of a hand", "#/fit", async (demo) => {
    await demo.byId("btn-clear").click();
    await demo.dragFrom({ x: 300, y: 300 }, 200, 100);
    await demo.dragFrom({ x: 350, y: 500 }, 300, -40);
  }],
  ["a trace and how it was asked for", "#/trace?sample=trace-logo", async (demo) => {
    await demo.slide("trace-detail", 52);
    await demo.slide("trace-corner", 61);
  }],
  ["a refined surface", "#/surface?sample=surf-sphere", async (demo) => {
    await demo.slide("surf-level-u", 1);
    await choose(demo, 12);
    await demo.byId("surf-refine").click();
    await demo.press("ArrowUp");
  }],
];

for (const [name, hash, work] of WORKS) {
  test(`${name}, saved by Ctrl+S and opened again, is the same to the last digit, under the name of what was on the stage`, async (t) => {
    const demo = await open(t, hash);
    await work(demo);
    await demo.idle();
    const state = await demo.state();
    await demo.focusStage();
    const path = await saved(t, demo, () => demo.page.keyboard.press("Control+s"));
    assert.ok(path.endsWith(`/${state[state.mode].sample ?? "expline"}.json`), path);
    assertSame(await (await reopened(t, path)).state(), state);
  });
}

for (const hash of ["#/curve?sample=circle-2", "#/curve?sample=glyph", "#/fit?sample=fit-roundrect", "#/trace?sample=trace-logo"]) {
  test(`the SVG of ${hash}, opened again, has the same contours within what Export says of it`, async (t) => {
    const demo = await open(t, hash);
    await demo.press("Control+e");
    await demo.byId("export-dialog").waitFor();
    const stated = await demo.metric("export-deviation");
    const path = await saved(t, demo, () => demo.byId("export-svg").click());
    const other = await reopened(t, path);
    const { contours } = (await other.state()).curve;
    assert.ok(contours.length > 0);
    for (const [i, { closed }] of contours.entries()) {
      const [here, there] = [await demo.sample(1500, i), await other.sample(6000, i)];
      const away = directedDistance(here, there, closed);
      // The polygon of 6000 sides is that far inside its curve.
      assert.ok(away <= stated + 1e-3, `contour ${i}: ${away} away, said to be ${stated}`);
    }
  });
}
