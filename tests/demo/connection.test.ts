import assert from "node:assert/strict";
import { test, type TestContext } from "node:test";
import { useBrowser, type Demo } from "./page.ts";

/**
 * A connection that is lost for a moment: what did not come is said, asked for again, and no longer spoken of once it
 * is there.
 */

const { open } = useBrowser();

/** A page on which some parts do not come until the way is `clear`. Kept parts would come past the way. */
async function cutOff(t: TestContext, parts: RegExp, options: Parameters<typeof open>[2] = {}): Promise<{ demo: Demo; clear(): Promise<void> }> {
  const demo = await open(t, "", { serviceWorkers: "block", ...options });
  const context = demo.page.context();
  await context.route(parts, (route) => route.abort());
  return { demo, clear: () => context.unroute(parts) };
}

const shownErrors = (demo: Demo): Promise<string[]> => demo.byId("error").allTextContents();

for (const [mode, has] of [["fit", "fit-smoothing"], ["trace", "trace-detail"], ["surface", "surf-sample"]] as const) {
  test(`${mode} that could not be loaded is there at the next visit, and nothing is said of it any more`, async (t) => {
    const { demo, clear } = await cutOff(t, new RegExp(`/${mode}-mode[^/]*\\.js`, "u"));
    await demo.byId(`tab-${mode}`).click();
    await demo.byId("error").waitFor();
    assert.match((await shownErrors(demo)).join(), /^This mode could not be loaded/);
    await clear();
    await demo.byId("tab-curve").click();
    await demo.byId(`tab-${mode}`).click();
    await demo.byId(has).first().waitFor();
    await demo.idle();
    assert.deepEqual(await shownErrors(demo), []);
  });
}

test("style sheets that did not come do when the mode does", async (t) => {
  const { demo, clear } = await cutOff(t, /\/assets\/[^/]*\.css/u);
  await demo.byId("tab-fit").click();
  await demo.byId("error").waitFor();
  await clear();
  await demo.byId("tab-curve").click();
  await demo.byId("tab-fit").click();
  await demo.byId("fit-smoothing").waitFor();
  const looks = (): Promise<string[]> => demo.page.evaluate(() => [".busy", ".fit-chart", ".button"].map((part) => getComputedStyle(document.querySelector(part) ?? document.body)).map((style) => `${style.position} ${style.height} ${style.borderTopWidth}`));
  await demo.until(looks, ([busy = "", chart = "", button = ""]) => busy.startsWith("absolute") && chart.includes(" 72px ") && button.endsWith(" 1px"), "all parts look as they should");
});

test("a mode that takes its time says so, on its own stage and nowhere else, until it is there", async (t) => {
  const demo = await open(t, "", { serviceWorkers: "block" });
  let go: () => void = () => undefined;
  const held = new Promise<void>((resolve) => (go = resolve));
  await demo.page.context().route(/\/fit-mode[^/]*\.js/u, (route) => void held.then(() => route.continue()));
  const note = demo.page.locator("main").getByText("Loading…");
  await demo.byId("tab-fit").click();
  await note.waitFor();
  await demo.byId("tab-curve").click();
  assert.equal(await note.count(), 0, "Curve is there");
  await demo.byId("tab-fit").click();
  await note.waitFor();
  go();
  await demo.byId("fit-smoothing").waitFor();
  await demo.idle();
  assert.equal(await note.count(), 0);
});

test("Samples that are asked for while Fit is on its way are Fit's, once it is there, and none for who has gone elsewhere", async (t) => {
  for (const stays of [true, false]) {
    const demo = await open(t, "", { serviceWorkers: "block" });
    let go: () => void = () => undefined;
    const held = new Promise<void>((resolve) => (go = resolve));
    await demo.page.context().route(/\/fit-mode[^/]*\.js/u, (route) => void held.then(() => route.continue()));
    await demo.byId("tab-fit").click();
    for (const _ of [1, 2]) await demo.byId("btn-samples").click();
    // The dialog's own part has come.
    await demo.until(() => demo.page.evaluate(() => performance.getEntriesByType("resource").some(({ name }) => name.includes("samples-dialog"))), (has) => has, "the dialog is there");
    await demo.page.waitForTimeout(200);
    assert.equal(await demo.byId("samples-dialog").count(), 0);
    if (!stays) await demo.byId("tab-curve").click();
    go();
    if (stays) await demo.byId("samples-dialog").waitFor();
    await demo.idle();
    assert.equal(await demo.byId("samples-dialog").count(), stays ? 1 : 0);
    assert.deepEqual([await demo.byId("sample-fit-star").count(), await demo.byId("sample-heart").count()], [stays ? 1 : 0, 0]);
    assert.deepEqual(demo.complaints, []);
  }
});

for (const part of ["reopening", "kept"]) {
  test(`without ${part} the last session is missed, and the rest of the page is there; the next visit has the session again`, async (t) => {
    const { demo, clear } = await cutOff(t, new RegExp(`/${part}-[^/]*\\.js`, "u"));
    await demo.focusStage();
    await demo.press("]", "ArrowUp");
    const curve = await demo.kept();
    const next = async (): Promise<void> => {
      await demo.page.goto("about:blank");
      await demo.load("");
    };
    await next();
    assert.match((await shownErrors(demo)).join(), /^Your last session could not be loaded/);
    await demo.byId("tab-fit").click();
    await demo.byId("fit-smoothing").waitFor();
    await demo.idle();
    await clear();
    await next();
    assert.deepEqual([(await demo.state()).curve, await shownErrors(demo)], [curve, []]);
  });
}

test("a link that comes while its part of the page does not is said, and nothing else happens", async (t) => {
  const { demo } = await cutOff(t, /\/reopening-[^/]*\.js/u);
  const before = await demo.state();
  await demo.page.evaluate(() => (location.hash = "#s=abc"));
  await demo.byId("error").waitFor();
  assert.match((await shownErrors(demo)).join(), /^The link could not be loaded/);
  assert.deepEqual([(await demo.state()).curve, demo.complaints.filter((text) => !text.includes("Failed to load resource"))], [before.curve, []]);
});

test("the way back from Fit loads no tool that nobody asked for", async (t) => {
  const { demo } = await cutOff(t, /\/draw-tool[^/]*\.js/u);
  await demo.byId("tab-fit").click();
  await demo.idle();
  await demo.byId("tab-curve").click();
  await demo.idle();
  assert.deepEqual([await shownErrors(demo), demo.complaints, await demo.byId("tool-select").getAttribute("aria-pressed")], [[], [], "true"]);
});

for (const part of ["fit-worker", "expline_fit_bg"]) {
  test(`without ${part} Fit says that its engine could not be loaded, on a phone as well, and fits when it is told to try again`, async (t) => {
    const { demo, clear } = await cutOff(t, new RegExp(`/${part}[^/]*$`, "u"), { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    await demo.byId("tab-fit").tap();
    await demo.byId("offer-again").waitFor();
    assert.deepEqual(await shownErrors(demo), ["The engine could not be loaded. Check the connection, then try again."]);
    await clear();
    await demo.byId("offer-again").tap();
    await demo.until(() => demo.byId("knot-0").count(), (count) => count > 0, "there is a curve");
    await demo.idle();
    assert.deepEqual(await shownErrors(demo), []);
  });
}

for (const part of ["trace-worker", "expline_trace_bg"]) {
  test(`without ${part} Trace says that its engine could not be loaded, and traces when somebody comes back to it`, async (t) => {
    const { demo, clear } = await cutOff(t, new RegExp(`/${part}[^/]*$`, "u"));
    await demo.page.evaluate(() => (location.hash = "#/trace?sample=trace-disc"));
    await demo.byId("offer-again").waitFor();
    assert.deepEqual(await shownErrors(demo), ["The engine could not be loaded. Check the connection, then try again."]);
    await clear();
    await demo.byId("tab-curve").click();
    assert.deepEqual(await demo.byId("offer-again").isVisible(), false);
    await demo.byId("tab-trace").click();
    await demo.idle();
    assert.deepEqual([await demo.metric("m-contours"), await shownErrors(demo)], [1, []]);
  });
}
