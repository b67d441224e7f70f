import assert from "node:assert/strict";
import { test, type TestContext } from "node:test";
import { useBrowser, type Demo, type Pair } from "./page.ts";

/** Drawings in the coordinates of maps. What browsers keep of a path, seven digits, is too little for them. */

const { open } = useBrowser();

/** Of a grid of metres that maps are printed with. */
const far: Pair = [500_000, 5_400_000];

async function opened(t: TestContext, hash: string, text: string): Promise<Demo> {
  const demo = await open(t, hash);
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill(text);
  await demo.byId("import-replace").check();
  await demo.byId("import-apply").click();
  await demo.byId("import-apply").waitFor({ state: "detached" });
  await demo.byId("zoom-fit").click();
  await demo.idle();
  return demo;
}

/** A shape of 100 by 160 with its corner at a place. */
function shapeAt([x, y]: Pair): string {
  return `M${x} ${y}C${x + 60} ${y} ${x + 100} ${y + 40} ${x + 100} ${y + 80}S${x + 30} ${y + 160} ${x} ${y + 120}z`;
}

/** The stage in shades of grey, a character each. */
function shades(demo: Demo): Promise<string> {
  return demo.page.evaluate(() => {
    const { data } = document.querySelector("canvas")?.getContext("2d")?.getImageData(0, 0, 936, 720) ?? { data: [] };
    let text = "";
    for (let i = 0; i < data.length; i += 4) text += String.fromCharCode(Math.round(((data[i] ?? 0) + (data[i + 1] ?? 0) + (data[i + 2] ?? 0)) / 3));
    return text;
  });
}

/**
 * Places are rounded elsewhere, to a hundredth of a pixel: the rim of a line may be so much darker or lighter, of 255.
 */
const slightly = 16;

/** How many pixels of two pages differ by more than slightly, of a thousand that are no paper. */
async function difference(near: Demo, away: Demo): Promise<number> {
  const [a, b] = [await shades(near), await shades(away)];
  let [drawn, differ] = [0, 0];
  for (let i = 0; i < a.length; i += 1) {
    if (a.charCodeAt(i) !== a.charCodeAt(0)) drawn += 1;
    if (Math.abs(a.charCodeAt(i) - b.charCodeAt(i)) > slightly) differ += 1;
  }
  assert.ok(drawn > 1000, "something is drawn");
  return (1000 * differ) / drawn;
}

/** Here and there the end of a tooth; a line that is missing or has stairs is fifty and more. */
const few = 2;

test("a drawing that is far away is drawn as it would be near by: as a whole, from close by, and in a drag", async (t) => {
  const pages = [await opened(t, "#/curve", shapeAt([0, 0])), await opened(t, "#/curve", shapeAt(far))] as const;
  for (const overlay of ["ov-comb", "ov-polygon", "ov-grid"]) for (const demo of pages) await demo.byId(overlay).check();
  for (const demo of pages) await demo.idle();
  assert.ok(await difference(...pages) < few, "as a whole");
  const places = await Promise.all(pages.map((demo) => demo.centre("pt-0-1")));
  for (const [i, demo] of pages.entries()) await demo.wheel(places[i] ?? { x: 0, y: 0 }, 25);
  assert.ok(await difference(...pages) < few, "from close by");
  for (const demo of pages) {
    const { x, y } = await demo.centre("pt-0-1");
    await demo.page.mouse.move(x, y);
    await demo.page.mouse.down();
    await demo.page.mouse.move(x - 90, y + 40, { steps: 4 });
    await demo.idle();
  }
  assert.ok(await difference(...pages) < few, "in a drag");
  for (const demo of pages) await demo.page.mouse.up();
});

test("measurements that are far away are drawn as they would be near by, and so is their curve", async (t) => {
  const table = ([x, y]: Pair): string => Array.from({ length: 60 }, (_, i) => `${x + i},${y + 20 * Math.sin(i / 9)}`).join("\n");
  const pages = [await opened(t, "#/fit", table([0, 0])), await opened(t, "#/fit", table(far))] as const;
  for (const overlay of ["ov-residual", "ov-heat", "ov-comb", "ov-parts"]) for (const demo of pages) await demo.byId(overlay).check();
  for (const demo of pages) {
    const { x, y } = await demo.toScreen(...((await demo.state()).fit.data[14] ?? [0, 0]));
    await demo.wheel({ x, y }, 12);
  }
  // The fit itself rounds otherwise there: its curve, comb and residuals may be a little off.
  assert.ok(await difference(...pages) < few);
});
