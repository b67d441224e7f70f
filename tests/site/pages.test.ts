import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { test } from "node:test";
import { assertNone, lowContrast, namesAndTargets, overflow } from "../demo/looked-at.ts";
import { SITE_URL, crawled, useSite } from "./site.ts";

const open = useSite();

test("every link leads to a page, and to a place on it that is there", async () => {
  const { pages, lost } = await crawled();
  assert.deepEqual(lost, []);
  assert.ok(pages.size > 100, `${pages.size} pages were found`);
  const strays: string[] = [];
  const elsewhere = new Set<string>();
  for (const [path, { links }] of pages) {
    for (const link of links) {
      if (!link.startsWith(SITE_URL)) {
        elsewhere.add(link);
        continue;
      }
      const [target = "", anchor = ""] = link.slice(SITE_URL.length).split("#");
      const ids = pages.get(target || "index.html")?.ids;
      // Code that a link brings along is no place on a page.
      if (ids === undefined || (anchor !== "" && !anchor.startsWith("code=") && !ids.has(decodeURIComponent(anchor)))) strays.push(`${path} → ${link}`);
    }
  }
  assert.deepEqual(strays, []);
  for (const link of elsewhere) assert.equal((await fetch(link)).status, 200, link);
});

test("every page of the folder docs/guide is on the site, and the contents lead to it", async () => {
  const { pages } = await crawled();
  const guides = readdirSync("docs/guide").map((name) => name.replace(/\.md$/, ".html"));
  assert.deepEqual(guides.filter((name) => !pages.has(name)), []);
});

test("the reference has every name of the interface, and none that only the package knows", async () => {
  const { pages } = await crawled();
  const library = Object.keys((await import("expline")) as object);
  const listed = pages.get("api/index.html")?.links.join(" ") ?? "";
  assert.deepEqual(library.filter((name) => !listed.includes(`/${name}.html`)), []);
  for (const [path, { html }] of pages) if (path.startsWith("api/")) assert.doesNotMatch(html, /MeasuredCurve|CurveData|@internal|ArrayBufferLike/, path);
});

/** Where links stand among words. */
const SENTENCES = "p, td, main li";
const LOOKED_AT = ["", "getting-started.html", "recipes.html", "trace.html", "api/index.html", "api/classes/HermiteCurve.html", "api/interfaces/SparseFitOptions.html", "benchmarks.html", "changelog.html"];

for (const path of LOOKED_AT) {
  for (const [width, colorScheme] of [[1280, "light"], [1280, "dark"], [320, "light"]] as const) {
    test(`${path || "the first page"} at ${width} px, ${colorScheme}: no complaint, no other host, names, targets, contrast, no sideways scrolling`, async (t) => {
      const { page, complaints } = await open(t, path, { viewport: { width, height: 800 }, colorScheme, hasTouch: width === 320 });
      await page.evaluate(() => document.querySelectorAll("details").forEach((each) => { each.open = true; }));
      await page.waitForLoadState("networkidle");
      assertNone(await namesAndTargets(page, SENTENCES));
      assertNone(await lowContrast(page));
      assert.ok((await overflow(page)) <= 0, `${await overflow(page)} px too wide`);
      assert.equal(await page.locator("h1").count(), 1, "one heading of the first level");
      assert.equal(await page.locator("main").count(), 1);
      assert.deepEqual(complaints, []);
    });
  }
}

test("dark colours follow the system, and the button, which is remembered", async (t) => {
  const { page } = await open(t, "", { colorScheme: "dark" });
  const paper = (): Promise<string> => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const dark = await paper();
  const button = page.locator("button.theme");
  await button.click();
  const light = await paper();
  assert.notEqual(light, dark);
  assert.match((await button.getAttribute("aria-label")) ?? "", /light/);
  await page.goto(`${SITE_URL}concepts.html`);
  assert.equal(await paper(), light, "on the next page");
  await page.emulateMedia({ colorScheme: "light" });
  await button.click();
  assert.equal(await paper(), dark, "dark where the system is light");
  await button.click();
  assert.equal(await paper(), light, "as the system");
});

test("the search finds fitSparse, by keys alone, and leads to it", async (t) => {
  const { page, complaints } = await open(t, "getting-started.html");
  await page.keyboard.press("Control+k");
  await page.keyboard.type("fitSparse");
  const first = page.locator("#hits [role=option]").first();
  await first.waitFor();
  assert.equal(await first.locator("b").textContent(), "fitSparse()");
  assert.equal(await first.getAttribute("aria-selected"), "true");
  await page.keyboard.press("ArrowDown");
  assert.equal(await first.getAttribute("aria-selected"), "false");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await page.waitForURL("**/api/functions/fitSparse.html");
  assert.equal(await page.locator("h1").textContent(), "fitSparse()");
  await page.keyboard.press("Control+k");
  await page.keyboard.type("xyzzyx");
  await page.locator("#hits .none").waitFor();
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#hits").isVisible(), false);
  assert.deepEqual(complaints, []);
});

test("the demo's help leads here, beside the drawing that stays open", async (t) => {
  const { page, complaints } = await open(t, "../");
  await page.getByRole("button", { name: "Help" }).click();
  const [documentation] = await Promise.all([page.waitForEvent("popup"), page.getByRole("link", { name: /documentation/ }).click()]);
  await documentation.waitForLoadState();
  assert.equal(await documentation.locator("h1").textContent(), "expline documentation");
  assert.deepEqual(complaints, []);
});

test("code is copied as it stands", async (t) => {
  const { page } = await open(t, "api/functions/fitSparse.html", { permissions: ["clipboard-read", "clipboard-write"] });
  const block = page.locator(".code").first();
  await block.getByRole("button", { name: "Copy" }).click();
  await block.getByText("Copied").waitFor();
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), await block.locator("code").textContent());
});

test("llms.txt names every page of the contents and has the README in full", async () => {
  const text = await (await fetch(`${SITE_URL}llms.txt`)).text();
  const { pages } = await crawled();
  const contents = (pages.get("index.html")?.links ?? []).map((link) => link.slice(SITE_URL.length)).filter((path) => /^[\w-]+\.html$/.test(path));
  assert.deepEqual(contents.filter((path) => !text.includes(`](${path})`) && path !== "index.html"), []);
  assert.ok(text.includes("## API at a glance"));
});

test("without scripts the pages can be read and the contents lead on", async (t) => {
  const { page } = await open(t, "", { javaScriptEnabled: false, viewport: { width: 390, height: 844 } });
  await page.locator("nav[aria-label=Contents] a", { hasText: "Concepts" }).click();
  assert.equal(await page.locator("h1").textContent(), "Concepts");
});
