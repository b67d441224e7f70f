import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { useBrowser, Demo, type Pair } from "./page.ts";

const { open, context } = useBrowser();

test("V01 the page boots quickly, quietly, from its own origin and within its budget", async (t) => {
  const page = await (await context(t)).newPage();
  const demo = new Demo(page);
  const url = process.env["DEMO_URL"] ?? "";
  const sizes = { text: 0, wasm: 0 };
  const strangers: string[] = [];
  const bodies: Promise<void>[] = [];
  const counted = new Set<string>();
  page.on("response", (response) => {
    // What is kept for later visits is asked for again, of the browser's own cache.
    if (counted.has(response.url())) return;
    counted.add(response.url());
    if (new URL(response.url()).origin !== new URL(url).origin) strangers.push(response.url());
    bodies.push(response.body().then((body) => {
      const kind = /\.wasm$/.test(response.url()) ? "wasm" : "text";
      if (/\.(?:html|css|js|wasm)$|\/$/.test(new URL(response.url()).pathname)) sizes[kind] += gzipSync(body).length;
    }));
  });
  await page.goto(url);
  const took = await page.evaluate(async () => {
    await window.explineDemo.ready;
    return performance.now();
  });
  await demo.idle();
  await page.waitForLoadState("networkidle");
  await Promise.all(bodies);
  t.diagnostic(`ready ${took.toFixed(0)} ms of 3000 after navigation; ${sizes.text} B html+css+js, ${sizes.wasm} B wasm, gzipped`);
  assert.deepEqual(demo.complaints, []);
  assert.deepEqual(strangers, []);
  assert.ok(sizes.text <= 80_000, `html+css+js: ${sizes.text} B`);
  assert.ok(sizes.wasm <= 250_000, `wasm: ${sizes.wasm} B`);
  assert.equal(await page.getByRole("tab").count(), 4);
  assert.equal((await demo.state()).mode, "curve");
  assert.match(await page.evaluate(() => window.explineDemo.version), /^\d+\.\d+\.\d+/);
  const pixels = await demo.pixels();
  const paper = pixels[0];
  const drawn = [...pixels].filter((pixel) => pixel !== paper).length;
  assert.ok(drawn >= 500, `${drawn} pixels that are not paper`);
});

test("DM-030 without WebAssembly the page says so, and its shell and help still work", async (t) => {
  const page = await (await context(t)).newPage();
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, "WebAssembly"));
  await page.goto(process.env["DEMO_URL"] ?? "");
  const message = page.locator('[data-testid="boot-error"]');
  await message.waitFor();
  assert.match((await message.textContent()) ?? "", /unsupported/);
  await page.locator('[data-testid="btn-help"]').click();
  await page.locator('[data-testid="help-dialog"]').waitFor();
});

test("a Content Security Policy without WebAssembly is named, with the line that is missing", async (t) => {
  const page = await (await context(t)).newPage();
  await page.route("**/*", async (route) => {
    const response = await route.fetch();
    const headers = response.headers();
    const policy = headers["content-security-policy"]?.replace(" 'wasm-unsafe-eval'", "") ?? "default-src 'self'";
    await route.fulfill({ response, headers: { ...headers, "content-security-policy": policy } });
  });
  await page.goto(process.env["DEMO_URL"] ?? "");
  const message = page.locator('[data-testid="boot-error"]');
  await message.waitFor();
  assert.match((await message.textContent()) ?? "", /Content Security Policy.*'wasm-unsafe-eval'.*script-src/s);
});

test("DM-031 the second visit needs no network", async (t) => {
  const demo = await open(t);
  const keeps = (): Promise<boolean> => demo.page.evaluate(async () => (await caches.match("./", { ignoreSearch: true })) !== undefined);
  await demo.until(keeps, (kept) => kept, "the page is kept");
  // What is still on its way when the network goes would be complained of.
  await demo.page.waitForLoadState("networkidle");
  await demo.page.context().setOffline(true);
  await demo.page.reload();
  await demo.page.evaluate(() => window.explineDemo.ready);
  await demo.idle();
  assert.ok((await demo.sample(100)).length === 100);
  assert.deepEqual(demo.complaints, []);
});

test("who has come back has every part of the page without a network: modes, dialogs, the pen", async (t) => {
  const demo = await open(t);
  const { page } = demo;
  const keeps = (part: string): Promise<boolean> => page.evaluate(async (name) => (await (await caches.open("expline")).keys()).some(({ url }) => url.includes(name)), part);
  await demo.until(() => keeps("index-"), (kept) => kept, "the page is kept");
  assert.equal(await keeps("fit-mode"), false, "a first visit loads what it shows and no more");
  await page.evaluate(async () => (await caches.open("expline")).put(new URL("./assets/of-an-earlier-version.js", location.href), new Response("")));
  await page.reload();
  const parts = await page.evaluate(async () => (await (await fetch("./parts.json")).json()) as string[]);
  assert.ok(parts.length > 40 && parts.some((part) => part.endsWith(".wasm")));
  await demo.until(async () => (await Promise.all(parts.map(keeps))).every((kept) => kept), (all) => all, "every part is kept");
  assert.equal(await keeps("of-an-earlier-version"), false);
  await page.context().setOffline(true);
  await page.reload();
  await page.evaluate(() => window.explineDemo.ready);
  for (const mode of ["fit", "trace", "surface"] as const) {
    await demo.byId(`tab-${mode}`).click();
    await demo.idle();
    if (mode === "fit") assert.ok(await demo.metric("m-knots") > 0, "the engine that fits is there");
    await demo.byId({ fit: "fit-smoothing", trace: "trace-detail", surface: "surf-sample" }[mode]).first().waitFor();
  }
  await demo.byId("btn-help").click();
  await demo.byId("help-dialog").waitFor();
  assert.deepEqual(demo.complaints, []);
});

test("a part that cannot be loaded is said", async (t) => {
  // Kept parts would come from the worker, past the route.
  const demo = await open(t, "", { serviceWorkers: "block" });
  await demo.page.route(/help-dialog/u, (route) => route.abort());
  await demo.byId("btn-help").click();
  await demo.byId("error").waitFor();
  assert.match(await demo.textOf("error"), /could not be loaded/);
});

test("where a part of Import or Export cannot be loaded, that is what is said, and not that the engine stopped", async (t) => {
  const demo = await open(t, "", { serviceWorkers: "block" });
  const said = async (id: string): Promise<string> => {
    await demo.byId(id).click();
    return (await demo.page.locator("[data-error=part-missing], .toast-error").first().textContent()) ?? "";
  };
  await demo.page.route(/\/(import-(?!dialog)|svg-write-|png-(?!size))[^/]*\.js/u, (route) => route.abort());
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill("M0 0H9");
  assert.match(await said("import-apply"), /could not be loaded/);
  await demo.press("Escape");
  // What the dialog itself waits for may come after that: it says nothing of what did not.
  let release = (): void => undefined;
  const held = new Promise<void>((resolve) => (release = resolve));
  await demo.page.route(/\/compress-[^/]*\.js/u, async (route) => {
    await held;
    await route.continue();
  });
  await demo.byId("btn-export").click();
  for (const id of ["export-svg", "export-png"]) {
    assert.match(await said(id), /could not be loaded/);
    release();
    await demo.idle();
    await demo.page.locator(".toast-error").getByRole("button", { name: "Dismiss" }).click();
  }
});

test("a part that was asked for is waited for, and asked for twice it is there once", async (t) => {
  const demo = await open(t, "", { serviceWorkers: "block" });
  await demo.page.route(/(dialog|code-drawer|menu)-?[^/]*\.js/u, (route) => void setTimeout(() => void route.continue(), 500));
  await demo.focusStage();
  await demo.press("?");
  assert.equal(await demo.byId("help-dialog").count(), 1, "the page is not idle before it is there");
  await demo.press("Escape");
  await demo.page.evaluate(() => ["btn-export", "btn-export"].forEach((id) => document.querySelector<HTMLElement>(`[data-testid=${id}]`)?.click()));
  await demo.idle();
  assert.equal(await demo.byId("export-dialog").count(), 1);
  await demo.press("Escape");
  await demo.page.evaluate(() => ["btn-code", "btn-code", "btn-code"].forEach((id) => document.querySelector<HTMLElement>(`[data-testid=${id}]`)?.click()));
  await demo.idle();
  assert.deepEqual([await demo.byId("code-drawer").count(), await demo.byId("code-drawer").isVisible()], [1, true], "opened, closed and opened");
  assert.deepEqual(demo.complaints, []);
});

test("an idle page asks for no frames", async (t) => {
  const demo = await open(t);
  await demo.page.waitForTimeout(500);
  const frames = await demo.page.evaluate(async () => {
    const original = window.requestAnimationFrame;
    let count = 0;
    window.requestAnimationFrame = (callback) => {
      count += 1;
      return original.call(window, callback);
    };
    await new Promise((resolve) => setTimeout(resolve, 2000));
    return count;
  });
  assert.ok(frames <= 5, `${frames} frames in two seconds`);
});

test("the empty stage offers the pen and samples, and a sample fills it", async (t) => {
  const demo = await open(t);
  await demo.byId("btn-clear").click();
  await demo.byId("empty-curve").waitFor();
  await demo.byId("empty-curve").getByRole("button", { name: "Heart" }).click();
  await demo.idle();
  assert.equal((await demo.points()).length, 6);
  assert.equal(await demo.byId("empty-curve").count(), 0);
  const at: Pair = [400, 226];
  assert.deepEqual([(await demo.point(0)).x, (await demo.point(0)).y], at);
});
