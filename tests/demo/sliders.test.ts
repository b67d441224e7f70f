import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";

const { open } = useBrowser();

/**
 * What the drag of a slider must leave as it was when it is taken back: the slider, the drawing, and what Undo would
 * do.
 */
async function standing(demo: Demo, id: string): Promise<{ readonly value: string } & Readonly<Record<string, unknown>>> {
  const undo = demo.byId("btn-undo");
  const { curve, fit, trace, surface } = (await demo.state()) as unknown as Record<string, object>;
  return {
    value: await demo.byId(id).inputValue(),
    said: await demo.byId(id).getAttribute("aria-valuetext"),
    undo: await undo.getAttribute("title"),
    can: await undo.isEnabled(),
    drawing: [curve, fit, { ...trace, result: undefined }, surface],
  };
}

/** Presses a slider's thumb and drags it from there by a part of its length. */
async function dragBy(demo: Demo, id: string, part: number): Promise<{ readonly x: number; readonly y: number; readonly width: number }> {
  const slider = demo.byId(id);
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  assert.ok(box !== null, `${id} has a box`);
  const at = await slider.evaluate((input: HTMLInputElement) => (Number(input.value) - Number(input.min)) / (Number(input.max) - Number(input.min)));
  // The thumb is 18 pixels wide or so, and stays within the box.
  const place = { x: box.x + 9 + at * (box.width - 18), y: box.y + box.height / 2, width: box.width - 18 };
  await demo.page.mouse.move(place.x, place.y);
  await demo.page.mouse.down();
  for (let i = 1; i <= 4; i += 1) await demo.page.mouse.move(place.x + (i / 4) * part * place.width, place.y);
  await demo.idle();
  return place;
}

const sliders = [
  ["#/curve?sample=blob-16", "level", 0.6],
  ["#/fit?sample=fit-star", "fit-smoothing", 0.3],
  ["#/trace?sample=trace-star", "trace-detail", 0.3],
  ["#/trace?sample=trace-star", "trace-alpha", 0.3],
  ["#/surface?sample=surf-sphere", "surf-level-u", 0.5],
] as const;

for (const key of ["Escape", "Control+z"]) {
  test(`${key} in the middle of a slider's drag puts everything back, and what is left of the drag does nothing`, async (t) => {
    for (const [hash, id, part] of sliders) {
      const demo = await open(t, hash);
      await demo.byId(id).waitFor();
      const before = await standing(demo, id);
      const { x, y, width } = await dragBy(demo, id, part);
      assert.notEqual(await demo.byId(id).inputValue(), before.value, `${id} is dragged`);
      await demo.press(key);
      assert.deepEqual(await standing(demo, id), before, `${id} after ${key}`);
      for (const way of [1.2, 0.5, 0.9]) await demo.page.mouse.move(x + way * part * width, y);
      await demo.idle();
      assert.deepEqual(await standing(demo, id), before, `${id} when the pointer goes on`);
      await demo.page.mouse.up();
      await demo.idle();
      assert.deepEqual(await standing(demo, id), before, `${id} after the release`);
      // The next drag is like the first.
      await dragBy(demo, id, part);
      await demo.page.mouse.up();
      await demo.idle();
      assert.notDeepEqual(await standing(demo, id), before, `${id} dragged again`);
      assert.deepEqual(demo.complaints, []);
      await demo.page.close();
    }
  });
}

test("Undo during the drag of a slider takes back the drag and no step before it, and no step of another name comes after it", async (t) => {
  const demo = await open(t, "#/trace?sample=trace-star");
  await demo.byId("trace-invert").check();
  await demo.idle();
  const before = await demo.byId("btn-undo").getAttribute("title");
  const { x, y, width } = await dragBy(demo, "trace-corner", 0.2);
  await demo.press("Control+z");
  for (const way of [0.1, 0.3]) await demo.page.mouse.move(x + way * width, y);
  await demo.page.mouse.up();
  await demo.idle();
  assert.equal(await demo.byId("btn-undo").getAttribute("title"), before);
  assert.equal(await demo.byId("btn-redo").isDisabled(), true);
  const settings = async (): Promise<unknown[]> => {
    const { settings: { invert, corner } } = (await demo.state()).trace as unknown as { settings: { invert: boolean; corner: number } };
    return [invert, corner];
  };
  assert.deepEqual(await settings(), [true, 45]);
  await demo.focusStage();
  await demo.press("Control+z");
  assert.deepEqual(await settings(), [false, 45]);
});

test("Escape during the drag keeps the selection; without a drag, after keys on the slider, it ends the selection and the value stays", async (t) => {
  const demo = await open(t, "#/curve?sample=blob-16");
  const chosen = (): Promise<number> => demo.page.evaluate(() => document.querySelectorAll('[data-testid="pt-x"]:not(:disabled)').length);
  await demo.click("pt-0-3");
  const comb = demo.byId("comb-scale");
  await demo.byId("ov-comb").check();
  assert.equal(await chosen(), 1);
  await dragBy(demo, "comb-scale", 0.3);
  assert.notEqual(await comb.inputValue(), "0");
  await demo.press("Escape");
  assert.deepEqual([await comb.inputValue(), await chosen()], ["0", 1]);
  await demo.page.mouse.up();
  await demo.idle();
  assert.deepEqual([await comb.inputValue(), await chosen()], ["0", 1]);
  await comb.focus();
  await demo.press("ArrowRight", "Escape");
  assert.notEqual(await comb.inputValue(), "0");
  assert.equal(await chosen(), 0);
});

test("a slider without anything to move says what it will be once there is", async (t) => {
  const demo = await open(t, "#/curve?sample=blob-16");
  await demo.slide("level", 2);
  await demo.byId("btn-clear").click();
  await demo.idle();
  assert.deepEqual([await demo.byId("level").inputValue(), await demo.byId("level").isDisabled()], [String((await demo.state()).curve.level), true]);
  await demo.click("tab-fit");
  await demo.byId("btn-clear").click();
  await demo.idle();
  assert.deepEqual([await demo.byId("fit-smoothing").inputValue(), await demo.byId("fit-smoothing").isDisabled()], [String((await demo.state()).fit.smoothing), true]);
});
