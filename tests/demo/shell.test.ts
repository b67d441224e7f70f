import assert from "node:assert/strict";
import { test } from "node:test";
import { assertSame, useBrowser, type Demo } from "./page.ts";

const { open } = useBrowser();

const modes = ["curve", "fit", "trace", "surface"] as const;

/** Address, tab, panel and state name the same mode. */
async function assertMode(demo: Demo, mode: (typeof modes)[number]): Promise<void> {
  await demo.idle();
  const { page } = demo;
  assert.equal((await demo.state()).mode, mode);
  assert.match(new URL(page.url()).hash, new RegExp(`^#/${mode}\\b`));
  for (const other of modes) assert.equal(await demo.byId(`tab-${other}`).getAttribute("aria-selected"), String(other === mode), other);
  assert.match((await demo.byId("panel").locator("h1, h2").first().textContent()) ?? "", new RegExp(mode, "i"));
}

test("V02 tabs, history and arrow keys agree with the address, the panel and the state", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.withoutSnap();
  await demo.drag("pt-0-1", 30, 10);
  const moved = await demo.points();
  for (const mode of ["fit", "trace", "surface", "curve"] as const) {
    await demo.byId(`tab-${mode}`).click();
    await assertMode(demo, mode);
  }
  assert.deepEqual(await demo.points(), moved);
  await demo.page.goBack();
  await assertMode(demo, "surface");
  await demo.page.goBack();
  await assertMode(demo, "trace");
  await demo.page.goForward();
  await assertMode(demo, "surface");
  await demo.byId("tab-surface").focus();
  await demo.press("ArrowRight");
  await demo.press("Enter");
  await assertMode(demo, "curve");
  await demo.press("ArrowRight");
  await demo.press("Enter");
  await assertMode(demo, "fit");
  await demo.byId("tab-curve").click();
  await assertMode(demo, "curve");
  assert.deepEqual(await demo.points(), moved);
  assert.deepEqual(demo.complaints, []);
});

test("who opened samples over their work is back at it when they go back in the browser, in every mode, and can go forward again", async (t) => {
  for (const [mode, first, others] of [["curve", "circle-2", ["heart", "glyph"]], ["fit", "fit-circle", ["fit-star", "fit-sine"]]] as const) {
    const demo = await open(t, `#/${mode}?sample=${first}`);
    const drawn = async (): Promise<unknown> => {
      const state = await demo.state();
      return mode === "curve" ? state.curve.contours : state.fit.data;
    };
    const at = (hash: string): Promise<unknown> => demo.until(() => demo.page.evaluate(() => location.hash), (now) => now === hash, hash).then(() => demo.idle());
    if (mode === "curve") await demo.byId("space").selectOption({ index: 1 });
    else await demo.dragFrom(await demo.toScreen(100, 100), 60, 40);
    await at(`#/${mode}`);
    const work = await drawn();
    const samples: unknown[] = [];
    for (const sample of others) {
      await demo.page.evaluate((hash) => { location.hash = hash; }, `#/${mode}?sample=${sample}`);
      await at(`#/${mode}?sample=${sample}`);
      samples.push(await drawn());
    }
    await demo.page.goBack();
    await at(`#/${mode}?sample=${others[0]}`);
    assert.deepEqual(await drawn(), samples[0]);
    await demo.page.goBack();
    await at(`#/${mode}`);
    assert.deepEqual(await drawn(), work);
    await demo.page.goForward();
    await at(`#/${mode}?sample=${others[0]}`);
    assert.deepEqual(await drawn(), samples[0]);
    await demo.page.goBack();
    await at(`#/${mode}`);
    assert.deepEqual(await drawn(), work);
    await demo.press("Control+z");
    assert.deepEqual(await drawn(), samples[0], "one step of the history");
    assert.deepEqual(demo.complaints, []);
  }
});

test("V02 a route to a later mode's sample opens that mode with that sample", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  await assertMode(demo, "fit");
  assert.equal((await demo.state()).fit.sample, "fit-star");
  assert.match(new URL(demo.page.url()).hash, /sample=fit-star/);
});

test("V12 twelve mixed actions: undone to the first state, redone to the last, and a new one ends what could be redone", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.withoutSnap();
  const { page } = demo;
  const settle = (): Promise<void> => page.waitForTimeout(650);
  const first = (await demo.state()).curve;
  await demo.drag("pt-0-1", 20, 15);
  await demo.click("pt-0-2");
  await demo.drag("hout-0-2", 18, -9);
  await demo.focusStage();
  await demo.press("Enter");
  await demo.press("Delete");
  await settle();
  await demo.slide("level", 1);
  await settle();
  await demo.click("pt-0-4");
  await demo.byId("pt-x").fill("333.25");
  await demo.press("Enter");
  await settle();
  await demo.byId("closed").click();
  await demo.idle();
  await demo.click("pt-0-6");
  // One press: on a slow machine two of them are too far apart to be one entry.
  await demo.press("ArrowUp");
  await settle();
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill("M10 10h80v40a20 20 0 0 1-20 20z");
  await demo.byId("import-apply").click();
  await demo.idle();
  await page.keyboard.press("Escape");
  await demo.click("pt-0-3");
  await demo.press("c");
  await settle();
  await demo.byId("space").selectOption("polynomial");
  await settle();
  await demo.byId("btn-clear").click();
  await demo.idle();
  const last = (await demo.state()).curve;
  assert.equal(last.contours.length, 0);
  for (let i = 0; i < 12; i += 1) await demo.byId("btn-undo").click();
  await demo.idle();
  assertSame((await demo.state()).curve, first);
  assert.equal(await demo.byId("btn-undo").isDisabled(), true);
  for (let i = 0; i < 12; i += 1) await demo.byId("btn-redo").click();
  await demo.idle();
  assertSame((await demo.state()).curve, last);
  for (let i = 0; i < 3; i += 1) await demo.byId("btn-undo").click();
  await demo.idle();
  assert.equal(await demo.byId("btn-redo").isDisabled(), false);
  await demo.click("pt-0-0");
  await demo.press("ArrowRight");
  assert.equal(await demo.byId("btn-redo").isDisabled(), true);
  assert.deepEqual(demo.complaints, []);
});

test("V13 the view zoom at the pointer, pans with space, fits, clamps, and is no part of the history", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const { page } = demo;
  const stay = await demo.toDoc(500, 300);
  const near = async (): Promise<void> => {
    const now = await demo.toDoc(500, 300);
    const { zoom } = (await demo.state()).view;
    assert.ok(Math.hypot(now.x - stay.x, now.y - stay.y) * zoom <= 0.5);
  };
  await page.mouse.move(500, 300);
  let { zoom } = (await demo.state()).view;
  for (let i = 0; i < 3; i += 1) await page.mouse.wheel(0, -120);
  await demo.idle();
  assert.ok((await demo.state()).view.zoom > zoom * 1.3);
  await near();
  ({ zoom } = (await demo.state()).view);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -120);
  await page.keyboard.up("Control");
  await demo.idle();
  assert.ok((await demo.state()).view.zoom > zoom);
  await near();

  const from = await demo.toScreen(400, 300);
  await demo.focusStage();
  await page.keyboard.down("Space");
  await demo.dragFrom({ x: 500, y: 300 }, 100, 50);
  await page.keyboard.up("Space");
  const to = await demo.toScreen(400, 300);
  assert.ok(Math.abs(to.x - from.x - 100) <= 1 && Math.abs(to.y - from.y - 50) <= 1);

  await demo.press("0");
  assert.equal((await demo.state()).view.zoom, 1);
  await demo.press("f");
  const box = await demo.byId("stage").boundingBox();
  assert.ok(box !== null);
  for (const [x, y] of await demo.sample(200)) {
    const at = await demo.toScreen(x, y);
    assert.ok(at.x - box.x >= 16 && at.y - box.y >= 16 && box.x + box.width - at.x >= 16 && box.y + box.height - at.y >= 16);
  }
  await demo.wheel({ x: 500, y: 300 }, 100);
  assert.equal((await demo.state()).view.zoom, 64);
  await demo.wheel({ x: 500, y: 300 }, -100);
  assert.equal((await demo.state()).view.zoom, 0.05);
  assert.equal(await demo.byId("btn-undo").isDisabled(), true);
});

test("V14 touch: a finger beside a point moves it, two fingers zoom and edit nothing, a two-finger tap undoes", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const before = await demo.points();
  const at = await demo.centre("pt-0-0");
  const start = { x: at.x - 13, y: at.y + 13 };
  await demo.touch("touchStart", start);
  for (let i = 1; i <= 6; i += 1) await demo.touch("touchMove", { x: start.x - 8 * i, y: start.y - 5 * i });
  await demo.touch("touchEnd");
  await demo.idle();
  const moved = await demo.points();
  const { zoom } = (await demo.state()).view;
  // Snapping may draw the point by 6 px at most.
  assert.ok(Math.abs((moved[0]?.x ?? 0) - (before[0]?.x ?? 0) + 48 / zoom) <= 7 / zoom);
  assert.deepEqual(moved.slice(1), before.slice(1));

  const [a, b] = [{ x: 180, y: 400 }, { x: 220, y: 400 }];
  await demo.touch("touchStart", a, b);
  for (let i = 1; i <= 8; i += 1) await demo.touch("touchMove", { x: a.x - 6 * i, y: a.y }, { x: b.x + 6 * i, y: b.y });
  await demo.touch("touchEnd");
  await demo.idle();
  assert.ok((await demo.state()).view.zoom >= 1.5 * zoom);
  assert.deepEqual(await demo.points(), moved);

  await demo.tap([a, b]);
  assert.deepEqual(await demo.points(), before);
});

test("V26 keyboard only: choose, nudge, cusp, insert, delete, undo, leave; help opens, holds the focus and gives it back", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const { page } = demo;
  const inStage = (): Promise<boolean> => page.evaluate(() => document.querySelector('[data-testid="stage"]')?.contains(document.activeElement) === true);
  for (let i = 0; i < 40 && !(await inStage()); i += 1) await page.keyboard.press("Tab");
  assert.equal(await inStage(), true, "Tab reaches the stage");

  const before = await demo.points();
  const at = await demo.toScreen(before[1]?.x ?? 0, before[1]?.y ?? 0);
  const clip = { x: at.x - 14, y: at.y - 14, width: 28, height: 28 };
  const plain = await page.screenshot({ clip });
  await demo.press("]", "]");
  const ringed = await page.screenshot({ clip });
  assert.notDeepEqual(ringed, plain);
  assert.match(await demo.textOf("live"), /Point 2 of 8/);
  await demo.press("ArrowUp", "ArrowUp", "ArrowUp", "ArrowUp", "ArrowUp");
  assert.ok(Math.abs((await demo.point(1)).y - (before[1]?.y ?? 0) + 5) < 1e-9);
  await demo.press("c");
  assert.equal((await demo.point(1)).kind, "cusp");
  assert.match(await demo.textOf("live"), /cusp/);
  await demo.press("Enter");
  assert.equal((await demo.points()).length, 9);
  await demo.press("Delete");
  assert.equal((await demo.points()).length, 8);
  await demo.press("Control+z", "Control+z");
  assert.equal((await demo.points()).length, 8);
  assert.equal((await demo.point(1)).kind, "cusp");
  assert.equal(await inStage(), true);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.querySelector('[data-testid="panel"]')?.contains(document.activeElement)), true, "Tab leads to the panel");

  await page.keyboard.press("Shift+Tab");
  assert.equal(await inStage(), true);
  await page.keyboard.press("?");
  const dialog = page.locator("dialog[open]");
  await dialog.waitFor();
  for (let i = 0; i < 30; i += 1) {
    await page.keyboard.press("Tab");
    // Outside the dialog the focus may only be on nothing: the browser's own frame.
    assert.equal(await page.evaluate(() => document.activeElement === document.body || document.activeElement?.closest("dialog[open]") !== null), true);
  }
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached" }).catch(() => dialog.waitFor({ state: "hidden" }));
  assert.equal(await inStage(), true, "the focus is back");
  assert.deepEqual(demo.complaints, []);
});

test("a dialog that is closed gives the focus back, but not when it has gone elsewhere since", async (t) => {
  const demo = await open(t);
  const focused = (): Promise<string | null> => demo.page.evaluate(() => document.activeElement?.getAttribute("data-testid") ?? null);
  for (const goesOn of [false, true]) {
    await demo.byId("btn-export").click();
    await demo.byId("export-dialog").waitFor();
    await demo.page.evaluate((leave) => {
      document.querySelector("dialog")?.close();
      // In the same breath, as a quick press of a key or a program would: the event that it is closed comes after.
      if (leave) document.querySelector<HTMLElement>("[data-testid=stage]")?.focus();
    }, goesOn);
    await demo.byId("export-dialog").waitFor({ state: "detached" });
    assert.equal(await focused(), goesOn ? "stage" : "btn-export");
  }
});

test("the help lists the gestures of the mode that it is opened in, and those of all modes", async (t) => {
  for (const [hash, own, other] of [["#/curve", "Drag a handle", "draws a stroke"], ["#/fit", "draws a stroke", "Drag a handle"]] as const) {
    const demo = await open(t, hash);
    await demo.byId("btn-help").click();
    const said = await demo.textOf("help-dialog");
    assert.ok(said.includes(own) && said.includes("zoom at the pointer"), `${hash} lacks its gestures`);
    assert.ok(!said.includes(other), `${hash} has those of another mode`);
    // The stage's menu is Curve's alone.
    assert.equal(said.includes("opens a menu"), hash === "#/curve", hash);
  }
});

test("buttons look like buttons in every mode, whatever was opened before, and the rail is there where it has tools", async (t) => {
  for (const [hash, id, rail] of [["#/fit", "fit-edit", true], ["#/surface", "surf-refine", false], ["#/trace", "trace-samples", false], ["", "code-copy", true]] as const) {
    const demo = await open(t, hash);
    if (hash === "") await demo.byId("btn-code").click();
    const button = demo.byId(id);
    await button.waitFor();
    await demo.still();
    assert.equal(await button.evaluate((element) => getComputedStyle(element).borderTopWidth), "1px", id);
    assert.equal(await demo.byId("tool-hand").isVisible(), rail, hash);
  }
});

test("keys that mean nothing in a mode do nothing of the browser's on its stage, and Escape leaves it", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.focusStage();
  await demo.press("]");
  await demo.press("2");
  await demo.focusStage();
  await demo.press("]", "Control+a", "Alt+ArrowLeft");
  assert.equal(await demo.page.evaluate(() => String(document.getSelection())), "");
  assert.equal((await demo.state()).mode, "fit", "no page before this one is gone back to");
  await demo.press("Escape", "Escape");
  assert.equal(await demo.page.evaluate(() => document.activeElement === document.body), true);
  await demo.press("1");
  assert.match(await demo.textOf("panel"), /point 1 of 6/, "what is chosen in Curve stays chosen");
});

test("the help has the keys of each mode under its name, those of the open one first", async (t) => {
  const demo = await open(t, "#/trace");
  await demo.byId("btn-help").click();
  await demo.byId("help-dialog").waitFor();
  const groups = await demo.byId("help-dialog").locator(".key-group").evaluateAll((all) => all.map((each) => ({
    name: each.querySelector("h3")?.textContent ?? "", keys: [...each.querySelectorAll("dt")].map((key) => key.textContent ?? ""),
  })));
  assert.equal(groups[1]?.name, "Trace");
  for (const { name, keys } of groups.slice(1)) assert.equal(new Set(keys).size, keys.length, `${name} has each key once: ${keys.join(" ")}`);
});

test("an offer to undo goes with the next step and with the mode: it would take back something else", async (t) => {
  const demo = await open(t, "#/fit");
  await demo.dragFrom({ x: 300, y: 300 }, 300, 120, 30);
  await demo.click("tab-curve");
  const simplify = async (): Promise<void> => {
    await demo.click("tab-curve");
    await demo.byId("curve-simplify").click();
    await demo.idle();
    await demo.page.locator(".toast-action", { hasText: "Undo" }).waitFor();
  };
  await simplify();
  await demo.click("tab-curve");
  assert.equal(await demo.page.locator(".toast-action").count(), 0);
  await demo.click("tab-fit");
  await demo.dragFrom({ x: 300, y: 500 }, 200, 60, 30);
  await simplify();
  await demo.dragFrom({ x: 300, y: 500 }, 200, 60, 30);
  assert.equal(await demo.page.locator(".toast-action").count(), 0);
});

test("the last number of every mode is in sight on a tablet; where they are too many, any wheel brings it there", async (t) => {
  for (const mode of ["curve?sample=glyph", "fit", "trace", "surface"]) {
    const demo = await open(t, `#/${mode}`, { viewport: { width: 768, height: 600 } });
    const last = demo.byId("m-ms");
    const isWhole = async (): Promise<boolean> => {
      const [number, bar] = await Promise.all([last.boundingBox(), demo.page.locator(".metrics").boundingBox()]);
      return number !== null && bar !== null && number.x + number.width <= bar.x + bar.width;
    };
    await demo.until(isWhole, Boolean, `${mode}: the last number is in sight`);
    await demo.page.setViewportSize({ width: 620, height: 600 });
    await demo.idle();
    const box = await demo.page.locator(".metrics").boundingBox();
    await demo.page.mouse.move((box?.x ?? 0) + 200, (box?.y ?? 0) + 10);
    await demo.page.mouse.wheel(0, 600);
    await demo.until(isWhole, Boolean, `${mode}: the last number is scrolled to`);
    await demo.page.close();
  }
});

test("who reads the panel's labels one by one, or searches the page for one, does not push the page out of a narrow window", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8", { viewport: { width: 800, height: 500 } });
  await demo.focusStage();
  await demo.press("]");
  await demo.byId("btn-panel").click();
  await demo.still();
  const farthest = await demo.page.evaluate(() => {
    const labels = [...document.querySelectorAll("[data-testid=panel] .field-label")];
    // As screen readers and Find do; some labels are for the former alone.
    return Math.max(...labels.map((label) => {
      label.scrollIntoView({ block: "end" });
      return window.scrollY;
    }));
  });
  assert.equal(farthest, 0);
  await demo.byId("btn-panel").click();
  await demo.still();
  const aside = await demo.page.evaluate(() => {
    document.querySelector("[data-testid=panel] .field-label")?.scrollIntoView();
    return window.scrollX + (document.querySelector(".app")?.scrollLeft ?? 0);
  });
  assert.equal(aside, 0, "what is put away beside the page stays there");
});

test("the focus of what a key takes away, hides or switches off goes on beside it or to the stage, never to nowhere", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const focused = (): Promise<string> => demo.page.evaluate(() => {
    const { activeElement } = document;
    return activeElement instanceof HTMLElement && activeElement !== document.body ? activeElement.closest("[data-testid]")?.getAttribute("data-testid") ?? "?" : "nowhere";
  });
  // Another mode brings other controls and other numbers.
  for (const [id, key] of [["level", "2"], ["fit-smoothing", "1"], ["m-points", "4"]] as const) {
    await demo.byId(id).focus();
    await demo.press(key);
    assert.equal(await demo.until(focused, (now) => now !== "nowhere" && now !== id, `${key} in ${id}`), "stage");
  }
  await demo.press("1");
  await demo.click("pt-0-2");
  await demo.byId("nudge-up").focus();
  await demo.press("Enter");
  await demo.press("Escape");
  assert.equal(await demo.until(focused, (now) => now !== "nowhere" && now !== "nudge-up", "no point, no nudging"), "stage");
  await demo.byId("btn-undo").focus();
  await demo.press("Enter");
  assert.equal(await demo.byId("btn-undo").isDisabled(), true);
  assert.equal(await demo.until(focused, (now) => now !== "nowhere" && now !== "btn-undo", "nothing is left to undo"), "btn-redo");
  assert.deepEqual(demo.complaints, []);
});

test("who looks at something else while a control goes is left where they are", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.byId("level").focus();
  await demo.byId("tab-fit").click();
  await demo.idle();
  assert.equal(await demo.page.evaluate(() => document.activeElement?.getAttribute("data-testid")), "tab-fit");
});

test("a file is saved, and Export opened, out of a field, with what was typed there", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.focusStage();
  await demo.press("]");
  const field = demo.byId("pt-x");
  await field.fill("123.5");
  const [download] = await Promise.all([demo.page.waitForEvent("download"), demo.page.keyboard.press("Control+s")]);
  assert.equal(download.suggestedFilename(), "heart.json");
  assert.equal((await demo.point(0)).x, 123.5);
  // Letters and editing keys stay the field's.
  await field.fill("7");
  await demo.press("Control+a", "Control+z", "c");
  assert.equal((await demo.point(0)).x, 123.5);
  await field.fill("77");
  await demo.press("Control+e");
  await demo.byId("export-dialog").waitFor();
  assert.equal((await demo.point(0)).x, 77);
});

test("who goes back in the browser in the middle of a drag finds the drawing as it was, and no dialog of where they were", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-star");
  await demo.click("tab-curve");
  await demo.withoutSnap();
  const { curve } = await demo.state();
  const { x, y } = await demo.centre("pt-0-0");
  await demo.page.mouse.move(x, y);
  await demo.page.mouse.down();
  await demo.page.mouse.move(x + 40, y - 20, { steps: 4 });
  await demo.page.goBack();
  await demo.until(() => demo.state(), ({ mode }) => mode === "fit", "Fit is there");
  await demo.page.mouse.move(x + 80, y - 40, { steps: 4 });
  await demo.page.mouse.up();
  await demo.idle();
  assert.deepEqual((await demo.state()).curve, curve);
  await demo.page.goForward();
  await demo.until(() => demo.state(), ({ mode }) => mode === "curve", "Curve is there");
  assert.ok(await demo.byId("btn-undo").isDisabled(), "there is nothing to take back");
  await demo.byId("btn-export").click();
  await demo.byId("export-dialog").waitFor();
  await demo.page.goBack();
  await demo.byId("export-dialog").waitFor({ state: "detached" });
});

test("what was chosen in a list is taken back by Undo's keys at once, and letters still choose in it", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  const space = demo.byId("space");
  await space.focus();
  await demo.press("ArrowDown");
  await demo.until(() => demo.state(), ({ curve }) => curve.space === "hyperbolic", "another space");
  await demo.press("Control+z");
  await demo.until(() => demo.state(), ({ curve }) => curve.space === "trigonometric", "the space of before");
  assert.equal(await space.inputValue(), "trigonometric");
  await demo.press("p");
  await demo.until(() => demo.state(), ({ curve }) => curve.space === "polynomial", "the space of that letter");
  assert.equal(await demo.byId("tool-pen").getAttribute("aria-pressed"), "false");
});

test("Escape in the zoom box shows the zoom that is in force again, and so does leaving it", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const percent = demo.byId("zoom-pct");
  const shown = await percent.inputValue();
  const { view } = await demo.state();
  await percent.fill("777");
  await demo.press("Escape");
  assert.equal(await percent.inputValue(), shown);
  await demo.press("Tab");
  assert.deepEqual((await demo.state()).view, view);
  // What the wheel does meanwhile does not disturb who types.
  await percent.focus();
  await demo.wheel(await demo.centre("stage"), 3);
  assert.equal(await percent.inputValue(), shown);
  await demo.press("Tab");
  assert.equal(await percent.inputValue(), `${Math.round((await demo.state()).view.zoom * 100)} %`);
});

test("keys of who has walked past the end of a dialog do nothing to the drawing behind it", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.focusStage();
  await demo.press("]");
  const before = await demo.state();
  await demo.byId("btn-help").click();
  await demo.byId("help-dialog").waitFor();
  const isNowhere = (): Promise<boolean> => demo.page.evaluate(() => document.activeElement === document.body);
  for (let i = 0; i < 20 && !(await isNowhere()); i += 1) await demo.press("Tab");
  assert.ok(await isNowhere(), "the browser goes on to its own bar after the last control");
  await demo.press("Delete", "ArrowRight", "2");
  assert.deepEqual(await demo.state(), before);
  await demo.press("Tab");
  assert.ok(await demo.page.evaluate(() => document.activeElement?.closest("dialog") !== null), "and comes back into the dialog");
  await demo.press("Escape");
  await demo.byId("help-dialog").waitFor({ state: "detached" });
});

test("the number that was refused is not said of another point, nor once a good one is typed", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  await demo.focusStage();
  await demo.press("]");
  await demo.byId("pt-x").fill("far");
  await demo.press("Enter");
  assert.match(await demo.textOf("error"), /Enter a number/);
  await demo.focusStage();
  await demo.press("]");
  await demo.still();
  assert.equal(await demo.byId("error").count(), 0);
  assert.equal(await demo.byId("pt-x").getAttribute("aria-invalid"), null);
  // Nor when the old number is typed in its place.
  const kept = await demo.byId("points").inputValue();
  for (const typed of ["none", kept]) {
    await demo.byId("points").fill(typed);
    await demo.press("Enter");
    assert.equal(await demo.byId("error").count(), typed === kept ? 0 : 1);
  }
});
