import assert from "node:assert/strict";
import { test } from "node:test";
import { Demo, assertSame, useBrowser } from "./page.ts";

const { open, context } = useBrowser();
const clipboard = { permissions: ["clipboard-read", "clipboard-write"] };

async function sharedLink(demo: Demo): Promise<string> {
  return demo.copied(() => demo.byId("btn-share").click());
}

test("V17 a link holds the drawing, its view and its mode, and nothing of it reaches a server", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", clipboard);
  await demo.withoutSnap();
  await demo.drag("pt-0-1", 21, -14);
  await demo.byId("zoom-in").click();
  await demo.idle();
  const url = new URL(await sharedLink(demo));
  assert.equal(url.search, "");
  assert.match(url.hash, /^#s=[A-Za-z0-9_-]+$/);
  const before = await demo.state();

  const page = await (await context(t)).newPage();
  const other = new Demo(page);
  await other.load(url.hash);
  const after = await other.state();
  assertSame(after.curve, before.curve);
  assertSame(after.view, before.view);
  assert.equal(after.mode, before.mode);
  const [a, b] = [await demo.sample(500), await other.sample(500)];
  for (const [i, [x, y]] of a.entries()) assert.ok(Math.hypot(x - (b[i]?.[0] ?? NaN), y - (b[i]?.[1] ?? NaN)) <= 1e-9);
  assert.deepEqual(other.complaints, []);
});

const bad = ["#s=garbage", "#s=", "#s=AAAA", "#s=%00%00", `#s=${"A".repeat(200_000)}`];

for (const hash of bad) {
  test(`V17 ${hash.slice(0, 20)} shows the default sample, says so, and the page works`, async (t) => {
    const demo = await open(t, hash);
    await demo.page.locator('[data-error="share-bad"]').waitFor();
    assert.equal((await demo.state()).curve.sample, "circle-2");
    await demo.withoutSnap();
    await demo.drag("pt-0-0", 20, 20);
    assert.notEqual((await demo.point(0)).x, 560);
  });
}

test("a link that unpacks to far more than it holds is refused while it unpacks", async (t) => {
  const demo = await open(t);
  const hash = await demo.page.evaluate(async () => {
    const zeros = new Blob([new Uint8Array(40 * 1024 * 1024)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    const bytes = new Uint8Array(await new Response(zeros).arrayBuffer());
    let text = "";
    for (const byte of bytes) text += String.fromCharCode(byte);
    return `#s=${btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
  });
  const fresh = new Demo(await (await context(t)).newPage());
  await fresh.load(hash);
  await fresh.page.locator('[data-error="share-bad"]').waitFor();
});

test("a drawing too large for a link says so and keeps the clipboard", async (t) => {
  const demo = await open(t, "", clipboard);
  await demo.page.evaluate(async () => {
    await navigator.clipboard.writeText("before");
    const state = structuredClone(window.explineDemo.getState());
    let seed = 7;
    const next = (): number => (seed = (seed * 48271) % 2147483647) / 2147483647;
    const points = Array.from({ length: 3000 }, () => ({ x: 800 * next(), y: 600 * next(), kind: "cusp" as const, in: { dx: next(), dy: next() }, out: { dx: next(), dy: next() } }));
    await window.explineDemo.setState({ ...state, curve: { space: "polynomial", omega: 0, level: 0, contours: [{ family: "hermite", closed: true, points }] } });
  });
  await demo.byId("btn-share").click();
  await demo.page.locator('[data-error="share-long"]').waitFor();
  assert.equal(await demo.page.evaluate(() => navigator.clipboard.readText()), "before");
});

/** Long enough for an autosave, which comes a second after a change. */
const untilKept = 1400;

test("DM-001 after a reload the last committed edit is there, and a fresh start is one press away", async (t) => {
  const demo = await open(t);
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  const kept = (await demo.state()).curve;
  await demo.page.waitForTimeout(untilKept);
  await demo.page.goto("about:blank");
  await demo.load("");
  assertSame((await demo.state()).curve, kept);
  await demo.byId("toast").getByRole("button", { name: "Start fresh" }).click();
  await demo.idle();
  assert.equal((await demo.point(0)).x, 560);
});

test("DM-001 a drag that is interrupted by a reload leaves the state before it", async (t) => {
  const demo = await open(t);
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  const kept = (await demo.state()).curve;
  await demo.page.waitForTimeout(untilKept);
  const { x, y } = await demo.centre("pt-0-1");
  await demo.page.mouse.move(x, y);
  await demo.page.mouse.down();
  await demo.page.mouse.move(x + 90, y, { steps: 4 });
  await demo.page.waitForTimeout(untilKept);
  await demo.page.goto("about:blank");
  await demo.load("");
  assertSame((await demo.state()).curve, kept);
});

test("DM-002 a tab that is killed loses nothing that was committed more than a second before", async (t) => {
  const shared = await context(t);
  const demo = new Demo(await shared.newPage());
  await demo.load("");
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  const kept = (await demo.state()).curve;
  await demo.page.waitForTimeout(untilKept);
  await demo.drag("pt-0-1", 15, 5);
  const last = (await demo.state()).curve;
  const killed = demo.page.waitForEvent("crash");
  const devtools = await shared.newCDPSession(demo.page);
  // The answer never comes.
  void devtools.send("Page.crash").catch(() => undefined);
  await killed;
  const again = new Demo(await shared.newPage());
  await again.load("");
  const { curve } = await again.state();
  const found = [kept, last].find((each) => JSON.stringify(each) === JSON.stringify(curve));
  assertSame(curve, found ?? kept);
  assert.deepEqual(again.complaints, []);
});

test("DM-003 DM-008 whichever byte of the newest copy is damaged, the copy before it opens", async (t) => {
  const demo = await open(t);
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  await demo.page.waitForTimeout(untilKept);
  const earlier = (await demo.state()).curve;
  await demo.drag("pt-0-1", -10, 25);
  await demo.page.waitForTimeout(untilKept);
  await demo.page.goto(new URL("favicon.svg", process.env["DEMO_URL"]).href);
  const newest = await demo.page.evaluate(() => {
    const keys = Object.keys(localStorage).filter((key) => key.startsWith("expline.kept."));
    const generation = (key: string): number => Number(localStorage.getItem(key)?.split(" ")[1]);
    return keys.sort((a, b) => generation(b) - generation(a))[0] ?? "";
  });
  const whole = await demo.page.evaluate((key) => localStorage.getItem(key) ?? "", newest);
  assert.ok(whole.length > 200, "there is something to damage");
  for (const at of [0, 5, 9, 20, 100, Math.floor(whole.length / 2), whole.length - 1]) {
    const damaged = whole.slice(0, at) + String.fromCharCode(whole.charCodeAt(at) ^ 1) + whole.slice(at + 1);
    await demo.page.goto(new URL("favicon.svg", process.env["DEMO_URL"]).href);
    await demo.page.evaluate(([key, text]) => localStorage.setItem(key, text), [newest, damaged] as const);
    await demo.load("");
    assertSame((await demo.state()).curve, earlier, `byte ${at}`);
  }
});

for (const [id, what, script] of [
  ["DM-004", "a full store", () => { Storage.prototype.setItem = () => { throw new DOMException("full", "QuotaExceededError"); }; }],
  ["DM-005", "a blocked store", () => Object.defineProperty(window, "localStorage", { get() { throw new DOMException("blocked", "SecurityError"); } })],
] as const) {
  test(`${id} with ${what} the page works, says that nothing is kept, and offers the file`, async (t) => {
    const fresh = await context(t);
    await fresh.addInitScript(script);
    const demo = new Demo(await fresh.newPage());
    await demo.load("");
    await demo.withoutSnap();
    await demo.drag("pt-0-0", 40, 30);
    const banner = demo.page.locator('[data-error="storage"]');
    await banner.waitFor();
    const [file] = await Promise.all([demo.page.waitForEvent("download"), banner.click()]);
    assert.match(file.suggestedFilename(), /\.json$/);
    assert.notEqual((await demo.point(0)).x, 560);
  });
}

test("DM-006 two tabs keep their drawings side by side; neither writes over the other", async (t) => {
  const shared = await context(t);
  const first = new Demo(await shared.newPage());
  await first.load("#/curve?sample=heart");
  await first.withoutSnap();
  await first.drag("pt-0-1", 30, 0);
  await first.page.waitForTimeout(untilKept);
  const second = new Demo(await shared.newPage());
  await second.load("#/curve?sample=circle-8");
  await second.withoutSnap();
  await second.drag("pt-0-1", 0, 30);
  await second.page.waitForTimeout(untilKept);
  const kept = await second.page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("expline.kept.")).map((key) => localStorage.getItem(key) ?? ""));
  assert.ok(kept.some((text) => text.includes('"sample":"heart"')) && kept.some((text) => text.includes('"sample":"circle-8"')));
  await second.page.close();
  await first.page.goto("about:blank");
  await first.load("");
  assert.equal((await first.state()).curve.sample, "circle-8", "the newest work opens");
});
