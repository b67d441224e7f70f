import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";

/** What the page says: out of the way of who sees it, and once to who hears it. */

const { open } = useBrowser();

const logo = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><path d="M2 0H22V24H12L2 24Z"/></svg>';

async function dropped(demo: Demo): Promise<void> {
  await demo.page.evaluate((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "logo.svg", { type: "image/svg+xml" }));
    document.querySelector("canvas")?.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, logo);
  await demo.byId("toast").waitFor();
  await demo.still();
}

test("a point beneath a message can be dragged, and what the message offers goes with that step", async (t) => {
  const demo = await open(t);
  await dropped(demo);
  await demo.withoutSnap();
  const box = await demo.byId("toast").locator("p").boundingBox();
  assert.ok(box !== null);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  // The logo's lowest point, in its middle, is brought beneath the message.
  const lowest = (await demo.points()).findIndex((point) => point.x === 12);
  const from = await demo.toScreen(12, 24);
  await demo.focusStage();
  await demo.page.keyboard.down("Space");
  await demo.dragFrom({ x: from.x, y: from.y - 200 }, x - from.x, y - from.y);
  await demo.page.keyboard.up("Space");
  const at = await demo.toScreen(12, 24);
  assert.ok(Math.hypot(at.x - x, at.y - y) < 1, "the point is beneath the words");
  assert.equal(await demo.byId("toast").count(), 1, "moving the view is no step");
  await demo.dragFrom(at, 40, -80);
  const moved = await demo.toScreen((await demo.point(lowest)).x, (await demo.point(lowest)).y);
  assert.ok(Math.hypot(moved.x - x - 40, moved.y - y + 80) < 1.5, "the point is where it was dragged");
  assert.equal(await demo.page.getByRole("button", { name: "Simplify in Fit" }).count(), 0);
});

test("a message covers no menu", async (t) => {
  const demo = await open(t, "", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await dropped(demo);
  await demo.byId("sheet-up").tap();
  await demo.byId("sheet-up").tap();
  await demo.page.getByRole("button", { name: "Menu" }).tap();
  await demo.still();
  const covered = await demo.page.evaluate(() => [...document.querySelectorAll("[data-testid=btn-samples], [data-testid=btn-import], [data-testid=btn-export], [data-testid=btn-share], [data-testid=btn-theme], [data-testid=btn-help]")]
    .filter((entry) => {
      const { x, y, width, height } = entry.getBoundingClientRect();
      return !entry.contains(document.elementFromPoint(x + width / 2, y + height / 2));
    }).map((entry) => entry.textContent));
  assert.deepEqual(covered, []);
});

/**
 * What a screen reader has to read out from now on: all that changes in live regions; of one that is not atomic, what
 * is added.
 */
async function listen(demo: Demo): Promise<() => Promise<string[]>> {
  await demo.page.evaluate(() => {
    const said: string[] = [];
    new MutationObserver((changes) => {
      for (const { target, addedNodes } of changes) {
        const region = (target instanceof Element ? target : target.parentElement)?.closest("[role=status]");
        if (region == null || addedNodes.length === 0) continue;
        const isAtomic = region.getAttribute("aria-atomic") !== "false";
        said.push(isAtomic ? region.textContent : [...addedNodes].map((node) => node.textContent).join(""));
      }
    }).observe(document.body, { subtree: true, childList: true });
    Object.assign(globalThis, { said });
  });
  return () => demo.page.evaluate(() => (globalThis as unknown as { said: string[] }).said.splice(0).filter((text) => text !== ""));
}

test("what is said is read out once, and so is where a nudge, an undo and a choice of all have led", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.focusStage();
  await demo.press("]", "]");
  const heard = await listen(demo);
  const hears = (wanted: RegExp): Promise<string[]> => {
    const all: string[] = [];
    return demo.until(async () => (all.push(...await heard()), all), (texts) => texts.some((text) => wanted.test(text)), `${wanted} is said`);
  };
  await demo.press("ArrowRight");
  const { x, y } = await demo.point(1);
  await hears(new RegExp(`^Point 2 of 8, symmetric, x ${Number(x.toFixed(2))}, y ${Number(y.toFixed(2))}$`, "u"));
  await demo.press("Delete");
  const deletions = (await hears(/^Point 1 of 7|^Point 2 of 7/u)).filter((text) => text.includes("deleted"));
  assert.equal(deletions.length, 1, deletions.join(" | "));
  await demo.press("Shift+Delete");
  const second = (await hears(/open there/u)).filter((text) => text.includes("deleted"));
  assert.equal(second.length, 1);
  assert.doesNotMatch(second[0] ?? "", /moved/u, "the message before it is not read again");
  await demo.press("Control+z");
  await hears(/^Undone: Delete/u);
  await demo.press("Control+Shift+z");
  await hears(/^Redone: Delete/u);
  await demo.press("Control+a");
  await hears(/^6 points selected$/u);
});

test("news of a step goes when the step is undone, in every way; what is said of something else stays", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8", { permissions: ["clipboard-read", "clipboard-write"] });
  const news = demo.page.locator(".toast");
  const erase = async (): Promise<void> => {
    await demo.focusStage();
    await demo.press("]", "Delete");
    await news.filter({ hasText: "Point deleted" }).waitFor();
  };
  for (const undo of [() => demo.press("Control+z"), () => demo.click("btn-undo")]) {
    await erase();
    await undo();
    assert.deepEqual(await news.allTextContents(), []);
  }
  await erase();
  await demo.press("ArrowUp");
  assert.equal(await news.count(), 1, "it is true after the next step, too");
  await demo.byId("m-points").click();
  await news.filter({ hasText: "Copied" }).waitFor();
  await demo.press("Control+z", "Control+z");
  assert.deepEqual(await news.allTextContents(), ["Copied 7"]);
});

test("an offer that is declined goes with what it was about", async (t) => {
  const demo = await open(t, "#/curve?sample=blob-16");
  await demo.focusStage();
  await demo.press("}");
  await demo.until(async () => (await demo.state()).curve.level, (level) => level === 1, "a level up");
  await demo.press("]", "ArrowUp", "{");
  const offer = demo.page.locator(".toast-action", { hasText: "Apply level" });
  await offer.waitFor();
  await demo.press("Escape");
  await offer.waitFor({ state: "detached" });
  assert.equal((await demo.state()).curve.level, 1);
});

test("news of a mode go when another is opened", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  const news = demo.page.locator(".toast");
  await demo.byId("curve-simplify").click();
  await news.filter({ hasText: "Copied to Fit" }).waitFor();
  await demo.click("tab-curve");
  assert.deepEqual(await news.allTextContents(), []);
});

test("an address that names no sample is said to, from whichever mode it is opened", async (t) => {
  const demo = await open(t, "#/fit");
  await demo.page.evaluate(() => { location.hash = "#/curve?sample=nobody"; });
  await demo.byId("toast").filter({ hasText: "There is no sample called nobody." }).waitFor();
  assert.equal((await demo.state()).mode, "curve");
});

test("of several files that are dropped, those that are refused are said when the others are there", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.page.evaluate((text) => {
    const data = new DataTransfer();
    for (const [content, name, type] of [["PK", "old.zip", "application/zip"], ["<svg", "broken.svg", "image/svg+xml"], [text, "logo.svg", "image/svg+xml"]] as const) {
      data.items.add(new File([content], name, { type }));
    }
    document.querySelector("canvas")?.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, logo);
  await demo.byId("toast").waitFor();
  await demo.byId("error").waitFor();
  await demo.still();
  assert.match(await demo.textOf("error"), /old\.zip is not a file.*The SVG could not be read/su);
  assert.match(await demo.textOf("toast"), /Imported 1 contour/);
  assert.equal((await demo.state()).curve.contours.length, 1);
});
