import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { assertNone, lowContrast, namesAndTargets, overflow } from "../demo/looked-at.ts";
import { SITE_URL, useSite } from "./site.ts";

const open = useSite();
const PLAYGROUND = "playground.html";

/** Until what was started is over. */
async function finished(page: Page): Promise<void> {
  await page.locator('.play[data-state="idle"]').waitFor({ timeout: 30_000 });
}

async function write(page: Page, code: string): Promise<void> {
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(code);
}

async function run(page: Page, code: string): Promise<string> {
  await write(page, code);
  await page.keyboard.press("Control+Enter");
  await finished(page);
  return (await page.locator(".play-said").innerText()).trim();
}

test("the first example runs by itself, prints and draws; so do the others when they are chosen", async (t) => {
  const { page, complaints } = await open(t, PLAYGROUND);
  await finished(page);
  const examples = page.getByLabel("Example");
  const names = await examples.locator("option").allTextContents();
  assert.ok(names.length >= 6);
  for (const name of names) {
    await examples.selectOption(name);
    await finished(page);
    assert.match(await page.locator(".play-status").innerText(), /^Done/, name);
    assert.notEqual(await page.locator(".play-said").innerText(), "", name);
    const box = await page.locator(".play-drawn :is(svg, img)").first().boundingBox();
    assert.ok(box !== null && box.width > 100 && box.height > 100, name);
  }
  assert.equal(await page.locator(".play-drawn svg path.wire").count(), 1, "a surface is drawn as lines");
  assert.deepEqual(complaints, []);
});

test("Ctrl and Enter runs what is written; errors name their code and the line", async (t) => {
  const { page } = await open(t, PLAYGROUND);
  await finished(page);
  assert.equal(await run(page, 'import { HermiteCurve } from "expline";\nconsole.log(HermiteCurve.ellipse({ center: [0, 0], radii: [3, 3], count: 2 }).evaluate(1), { a: [1] });'), "Float64Array(2) [-3, 0] { a: [1] }");
  assert.match(await run(page, 'import { HermiteCurve } from "expline";\n\nHermiteCurve.ellipse({ center: [0, 0], radii: [3, 3], count: 1 });'), /^E_TOO_FEW_POINTS: .*\(line 3\)/s);
  assert.match(await run(page, "const a = ;"), /^SyntaxError/);
  assert.match(await run(page, "for (let i = 0; i < 1e5; i++) console.log(i);"), /499\n…$/);
});

test("an endless loop leaves the page as it is, and ends by Stop", async (t) => {
  const { page } = await open(t, PLAYGROUND);
  await finished(page);
  await write(page, "for (;;);");
  await page.getByRole("button", { name: "Run" }).click();
  await page.locator('.play[data-state="running"]').waitFor();
  assert.equal(await page.evaluate(() => 1 + 1), 2, "the page answers");
  await page.getByRole("button", { name: "Stop" }).click();
  await finished(page);
  assert.equal(await page.locator(".play-status").innerText(), "Stopped.");
  assert.equal(await run(page, "console.log('again')"), "again");
});

test("and by itself after ten seconds", async (t) => {
  const { page } = await open(t, PLAYGROUND);
  await finished(page);
  assert.match(await run(page, "for (;;);"), /stopped: it took longer than 10 s/);
});

test("a link holds the code, to the letter, and runs nothing by itself", async (t) => {
  const { page } = await open(t, PLAYGROUND, { permissions: ["clipboard-read", "clipboard-write"] });
  await finished(page);
  const code = `// ω → “φ” 🖋 \`\\\`\n${"console.log('lines');\n".repeat(200)}`;
  await write(page, code);
  await page.getByRole("button", { name: "Copy link" }).click();
  await page.getByText("Copied").waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.ok(link.startsWith(`${SITE_URL}playground.html#code=`) && link.length < 400, `${link.length} letters for ${code.length}`);
  const { page: other } = await open(t, link.slice(SITE_URL.length));
  await other.locator(".play-status", { hasText: "press Run" }).waitFor();
  assert.equal(await other.locator(".play-said").innerText(), "");
  assert.equal(await other.locator("iframe").count(), 0, "not even the frame is there");
  await other.getByRole("button", { name: "Run" }).click();
  await finished(other);
  assert.equal((await other.locator(".play-said pre").allTextContents()).length, 200);
  // Links that were cut off or say too much begin with an example.
  const { page: broken } = await open(t, "playground.html#code=AAAA");
  await finished(broken);
  assert.match(await broken.locator(".cm-content").innerText(), /HermiteCurve/);
});

test("code of the guides opens in the playground", async (t) => {
  const { page } = await open(t, "recipes.html");
  const block = page.locator(".code").first();
  const code = (await block.locator("code").textContent()) ?? "";
  const link = (await block.getByRole("link", { name: "Try it" }).getAttribute("href")) ?? "";
  const { page: other } = await open(t, link);
  await other.locator(".play-status", { hasText: "press Run" }).waitFor();
  assert.equal((await other.locator(".cm-line").allInnerTexts()).map((line) => line.replace(/\n$/, "")).join("\n").trim(), code.trim());
});

test("code of a link has no part in the page: no origin, no storage, no document, no network", async (t) => {
  const { page, complaints } = await open(t, PLAYGROUND);
  await finished(page);
  await page.evaluate(() => localStorage.setItem("a drawing", "mine"));
  const said = await run(page, `
    console.log(self.origin, typeof document, typeof localStorage);
    const tried = async (name, action) => { try { await action(); console.log(name, "works"); } catch (error) { console.log(name, "is refused"); } };
    await tried("indexedDB", () => new Promise((yes, no) => { const open = indexedDB.open("x"); open.onsuccess = yes; open.onerror = no; }));
    await tried("caches", () => caches.open("x"));
    await tried("fetch", () => fetch(${JSON.stringify(SITE_URL)}));
    await tried("elsewhere", () => fetch("https://example.org/"));
    await tried("import", () => import(${JSON.stringify(`${SITE_URL}assets/library.js`)}));
    await tried("eval", () => eval("1"));
  `);
  const lines = said.split("\n");
  assert.equal(lines[0], "null undefined undefined");
  assert.deepEqual(lines.slice(1), ["indexedDB", "caches", "fetch", "elsewhere", "import", "eval"].map((name) => `${name} is refused`));
  assert.deepEqual(complaints.filter((each) => each.startsWith("asks")), []);
});

test("what code gives to be drawn cannot run in the page", async (t) => {
  const { page } = await open(t, PLAYGROUND);
  await finished(page);
  await run(page, `export default ["<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9' onload='parent.hacked = 1'><script>parent.hacked = 1</script><circle r='4' cx='4' cy='4'/></svg>", "M0 0\\"><script>hacked = 1</script>"];`);
  assert.equal(await page.evaluate(() => "hacked" in window), false);
  assert.equal(await page.locator(".play-drawn script").count(), 0);
});

test("the frame takes no orders where it has an origin", async (t) => {
  const { page } = await open(t, PLAYGROUND);
  await finished(page);
  // Its own header takes the origin away, even where it is opened by itself.
  const response = await fetch(`${SITE_URL}assets/sandbox.html`);
  assert.match(response.headers.get("content-security-policy") ?? "", /sandbox allow-scripts; frame-ancestors 'self'/);
  // The frame's code in a window that has the page's origin, as it would be in somebody else's page without a sandbox.
  const script = /<script>([\s\S]*)<\/script>/.exec(await response.text())?.[1] ?? "";
  assert.ok(script.length > 100);
  await page.evaluate(() => {
    addEventListener("message", () => (document.title = "heard"));
    document.body.append(Object.assign(document.createElement("iframe"), { name: "unframed", srcdoc: "<!doctype html>" }));
  });
  const frame = await (await page.waitForSelector("iframe[name=unframed]", { state: "attached" })).contentFrame();
  assert.ok(frame !== null);
  await frame.evaluate(script);
  assert.equal(await frame.evaluate(() => new Promise((done) => setTimeout(() => done(self.origin), 200))), new URL(SITE_URL).origin);
  assert.notEqual(await page.title(), "heard", "it is not ready for orders");
});

test("the editor is left by keys, and everything has a name, in both themes and on a phone", async (t) => {
  for (const [width, colorScheme] of [[1280, "light"], [1280, "dark"], [320, "light"]] as const) {
    const { page, complaints } = await open(t, PLAYGROUND, { viewport: { width, height: 800 }, colorScheme });
    await finished(page);
    assertNone(await namesAndTargets(page, "p, td, main li"));
    assertNone(await lowContrast(page));
    assert.ok((await overflow(page)) <= 0);
    assert.deepEqual(complaints, []);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Escape");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement?.className), "play-said");
  }
});
