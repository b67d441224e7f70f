import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";

/** What screen readers hear beside what is focused: everything that happens on the stage, and nothing twice. */

const { open } = useBrowser();

/** Longer than the page waits until all is still. */
const pastSettling = 1200;

/** What is said from now on, an entry for each time. */
async function listen(demo: Demo): Promise<() => Promise<string[]>> {
  await demo.page.waitForTimeout(pastSettling);
  const heard = await demo.byId("live").evaluateHandle((live) => {
    const texts: string[] = [];
    new MutationObserver(() => texts.push(live.textContent ?? "")).observe(live, { childList: true, characterData: true, subtree: true });
    return texts;
  });
  return async () => {
    await demo.idle();
    await demo.page.waitForTimeout(pastSettling);
    return heard.evaluate((texts) => texts.splice(0));
  };
}

test("what is chosen is said once, and where it is now when it was moved", async (t) => {
  const demo = await open(t);
  await demo.focusStage();
  const heard = await listen(demo);
  await demo.press("]");
  assert.deepEqual(await heard(), ["Point 1 of 2, symmetric, x 560, y 300"]);
  await demo.press("ArrowUp");
  assert.deepEqual(await heard(), ["Point 1 of 2, symmetric, x 560, y 299"]);
  await demo.press(".");
  assert.equal((await heard()).length, 1);
});

test("keys that only change what is to be seen say what they did", async (t) => {
  const demo = await open(t);
  await demo.focusStage();
  await demo.press("0");
  const heard = await listen(demo);
  for (const [key, text] of [["k", "Curvature comb on"], ["k", "Curvature comb off"], ["g", "Grid on"], ["+", "Zoom 125 %"], ["0", "Zoom 100 %"], ["p", "Pen"], ["v", "Select and edit"]] as const) {
    await demo.press(key);
    assert.deepEqual(await heard(), [text]);
  }
});

test("what has become of the drawing is said where what is chosen does not say it", async (t) => {
  const demo = await open(t);
  await demo.focusStage();
  const heard = await listen(demo);
  await demo.press("}");
  assert.deepEqual(await heard(), ["Closed curve, 4 points, 0 cusps."]);
  await demo.press("Control+a");
  assert.deepEqual(await heard(), ["4 points selected"]);
  await demo.press("Control+d");
  assert.deepEqual(await heard(), ["2 contours, 2 closed, 8 points, 0 cusps."], "the copies are chosen, as the points were");
  await demo.byId("btn-clear").click();
  assert.deepEqual(await heard(), ["An empty drawing. Use the pen or open a sample to begin."]);
});

test("in Surface it is said where the arrows have taken a point, and where Undo has", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-torus");
  await demo.focusStage();
  const heard = await listen(demo);
  await demo.press("]");
  const [before] = await heard();
  assert.match(before ?? "", /^Control point 1, 1, on the surface, x 1\.4, y 0, z 0$/);
  await demo.press("ArrowUp");
  const moved = await heard();
  assert.ok(moved.length === 1 && moved[0]?.startsWith("Control point 1, 1, ") === true && moved[0] !== before, moved.join());
  await demo.press("Control+z");
  assert.deepEqual(await heard(), ["Undone: Nudge", before]);
});

test("it is said what a fit and a trace have come to", async (t) => {
  const demo = await open(t);
  const heard = await listen(demo);
  await demo.byId("tab-fit").click();
  await demo.idle();
  await demo.byId("btn-samples").click();
  await demo.byId("sample-fit-star").click();
  await demo.idle();
  assert.match((await heard()).at(-1) ?? "", /^One closed stroke, 300 points, fitted with \d+ knots: .* No point is farther than [\d.]+ from the curve\.$/);
  await demo.page.evaluate(() => (location.hash = "#/trace?sample=trace-disc"));
  await demo.idle();
  assert.match((await heard()).at(-1) ?? "", /^Disc: 1 outline, .* from the edge in the picture\.$/);
});
