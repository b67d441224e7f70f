import assert from "node:assert/strict";
import { after, before, type TestContext } from "node:test";
import type { Browser, BrowserContext, BrowserContextOptions, CDPSession, Page } from "playwright-core";
import { launch } from "../../scripts/browser.mjs";
import type { ExplineDemo } from "../../www/src/contract.ts";

/**
 * The demo in a real browser, driven as a person would: by pointer and keys, and looked at through
 * `window.explineDemo`.
 */

declare global {
  interface Window {
    explineDemo: ExplineDemo;
  }
}

export type Pair = [number, number];
type State = ReturnType<ExplineDemo["getState"]>;

/** One browser for a test file. Call at its top level. */
export function useBrowser(): {
  /** A fresh window on the page, ready. */
  open(t: TestContext, hash?: string, options?: BrowserContextOptions): Promise<Demo>;
  /** A fresh browser context with nothing in it yet. */
  context(t: TestContext, options?: BrowserContextOptions): Promise<BrowserContext>;
} {
  let browser: Browser | undefined;
  before(async () => {
    browser = await launch();
  });
  after(async () => {
    await browser?.close();
  });
  async function context(t: TestContext, options: BrowserContextOptions = {}): Promise<BrowserContext> {
    assert.ok(browser !== undefined, "the browser is started before the tests");
    const fresh = await browser.newContext({ viewport: { width: 1280, height: 800 }, deviceScaleFactor: 1, ...options });
    t.after(() => fresh.close());
    if (slowness > 1) fresh.on("page", (page) => void slowDown(fresh, page));
    if (lateness > 0) await fresh.route(/\/assets\//u, (route) => void setTimeout(() => void route.continue().catch(() => undefined), lateness));
    return fresh;
  }
  return {
    context,
    async open(t, hash = "", options = {}) {
      const demo = new Demo(await (await context(t, options)).newPage());
      await demo.load(hash);
      return demo;
    },
  };
}

/** `DEMO_SLOWNESS=4` runs the pages on a quarter of the processor: what depends on a fast machine shows. */
const slowness = Number(process.env["DEMO_SLOWNESS"] ?? 1);

/**
 * `DEMO_LATENESS=400` hands out every part of the page so many milliseconds later: what does not wait for a part shows.
 */
const lateness = Number(process.env["DEMO_LATENESS"] ?? 0);

async function slowDown(context: BrowserContext, page: Page): Promise<void> {
  const devtools = await context.newCDPSession(page);
  await devtools.send("Emulation.setCPUThrottlingRate", { rate: slowness });
}

export interface Place {
  readonly x: number;
  readonly y: number;
}

export class Demo {
  readonly page: Page;
  #devtools: Promise<CDPSession> | undefined;
  /** Of the last event that was sent with a time stamp of its own, in seconds since 1970. */
  #time = 0;
  /** Console errors and uncaught exceptions since the page was opened. */
  readonly complaints: string[] = [];

  constructor(page: Page) {
    this.page = page;
    page.on("console", (message) => message.type() === "error" && this.complaints.push(`${message.text()} ${message.location().url}`));
    page.on("pageerror", (error) => this.complaints.push(String(error)));
  }

  async load(hash: string): Promise<void> {
    const { DEMO_URL } = process.env;
    assert.ok(DEMO_URL !== undefined, "DEMO_URL names the served demo");
    await this.page.goto(new URL(hash, DEMO_URL).href);
    await this.page.evaluate(() => window.explineDemo.ready);
    await this.idle();
  }

  idle(): Promise<void> {
    return this.page.evaluate(() => window.explineDemo.idle());
  }

  state(): Promise<State> {
    return this.page.evaluate(() => window.explineDemo.getState());
  }

  async points(contour = 0): Promise<State["curve"]["contours"][number]["points"]> {
    return (await this.state()).curve.contours[contour]?.points ?? [];
  }

  async point(index: number, contour = 0): Promise<State["curve"]["contours"][number]["points"][number]> {
    const point = (await this.points(contour))[index];
    assert.ok(point !== undefined, `there is a point ${contour}-${index}`);
    return point;
  }

  sample(count: number, contour = 0): Promise<Pair[]> {
    return this.page.evaluate(([n, c]) => window.explineDemo.sample(n, c), [count, contour] as const);
  }

  stats(): Promise<ReturnType<ExplineDemo["stats"]>> {
    return this.page.evaluate(() => window.explineDemo.stats());
  }

  toScreen(x: number, y: number): Promise<{ x: number; y: number }> {
    return this.page.evaluate(([a, b]) => window.explineDemo.toScreen(a, b), [x, y] as const);
  }

  toDoc(x: number, y: number): Promise<{ x: number; y: number }> {
    return this.page.evaluate(([a, b]) => window.explineDemo.toDoc(a, b), [x, y] as const);
  }

  byId(id: string): ReturnType<Page["locator"]> {
    return this.page.locator(`[data-testid="${id}"]`);
  }

  /** The middle of an element's box. */
  async centre(id: string): Promise<Place> {
    const box = await this.byId(id).boundingBox();
    assert.ok(box !== null, `${id} has a box`);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  async click(id: string): Promise<void> {
    const { x, y } = await this.centre(id);
    await this.page.mouse.click(x, y);
    await this.idle();
    const box = await this.byId("stage").boundingBox();
    const onStage = box !== null && x >= box.x && y >= box.y && x <= box.x + box.width && y <= box.y + box.height;
    // Two clicks of a test on the stage are never one double-click of a person.
    if (onStage) await this.page.waitForTimeout(450);
  }

  /** Turns the wheel over a place by so many notches, all between two frames. */
  async wheel({ x, y }: Place, notches: number): Promise<void> {
    await this.byId("stage").evaluate((stage, [clientX, clientY, count]) => {
      for (let i = 0; i < Math.abs(count); i += 1) stage.dispatchEvent(new WheelEvent("wheel", { clientX, clientY, deltaY: -120 * Math.sign(count), bubbles: true, cancelable: true }));
    }, [x, y, notches] as const);
    await this.idle();
  }

  /** Two presses 80 ms apart by their own time stamps, however long the page takes for either. */
  async doubleClick(x: number, y: number): Promise<void> {
    const devtools = await this.#tools();
    await this.page.mouse.move(x, y);
    this.#time = Date.now() / 1000;
    for (const clickCount of [1, 2]) {
      for (const type of ["mousePressed", "mouseReleased"] as const) await devtools.send("Input.dispatchMouseEvent", { type, x, y, button: "left", clickCount, timestamp: (this.#time += 0.04) });
    }
    await this.idle();
    await this.page.waitForTimeout(450);
  }

  #tools(): Promise<CDPSession> {
    return (this.#devtools ??= this.page.context().newCDPSession(this.page));
  }

  /** Fingers, an event every 16 ms by its time stamp, however long the page takes for it. */
  async touch(type: "touchStart" | "touchMove" | "touchEnd", ...points: Place[]): Promise<void> {
    const devtools = await this.#tools();
    await devtools.send("Input.dispatchTouchEvent", { type, touchPoints: points.map((point, id) => ({ ...point, id })), timestamp: (this.#time += 0.016) });
  }

  /** So many taps in quick succession. */
  async tap(fingers: readonly Place[], times = 1): Promise<void> {
    this.#time = Math.max(this.#time, Date.now() / 1000);
    for (let i = 0; i < times; i += 1) {
      await this.touch("touchStart", ...fingers);
      await this.touch("touchEnd");
    }
    await this.idle();
  }

  async dragFrom(from: Place, dx: number, dy: number, steps = 4): Promise<void> {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(from.x + dx, from.y + dy, { steps });
    await mouse.up();
    await this.idle();
  }

  async drag(id: string, dx: number, dy: number): Promise<void> {
    await this.dragFrom(await this.centre(id), dx, dy);
  }

  async press(...keys: string[]): Promise<void> {
    for (const key of keys) await this.page.keyboard.press(key);
    await this.idle();
  }

  /** Checks that drag need the pointer's own coordinates. */
  async withoutSnap(): Promise<void> {
    const snap = this.byId("snap");
    if (await snap.isChecked()) await snap.uncheck();
    await this.idle();
  }

  /** Sets a native range input as a drag of its thumb would, and lets go of it. */
  async slide(id: string, value: number): Promise<void> {
    await this.byId(id).fill(String(value));
    await this.idle();
  }

  /** Keys go to the stage. */
  async focusStage(): Promise<void> {
    await this.byId("stage").focus();
  }

  /** What the page has begun to move is where it goes: fading dialogs, folding parts. */
  async still(): Promise<void> {
    await this.idle();
    await this.page.evaluate(() => Promise.allSettled(document.getAnimations().map((each) => each.finished)));
  }

  /** What was copied by `copy`, which is waited for. */
  async copied(copy: () => Promise<void>): Promise<string> {
    await this.page.evaluate(() => navigator.clipboard.writeText(""));
    await copy();
    return this.until(() => this.page.evaluate(() => navigator.clipboard.readText()), (text) => text !== "", "something is copied");
  }

  /** What the browser keeps of this page, in its database. */
  keptTexts(): Promise<{ key: string; text: string }[]> {
    return this.page.evaluate(async () => {
      const request = <T>(asked: IDBRequest<T>): Promise<T> => new Promise((resolve, reject) => {
        asked.onsuccess = () => resolve(asked.result);
        asked.onerror = () => reject(asked.error ?? new Error("no answer"));
      });
      if (!(await indexedDB.databases()).some(({ name }) => name === "expline")) return [];
      const database = await request(indexedDB.open("expline"));
      const table = database.transaction("kept").objectStore("kept");
      const [keys, texts] = await Promise.all([request(table.getAllKeys()), request(table.getAll())]);
      database.close();
      return keys.map((key, i) => ({ key: String(key), text: String(texts[i]) }));
    });
  }

  /** The page keeps what is there within a second; the drawing as it is kept. */
  async kept(): Promise<State["curve"]> {
    const { curve } = await this.state();
    const text = JSON.stringify(curve);
    await this.until(() => this.keptTexts(), (all) => all.some((each) => each.text.includes(text)), "the drawing is kept");
    return curve;
  }

  /** Looks again and again until it is as it should be. */
  async until<T>(look: () => Promise<T>, good: (seen: T) => boolean, what: string): Promise<T> {
    const start = Date.now();
    for (;;) {
      const seen = await look();
      if (good(seen)) return seen;
      // Only a page that hangs takes so long.
      assert.ok(Date.now() - start < 60_000, `not within a minute: ${what}`);
      await this.page.waitForTimeout(50);
    }
  }

  async textOf(id: string): Promise<string> {
    return (await this.byId(id).textContent()) ?? "";
  }

  /** The unrounded number behind a readout. */
  async metric(id: string): Promise<number> {
    return Number(await this.byId(id).getAttribute("data-value"));
  }

  /** How many pixels differ between two pictures of the stage. */
  async changedPixels(before: string, after: string): Promise<number> {
    return this.page.evaluate(([a, b]) => {
      let changed = Math.abs(a.length - b.length);
      for (let i = 0; i < Math.min(a.length, b.length); i += 1) changed += a[i] === b[i] ? 0 : 1;
      return changed;
    }, [before, after] as const);
  }

  /** The canvas's pixels, one character per pixel: enough to compare pictures and to count what is not paper. */
  pixels(): Promise<string> {
    return this.page.evaluate(() => {
      const canvas = document.querySelector("canvas");
      const context = canvas?.getContext("2d");
      if (canvas == null || context == null) return "";
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      let text = "";
      for (let i = 0; i < data.length; i += 4) text += String.fromCharCode(33 + (((data[i] ?? 0) * 3 + (data[i + 1] ?? 0) * 5 + (data[i + 2] ?? 0) * 7) % 90));
      return text;
    });
  }
}

export function boxDiagonal(points: readonly Pair[]): number {
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  return Math.hypot(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
}

function distanceToSegment([x, y]: Pair, [ax, ay]: Pair, [bx, by]: Pair): number {
  const [ux, uy] = [bx - ax, by - ay];
  const size = ux * ux + uy * uy;
  const t = size === 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * ux + (y - ay) * uy) / size));
  return Math.hypot(x - ax - t * ux, y - ay - t * uy);
}

/** The largest distance from points of one curve to the polygon through a dense sampling of another. */
export function directedDistance(from: readonly Pair[], to: readonly Pair[], closed: boolean): number {
  let worst = 0;
  for (const point of from) {
    let best = Infinity;
    const last = closed ? to.length : to.length - 1;
    for (let i = 0; i < last; i += 1) {
      const [a, b] = [to[i], to[(i + 1) % to.length]];
      if (a !== undefined && b !== undefined) best = Math.min(best, distanceToSegment(point, a, b));
    }
    worst = Math.max(worst, best);
  }
  return worst;
}

export function radiusError(points: readonly Pair[], centre: Pair = [400, 300], radius = 160): number {
  return Math.max(...points.map(([x, y]) => Math.abs(Math.hypot(x - centre[0], y - centre[1]) - radius))) / radius;
}

/** Two states alike to 1e-12, whatever the order of their keys. */
export function assertSame(actual: unknown, expected: unknown, path = "state"): void {
  if (typeof actual === "number" && typeof expected === "number") {
    assert.ok(Math.abs(actual - expected) <= 1e-12 * Math.max(1, Math.abs(expected)), `${path}: ${actual} is not ${expected}`);
  } else if (typeof actual === "object" && typeof expected === "object" && actual !== null && expected !== null) {
    const keys = new Set([...Object.keys(actual), ...Object.keys(expected)]);
    for (const key of keys) assertSame(Reflect.get(actual, key), Reflect.get(expected, key), `${path}.${key}`);
  } else assert.deepEqual(actual, expected, path);
}
