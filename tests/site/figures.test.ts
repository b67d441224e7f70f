import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import type { Locator, Page } from "playwright-core";
import { assertNone, lowContrast, namesAndTargets, overflow } from "../demo/looked-at.ts";
import { useSite } from "./site.ts";

const open = useSite();
const NAMES = readdirSync("site/figures").filter((name) => name !== "stage.ts").map((name) => name.replace(/\.ts$/, ""));

/** A figure, once it is drawn, and those above it, which may push it down as they come. */
async function shown(page: Page, name: string): Promise<Locator> {
  const figure = page.locator(`[data-figure="${name}"]`);
  for (const above of await page.locator("[data-figure]").evaluateAll((all) => all.map((each) => each.getAttribute("data-figure") ?? ""))) {
    if (above === name) break;
    await page.locator(`[data-figure="${above}"]`).scrollIntoViewIfNeeded();
    await page.locator(`[data-figure="${above}"][data-ready]`).waitFor();
  }
  await figure.scrollIntoViewIfNeeded();
  await page.locator(`[data-figure="${name}"][data-ready]`).waitFor();
  return figure;
}

const drawnOf = (figure: Locator): Promise<string> => figure.locator("svg path").evaluateAll((all) => all.map((each) => `${each.getAttribute("d")}${each.getAttribute("transform")}`).join());

test("every figure is drawn, without a complaint, and says in words what it shows", async (t) => {
  const { page, complaints } = await open(t, "concepts.html");
  assert.deepEqual((await page.locator("[data-figure]").evaluateAll((all) => all.map((each) => each.getAttribute("data-figure")))).sort(), [...NAMES].sort());
  for (const name of NAMES) {
    const figure = await shown(page, name);
    const boxes = await figure.locator("svg path:not([d=''])").evaluateAll((all) => all.map((each) => (each as SVGGraphicsElement).getBoundingClientRect().width));
    assert.ok(Math.max(...boxes) > 100, `${name} draws lines of ${Math.max(...boxes)} px`);
    assert.ok((await figure.locator("figcaption").textContent() ?? "").length > 40, name);
    assert.notEqual(await figure.locator(".said").textContent(), "", name);
  }
  assert.deepEqual(complaints, []);
});

test("the code beside a figure is in the file that draws it, word by word", async (t) => {
  const { page } = await open(t, "concepts.html");
  for (const name of NAMES) {
    const code = (await page.locator(`[data-figure="${name}"] code`).textContent()) ?? "";
    assert.ok(code.split("\n").length > 5 && readFileSync(`site/figures/${name}.ts`, "utf8").includes(code), name);
  }
});

test("a figure loads of the package what it imports, and no more", async (t) => {
  const { page } = await open(t);
  await shown(page, "circle");
  await page.waitForLoadState("networkidle");
  const bytes = await page.evaluate(() => performance.getEntriesByType("resource").reduce((sum, each) => sum + (each as PerformanceResourceTiming).encodedBodySize, 0));
  // Curves and paths are 64 kB of it; fits and traces would be 150 kB each.
  assert.ok(bytes < 90_000, `${bytes} bytes for the first page`);
});

test("handles and points follow the arrow keys, and the pointer", async (t) => {
  const { page } = await open(t, "concepts.html");
  const figure = await shown(page, "handles");
  const point = figure.getByRole("button", { name: /^Point 1,/ });
  const before = await drawnOf(figure);
  const name = await point.getAttribute("aria-label");
  await point.focus();
  await page.keyboard.press("Shift+ArrowUp");
  const moved = await drawnOf(figure);
  assert.notEqual(moved, before);
  assert.notEqual(await point.getAttribute("aria-label"), name, "its name says where it is");
  const handle = figure.getByRole("button", { name: /^Handle of point 2, leaving/ });
  const box = await handle.boundingBox();
  assert.ok(box !== null);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 20, box.y + box.height / 2 + 30, { steps: 3 });
  await page.mouse.up();
  assert.notEqual(await drawnOf(figure), moved);
  const after = await handle.boundingBox();
  const centre = (of: typeof box): number[] => [of.x + of.width / 2, of.y + of.height / 2];
  const [from, to] = [centre(box), centre(after ?? box)];
  for (const [axis, way] of [20, 30].entries()) assert.ok(Math.abs((to[axis] ?? 0) - (from[axis] ?? 0) - way) < 1, `it is where the pointer let it go: ${from} → ${to}`);
});

test("a finger drags a point while the page stays", async (t) => {
  const { page } = await open(t, "concepts.html", { hasTouch: true, viewport: { width: 390, height: 844 } });
  const figure = await shown(page, "interpolating");
  const point = figure.getByRole("button", { name: /^Point 3 of 8/ });
  const before = await drawnOf(figure);
  const [box, scrolled] = [await point.boundingBox(), await page.evaluate(() => scrollY)];
  assert.ok(box !== null);
  const session = await page.context().newCDPSession(page);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  for (const step of [10, 25, 40]) await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x, y: y - step }] });
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  assert.notEqual(await drawnOf(figure), before);
  assert.equal(await page.evaluate(() => scrollY), scrolled);
});

test("inserting and refining leave the curve where it is", async (t) => {
  const { page } = await open(t, "concepts.html");
  const figure = await shown(page, "refine");
  const said = (): Promise<string> => figure.locator(".said").innerText();
  assert.match(await said(), /^5 points/);
  await figure.getByRole("button", { name: "Insert" }).click();
  assert.match(await said(), /^6 points/);
  await figure.getByRole("slider", { name: "Refine" }).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.match(await said(), /^15 points/);
  // Two hundred units wide: a double tells 2e-14 of them.
  const [, moved] = /moved by (\S+)\.$/.exec(await said()) ?? [];
  assert.ok(Number(moved) < 1e-12, moved);
});

test("a finer level of the interpolating curve shows more points of the same curve", async (t) => {
  const { page } = await open(t, "concepts.html");
  const figure = await shown(page, "interpolating");
  const outline = (): Promise<string | null> => figure.locator("path.filled").getAttribute("d");
  const before = await outline();
  await figure.getByRole("slider", { name: "Level" }).focus();
  await page.keyboard.press("ArrowRight");
  assert.match(await figure.locator(".said").innerText(), /16 finer ones/);
  assert.equal(await outline(), before);
});

test("a stroke that is drawn is fitted, and more smoothing leaves fewer knots", async (t) => {
  const { page } = await open(t, "concepts.html");
  const figure = await shown(page, "fit");
  const knots = async (): Promise<number> => Number(/(\d+) knots/.exec(await figure.locator(".said").innerText())?.[1]);
  const slider = figure.getByRole("slider", { name: "Smoothing" });
  await slider.fill("0.1");
  const many = await knots();
  await slider.fill("0.8");
  assert.ok((await knots()) < many, `${await knots()} of ${many}`);
  const box = await figure.locator("svg").boundingBox();
  assert.ok(box !== null);
  await page.mouse.move(box.x + 200, box.y + 100);
  await page.mouse.down();
  for (let i = 0; i <= 40; i += 1) await page.mouse.move(box.x + 200 + 5 * i, box.y + 100 + 60 * Math.sin(i / 8));
  await page.mouse.up();
  assert.match(await figure.locator(".said").innerText(), /^4[01] points/);
});

test("what is painted on the picture is traced, and other pictures can be chosen", async (t) => {
  const { page } = await open(t, "concepts.html");
  const figure = await shown(page, "trace");
  const before = await drawnOf(figure);
  const box = await figure.locator("svg").boundingBox();
  assert.ok(box !== null);
  await page.mouse.move(box.x + box.width / 2 - 100, box.y + 40);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - 80, box.y + 60, { steps: 3 });
  await page.mouse.up();
  const painted = await drawnOf(figure);
  assert.notEqual(painted, before);
  await figure.getByRole("combobox", { name: "Picture" }).selectOption("square");
  assert.match(await figure.locator(".said").innerText(), / 4 corners/);
});

test("the surface turns by keys, and a pulled point changes it", async (t) => {
  const { page } = await open(t, "concepts.html");
  const figure = await shown(page, "surface");
  const before = await drawnOf(figure);
  await figure.locator("svg").focus();
  await page.keyboard.press("ArrowLeft");
  const turned = await drawnOf(figure);
  assert.notEqual(turned, before);
  await figure.getByRole("slider", { name: "Pull a point" }).fill("1");
  assert.notEqual(await drawnOf(figure), turned);
  assert.match(await figure.locator(".said").innerText(), /a torus, exact/);
});

for (const [width, colorScheme] of [[1280, "dark"], [320, "light"]] as const) {
  test(`figures at ${width} px, ${colorScheme}: names, targets, contrast, no sideways scrolling`, async (t) => {
    const { page, complaints } = await open(t, "concepts.html", { viewport: { width, height: 800 }, colorScheme });
    for (const name of NAMES) await shown(page, name);
    assertNone(await namesAndTargets(page, "p, td, main li"));
    assertNone(await lowContrast(page));
    assert.ok((await overflow(page)) <= 0);
    assert.deepEqual(complaints, []);
  });
}
