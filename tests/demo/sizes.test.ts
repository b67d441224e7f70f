import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";
import { bothWays, evaluatePath } from "./path-oracle.ts";

/** Drawings a hundred thousand times smaller and larger than those of the samples, from the file to the file again. */

const { open } = useBrowser();

/** A drop 0.8 of the size wide, with a line along it. */
function fileOf(size: number): string {
  const at = (part: number): string => String(Number((part * size).toPrecision(6)));
  const d = `M${at(0.1)} ${at(0.1)}H${at(0.9)}V${at(0.5)}C${at(0.9)} ${at(0.9)} ${at(0.1)} ${at(0.9)} ${at(0.1)} ${at(0.5)}Z`;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${at(1)} ${at(1)}"><path fill="none" stroke="teal" stroke-width="${at(0.02)}" d="${d}"/></svg>`;
}

async function imported(demo: Demo, text: string): Promise<void> {
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill(text);
  await demo.byId("import-apply").click();
  await demo.byId("import-apply").waitFor({ state: "detached" });
  await demo.idle();
}

async function exported(demo: Demo): Promise<string> {
  await demo.byId("btn-export").click();
  const [file] = await Promise.all([demo.page.waitForEvent("download"), demo.byId("export-svg").click()]);
  await demo.page.keyboard.press("Escape");
  await demo.byId("export-dialog").waitFor({ state: "detached" });
  return readFile(await file.path(), "utf8");
}

/** Width on the screen of what lies between two places of the drawing. */
async function widthOf(demo: Demo, from: number, to: number): Promise<number> {
  const [a, b] = [await demo.toScreen(from, 0), await demo.toScreen(to, 0)];
  return b.x - a.x;
}

for (const size of [1e-5, 0.01, 1, 1e6]) {
  test(`a drawing of ${size} units fills the stage, is edited by hand, by keys and by numbers, and comes back as it was`, async (t) => {
    const demo = await open(t);
    await imported(demo, fileOf(size));
    await demo.withoutSnap();
    const width = await widthOf(demo, 0.1 * size, 0.9 * size);
    assert.ok(width > 300 && width < 936, `${width} px wide`);

    // Thirty notches further in a part of it is seen large; all of it comes back, and as small as a stamp.
    const middle = await demo.centre("stage");
    await demo.wheel(middle, 30);
    assert.ok(await widthOf(demo, 0, size) > 8000, "its parts can be seen");
    await demo.wheel(middle, -200);
    assert.ok(await widthOf(demo, 0, size) < 100, "it can be seen small");
    await demo.byId("zoom-fit").click();
    await demo.idle();

    const before = await demo.points();
    const step = 50 / ((await demo.toScreen(size, 0)).x - (await demo.toScreen(0, 0)).x) * size;
    await demo.drag("pt-0-2", 50, 0);
    const { x } = await demo.point(2);
    assert.ok(Math.abs(x - (before[2]?.x ?? NaN) - step) < 0.02 * size, `it follows the pointer: ${x}`);
    await demo.focusStage();
    await demo.press("ArrowRight");
    const nudged = (await demo.point(2)).x - x;
    assert.ok(nudged > 0 && nudged <= size / 10, `an arrow moves it by ${nudged}`);
    // What the field prints is to a thousandth of the drawing what is there, and what is typed is what comes of it.
    const field = demo.byId("pt-x");
    assert.ok(Math.abs(Number(await field.inputValue()) - (await demo.point(2)).x) <= size / 1000, await field.inputValue());
    await field.fill(String(Number((0.85 * size).toPrecision(6))));
    await field.press("Enter");
    assert.equal((await demo.point(2)).x, Number((0.85 * size).toPrecision(6)));

    const now = await demo.sample(400);
    const file = await exported(demo);
    const d = / d="([^"]+)"/u.exec(file)?.[1] ?? "";
    const [subpath] = evaluatePath(d);
    const away = bothWays(now, subpath?.points ?? [], true);
    assert.ok(away < size / 1000, `${away} away`);
    const edited = await demo.points();
    await imported(demo, file);
    const again = (await demo.state()).curve.contours.at(-1);
    assert.equal(again?.points.length, edited.length);
    again?.points.forEach((point, i) => {
      assert.ok(Math.hypot(point.x - (edited[i]?.x ?? NaN), point.y - (edited[i]?.y ?? NaN)) <= size / 1000, `point ${i} of ${JSON.stringify(again.points)}`);
    });
    assert.ok(Math.abs((again?.line?.width ?? NaN) - 0.02 * size) < 1e-6 * size, "its line is as wide as it was");
    assert.deepEqual(demo.complaints, []);
  });
}

test("what is kept and shared of a tiny drawing is opened at the zoom that it was left at", async (t) => {
  const demo = await open(t, "", { permissions: ["clipboard-read", "clipboard-write"] });
  await imported(demo, fileOf(1e-5));
  const { view } = await demo.state();
  const link = await demo.copied(() => demo.byId("btn-share").click());
  const other = await open(t, link.slice(link.indexOf("#")));
  assert.deepEqual((await other.state()).view, view);
  assert.deepEqual(other.complaints, []);
});

test("a drawing of a million units in Fit can be saved and opened again", async (t) => {
  const demo = await open(t, "#/fit");
  await imported(demo, fileOf(1e6));
  const { fit } = await demo.state();
  assert.ok(fit.data.length > 20);
  const state = await demo.state();
  await demo.page.evaluate((saved) => window.explineDemo.setState(saved), state);
  assert.deepEqual((await demo.state()).fit.data, fit.data);
});
