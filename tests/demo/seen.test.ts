import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";

/** What is on the page can be seen, read to its end and pressed, and stays where it is while it is pressed. */

const { open } = useBrowser();

const tablet = { viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true } as const;

async function imported(demo: Demo, text: string): Promise<void> {
  await demo.page.evaluate((pasted) => {
    const data = new DataTransfer();
    data.setData("text/plain", pasted);
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, text);
  await demo.page.locator(".toast").first().waitFor();
  await demo.idle();
}

test("every number of the points table can be read to its last digit", async (t) => {
  const demo = await open(t, "", tablet);
  await imported(demo, "M-123456.789 -987654.321C-122856 -987654 -122456 -987254 -122456.789 -986854.2S-123156 -986054 -123456.789 -986454.321z");
  await demo.page.locator(".panel-toggle").click();
  await demo.page.getByText("Points table").click();
  const fields = demo.byId("points-table").locator("input");
  await fields.nth(5).waitFor();
  assert.equal(await fields.first().inputValue(), "-123456.79");
  assert.deepEqual(await fields.evaluateAll((all) => all.filter((each) => each.scrollWidth > each.clientWidth).map((each) => each.ariaLabel)), []);
});

test("a slider that is dragged from end to end stays where it is, and as long as it is", async (t) => {
  const demo = await open(t);
  for (const [hash, id] of [["#/curve?sample=blob-16", "level"], ["#/fit?sample=fit-star", "fit-noise"], ["#/trace?sample=trace-logo", "trace-alpha"]] as const) {
    await demo.page.evaluate((to) => { location.hash = to; }, hash);
    await demo.byId(id).scrollIntoViewIfNeeded();
    await demo.still();
    const boxOf = async (): Promise<string> => JSON.stringify(await demo.byId(id).boundingBox());
    const before = await boxOf();
    const { x, y, width, height } = JSON.parse(before) as DOMRect;
    await demo.page.mouse.move(x + 8, y + height / 2);
    await demo.page.mouse.down();
    for (let i = 0; i <= 12; i += 1) {
      await demo.page.mouse.move(x + 8 + ((width - 16) * i) / 12, y + height / 2);
      await demo.page.waitForTimeout(20);
      assert.equal(await boxOf(), before, id);
    }
    await demo.page.mouse.up();
    await demo.idle();
    assert.equal(await boxOf(), before, id);
  }
});
