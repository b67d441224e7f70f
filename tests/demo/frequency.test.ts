import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser } from "./page.ts";

/** The field for the frequency of what is selected. */

const { open } = useBrowser();

test("segments of several frequencies are shown as Mixed, which changes nothing, and a number changes the selected ones", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const own = [0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2];
  await demo.page.evaluate(async (omega) => {
    const state = window.explineDemo.getState();
    const contours = state.curve.contours.map((contour) => ({ ...contour, omega }));
    await window.explineDemo.setState({ ...state, curve: { ...state.curve, contours } });
  }, own);
  const omega = demo.byId("omega");
  const frequencies = async (): Promise<readonly number[] | undefined> => (await demo.state()).curve.contours[0]?.omega;
  assert.equal(await omega.inputValue(), "Mixed", "of the whole drawing");
  assert.equal(await demo.byId("omega-auto").getAttribute("aria-pressed"), "false");

  await demo.click("pt-0-2");
  await demo.page.keyboard.down("Shift");
  await demo.click("pt-0-3");
  await demo.page.keyboard.up("Shift");
  assert.equal(await omega.inputValue(), "0.7", "of the one segment between");
  await demo.page.keyboard.down("Shift");
  await demo.click("pt-0-4");
  await demo.page.keyboard.up("Shift");
  assert.equal(await omega.inputValue(), "Mixed");
  await omega.focus();
  await demo.press("ArrowUp", "Enter");
  await demo.idle();
  assert.deepEqual(await frequencies(), own);

  await omega.fill("1.5");
  await omega.press("Enter");
  await demo.idle();
  assert.deepEqual(await frequencies(), [0.5, 0.6, 1.5, 1.5, 0.9, 1, 1.1, 1.2]);
  assert.equal(await omega.inputValue(), "1.5");
  await demo.focusStage();
  await demo.press("Control+z");
  assert.deepEqual(await frequencies(), own);
  assert.equal(await omega.inputValue(), "Mixed");
});

test("a number that is taken by a press elsewhere is for what was selected when it was typed", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const { omega: before } = (await demo.state()).curve;
  await demo.click("pt-0-2");
  await demo.page.keyboard.down("Shift");
  await demo.click("pt-0-3");
  await demo.page.keyboard.up("Shift");
  await demo.byId("omega").fill("1.5");
  const stage = await demo.byId("stage").boundingBox();
  assert.ok(stage !== null);
  await demo.page.mouse.click(stage.x + stage.width - 40, stage.y + 40);
  await demo.idle();
  const { curve } = await demo.state();
  assert.equal(curve.omega, before, "that of the drawing");
  assert.deepEqual(curve.contours[0]?.omega?.map((own) => own === 1.5), [false, false, true, false, false, false, false, false]);
});
