import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { assertSame, useBrowser, type Demo } from "./page.ts";
import { evaluatePath } from "./path-oracle.ts";

/** Tables of measurements in Fit: y points up, and the numbers stay what they are. */

const { open } = useBrowser();

/** A curve that rises and levels off, as people who measure see it. */
const rows = Array.from({ length: 40 }, (_, i) => [i, Number((20 + 15 * (1 - Math.exp(-i / 12))).toFixed(3))] as [number, number]);
const table = `t,v\n${rows.map(([t, v]) => `${t},${v}`).join("\n")}`;
/** A stroke that goes down on the screen. */
const falling = "M0 0C10 0 20 10 30 30";

async function imported(demo: Demo, text: string, replaces = true): Promise<void> {
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill(text);
  await demo.byId("import-replace").setChecked(replaces);
  await demo.byId("import-apply").click();
  await demo.byId("import-apply").waitFor({ state: "detached" });
  await demo.idle();
}

/** Whether the last of the data is higher on the screen than the first. */
async function rises(demo: Demo): Promise<boolean> {
  const { data } = (await demo.state()).fit;
  const [[x0, y0] = [0, 0], [x1, y1] = [0, 0]] = [data[0], data.at(-1)];
  return (await demo.toScreen(x1, y1)).y < (await demo.toScreen(x0, y0)).y;
}

async function isInSight(demo: Demo): Promise<void> {
  const { data } = (await demo.state()).fit;
  for (const [x, y] of data) {
    const at = await demo.toScreen(x, y);
    assert.ok(at.x > 40 && at.x < 976 && at.y > 48 && at.y < 708, `${x}, ${y} is seen at ${at.x}, ${at.y}`);
  }
}

test("a ring of positions is closed in Fit, however few they are, and comes back as it was drawn", async (t) => {
  const demo = await open(t, "#/fit");
  const ring = [[0, 0], [60, 0], [60, 20], [20, 20], [20, 50], [0, 50], [0, 0]];
  await imported(demo, JSON.stringify({ type: "Polygon", coordinates: [ring] }));
  assertSame((await demo.state()).fit.data, ring);
  assert.match(await demo.byId("panel").innerText(), /One closed stroke/u);
  assert.equal(await demo.byId("fit-target").inputValue(), "error", "it was not measured, so there is no noise to smooth");
  for (const [x = NaN, y = NaN] of await demo.sample(200)) {
    // Of a drawing of 60 by 50 the tolerance is .2.
    const inside = x > -0.3 && y > -0.3 && ((x < 60.3 && y < 20.3) || (x < 20.3 && y < 50.3));
    assert.ok(inside, `${x}, ${y} is no place of an L`);
  }
});

test("a table of measurements rises where its numbers do, and one press turns it over; the numbers stay", async (t) => {
  const demo = await open(t, "#/fit");
  assert.equal(await demo.byId("fit-up").isVisible(), false, "a sample is as it was drawn");
  await imported(demo, table);
  assert.match(await demo.textOf("toast"), /y points up, as in a chart/u);
  assertSame((await demo.state()).fit.data, rows);
  assert.equal(await rises(demo), true);
  await isInSight(demo);
  for (const id of ["m-rms", "m-max"]) assert.doesNotMatch(await demo.textOf(id), /px/u, "nobody has said what was measured");
  assert.match(await demo.byId("panel").innerText(), /40 points → (?:1 knot|\d+ knots) \(/u);
  // What the knots and the samples say is in the numbers of the data, too.
  const [last] = (await demo.sample(2)).slice(-1);
  assert.ok(Math.abs((last?.[1] ?? 0) - 34.4) < 1, String(last));

  await demo.byId("fit-up").locator("[value=down]").check();
  await demo.idle();
  assert.equal(await rises(demo), false);
  assertSame((await demo.state()).fit.data, rows);
  await isInSight(demo);
  await demo.press("Control+z");
  assert.equal(await rises(demo), true);
  await isInSight(demo);

  // The picture turns with the numbers: the curve is where the points are.
  const at = await demo.toScreen(39, 34.4);
  const seen = await demo.page.evaluate(([x, y]) => {
    const canvas = document.querySelector("canvas");
    const box = canvas?.getBoundingClientRect();
    const data = canvas?.getContext("2d")?.getImageData(x - (box?.left ?? 0) - 4, y - (box?.top ?? 0) - 4, 8, 8).data ?? [];
    return data.some((value, i) => i % 4 === 0 && value < 90);
  }, [at.x, at.y] as const);
  assert.ok(seen, "the end of the curve is drawn where it is said to be");
  assert.deepEqual(demo.complaints, []);
});

test("wheel, drags of the hand and strokes go where the pointer goes while y points up", async (t) => {
  const demo = await open(t, "#/fit");
  await imported(demo, table);
  const under = await demo.toDoc(700, 250);
  await demo.wheel({ x: 700, y: 250 }, 3);
  const now = await demo.toScreen(under.x, under.y);
  assert.ok(Math.hypot(now.x - 700, now.y - 250) < 0.5, `${now.x}, ${now.y}`);
  await demo.press("h");
  const before = await demo.toScreen(10, 28);
  await demo.dragFrom({ x: 500, y: 400 }, 60, 45);
  const after = await demo.toScreen(10, 28);
  assert.ok(Math.hypot(after.x - before.x - 60, after.y - before.y - 45) < 1);
  await demo.press("d");
  await demo.dragFrom({ x: 200, y: 500 }, 300, 100);
  const { data } = (await demo.state()).fit;
  const [x, y] = data.at(-1) ?? [0, 0];
  const end = await demo.toScreen(x, y);
  assert.ok(Math.hypot(end.x - 500, end.y - 600) < 1.5, `the stroke ends at ${end.x}, ${end.y}`);
});

test("a chart leaves Fit the right way up: as a file, which says so, and in Curve, in sight", async (t) => {
  const demo = await open(t, "#/fit");
  await imported(demo, table);
  await demo.byId("btn-export").click();
  assert.match(await demo.textOf("export-turned"), /other sign/u);
  const [file] = await Promise.all([demo.page.waitForEvent("download"), demo.byId("export-svg").click()]);
  const d = / d="([^"]+)"/u.exec(await readFile(await file.path(), "utf8"))?.[1] ?? "";
  const drawn = evaluatePath(d)[0]?.points ?? [];
  assert.ok(Math.abs((drawn[0]?.[1] ?? 0) + 20) < 1.5 && Math.abs((drawn.at(-1)?.[1] ?? 0) + 34.4) < 1.5, d);
  await demo.page.keyboard.press("Escape");

  const [left, top] = [await demo.toScreen(0, 20), await demo.toScreen(39, 34.4)];
  await demo.byId("fit-edit").click();
  await demo.idle();
  const points = await demo.points();
  const [first, last] = [points[0], points.at(-1)];
  assert.ok(first !== undefined && last !== undefined);
  const [a, b] = [await demo.toScreen(first.x, first.y), await demo.toScreen(last.x, last.y)];
  assert.ok(Math.hypot(a.x - left.x, a.y - left.y) < 30 && Math.hypot(b.x - top.x, b.y - top.y) < 30, "it is where it was");
  // The other modes are seen as ever.
  await demo.press("4");
  await demo.press("2");
  assert.equal(await rises(demo), true);
});

test("a drawing beside a chart stays upright, one in its place is one, and a saved chart is opened as it was", async (t) => {
  const demo = await open(t, "#/fit");
  await imported(demo, table);
  const state = await demo.state();
  await imported(demo, falling, false);
  const { data } = (await demo.state()).fit;
  const [from, to] = [data[rows.length] ?? [0, 0], data.at(-1) ?? [0, 0]];
  assert.ok((await demo.toScreen(to[0] ?? 0, to[1] ?? 0)).y > (await demo.toScreen(from[0] ?? 0, from[1] ?? 0)).y + 20, "it falls, as it did");
  await imported(demo, falling);
  assert.equal(await rises(demo), false);
  assert.ok(((await demo.state()).fit.data.at(-1)?.[1] ?? 0) > 29, "in its own numbers");
  await demo.page.evaluate((saved) => window.explineDemo.setState(saved), state);
  await demo.idle();
  assert.equal(await rises(demo), true);
  assertSame((await demo.state()).fit, state.fit);
  assertSame((await demo.state()).view, state.view);
});

test("the preview of an export has a wash inside closed contours only, as the stage has", async (t) => {
  const demo = await open(t, "#/curve?sample=sine");
  await demo.byId("btn-export").click();
  await demo.byId("export-deviation").waitFor();
  const fills = (): Promise<string[]> => demo.byId("export-dialog").locator(".export-picture path").evaluateAll((paths) =>
    paths.filter((path) => path.getAttribute("d") !== "").map((path) => getComputedStyle(path).fill));
  assert.deepEqual(await fills(), ["none"]);
});
