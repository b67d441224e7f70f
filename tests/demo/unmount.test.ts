import assert from "node:assert/strict";
import { test } from "node:test";
import { Demo, useBrowser } from "./page.ts";

const { context } = useBrowser();

/** What the page holds on to outside of its own elements. */
interface Held {
  listeners: number;
  workers: number;
}

declare global {
  interface Window {
    held: Held;
  }
}

/** Counts listeners of the window, the document and the media queries, and workers that run. */
function count(): void {
  const held: Held = (window.held = { listeners: 0, workers: 0 });
  for (const target of [Window.prototype, Document.prototype, MediaQueryList.prototype] as const) {
    const add = EventTarget.prototype.addEventListener;
    Object.defineProperty(target, "addEventListener", {
      configurable: true,
      value(this: EventTarget, type: string, listener: EventListener, options?: AddEventListenerOptions) {
        held.listeners += 1;
        options?.signal?.addEventListener("abort", () => (held.listeners -= 1));
        add.call(this, type, listener, options);
      },
    });
  }
  window.Worker = class extends Worker {
    #ended = false;
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      held.workers += 1;
    }
    override terminate(): void {
      if (!this.#ended) held.workers -= 1;
      this.#ended = true;
      super.terminate();
    }
  };
}

test("DM-029 taken apart and put together twice, the page leaves nothing behind and works", async (t) => {
  const fresh = await context(t);
  await fresh.addInitScript(count);
  const demo = new Demo(await fresh.newPage());
  await demo.load("#/fit?sample=fit-star");
  const { page } = demo;
  const held = (): Promise<Held> => page.evaluate(() => ({ ...window.held }));
  await demo.byId("tab-trace").click();
  await demo.byId("sample-trace-star").click();
  await demo.idle();
  const first = await held();
  assert.ok(first.listeners > 5 && first.workers === 2, JSON.stringify(first));
  for (let round = 0; round < 2; round += 1) {
    await page.evaluate(() => Reflect.set(window, "again", window.explineDemo.unmount()));
    assert.deepEqual(await held(), { listeners: 0, workers: 0 }, `round ${round}`);
    assert.equal(await demo.byId("tab-curve").count(), 0);
    await page.evaluate(async () => {
      const { mount } = Reflect.get(window, "again") as ReturnType<Window["explineDemo"]["unmount"]>;
      await mount().ready;
    });
    await demo.idle();
    assert.equal(await demo.byId("tab-curve").count(), 1);
  }
  await demo.byId("tab-curve").click();
  await demo.idle();
  await demo.withoutSnap();
  const { x } = await demo.point(0);
  await demo.drag("pt-0-0", 40, 0);
  const { zoom } = (await demo.state()).view;
  assert.ok(Math.abs((await demo.point(0)).x - x - 40 / zoom) < 0.5 / zoom);
  await demo.press("Control+z");
  assert.equal((await demo.point(0)).x, x);
  assert.deepEqual(demo.complaints, []);
});
