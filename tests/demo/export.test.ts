import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { inflateSync } from "node:zlib";
import { test } from "node:test";
import type { Download } from "playwright-core";
import { assertSame, useBrowser, type Demo } from "./page.ts";
import { bothWays, commandsOf, evaluatePath } from "./path-oracle.ts";

const { open } = useBrowser();
const clipboard = { permissions: ["clipboard-read", "clipboard-write"] };

async function openExport(demo: Demo, options: { tolerance?: string; decimals?: string; segments?: string } = {}): Promise<void> {
  await demo.byId("btn-export").click();
  await demo.byId("export-dialog").waitFor();
  if (options.segments !== undefined) await demo.byId("export-segments").selectOption(options.segments);
  for (const [id, value] of [["export-tolerance", options.tolerance], ["export-decimals", options.decimals]] as const) {
    if (value === undefined) continue;
    await demo.byId(id).fill(value);
    await demo.byId(id).press("Enter");
  }
  await demo.byId("export-deviation").waitFor();
}

async function copied(demo: Demo, id: string): Promise<string> {
  await demo.byId(id).click();
  await demo.byId("toast").waitFor();
  return demo.page.evaluate(() => navigator.clipboard.readText());
}

async function downloaded(demo: Demo, id: string): Promise<{ file: Download; bytes: Buffer }> {
  const [file] = await Promise.all([demo.page.waitForEvent("download"), demo.byId(id).click()]);
  return { file, bytes: await readFile(await file.path()) };
}

for (const sample of ["heart", "circle-2", "glyph"]) {
  test(`V16 the path of ${sample} is the curve, and the printed deviation is the true one`, async (t) => {
    const demo = await open(t, `#/curve?sample=${sample}`, clipboard);
    await openExport(demo, { tolerance: "0.02", decimals: "4" });
    const d = await copied(demo, "export-d");
    const subpaths = evaluatePath(d);
    const { contours } = (await demo.state()).curve;
    assert.equal(subpaths.length, contours.length);
    let worst = 0;
    for (const [i, subpath] of subpaths.entries()) {
      assert.equal(subpath.closed, contours[i]?.closed);
      // A multiple of every sample's number of segments: a corner between two samples would be cut off by this test.
      const curve = await demo.sample(3960, i);
      worst = Math.max(worst, bothWays(curve, subpath.points, subpath.closed));
    }
    const printed = await demo.metric("export-deviation");
    t.diagnostic(`true ${worst.toExponential(2)}, printed ${printed.toExponential(2)}, ${d.length} characters`);
    assert.ok(worst <= 0.02 + 1e-3, `${worst} away`);
    // Below the rounding of four decimals and the sampling of this test there is nothing to compare.
    if (worst > 1e-3) assert.ok(Math.abs(printed - worst) <= 0.2 * worst, `printed ${printed}, true ${worst}`);
    else assert.ok(printed <= 1.2e-3, `printed ${printed}`);
    assert.equal(await demo.metric("export-bytes"), d.length);
    await demo.until(() => demo.metric("export-gzip"), (bytes) => bytes > 0, "the compressed size is known");
  });
}

test("the numbers are those of the path that is shown, whichever of them is known last", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.page.evaluate(() => {
    const { arrayBuffer } = Response.prototype;
    let first = true;
    Response.prototype.arrayBuffer = async function (this: Response) {
      const slow = first;
      first = false;
      if (slow) await new Promise((done) => setTimeout(done, 600));
      return arrayBuffer.call(this);
    };
  });
  await openExport(demo, { decimals: "0" });
  const d = await demo.byId("export-preview").inputValue();
  assert.equal(await demo.metric("export-bytes"), d.length);
  const packed = await demo.until(() => demo.metric("export-gzip"), (bytes) => bytes > 0, "the compressed size is known");
  await demo.page.waitForTimeout(1000);
  assert.deepEqual([await demo.metric("export-bytes"), await demo.metric("export-gzip")], [d.length, packed]);
});

test("V16 a circle is arcs and nothing else", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-2", clipboard);
  await openExport(demo);
  const d = await copied(demo, "export-d");
  assert.deepEqual([...new Set(commandsOf(d).map(({ letter }) => letter))].sort(), ["A", "M", "Z"]);
  assert.ok(d.length <= 94, `${d.length} characters`);
});

test("cubics only, a polyline and relative commands draw the same curve", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", clipboard);
  const curve = await demo.sample(4000);
  for (const [segments, letters] of [["cubics", "CMZ"], ["polyline", "LMZ"]] as const) {
    await openExport(demo, { segments, tolerance: "0.05" });
    for (const relative of [false, true]) {
      await demo.byId("export-relative").setChecked(relative);
      const d = await demo.byId("export-preview").inputValue();
      const used = [...new Set(commandsOf(d).map(({ letter }) => letter.toUpperCase()))].sort().join("");
      assert.ok([...used].every((letter) => `${letters}S`.includes(letter)), `${segments}: ${used}`);
      const [subpath] = evaluatePath(d);
      assert.ok(subpath !== undefined);
      const away = bothWays(curve, subpath.points, true);
      assert.ok(away <= 0.05 + 2e-3, `${segments}${relative ? ", relative" : ""}: ${away}`);
    }
    await demo.byId("export-relative").setChecked(false);
    await demo.page.keyboard.press("Escape");
  }
});

test("V16 the SVG file is well formed and its viewBox holds the curve", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await openExport(demo);
  const { file, bytes } = await downloaded(demo, "export-svg");
  assert.equal(file.suggestedFilename(), "heart.svg");
  const text = bytes.toString("utf8");
  const parsed = await demo.page.evaluate((source) => {
    const document = new DOMParser().parseFromString(source, "image/svg+xml");
    return { broken: document.querySelector("parsererror") !== null, box: document.documentElement.getAttribute("viewBox"), d: document.querySelector("path")?.getAttribute("d") };
  }, text);
  assert.equal(parsed.broken, false);
  const [x = 0, y = 0, width = 0, height = 0] = (parsed.box ?? "").split(" ").map(Number);
  for (const [px, py] of await demo.sample(500)) assert.ok(px > x && px < x + width && py > y && py < y + height);
  assert.equal(evaluatePath(parsed.d ?? "").length, 1);
});

test("V16 a drawing goes out as JSON, is cleared, and comes back as it was", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.withoutSnap();
  await demo.drag("pt-0-1", 13, 7);
  const before = await demo.state();
  await openExport(demo);
  const { file, bytes } = await downloaded(demo, "export-json");
  assert.equal(file.suggestedFilename(), "heart.json");
  await demo.page.keyboard.press("Escape");
  await demo.byId("btn-clear").click();
  assert.equal((await demo.state()).curve.contours.length, 0);
  await demo.byId("btn-import").click();
  await demo.byId("import-file").setInputFiles({ name: "heart.json", mimeType: "application/json", buffer: bytes });
  await demo.byId("import-dialog").waitFor({ state: "detached" });
  await demo.idle();
  assertSame(await demo.state(), before);
});

/** Width, height and how many of its pixels are not transparent, from the file's own chunks. */
function readPng(bytes: Buffer): { width: number; height: number; drawn: number } {
  const width = bytes.readUInt32BE(16);
  const height = bytes.readUInt32BE(20);
  assert.deepEqual([bytes[24], bytes[25]], [8, 6], "eight bits, red green blue alpha");
  const data: Buffer[] = [];
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at)) {
    if (bytes.toString("latin1", at + 4, at + 8) === "IDAT") data.push(bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at)));
  }
  const raw = inflateSync(Buffer.concat(data));
  // Filtered rows: a row that is all zero after its filter byte repeats or is empty; counting others bounds the drawn
  // ones.
  let drawn = 0;
  for (let row = 0; row < height; row += 1) for (let i = 1; i <= 4 * width; i += 1) drawn += raw[row * (4 * width + 1) + i] === 0 ? 0 : 1;
  return { width, height, drawn };
}

test("V16 the picture at 2× has the size that its button states, and a drawing on it", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await openExport(demo);
  await demo.byId("export-png-scale").selectOption("2");
  const { bytes } = await downloaded(demo, "export-png");
  const { width, height, drawn } = readPng(bytes);
  // The button has its size once the drawing has been measured.
  await demo.until(() => demo.textOf("export-png"), (text) => text === `PNG ${width} × ${height}`, `${width} × ${height} is stated`);
  const bounds = await demo.sample(2000);
  const wide = Math.max(...bounds.map(([x]) => x)) - Math.min(...bounds.map(([x]) => x));
  assert.ok(width >= 2 * wide && width <= 2 * wide + 80, `${width} pixels for ${wide} units`);
  assert.ok(drawn > 1000, `${drawn} bytes that differ`);
});

test("SX-004 SX-005 numbers in the path are plain decimals, whatever the browser's language", async (t) => {
  const demo = await open(t, "", { ...clipboard, locale: "fa-IR" });
  await demo.page.evaluate(async () => {
    const state = structuredClone(window.explineDemo.getState());
    const point = (x: number, y: number) => ({ x, y, kind: "cusp" as const, in: { dx: 0, dy: 0 }, out: { dx: 0, dy: 0 } });
    const contours = [{ family: "hermite" as const, closed: false, points: [point(1234.5, 1e-7), point(-1e-9, 0.1), point(123456789.123, 1e8)] }];
    await window.explineDemo.setState({ ...state, curve: { space: "polynomial", omega: 0, level: 0, contours } });
  });
  await openExport(demo, { decimals: "3" });
  const d = await demo.byId("export-preview").inputValue();
  assert.match(d, /1234\.5/);
  for (const number of d.match(/[^a-z ,]+/gi) ?? []) for (const part of number.match(/-?[^-]+/g) ?? []) assert.match(part, /^-?\d*\.?\d+$/, d);
});

test("the code reproduces the drawing in every framework's words", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", clipboard);
  await demo.byId("btn-code").click();
  for (const name of ["vanilla", "react", "vue", "svelte", "worker"]) {
    await demo.byId(`code-${name}`).click();
    const code = await demo.textOf("code-listing");
    assert.match(code, /from "expline"/);
    assert.match(code, /\[400, 226\]/);
  }
  await demo.byId("code-vanilla").click();
  const field = demo.byId("points");
  await field.fill("9");
  await field.press("Enter");
  await demo.idle();
  const listing = await demo.textOf("code-listing");
  const places = listing.slice(listing.indexOf("points:"), listing.indexOf("tangents:"));
  assert.equal((places.match(/\[-?[\d.]+, -?[\d.]+\]/g) ?? []).length, 9);
  await demo.byId("code-copy").click();
  await demo.byId("toast").waitFor();
  assert.equal(await demo.page.evaluate(() => navigator.clipboard.readText()), listing);
});

test("numbers of the status bar are copied by a press", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-2", clipboard);
  const length = await copied(demo, "m-length");
  assert.ok(Math.abs(Number(length) - 320 * Math.PI) < 1e-6, length);
});

test("the code leaves the drawing in sight, follows the sliders of every mode, and gives the focus back", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.byId("btn-code").click();
  const drawer = demo.byId("code-drawer");
  await drawer.waitFor();
  await demo.still();
  const top = (await drawer.boundingBox())?.y ?? 0;
  for (let i = 0; i < 6; i += 1) assert.ok((await demo.centre(`pt-0-${i}`)).y < top, `point ${i} is above the code`);
  await demo.press("Escape");
  assert.equal(await demo.page.evaluate(() => (document.activeElement as HTMLElement).dataset["testid"]), "btn-code");
  await demo.byId("tab-trace").click();
  await demo.byId("empty-trace").getByRole("button", { name: "Logo" }).click();
  await demo.idle();
  await demo.byId("btn-code").click();
  const before = await demo.textOf("code-listing");
  await demo.slide("trace-detail", 80);
  assert.notEqual(await demo.textOf("code-listing"), before);
});

test("a very long program waits for the end of a drag, and is then that of what is there", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  // Between two points of the circle so many that their program is shown in part.
  await demo.page.evaluate(async () => {
    const state = window.explineDemo.getState();
    const count = 2000;
    const points = Array.from({ length: count }, (_, i) => {
      const angle = (2 * Math.PI * i) / count;
      const [dx, dy] = [-Math.sin(angle), Math.cos(angle)];
      const step = (160 * 2 * Math.PI) / count / 3;
      return { x: 400 - 160 * dy, y: 300 + 160 * dx, kind: "symmetric" as const, in: { dx: -step * dx, dy: step * dy }, out: { dx: step * dx, dy: -step * dy } };
    });
    await window.explineDemo.setState({ ...state, curve: { space: state.curve.space, omega: "auto", level: 0, contours: [{ family: "hermite", closed: true, points }] } });
  });
  await demo.byId("btn-code").click();
  await demo.byId("code-drawer").waitFor();
  await demo.still();
  const before = await demo.textOf("code-listing");
  const { x, y } = await demo.page.evaluate(() => {
    const [first = { x: 0, y: 0 }] = window.explineDemo.getState().curve.contours[0]?.points ?? [];
    return window.explineDemo.toScreen(first.x, first.y);
  });
  await demo.page.mouse.move(x, y);
  await demo.page.mouse.down();
  await demo.page.mouse.move(x + 30, y + 20, { steps: 5 });
  await demo.idle();
  assert.equal(await demo.textOf("code-listing"), before);
  await demo.page.mouse.up();
  await demo.idle();
  assert.notEqual(await demo.textOf("code-listing"), before);
});

test("where nothing is drawn Export says so, and never writes what another mode has", async (t) => {
  const demo = await open(t, "#/trace");
  const offered = async (): Promise<boolean> => {
    await demo.press("Control+e");
    return (await demo.byId("export-dialog").count()) > 0;
  };
  assert.equal(await offered(), false, "an empty Trace");
  assert.match(await demo.textOf("toast"), /nothing to export yet/);
  await demo.byId("tab-curve").click();
  await demo.idle();
  await demo.byId("btn-clear").click();
  assert.equal(await offered(), false, "an empty Curve");
  await demo.press("Control+z");
  assert.ok(await offered());
});
