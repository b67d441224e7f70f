import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";

/** What is copied, cut and pasted within the page. */

const { open } = useBrowser();
const permissions = ["clipboard-read", "clipboard-write"];

async function begunPaste(demo: Demo, text: string): Promise<void> {
  await demo.page.evaluate((given) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", given);
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  }, text);
}

async function paste(demo: Demo, text: string): Promise<void> {
  await begunPaste(demo, text);
  await demo.idle();
}

async function copied(demo: Demo, key: "Control+c" | "Control+x"): Promise<string> {
  await demo.focusStage();
  return demo.copied(() => demo.press(key));
}

test("a copy is pasted as what it is, beside its original, chosen, without moving the view", async (t) => {
  const demo = await open(t, "#/curve?sample=blob-16", { permissions });
  const [before] = (await demo.state()).curve.contours;
  const { view } = await demo.state();
  const text = await copied(demo, "Control+c");
  // Clipboards of Windows change the ends of lines.
  for (const given of [text, text.replaceAll("\n", "\r\n")]) await paste(demo, given);
  const { curve, view: after } = await demo.state();
  assert.equal(curve.contours.length, 3);
  assert.deepEqual(after, view);
  for (const [k, contour] of curve.contours.entries()) {
    assert.equal(contour.family, "interpolating");
    assert.deepEqual(contour.points.map(({ x, y }) => [x, y]), before?.points.map(({ x, y }) => [x + 16 * k, y + 16 * k]));
  }
  const moved = curve.contours[2]?.points.map(({ x }) => x + 1);
  await demo.focusStage();
  await demo.press("ArrowRight");
  const nudged = (await demo.state()).curve.contours;
  assert.deepEqual(nudged[2]?.points.map(({ x }) => x), moved, "what was pasted last is what is moved");
  assert.deepEqual(nudged[1], curve.contours[1]);
});

test("what is pasted the moment that the clipboard has it is what was copied", async (t) => {
  const demo = await open(t, "#/curve?sample=blob-16", { permissions });
  await demo.page.evaluate(() => {
    const { clipboard } = navigator;
    const write = clipboard.write.bind(clipboard);
    clipboard.write = async (items) => {
      await write(items);
      const clipboardData = new DataTransfer();
      clipboardData.setData("text/plain", await clipboard.readText());
      document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
      // The page hears of it only after the paste.
      await new Promise((done) => setTimeout(done, 300));
    };
  });
  await demo.focusStage();
  await demo.press("Control+c");
  const { curve } = await demo.until(() => demo.state(), (state) => state.curve.contours.length > 1, "the copy is pasted");
  assert.deepEqual(curve.contours.map(({ family }) => family), ["interpolating", "interpolating"]);
});

test("the clipboard is asked in the turn of the press, before any part of the page is loaded: Safari forgets the press then", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", { permissions });
  await demo.page.evaluate(() => {
    const asked: string[] = [];
    const { clipboard } = navigator;
    const write = clipboard.write.bind(clipboard);
    Object.assign(window, { asked });
    clipboard.write = (items) => {
      asked.push(window.event?.type ?? "later");
      return write(items);
    };
  });
  const texts: string[] = [];
  for (const act of [() => demo.press("Control+c"), () => demo.byId("btn-share").click(), () => demo.press("Control+x")]) {
    await demo.focusStage();
    texts.push(await demo.copied(act));
  }
  assert.deepEqual(texts.map((text) => /^<svg|#s=/u.exec(text)?.[0]), ["<svg", "#s=", "<svg"]);
  assert.deepEqual(await demo.page.evaluate(() => (window as { asked?: string[] }).asked), ["keydown", "click", "keydown"]);
  await demo.until(() => demo.state(), ({ curve }) => curve.contours.length === 0, "the heart is cut");
  assert.equal(await demo.textOf("toast"), "Cut the contour.");
  await demo.press("Control+z");
  assert.equal(await demo.page.getByText("Cut the contour.").count(), 0, "what was undone is not said any more");
});

test("what is cut is pasted in its place, and far from where one looks it is brought into sight", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", { permissions });
  const [heart] = (await demo.state()).curve.contours;
  const text = await copied(demo, "Control+x");
  await demo.until(() => demo.state(), ({ curve }) => curve.contours.length === 0, "the heart is cut");
  await demo.page.evaluate(async () => {
    const state = window.explineDemo.getState();
    await window.explineDemo.setState({ ...state, view: { zoom: 1, x: 90_000, y: 0 } });
  });
  await paste(demo, text);
  assert.deepEqual((await demo.state()).curve.contours, [heart]);
  const at = await demo.toScreen(heart?.points[0]?.x ?? 0, heart?.points[0]?.y ?? 0);
  assert.ok(at.x > 40 && at.x < 976 && at.y > 48 && at.y < 768, JSON.stringify(at));
});

test("a drawing that was exported comes back where it was", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", { permissions });
  const { points } = (await demo.state()).curve.contours[0] ?? { points: [] };
  const text = await copied(demo, "Control+c");
  await demo.page.reload();
  await demo.page.evaluate(() => window.explineDemo.ready);
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill(text);
  await demo.byId("import-apply").click();
  await demo.byId("import-dialog").waitFor({ state: "detached" });
  await demo.idle();
  const back = await demo.points();
  // Four decimals are written.
  for (const { x, y } of points) assert.ok(back.some((point) => Math.hypot(point.x - x, point.y - y) <= 1e-4), `${x}, ${y} is a point again`);
});

test("of what was deleted nothing stays under the pointer, and no curve is said to have moved", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  const [x, y] = (await demo.sample(800))[150] ?? [0, 0];
  const at = await demo.toScreen(x, y);
  await demo.page.mouse.move(at.x, at.y);
  await demo.focusStage();
  await demo.press("Control+a", "Delete");
  assert.equal(await demo.textOf("toast"), "6 points deleted.");
  const empty = await demo.pixels();
  await demo.page.mouse.move(at.x + 200, at.y + 200);
  await demo.idle();
  assert.equal(await demo.changedPixels(empty, await demo.pixels()), 0, "no mark of the curve that was there");
});

test("a copied file is opened, and not its name, which some systems put beside it", async (t) => {
  const demo = await open(t);
  await demo.page.evaluate(() => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", "my logo.svg");
    clipboardData.items.add(new File(["<svg xmlns='http://www.w3.org/2000/svg'><circle cx='40' cy='40' r='20'/></svg>"], "my logo.svg", { type: "image/svg+xml" }));
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  });
  await demo.until(() => demo.state(), ({ curve }) => curve.sample === undefined, "the file is opened");
  assert.equal((await demo.state()).curve.contours.length, 1);
});

/** What another program put on the clipboard as a part of a page. */
async function pastePage(demo: Demo, page: string, plain: string): Promise<void> {
  await demo.page.evaluate(([html, text]) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/html", html);
    if (text !== "") clipboardData.setData("text/plain", text);
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  }, [page, plain] as const);
  await demo.idle();
}

test("a drawing that was copied as a part of a page only is pasted, inline or as the address of a picture", async (t) => {
  const drawing = '<svg width="100" height="100" xmlns="http://www.w3.org/2000/svg"><path d="M10 10h80v40z"/></svg>';
  for (const page of [`<meta charset='utf-8'>${drawing}`, `<html><body>\r\n<!--StartFragment-->${drawing}<!--EndFragment-->\r\n</body></html>`, `<img src="data:image/svg+xml,${encodeURIComponent(drawing)}">`]) {
    const demo = await open(t, "#/curve?sample=heart");
    await pastePage(demo, page, "");
    const [contour] = await demo.until(async () => (await demo.state()).curve.contours, (contours) => contours[0]?.points.length === 3, page.slice(0, 40));
    assert.deepEqual(contour?.points.map(({ x, y }) => [x, y]), [[10, 10], [90, 10], [90, 50]]);
  }
});

test("what a design program copies for itself alone is said to be nothing to draw, and how it can be copied", async (t) => {
  const figma = "<meta charset='utf-8'><html><head></head><body><span data-metadata=\"<!--(figmeta)eyJmaWxlS2V5IjoiYWJjIn0=(/figmeta)-->\"></span><span data-buffer=\"<!--(figma)ZmlnLWtpd2kAAAA=(/figma)-->\"></span></body></html>";
  for (const plain of ["", "Rectangle 1"]) {
    const demo = await open(t, "#/curve?sample=heart");
    await pastePage(demo, figma, plain);
    const error = demo.page.locator('[data-testid="error"][data-error="paste-unknown"]');
    await error.waitFor();
    assert.match((await error.textContent()) ?? "", /Copy as SVG/u);
    assert.equal((await demo.points()).length, 6);
  }
});

test("what is pasted while a point is dragged is there after the drag, as a step of its own", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.drag("pt-0-1", 5, 5);
  const { x, y } = await demo.centre("pt-0-2");
  const before = (await demo.points())[2];
  await demo.page.mouse.move(x, y);
  await demo.page.mouse.down();
  await demo.page.mouse.move(x + 20, y + 10, { steps: 4 });
  // It waits for the drag, and the page is not idle as long.
  await begunPaste(demo, "M10 10h80v40z");
  await demo.page.waitForTimeout(300);
  await demo.page.mouse.move(x + 40, y + 20, { steps: 4 });
  await demo.page.mouse.up();
  await demo.until(() => demo.state(), ({ curve }) => curve.contours.length === 2, "what was pasted is there");
  assert.notDeepEqual((await demo.points())[2], before);
  await demo.focusStage();
  await demo.press("Control+z");
  assert.equal((await demo.state()).curve.contours.length, 1);
  assert.notDeepEqual((await demo.points())[2], before, "the drag is still done");
});

test("where the browser keeps the clipboard to itself, what was to be copied can be copied by hand, and nothing is cut", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  // As where a page is not served safely, or in a frame that may not.
  await demo.page.evaluate(() => Object.defineProperty(navigator, "clipboard", { configurable: true, value: undefined }));
  const offered = async (): Promise<string> => {
    await demo.byId("by-hand-dialog").waitFor();
    const text = await demo.page.evaluate(() => {
      const field = document.activeElement as HTMLTextAreaElement;
      return field.value.slice(field.selectionStart, field.selectionEnd);
    });
    await demo.press("Escape");
    await demo.byId("by-hand-dialog").waitFor({ state: "detached" });
    return text;
  };
  await demo.byId("btn-share").click();
  assert.match(await offered(), /^http[^#]*#s=/u);
  await demo.focusStage();
  await demo.press("Control+a", "Control+x");
  assert.match(await offered(), /^<svg/u);
  assert.equal((await demo.state()).curve.contours.length, 1);
  await demo.press("Control+e");
  await demo.byId("export-ts").click();
  assert.match(await offered(), /from "expline"/u);
  assert.ok(await demo.byId("export-dialog").isVisible(), "and Export is there as it was");
  await demo.press("Escape");
  await demo.byId("export-dialog").waitFor({ state: "detached" });
  const { x, y } = await demo.toScreen(40, 40);
  await demo.page.mouse.click(x, y, { button: "right" });
  await demo.byId("menu-paste").click();
  assert.match(await demo.textOf("error"), /blocked pasting\. Press Ctrl\+V/u);
  await demo.byId("btn-code").click();
  await demo.byId("code-copy").click();
  assert.equal(await offered(), await demo.textOf("code-listing"));
});
