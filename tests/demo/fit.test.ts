import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo, type Pair } from "./page.ts";

const { open } = useBrowser();

type Result = { knots: { x: number; y: number; type: "linear" | "cubic" | "coincident" }[]; rms: number; max: number };

async function result(demo: Demo): Promise<Result> {
  const { fit } = (await demo.state()) as unknown as { fit: { result?: Result } };
  assert.ok(fit.result !== undefined, "there is a fit");
  return fit.result;
}

const count = ({ knots }: Result, type: string): number => knots.filter((knot) => knot.type === type).length;

/** The ten corners of the star. */
const corners: Pair[] = Array.from({ length: 10 }, (_, i) => {
  const [angle, radius] = [(Math.PI * i) / 5 - Math.PI / 2, i % 2 === 0 ? 180 : 75];
  return [400 + radius * Math.cos(angle), 300 + radius * Math.sin(angle)];
});

test("V18 smoothing makes knots vanish, and the legend says how many there are", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  const seen: Result[] = [];
  const times: number[] = [];
  for (const value of [5, 25, 45, 65, 85]) {
    await demo.slide("fit-smoothing", value);
    times.push((await demo.stats()).lastJobMs);
    const now = await result(demo);
    for (const type of ["linear", "cubic", "coincident"]) assert.equal((await demo.textOf(`legend-${type}`)).replace(/\D/g, ""), String(count(now, type)));
    if (now.knots.length <= 256) assert.equal(await demo.page.locator('[data-testid^="knot-"]').count(), now.knots.length);
    seen.push(now);
  }
  t.diagnostic(`knots ${seen.map(({ knots }) => knots.length).join(", ")}; rms ${seen.map(({ rms }) => rms.toFixed(2)).join(", ")}; ${times.map((ms) => ms.toFixed(0)).join(", ")} ms`);
  seen.forEach((now, i) => {
    const before = seen[i - 1];
    if (before === undefined) return;
    assert.ok(now.knots.length <= before.knots.length + 1, `${now.knots.length} knots after ${before.knots.length}`);
    assert.ok(now.rms >= 0.98 * before.rms, `rms ${now.rms} after ${before.rms}`);
  });
  assert.ok((seen[4]?.knots.length ?? 99) < (seen[0]?.knots.length ?? 0));
});

test("V18 the stage follows while the slider is dragged", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  const box = await demo.byId("fit-smoothing").boundingBox();
  assert.ok(box !== null);
  const { mouse } = demo.page;
  const goTo = (share: number): Promise<void> => mouse.move(box.x + share * box.width, box.y + box.height / 2, { steps: 4 });
  await goTo(0.2);
  let before = await demo.pixels();
  const changed = async (what: string): Promise<void> => {
    before = await demo.until(() => demo.pixels(), (now) => now !== before, `${what} before the release`);
  };
  await mouse.down();
  await changed("the stop where it was pressed");
  // Stops so far apart that each has other knots: near ones may have the same, and the same curve.
  for (const share of [0.75, 0.98, 0.2, 0.98]) {
    await goTo(share);
    await changed(`the stop at ${share}`);
  }
  await mouse.up();
  await demo.idle();
});

test("V19 knot types tell the truth: corners of a star, smooth knots of a circle", async (t) => {
  const star = await open(t, "#/fit?sample=fit-star");
  const found = await result(star);
  const sharp = found.knots.filter(({ type }) => type !== "cubic");
  t.diagnostic(`star: ${count(found, "linear")} linear, ${count(found, "coincident")} coincident, ${count(found, "cubic")} cubic`);
  assert.ok(sharp.length >= 10 && sharp.length <= 14, `${sharp.length} corners`);
  for (const [x, y] of corners) assert.ok(sharp.some((knot) => Math.hypot(knot.x - x, knot.y - y) <= 6), `the corner at ${x}, ${y}`);
  assert.ok(count(found, "cubic") <= 4);
  await star.byId("fit-model").locator('[value="linear"]').check();
  await star.idle();
  assert.equal(count(await result(star), "cubic") + count(await result(star), "coincident"), 0);
  await star.byId("fit-model").locator('[value="cubic"]').check();
  await star.idle();
  assert.equal(count(await result(star), "linear") + count(await result(star), "coincident"), 0);

  const circle = await open(t, "#/fit?sample=fit-circle");
  const round = await result(circle);
  t.diagnostic(`circle: ${count(round, "linear")} linear, ${count(round, "cubic")} cubic`);
  assert.ok(count(round, "linear") <= 1);
  assert.ok(count(round, "cubic") >= 4 && count(round, "cubic") <= 24);
  const off = (await circle.sample(2000)).map(([x, y]) => Math.abs(Math.hypot(x - 400, y - 300) - 160));
  assert.ok(Math.max(...off) <= 5, `radius off by ${Math.max(...off)}`);
});

test("V20 a freehand stroke is fitted, compared and handed over to Curve", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  await demo.click("btn-clear");
  await demo.byId("fit-tool").locator('[value="draw"]').check();
  const { mouse } = demo.page;
  const at = async (x: number): Promise<{ x: number; y: number }> => demo.toScreen(x, 300 + 80 * Math.sin(x / 60));
  const start = await at(250);
  await mouse.move(start.x, start.y);
  await mouse.down();
  for (let i = 1; i <= 150; i += 1) {
    const { x, y } = await at(250 + 4 * i);
    await mouse.move(x, y);
  }
  await mouse.up();
  await demo.idle();
  const fit = await result(demo);
  t.diagnostic(`freehand: ${fit.knots.length} knots, max ${fit.max.toFixed(2)} px`);
  assert.ok(fit.knots.length <= 30, `${fit.knots.length} knots`);
  assert.ok(fit.max <= 6, `off by ${fit.max} px`);
  const both = await demo.pixels();
  await demo.focusStage();
  await demo.page.keyboard.down("o");
  await demo.idle();
  const alone = await demo.pixels();
  assert.ok((await demo.changedPixels(both, alone)) > 0, "the curve goes");
  await demo.page.keyboard.up("o");
  await demo.idle();
  assert.equal(await demo.changedPixels(both, await demo.pixels()), 0, "the curve is back");

  const curve = await demo.sample(800);
  await demo.byId("fit-edit").click();
  await demo.idle();
  assert.equal((await demo.state()).mode, "curve");
  const edited = await demo.sample(800);
  const farthest = Math.max(...curve.map(([x, y]) => Math.min(...edited.map(([a, b]) => Math.hypot(a - x, b - y)))));
  assert.ok(farthest <= 1, `off by ${farthest}`);
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

test("the target drives the slider, and shows where it has led", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-circle");
  await demo.byId("fit-target").selectOption("knots");
  await demo.byId("fit-target-value").fill("8");
  await demo.byId("fit-target-value").press("Enter");
  await demo.idle();
  const found = await result(demo);
  assert.ok(found.knots.length <= 8, `${found.knots.length} knots`);
  assert.equal(Number(await demo.byId("fit-smoothing").inputValue()), (await demo.state()).fit.smoothing);
  assert.equal(await demo.byId("fit-target-note").isVisible(), false);
});

test("where a number of knots cannot be had, it is said beside the number", async (t) => {
  // A closed curve of straight pieces and smooth ones does not come down to two places.
  const demo = await open(t, "#/fit?sample=fit-star");
  await demo.byId("fit-target").selectOption("knots");
  await demo.byId("fit-target-value").fill("2");
  await demo.byId("fit-target-value").press("Enter");
  await demo.idle();
  const { knots } = await result(demo);
  assert.ok(knots.length > 2, `${knots.length} knots`);
  assert.match(await demo.textOf("fit-target-note"), new RegExp(`No fewer than ${knots.length} knots`, "u"));
  await demo.byId("fit-target").selectOption("off");
  await demo.idle();
  assert.equal(await demo.byId("fit-target-note").isVisible(), false);
});

test("a shared link holds the sample by its name, its noise and its seed", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-circle");
  await demo.slide("fit-noise", 4);
  const { data } = (await demo.state()).fit;
  const hash = await demo.page.evaluate(async () => {
    let copied = "";
    Object.defineProperty(navigator, "clipboard", { configurable: true, value: { write: async ([item]: ClipboardItem[]) => void (copied = await (await item?.getType("text/plain"))?.text() ?? "") } });
    document.querySelector<HTMLElement>('[data-testid="btn-share"]')?.click();
    while (copied === "") await new Promise((resolve) => requestAnimationFrame(resolve));
    return new URL(copied).hash;
  });
  assert.ok(hash.startsWith("#s=") && hash.length < 1500, `${hash.length} characters`);
  const other = await open(t, hash);
  assert.deepEqual((await other.state()).fit.data, data);
});

test("the empty stage leaves room to draw on, first thing after the page was opened", async (t) => {
  const demo = await open(t, "#/fit");
  await demo.byId("btn-clear").click();
  await demo.idle();
  const card = await demo.byId("empty-fit").boundingBox();
  const stage = await demo.byId("stage").boundingBox();
  assert.ok(card !== null && stage !== null && card.height < stage.height / 2 && card.width < stage.width * 0.7, `${card?.width} by ${card?.height} px`);
  assert.ok(card.y > stage.y && card.y + card.height < stage.y + stage.height);
  await demo.dragFrom({ x: stage.x + 60, y: card.y + card.height / 2 }, 120, 40, 30);
  assert.ok((await demo.state()).fit.data.length > 20);
});

test("V18 knots that have vanished are gone from the picture, without a touch of the stage", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  // While the chart is being filled, every column of it is a new picture anyway.
  await demo.until(() => demo.page.locator("[data-testid=fit-chart] rect").count(), (columns) => columns === 21, "the chart is filled");
  await demo.slide("fit-smoothing", 85);
  const after = await demo.pixels();
  await demo.byId("tab-curve").click();
  await demo.byId("tab-fit").click();
  await demo.idle();
  assert.equal(await demo.changedPixels(after, await demo.pixels()), 0);
});

test("the chart says of every smoothing what the slider gives there", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  const chart = demo.byId("fit-chart");
  await demo.until(() => chart.locator("rect").count(), (columns) => columns === 21, "the chart is filled");
  const said = (await chart.getAttribute("aria-label")) ?? "";
  for (const at of [0, 40, 100]) {
    await demo.slide("fit-smoothing", at);
    const { knots, rms } = await result(demo);
    assert.ok(said.includes(`At ${at}: ${knots.length} knots, rms ${rms.toPrecision(2)}`), `${knots.length} knots, rms ${rms} at ${at}, not as in: ${said}`);
  }
  // A parabola is fitted without an error, whatever the smoothing: the line of the errors lies at the chart's foot.
  await demo.page.evaluate(async () => {
    const { fit: { sample: _sample, ...fit }, ...state } = window.explineDemo.getState();
    await window.explineDemo.setState({ ...state, fit: { ...fit, starts: [], data: Array.from({ length: 41 }, (_, i): [number, number] => [10 * i, (i - 20) ** 2]) } });
  });
  const errors = async (): Promise<number[]> => [...((await chart.locator(".chart-line").getAttribute("d")) ?? "").matchAll(/ ([\d.]+)/gu)].map(([, y]) => Number(y));
  const foot = await demo.until(errors, (heights) => heights.length === 21 && (heights[0] ?? 0) > 60, "the chart is filled with the parabola's");
  assert.ok(foot.every((y) => y > 69), `${foot}`);
});

test("a knot that is dragged draws nothing: it is chosen, and Edit in Curve is offered", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  const { fit } = await demo.state();
  assert.match(await demo.textOf("hint"), /instead of the sample/u);
  const { x, y } = (await result(demo)).knots[0] ?? { x: NaN, y: NaN };
  await demo.drag("knot-0", 60, 40);
  const after = await demo.state();
  assert.deepEqual(after.fit.data, fit.data);
  assert.ok(await demo.byId("btn-undo").isDisabled(), "nothing happened that could be undone");
  await demo.page.locator('[data-testid="toast"] .toast-action').click();
  await demo.idle();
  assert.equal((await demo.state()).mode, "curve");
  assert.ok((await demo.points()).some((point) => Math.hypot(point.x - x, point.y - y) < 1e-6), "the knot is a point there");
});

test("the rail in Fit has no tool that edits points, as there are none; Curve has it back", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  assert.equal(await demo.byId("tool-select").isVisible(), false);
  assert.equal(await demo.byId("tool-draw").getAttribute("aria-pressed"), "true");
  await demo.byId("tab-curve").click();
  await demo.idle();
  assert.equal(await demo.byId("tool-select").getAttribute("aria-pressed"), "true");
});
