import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";

/** The dialog of Import: while its part of the page is on its way, and with very much in its field. */

const { open } = useBrowser();

const twoContours = "M10 10h80v40H40zM120 20c20-20 60-20 80 0s20 60 0 80z";

/** Parts of the page that are not there yet take their time. */
function slowly(demo: Demo): Promise<unknown> {
  return demo.page.route("**/*.js", async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 400));
    await route.continue();
  });
}

test("the page is not idle before what was imported is on the stage, however long its part of the page takes to load", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill(twoContours);
  await slowly(demo);
  await demo.byId("import-apply").click();
  await demo.idle();
  assert.equal((await demo.state()).curve.contours.length, 2);
});

/** Presses in one turn of the page, which no machine is too slow for. */
function pressed(demo: Demo, ...selectors: readonly string[]): Promise<void> {
  return demo.page.evaluate((all) => all.forEach((each) => document.querySelector<HTMLElement>(`dialog ${each}`)?.click()), selectors);
}

test("who presses Import twice while its part of the page loads imports once, and who closes the dialog nothing", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const [apply, close] = ["[data-testid=import-apply]", "[aria-label=Close]"];
  for (const [presses, count] of [[[apply, close], 1], [[apply, apply], 3]] as const) {
    await demo.byId("btn-import").click();
    await demo.byId("import-text").fill(twoContours);
    await demo.byId("import-replace").uncheck();
    await pressed(demo, ...presses);
    await demo.idle();
    assert.deepEqual([(await demo.state()).curve.contours.length, await demo.byId("import-dialog").count()], [count, 0]);
  }
});

test("very many rows are set in Import's field at once, at the cursor, and not typed", async (t) => {
  const demo = await open(t);
  await demo.byId("btn-import").click();
  const field = demo.byId("import-text");
  await field.fill("0,0\n");
  const rows = Array.from({ length: 50_000 }, (_, i) => `${i},${i % 100}`).join("\n");
  // A paste that is made by a script types nothing: what is there then was set by the page.
  await field.evaluate((element, text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", text);
    element.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  }, rows);
  assert.equal(await field.inputValue(), `0,0\n${rows}`);
});
