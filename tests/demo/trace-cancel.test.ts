import assert from "node:assert/strict";
import { test } from "node:test";
import { Demo, useBrowser } from "./page.ts";

const { context } = useBrowser();

/** From when on the outlines that workers send are kept back, and which have been. */
interface Gate {
  closed: boolean;
  readonly waiting: (() => void)[];
}

declare global {
  interface Window {
    traceGate: Gate;
  }
}

/** A page whose tracer can be held at its last step: a trace then is under way for as long as a test needs it to be. */
async function openWithGate(t: Parameters<typeof context>[0], hash: string): Promise<Demo> {
  const fresh = await context(t);
  await fresh.addInitScript(() => {
    const gate: Gate = (window.traceGate = { closed: false, waiting: [] });
    window.Worker = class extends Worker {
      override addEventListener(type: string, listener: EventListenerOrEventListenerObject): void {
        super.addEventListener(type, (event) => {
          const hear = (): void => (typeof listener === "function" ? listener.call(this, event) : listener.handleEvent(event));
          if (gate.closed && event instanceof MessageEvent && (event.data as { kind: string }).kind === "traced") gate.waiting.push(hear);
          else hear();
        });
      }
    };
  });
  const demo = new Demo(await fresh.newPage());
  await demo.load(hash);
  return demo;
}

interface Counts {
  readonly contours: number;
  readonly holes: number;
  readonly cusps: number;
  readonly segments: number;
}

async function counts(demo: Demo): Promise<Counts> {
  const { trace } = (await demo.state()) as unknown as { trace: { result?: { contours: number; holes: number; cusps: readonly object[]; segments: number } } };
  assert.ok(trace.result !== undefined, "there are outlines");
  const { contours, holes, cusps, segments } = trace.result;
  return { contours, holes, cusps: cusps.length, segments };
}

/** What the bar says at every frame from now on, and when the frames were. */
async function watch(demo: Demo): Promise<void> {
  await demo.page.evaluate(() => {
    const seen: { time: number; value: number; text: string; shown: boolean }[] = [];
    Reflect.set(window, "seenProgress", seen);
    const note = (time: number): void => {
      const bar = document.querySelector('[data-testid="progress"]');
      seen.push({ time, value: Number(bar?.getAttribute("aria-valuenow")), text: bar?.textContent ?? "", shown: bar?.checkVisibility() === true });
      if (seen.length < 6000) requestAnimationFrame(note);
    };
    requestAnimationFrame(note);
  });
}

function seen(demo: Demo): Promise<{ time: number; value: number; text: string; shown: boolean }[]> {
  return demo.page.evaluate(() => Reflect.get(window, "seenProgress") as { time: number; value: number; text: string; shown: boolean }[]);
}

/** Times are printed beside the budget and not asserted: a busy neighbour says nothing about the page. */
test("V24 a long trace says how far it is, leaves the page in hand, cancels, and does the same once more", async (t) => {
  const demo = await openWithGate(t, "#/trace");
  const { page } = demo;
  await page.evaluate(() => {
    const state = window.explineDemo.getState();
    return window.explineDemo.setState({ ...state, trace: { ...state.trace, sample: "trace-big", settings: { ...state.trace.settings, size: 2048 } } });
  });
  await demo.idle();
  const whole = await counts(demo);
  t.diagnostic(`sheet at 2048: ${whole.contours} contours, ${whole.cusps} corners, ${((await demo.stats()).lastJobMs / 1000).toFixed(1)} s of 20`);
  assert.ok(whole.contours >= 400);

  await watch(demo);
  await page.evaluate(() => (window.traceGate.closed = true));
  await demo.byId("trace-run").click();
  await page.locator('[data-testid="progress"]', { hasText: /%/u }).waitFor();
  const { zoom } = (await demo.state()).view;
  const { x, y } = await demo.centre("stage");
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -240);
  await page.waitForFunction((before) => window.explineDemo.getState().view.zoom > before, zoom);
  const stopped = await page.evaluate(async () => {
    const pressed = performance.now();
    document.querySelector<HTMLElement>('[data-testid="trace-cancel"]')?.click();
    await window.explineDemo.idle();
    return performance.now() - pressed;
  });
  await page.locator('[data-testid="toast"]', { hasText: "Cancelled" }).waitFor();
  assert.deepEqual(await counts(demo), whole, "the result before is back");
  await demo.byId("trace-cancel").waitFor({ state: "hidden" });
  assert.equal(await page.locator('[data-testid="progress"]').isVisible(), false);

  const frames = (await seen(demo)).filter(({ shown }) => shown);
  frames.forEach(({ value }, i) => assert.ok(value >= (frames[i - 1]?.value ?? 0), `${value} after ${frames[i - 1]?.value ?? 0}`));
  assert.ok(frames.some(({ text }) => /%/u.test(text)), "with words");
  const gaps = frames.slice(1).map(({ time }, i) => time - (frames[i]?.time ?? time)).sort((a, b) => a - b);
  t.diagnostic(`idle ${stopped.toFixed(0)} ms of 50 after Cancel; frame gaps p95 ${(gaps[Math.floor(0.95 * gaps.length)] ?? 0).toFixed(0)} ms of 100`);

  await page.evaluate(() => (window.traceGate.closed = false));
  await demo.byId("trace-run").click();
  await demo.idle();
  assert.deepEqual(await counts(demo), whole);
  assert.deepEqual(demo.complaints, []);
});

test("what a cancelled trace still sends is heard no more", async (t) => {
  const demo = await openWithGate(t, "#/trace?sample=trace-star");
  const { page } = demo;
  const star = await counts(demo);
  await page.evaluate(() => (window.traceGate.closed = true));
  await demo.byId("trace-corner").fill("180");
  await page.waitForFunction(() => window.traceGate.waiting.length > 0);
  await demo.byId("trace-cancel").click();
  await demo.idle();
  await page.evaluate(() => window.traceGate.waiting.forEach((hear) => hear()));
  await demo.idle();
  assert.deepEqual(await counts(demo), star);
});

test("after Cancel the page says whose settings the outlines are of, until they are traced anew", async (t) => {
  const demo = await openWithGate(t, "#/trace?sample=trace-star");
  const { page } = demo;
  const behind = demo.byId("trace-behind");
  assert.equal(await behind.isVisible(), false);
  await page.evaluate(() => (window.traceGate.closed = true));
  await demo.byId("trace-corner").fill("180");
  await page.waitForFunction(() => window.traceGate.waiting.length > 0);
  await demo.byId("trace-cancel").click();
  await demo.idle();
  assert.equal(await behind.isVisible(), true);
  assert.match(await demo.textOf("hint"), /of the settings before/u);
  await page.evaluate(() => (window.traceGate.closed = false));
  await demo.byId("trace-run").click();
  await demo.idle();
  assert.equal(await behind.isVisible(), false);
  assert.equal((await counts(demo)).cusps, 0);
});
