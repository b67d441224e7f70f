import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
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

test("a drawing too large for a link says so, keeps the clipboard and offers the file", async (t) => {
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
  const [file] = await Promise.all([demo.page.waitForEvent("download"), demo.byId("error").getByRole("button", { name: "Download JSON" }).click()]);
  const saved = JSON.parse(await readFile(await file.path(), "utf8")) as { curve: unknown };
  assertSame(saved.curve, (await demo.state()).curve);
  assert.equal(await demo.byId("error").count(), 0, "it has been seen to");
});

/** Longer than the second after which a change is kept: to see that something is not. */
const pastKeeping = 1400;

test("DM-001 after a reload the last committed edit is there, and a fresh start is one press away", async (t) => {
  const demo = await open(t);
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  const kept = await demo.kept();
  await demo.page.goto("about:blank");
  await demo.load("");
  assertSame((await demo.state()).curve, kept);
  await demo.byId("toast").getByRole("button", { name: "Start fresh" }).click();
  await demo.idle();
  assert.equal((await demo.point(0)).x, 560);
});

test("DM-001 an edit is kept when the page is left at once", async (t) => {
  const demo = await open(t);
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  await demo.kept();
  await demo.drag("pt-0-1", 10, 20);
  const { curve } = await demo.state();
  await demo.page.goto("about:blank");
  await demo.load("");
  assertSame((await demo.state()).curve, curve);
  await demo.kept();
  assert.equal(await demo.page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("expline.kept.")).length), 0, "it has moved into the database");
});

/** Loads the page again while a point is dragged; answers what was there before the drag. */
async function reloadDuringDrag(demo: Demo): Promise<Awaited<ReturnType<Demo["state"]>>["curve"]> {
  const { curve } = await demo.state();
  const { x, y } = await demo.centre("pt-0-1");
  await demo.page.mouse.move(x, y);
  await demo.page.mouse.down();
  await demo.page.mouse.move(x + 60, y + 20, { steps: 4 });
  await demo.idle();
  assert.notDeepEqual((await demo.state()).curve, curve, "the drag has begun");
  await demo.page.reload();
  await demo.page.mouse.up();
  await demo.page.evaluate(() => window.explineDemo.ready);
  await demo.idle();
  return curve;
}

for (const [how, leave] of [
  ["goes to another page", async ({ page }) => void (await page.goto("about:blank"))],
  ["closes the tab", ({ page }) => page.close({ runBeforeUnload: true })],
  ["looks at another tab, and the browser ends this one", ({ page }) => page.evaluate(() => {
    Object.defineProperty(document, "visibilityState", { value: "hidden" });
    Object.defineProperty(document, "hidden", { value: true });
    document.dispatchEvent(new Event("visibilitychange"));
    // What ends without a word.
    window.addEventListener("pagehide", (event) => event.stopImmediatePropagation(), { capture: true });
  })],
] as const satisfies readonly (readonly [string, (demo: Demo) => Promise<void>])[]) {
  test(`DM-001 who ${how} before what keeps drawings has come finds the first edit again`, async (t) => {
    const shared = await context(t, { serviceWorkers: "block" });
    // So that there is a page left when one is closed.
    const next = new Demo(await shared.newPage());
    const demo = new Demo(await shared.newPage());
    await demo.load("");
    await demo.page.route(/\/(autosave|keeping)-[^/]*\.js/u, () => undefined);
    await demo.focusStage();
    await demo.page.keyboard.press("]");
    await demo.page.keyboard.press("ArrowUp");
    const { curve } = await demo.state();
    await leave(demo);
    await next.load("");
    assertSame((await next.state()).curve, curve);
  });
}

test("DM-001 where what keeps drawings never came, the last edit is there at the next visit, and a drag that was under way is not", async (t) => {
  const demo = await open(t, "", { serviceWorkers: "block" });
  await demo.page.route(/\/autosave-[^/]*\.js/u, (route) => route.abort());
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  await demo.page.locator("[data-error=storage]").waitFor();
  const curve = await reloadDuringDrag(demo);
  assertSame((await demo.state()).curve, curve);
});

for (const [what, part] of [["the last session", "kept"], ["a shared link", "share"]] as const) {
  test(`DM-001 while ${what} is still on its way, nothing else is shown that could be worked on and would be lost`, async (t) => {
    const demo = await open(t, "#/curve?sample=heart", { serviceWorkers: "block", permissions: ["clipboard-read", "clipboard-write"] });
    await demo.focusStage();
    await demo.press("]", "ArrowUp");
    const curve = await demo.kept();
    const address = part === "share" ? new URL(await demo.copied(() => demo.byId("btn-share").click())).hash : "";
    await demo.page.goto("about:blank");
    let release = (): void => undefined;
    const held = new Promise<void>((resolve) => (release = resolve));
    await demo.page.route(new RegExp(`/${part}-[^/]*\\.js`, "u"), async (route) => {
      await held;
      await route.continue();
    });
    await demo.page.goto(new URL(address, process.env["DEMO_URL"]).href);
    await demo.page.locator(".boot-note").waitFor();
    await demo.focusStage();
    await demo.page.keyboard.press("]");
    await demo.page.keyboard.press("ArrowRight");
    assert.deepEqual((await demo.state()).curve.contours, []);
    release();
    await demo.page.evaluate(() => window.explineDemo.ready);
    await demo.idle();
    assertSame((await demo.state()).curve, curve);
  });
}

test("the stage says what it waits for: the engine, and once that is there the drawing", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", { serviceWorkers: "block" });
  await demo.focusStage();
  await demo.press("]", "ArrowUp");
  await demo.kept();
  await demo.page.goto("about:blank");
  const release = new Map<string, () => void>();
  for (const part of ["expline_bg-", "kept-"]) {
    const held = new Promise<void>((resolve) => release.set(part, resolve));
    await demo.page.route((url) => url.pathname.includes(`/${part}`), async (route) => {
      await held;
      await route.continue();
    });
  }
  await demo.page.goto(process.env["DEMO_URL"] ?? "");
  const note = demo.page.locator(".boot-note");
  await note.waitFor();
  assert.equal(await note.textContent(), "Loading the spline engine…");
  release.get("expline_bg-")?.();
  await demo.until(() => note.textContent(), (text) => text === "Opening your drawing…", "the drawing is waited for");
  release.get("kept-")?.();
  await demo.page.evaluate(() => window.explineDemo.ready);
  await demo.idle();
  assert.equal(await note.count(), 0);
});

test("DM-001 what was done just before a drag is kept when a reload interrupts the drag", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.drag("pt-0-1", 40, 30);
  // What keeps it comes with the first change.
  const parts = (): Promise<string[]> => demo.page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name));
  await demo.until(parts, (names) => names.some((name) => name.includes("/autosave-")), "it can be kept");
  await demo.idle();
  const curve = await reloadDuringDrag(demo);
  assert.deepEqual((await demo.state()).curve, curve);
});

test("DM-001 a drag that is interrupted by a reload leaves the state before it", async (t) => {
  const demo = await open(t);
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  const kept = await demo.kept();
  const { x, y } = await demo.centre("pt-0-1");
  await demo.page.mouse.move(x, y);
  await demo.page.mouse.down();
  await demo.page.mouse.move(x + 90, y, { steps: 4 });
  await demo.page.waitForTimeout(pastKeeping);
  await demo.page.goto("about:blank");
  await demo.load("");
  assertSame((await demo.state()).curve, kept);
});

test("DM-001 a tab that lay idle while others were worked in, and more of them than are kept, shows its own work when it is loaded again", async (t) => {
  const shared = await context(t);
  const edited = async (sample: string, by: number): Promise<Demo> => {
    const demo = new Demo(await shared.newPage());
    await demo.load(`#/curve?sample=${sample}`);
    await demo.withoutSnap();
    await demo.drag("pt-0-0", by, 30);
    await demo.kept();
    return demo;
  };
  const own = await edited("heart", 40);
  const { curve } = await own.state();
  const text = JSON.stringify(curve);
  for (let i = 0; i < 4; i += 1) await edited("glyph", 40 + i);
  await own.until(() => own.keptTexts(), (all) => all.every((each) => !each.text.includes(text)), "it has given way");
  await own.page.bringToFront();
  await own.page.reload();
  await own.page.evaluate(() => window.explineDemo.ready);
  await own.idle();
  assert.deepEqual((await own.state()).curve, curve);
});

test("DM-002 a tab that is killed loses nothing that was committed more than a second before", async (t) => {
  const shared = await context(t);
  const demo = new Demo(await shared.newPage());
  await demo.load("");
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  const kept = await demo.kept();
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

/** A page of the same origin on which the demo does not run. */
async function aside(demo: Demo): Promise<void> {
  await demo.page.goto(new URL("favicon.svg", process.env["DEMO_URL"]).href);
}

test("DM-003 DM-008 whichever byte of the newest copy is damaged, the copy before it opens and the damaged one can be saved", async (t) => {
  const demo = await open(t);
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  const earlier = await demo.kept();
  await demo.drag("pt-0-1", -10, 25);
  await demo.kept();
  await aside(demo);
  const [newest] = (await demo.keptTexts()).sort((a, b) => Number(b.text.split(" ")[1]) - Number(a.text.split(" ")[1]));
  assert.ok(newest !== undefined && newest.text.length > 200, "there is something to damage");
  const { key, text: whole } = newest;
  for (const at of [0, 9, Math.floor(whole.length / 2), whole.length - 1]) {
    const damaged = whole.slice(0, at) + String.fromCharCode(whole.charCodeAt(at) ^ 1) + whole.slice(at + 1);
    await aside(demo);
    await demo.page.evaluate(([where, text]) => new Promise<void>((resolve, reject) => {
      // Left there by the page that was just left.
      localStorage.removeItem(where);
      const request = indexedDB.open("expline");
      request.onsuccess = () => {
        const transaction = request.result.transaction("kept", "readwrite");
        transaction.objectStore("kept").put(text, where);
        transaction.oncomplete = () => {
          request.result.close();
          resolve();
        };
        transaction.onabort = () => reject(transaction.error ?? new Error("not written"));
      };
    }), [key, damaged] as const);
    await demo.load("");
    assertSame((await demo.state()).curve, earlier, `byte ${at}`);
    if (at > 0) continue;
    const save = demo.page.getByRole("button", { name: "Download damaged copy" });
    const [file] = await Promise.all([demo.page.waitForEvent("download"), save.click()]);
    assert.equal(await readFile(await file.path(), "utf8"), damaged);
  }
});

const full = (): void => {
  const refuse = (): never => {
    throw new DOMException("full", "QuotaExceededError");
  };
  Storage.prototype.setItem = refuse;
  IDBObjectStore.prototype.put = refuse;
};

const blocked = (): void => {
  const refuse = (): never => {
    throw new DOMException("blocked", "SecurityError");
  };
  Object.defineProperty(window, "localStorage", { get: refuse });
  IDBFactory.prototype.open = refuse;
};

for (const [id, what, script] of [["DM-004", "a full store", full], ["DM-005", "a blocked store", blocked]] as const) {
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

test("without a database a drawing is kept in the local store, and what is there from before opens", async (t) => {
  const fresh = await context(t);
  await fresh.addInitScript(() => {
    if (localStorage.getItem("test.blocked") === null) return;
    IDBFactory.prototype.open = () => {
      throw new DOMException("blocked", "SecurityError");
    };
  });
  const demo = new Demo(await fresh.newPage());
  await demo.load("");
  await demo.page.evaluate(() => localStorage.setItem("test.blocked", "1"));
  await demo.load("");
  await demo.page.reload();
  await demo.page.evaluate(() => window.explineDemo.ready);
  await demo.withoutSnap();
  await demo.drag("pt-0-0", 40, 30);
  const { curve } = await demo.state();
  const text = JSON.stringify(curve);
  await demo.page.waitForFunction((wanted) => Object.keys(localStorage).some((key) => key.startsWith("expline.kept.") && localStorage.getItem(key)?.includes(wanted) === true), text);
  await demo.page.evaluate(() => localStorage.removeItem("test.blocked"));
  await aside(demo);
  await demo.load("");
  assertSame((await demo.state()).curve, curve);
  await demo.kept();
});

test("DM-006 two tabs keep their drawings side by side; neither writes over the other", async (t) => {
  const shared = await context(t);
  const first = new Demo(await shared.newPage());
  await first.load("#/curve?sample=heart");
  await first.withoutSnap();
  await first.drag("pt-0-1", 30, 0);
  await first.kept();
  const second = new Demo(await shared.newPage());
  await second.load("#/curve?sample=circle-8");
  await second.withoutSnap();
  await second.drag("pt-0-1", 0, 30);
  await second.kept();
  const kept = (await second.keptTexts()).map(({ text }) => text);
  assert.ok(kept.some((text) => text.includes('"sample":"heart"')) && kept.some((text) => text.includes('"sample":"circle-8"')));
  await second.page.close();
  await first.page.goto("about:blank");
  await first.load("");
  assert.equal((await first.state()).curve.sample, "circle-8", "the newest work opens");
});

/** The same page once more, as by the browser's button. */
async function reload(demo: Demo): Promise<void> {
  await demo.page.reload();
  await demo.page.evaluate(() => window.explineDemo.ready);
  await demo.idle();
}

test("DM-001 in every mode the page that is loaded again shows what was worked on, and the other modes keep theirs", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.withoutSnap();
  await demo.drag("pt-0-1", 30, 0);
  const { curve } = await demo.state();
  await demo.byId("tab-fit").click();
  await demo.idle();
  await demo.byId("btn-clear").click();
  await demo.dragFrom({ x: 300, y: 300 }, 200, 60, 40);
  await demo.until(() => demo.keptTexts(), (all) => all.some(({ text }) => text.includes('"mode":"fit"') && !text.includes('"data":[]')), "the stroke is kept");
  const { fit } = await demo.state();
  assert.ok(fit.data.length >= 4, `${fit.data.length} points`);
  await reload(demo);
  assert.equal((await demo.state()).mode, "fit");
  assertSame((await demo.state()).fit.data, fit.data);
  assertSame((await demo.state()).curve, curve);
  await demo.byId("tab-surface").click();
  await demo.idle();
  await demo.byId("surf-level-u").fill("1");
  await demo.idle();
  await demo.until(() => demo.keptTexts(), (all) => all.some(({ text }) => text.includes('"levelU":1')), "the surface is kept");
  await reload(demo);
  assert.equal((await demo.state()).mode, "surface");
  assert.equal((await demo.state()).surface.levelU, 1);
  assertSame((await demo.state()).fit.data, fit.data);
});

test("a tab that is loaded again shows its own work, whatever another tab has kept since", async (t) => {
  const shared = await context(t);
  const first = new Demo(await shared.newPage());
  await first.load("#/curve?sample=heart");
  await first.withoutSnap();
  await first.drag("pt-0-1", 30, 0);
  const kept = await first.kept();
  const second = new Demo(await shared.newPage());
  await second.load("#/curve?sample=circle-8");
  await second.withoutSnap();
  await second.drag("pt-0-1", 0, 30);
  await second.kept();
  await reload(first);
  assertSame((await first.state()).curve, kept);
});

test("a link to a sample shows the sample, whatever was kept, and a shared drawing is still there when the page is loaded again", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", { permissions: ["clipboard-read", "clipboard-write"] });
  await demo.withoutSnap();
  await demo.drag("pt-0-1", 30, 0);
  await demo.kept();
  const link = await demo.copied(() => demo.byId("btn-share").click());
  const { curve } = await demo.state();
  await demo.page.goto("about:blank");
  await demo.load("#/curve?sample=circle-8");
  assert.equal((await demo.points()).length, 8);
  const other = new Demo(await (await context(t)).newPage());
  await other.load(new URL(link).hash);
  assertSame((await other.state()).curve, curve);
  await reload(other);
  assertSame((await other.state()).curve, curve);
});

test("a link that is opened over work is one step of the history: Undo has the work back", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8", { permissions: ["clipboard-read", "clipboard-write"] });
  const link = await demo.copied(() => demo.byId("btn-share").click());
  await demo.page.evaluate(() => (location.hash = "#/curve?sample=heart"));
  await demo.idle();
  await demo.focusStage();
  await demo.press("]", "ArrowUp");
  const { curve } = await demo.state();
  await demo.page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await demo.until(() => demo.points(), (points) => points.length === 8, "the link is open");
  await demo.byId("btn-undo").click();
  await demo.idle();
  assertSame((await demo.state()).curve, curve);
});
