import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo, type Place } from "./page.ts";

const { open } = useBrowser();

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } as const;
const smallest = { ...phone, viewport: { width: 320, height: 568 } } as const;

/** Whether a finger there would touch the stage, and nothing that lies over it. */
function isOnStage(demo: Demo, { x, y }: Place): Promise<boolean> {
  return demo.page.evaluate(([left, top]) => document.elementFromPoint(left, top)?.closest("[data-part=surface]") != null, [x, y] as const);
}

test("on every phone both ends of every handle of the first circle can be touched, with the sheet down and half up", async (t) => {
  for (const options of [phone, smallest]) {
    const demo = await open(t, "", options);
    for (const raised of [false, true]) {
      if (raised) await demo.byId("sheet-up").click();
      await demo.still();
      const { width, height } = options.viewport;
      for (const id of ["pt-0-0", "pt-0-1", "hin-0-0", "hout-0-0", "hin-0-1", "hout-0-1"]) {
        assert.ok(await isOnStage(demo, await demo.centre(id)), `${id} on ${width} × ${height}, ${raised ? "half up" : "down"}`);
      }
    }
  }
});

test("a sheet that goes up and down again leaves the view as it was; a view that was moved stays", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", phone);
  const before = (await demo.state()).view;
  await demo.byId("sheet-up").click();
  await demo.still();
  assert.ok((await demo.state()).view.zoom < before.zoom);
  await demo.byId("sheet-down").click();
  await demo.still();
  assert.deepEqual((await demo.state()).view, before);
  await demo.byId("zoom-in").click();
  await demo.idle();
  const moved = (await demo.state()).view;
  await demo.byId("sheet-up").click();
  await demo.still();
  assert.deepEqual((await demo.state()).view, moved);
});

test("a dialog opened from the phone's menu gives the focus back to the menu's button", async (t) => {
  const demo = await open(t, "", phone);
  for (const [id, dialog] of [["btn-samples", "samples-dialog"], ["btn-import", "import-dialog"], ["btn-export", "export-dialog"], ["btn-help", "help-dialog"]] as const) {
    await demo.byId("btn-menu").click();
    await demo.byId(id).click();
    await demo.byId(dialog).waitFor();
    await demo.page.keyboard.press("Escape");
    await demo.byId(dialog).waitFor({ state: "detached" });
    assert.equal(await demo.page.evaluate(() => (document.activeElement as HTMLElement).dataset["testid"]), "btn-menu", id);
  }
});

test("where the header has no room for all it has, it stays one row, and its menu has the file actions", async (t) => {
  for (const viewport of [{ width: 667, height: 375 }, { width: 740, height: 360 }, { width: 640, height: 400 }]) {
    const demo = await open(t, "", { ...phone, viewport, ...(viewport.width === 640 ? { hasTouch: false, isMobile: false } : {}) });
    const where = `${viewport.width} × ${viewport.height}`;
    const rows = await demo.page.locator("header button:visible, header a:visible").evaluateAll((all) => all.map((each) => each.getBoundingClientRect()).map(({ top, bottom }) => (top + bottom) / 2));
    // Of one row the middles are at one height, give or take the tabs' rule.
    assert.ok(Math.max(...rows) - Math.min(...rows) <= 4, `${where}: ${rows.join(", ")}`);
    await demo.byId("btn-menu").click();
    const covered = await demo.page.locator(".header-menu > *").evaluateAll((all) => all.filter((entry) => {
      const { x, y, width, height } = entry.getBoundingClientRect();
      return !entry.contains(document.elementFromPoint(x + width / 2, y + height / 2));
    }).map((entry) => entry.textContent));
    assert.deepEqual([covered, await demo.page.locator(".header-menu > *").count()], [[], 6], where);
    await demo.byId("btn-samples").click();
    await demo.byId("samples-dialog").waitFor();
  }
});

/** What lies over the stage: its boxes by name. */
async function partsOver(demo: Demo): Promise<{ part: string; box: { x: number; y: number; width: number; height: number } }[]> {
  const boxes = await Promise.all([".stage-hint", ".stage-zoom", ".tools"].map(async (part) => ({ part, box: await demo.page.locator(part).boundingBox() })));
  return boxes.flatMap(({ part, box }) => (box === null || box.height === 0 ? [] : [{ part, box }]));
}

/** Nothing that lies over the stage lies over the curve, or over anything else there. */
async function assertNothingCovers(demo: Demo, where: string): Promise<void> {
  const parts = await partsOver(demo);
  for (const { part, box } of parts) {
    for (const [x, y] of await demo.sample(300)) {
      const at = await demo.toScreen(x, y);
      assert.ok(at.x < box.x || at.x > box.x + box.width || at.y < box.y || at.y > box.y + box.height, `${where}: ${part} lies over ${JSON.stringify(at)}`);
    }
    for (const other of parts) assert.ok(other.part === part || other.box.x >= box.x + box.width || other.box.x + other.box.width <= box.x || other.box.y >= box.y + box.height || other.box.y + other.box.height <= box.y, `${where}: ${part} over ${other.part}`);
  }
}

test("in a page that is zoomed to 400 % nothing lies over a drawing that was fitted, nothing over anything else, and all is on the stage", async (t) => {
  // Windows of 1280 × 1024 and 1280 × 1144, and one that is as wide as phones are.
  for (const viewport of [{ width: 320, height: 256 }, { width: 320, height: 286 }, { width: 390, height: 270 }]) {
    for (const options of [{ viewport }, { viewport, hasTouch: true, isMobile: true }]) {
      const demo = await open(t, "#/curve?sample=heart", options);
      await demo.still();
      const where = `${viewport.width} × ${viewport.height}`;
      await assertNothingCovers(demo, where);
      const stage = await demo.page.locator(".stage").boundingBox();
      const parts = await partsOver(demo);
      assert.ok(stage !== null && parts.length === 2, where);
      for (const { part, box } of parts) assert.ok(box.x >= 0 && box.y >= stage.y && box.x + box.width <= viewport.width && box.y + box.height <= stage.y + stage.height, `${where}: ${part} ${JSON.stringify(box)}`);
    }
  }
});

test("the arrows of the sheet are as large as a finger's buttons, and lie on none of its numbers", async (t) => {
  for (const options of [phone, smallest]) {
    const demo = await open(t, "", options);
    await demo.still();
    for (const id of ["sheet-up", "sheet-down"]) {
      const box = await demo.byId(id).boundingBox();
      assert.ok(box !== null && box.width >= 44 && box.height >= 44, `${id}: ${JSON.stringify(box)}`);
      // What a finger finds on them, near their corners, is the button.
      const found = await demo.byId(id).evaluate((button) => {
        const { left, top, right, bottom } = button.getBoundingClientRect();
        return [left + 2, right - 2].flatMap((x) => [top + 2, bottom - 2].map((y) => button.contains(document.elementFromPoint(x, y))));
      });
      assert.deepEqual(found, [true, true, true, true], id);
    }
  }
});

test("the number that the page opens with, and the Bézier's beside it, are in sight without scrolling", async (t) => {
  const demo = await open(t, "", phone);
  await demo.still();
  for (const id of ["m-points", "m-error", "m-bezier"]) {
    const box = await demo.byId(id).boundingBox();
    assert.ok(box !== null && box.x >= 0 && box.x + box.width <= phone.viewport.width, `${id}: ${JSON.stringify(box)}`);
  }
});

test("the hint is there to its last word, at any size of text", async (t) => {
  for (const [viewport, size] of [[{ width: 1280, height: 800 }, "200%"], [{ width: 720, height: 450 }, "100%"], [{ width: 320, height: 568 }, "100%"], [{ width: 320, height: 568 }, "200%"]] as const) {
    const demo = await open(t, "", { viewport });
    await demo.page.evaluate((text) => { document.documentElement.style.fontSize = text; }, size);
    await demo.still();
    const cut = await demo.byId("hint").evaluate((hint) => ({ across: hint.scrollWidth - hint.clientWidth, down: hint.scrollHeight - hint.clientHeight, top: hint.getBoundingClientRect().top }));
    assert.ok(cut.across <= 0 && cut.down <= 1 && cut.top > 48, `${viewport.width} px, ${size}: ${JSON.stringify(cut)}`);
  }
});

test("the hint ends before the zoom box, with a finger's buttons, too", async (t) => {
  for (const options of [{ ...phone, viewport: { width: 740, height: 360 } }, { viewport: { width: 640, height: 480 } }]) {
    const demo = await open(t, "", options);
    await demo.still();
    const [hint, zoom] = await Promise.all([demo.byId("hint").boundingBox(), demo.page.locator(".stage-zoom").boundingBox()]);
    assert.ok(hint !== null && zoom !== null && hint.x + hint.width <= zoom.x, JSON.stringify({ hint, zoom }));
  }
});

test("on a phone that lies on its side the hint is below the lowest point, in two lines, too", async (t) => {
  for (const viewport of [{ width: 667, height: 375 }, { width: 740, height: 360 }]) {
    for (const sample of ["heart", "blob-16", "circle-8"]) {
      const demo = await open(t, `#/curve?sample=${sample}`, { viewport, hasTouch: true, isMobile: true });
      const { y: top } = await demo.byId("hint").boundingBox() ?? { y: 0 };
      const points = await demo.points();
      const lowest = Math.max(...await Promise.all(points.map(async ({ x, y }) => (await demo.toScreen(x, y)).y)));
      // A marker reaches seven pixels down from its point.
      assert.ok(lowest + 7 <= top, `${sample}: the lowest point is at ${lowest}, the hint begins at ${top}`);
    }
  }
});

test("on the smallest phone that lies on its side nothing lies over a drawing that was fitted, and nothing over anything else", async (t) => {
  for (const sample of ["circle-2", "heart", "blob-16"]) {
    const demo = await open(t, `#/curve?sample=${sample}`, { viewport: { width: 568, height: 320 }, hasTouch: true, isMobile: true });
    await assertNothingCovers(demo, sample);
    assert.equal((await partsOver(demo)).length, 3, "all of them are there");
  }
});

test("what the page says lies above the zoom box, with a finger's buttons, too", async (t) => {
  const demo = await open(t, "", { viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true });
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill("M0 0L100 100");
  await demo.byId("import-apply").click();
  await demo.byId("toast").waitFor();
  await demo.still();
  const [toast, zoom] = [await demo.byId("toast").boundingBox(), await demo.page.locator(".stage-zoom").boundingBox()];
  assert.ok(toast !== null && zoom !== null && toast.y + toast.height <= zoom.y, `${JSON.stringify(toast)} over ${JSON.stringify(zoom)}`);
});

test("what the waves around the first circle are can be read on every phone", async (t) => {
  for (const size of [phone, smallest]) {
    const demo = await open(t, "", size);
    // The label is all that is drawn in its colour in the middle of the circle.
    const { x, y } = await demo.toScreen(400, 300);
    const covered = await demo.page.evaluate(([left, top]) => [-60, 0, 60].filter((dx) => document.elementFromPoint(left + dx, top)?.closest("[data-part=surface]") == null), [x, y] as const);
    assert.deepEqual(covered, []);
    const ink = await demo.page.evaluate(([left, top]) => {
      const canvas = document.querySelector<HTMLCanvasElement>("canvas.stage-canvas");
      const box = canvas?.getBoundingClientRect();
      const { data } = canvas?.getContext("2d")?.getImageData(left - (box?.left ?? 0) - 60, top - (box?.top ?? 0) - 10, 120, 20) ?? { data: [] };
      return Array.from(data).filter((value, i) => i % 4 === 0 && value > 100 && value < 180).length;
    }, [x, y] as const);
    assert.ok(ink > 100, `${ink} pixels of letters`);
  }
});

test("what is handed over to another mode with the sheet all the way up is in sight there", async (t) => {
  for (const options of [phone, smallest]) {
    const demo = await open(t, "#/fit?sample=fit-circle", options);
    for (let i = 0; i < 2; i += 1) await demo.byId("sheet-up").click();
    await demo.still();
    await demo.byId("fit-edit").click();
    await demo.still();
    const { mode, curve } = await demo.state();
    assert.equal(mode, "curve");
    for (const i of curve.contours[0]?.points.keys() ?? []) assert.ok(await isOnStage(demo, await demo.centre(`pt-0-${i}`)), `point ${i} of the fit`);
  }
});

test("the code's tabs and buttons are in one row on a phone, and all within it", async (t) => {
  const demo = await open(t, "", { ...phone, viewport: { width: 360, height: 740 } });
  await demo.byId("sheet-up").click();
  await demo.byId("btn-code").click();
  await demo.byId("code-drawer").waitFor();
  await demo.still();
  const boxes = await demo.page.locator(".drawer-head button").evaluateAll((buttons) => buttons.map((button) => button.getBoundingClientRect().toJSON() as DOMRect));
  assert.equal(boxes.length, 7);
  const middles = boxes.map(({ top, height }) => top + height / 2);
  assert.ok(Math.max(...middles) - Math.min(...middles) < 8, middles.join(" "));
  for (const { left, right, height } of boxes) assert.ok(left >= 0 && right <= 360 && height >= 44, `${left} to ${right}, ${height} high`);
});

test("with the sheet all the way up, the program and what the page says are in sight", async (t) => {
  for (const options of [phone, smallest]) {
    const demo = await open(t, "#/curve?sample=blob-16", options);
    const isSeen = (selector: string): Promise<boolean> => demo.page.locator(selector).evaluate((element) => {
      const { left, top, width, height } = element.getBoundingClientRect();
      return element.contains(document.elementFromPoint(left + width / 2, top + height / 2));
    });
    for (let i = 0; i < 2; i += 1) await demo.byId("sheet-up").click();
    await demo.byId("btn-code").click();
    await demo.byId("code-drawer").waitFor();
    await demo.still();
    assert.ok(await isSeen("[data-testid=code-listing]"), "the program");
    await demo.byId("btn-code").click();
    await demo.still();
    await demo.byId("curve-simplify").click();
    // Words of a message let fingers through, and go after a while.
    const toast = demo.byId("toast");
    const isInSight = await toast.evaluate((message) => {
      message.style.setProperty("pointer-events", "auto");
      const { left, top, width, height } = message.getBoundingClientRect();
      return message.contains(document.elementFromPoint(left + width / 2, top + height / 2));
    });
    assert.ok(isInSight, "the message");
  }
});

test("who has fingers is not told of keys", async (t) => {
  const demo = await open(t, "", phone);
  await demo.byId("sheet-up").click();
  for (const mode of ["curve", "surface"] as const) {
    await demo.byId(`tab-${mode}`).click();
    await demo.still();
    assert.match(await demo.byId("panel").getByText("Nothing selected.").innerText(), /^Nothing selected\. Tap a (?:control )?point\.$/u);
  }
});

test("the phone's menu closes when the focus goes on past it, and on Escape from its button", async (t) => {
  const demo = await open(t, "", smallest);
  const { page } = demo;
  const isOpen = async (): Promise<boolean> => demo.byId("btn-samples").isVisible();
  await demo.byId("btn-menu").click();
  assert.ok(await isOpen());
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => (document.activeElement as HTMLElement).dataset["testid"]), "btn-menu");
  assert.ok(await isOpen(), "its button is a part of it");
  await page.keyboard.press("Escape");
  assert.equal(await isOpen(), false);
  await page.keyboard.press("Enter");
  assert.ok(await isOpen());
  for (let i = 0; i < 7; i += 1) await page.keyboard.press("Tab");
  assert.equal(await isOpen(), false);
});

test("on a phone that lies on its side an empty stage shows all that it offers", async (t) => {
  for (const viewport of [{ width: 740, height: 360 }, { width: 667, height: 375 }]) {
    const demo = await open(t, "#/trace", { ...phone, viewport });
    for (const mode of ["trace", "fit", "curve"] as const) {
      await demo.byId(`tab-${mode}`).click();
      await demo.idle();
      // What is cleared is in the drawer.
      if (mode !== "trace") await demo.byId("btn-clear").evaluate((button: HTMLButtonElement) => button.click());
      await demo.byId(`empty-${mode}`).waitFor();
      await demo.still();
      const zoom = await demo.page.locator(".stage-zoom").boundingBox();
      const header = await demo.page.locator(".header").boundingBox();
      assert.ok(zoom !== null && header !== null);
      for (const each of await demo.byId(`empty-${mode}`).locator("h2, .button, .trace-drop, .sample, p").all()) {
        const box = await each.boundingBox();
        assert.ok(box === null || (box.y >= header.y + header.height && box.y + box.height <= zoom.y), `${mode}: ${JSON.stringify({ box, zoom })}`);
      }
      const hidden = await demo.byId(`empty-${mode}`).evaluate(({ scrollHeight, clientHeight }) => scrollHeight - clientHeight);
      assert.ok(hidden <= 0, `${mode}: ${hidden} px are out of sight`);
    }
  }
});

test("with text twice as large on the smallest phone the stage keeps half of the screen, and an empty Trace says what it is", async (t) => {
  const demo = await open(t, "#/trace", smallest);
  await demo.page.evaluate(() => { document.documentElement.style.fontSize = "200%"; });
  await demo.still();
  const stage = await demo.byId("stage").boundingBox();
  assert.ok(stage !== null && stage.height >= 284, JSON.stringify(stage));
  const title = await demo.page.locator(".empty-trace > h2").boundingBox();
  const card = await demo.byId("empty-trace").boundingBox();
  assert.ok(title !== null && card !== null && title.y >= card.y && title.y + title.height <= card.y + card.height, JSON.stringify({ title, card }));
});

test("the longest shape of Surface is read to its last letter, on a desktop and with text twice as large on phones", async (t) => {
  for (const options of [{}, smallest, { ...phone, viewport: { width: 360, height: 740 } }]) {
    const demo = await open(t, "#/surface?sample=surf-paraboloid", options);
    if ("viewport" in options) {
      await demo.page.evaluate(() => { document.documentElement.style.fontSize = "200%"; });
      await demo.byId("sheet-up").click();
      await demo.byId("sheet-up").click();
    }
    await demo.still();
    const { letters, room } = await demo.byId("surf-sample").evaluate((select: HTMLSelectElement) => {
      const { font, fontSize } = getComputedStyle(select);
      const context = document.createElement("canvas").getContext("2d");
      if (context !== null) context.font = font;
      // The arrow is as wide as the letters are high.
      return { letters: context?.measureText(select.selectedOptions[0]?.text ?? "").width ?? Infinity, room: select.clientWidth - 2 * parseFloat(getComputedStyle(select).paddingInlineStart) - parseFloat(fontSize) };
    });
    assert.ok(letters > 0 && letters <= room, `${letters} px in ${room}`);
  }
});

test("on a tablet Escape puts the panel away again, from its button and from within, and a typed number first", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", { viewport: { width: 768, height: 1024 }, hasTouch: true, isMobile: true });
  const isOpen = async (): Promise<boolean> => (await demo.byId("btn-panel").getAttribute("aria-expanded")) === "true";
  await demo.byId("btn-panel").click();
  await demo.press("Escape");
  assert.equal(await isOpen(), false);
  await demo.byId("btn-panel").click();
  await demo.still();
  await demo.byId("omega").fill("2");
  await demo.press("Escape");
  assert.equal(await isOpen(), true, "what was typed is taken back");
  await demo.press("Escape");
  assert.equal(await isOpen(), false);
  assert.equal(await demo.page.evaluate(() => document.activeElement?.getAttribute("data-testid")), "btn-panel");
});

test("beside the stage the panel stays where it is when Escape is pressed in it", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.byId("omega").focus();
  await demo.press("Escape");
  assert.ok(await demo.byId("omega").isVisible());
});

test("fingers, which can drop and paste nothing, are asked to choose a picture", async (t) => {
  const demo = await open(t, "#/trace", phone);
  await demo.byId("empty-trace").waitFor();
  assert.doesNotMatch(await demo.textOf("empty-trace"), /drop|paste/iu);
  const beside = await open(t, "#/trace");
  await beside.byId("empty-trace").waitFor();
  assert.match(await beside.textOf("empty-trace"), /Drop a picture, paste one.*Drop, paste or choose/su);
});

test("on a phone all that Export can save is in sight at once", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", phone);
  await demo.byId("btn-menu").click();
  await demo.byId("btn-export").click();
  await demo.byId("export-dialog").waitFor();
  await demo.still();
  const hidden = await demo.page.locator(".dialog-foot").evaluate((foot) => {
    const { top, bottom } = foot.getBoundingClientRect();
    return [...foot.querySelectorAll("button, select")].filter((each) => {
      const box = each.getBoundingClientRect();
      return box.top < top || box.bottom > bottom;
    }).map((each) => each.textContent);
  });
  assert.deepEqual(hidden, []);
});

test("in Export the longest choice of every list is there to its last letter, beside a mouse, too", async (t) => {
  for (const options of [{}, phone, { ...phone, viewport: { width: 360, height: 740 } }, { ...phone, viewport: { width: 430, height: 932 } }, smallest]) {
    const demo = await open(t, "", options);
    if (await demo.byId("btn-menu").isVisible()) await demo.byId("btn-menu").click();
    await demo.byId("btn-export").click();
    await demo.byId("export-dialog").waitFor();
    await demo.still();
    const cut = await demo.page.locator("[data-testid=export-dialog] .export-options select").evaluateAll((all) => all.flatMap((list) => {
      // A list is by itself as wide as its longest choice and its arrow need.
      const free = list.cloneNode(true) as HTMLElement;
      free.style.cssText = "position: fixed; width: max-content; min-width: 0";
      list.after(free);
      const [has, needs] = [list, free].map((each) => each.getBoundingClientRect().width);
      free.remove();
      return (has ?? 0) >= (needs ?? 0) ? [] : [`${list.getAttribute("data-testid")}: ${has} of ${needs}`];
    }));
    assert.deepEqual(cut, [], JSON.stringify(options));
  }
});

test("in Help what keys do begins in one line below the other, however long the keys are", async (t) => {
  for (const options of [{}, { viewport: { width: 700, height: 800 } }, phone, smallest]) {
    const demo = await open(t, "", options);
    await demo.focusStage();
    await demo.press("?");
    await demo.byId("help-dialog").waitFor();
    await demo.still();
    const groups = await demo.page.locator(".key-group").evaluateAll((all) => all.map((group) => {
      const begin = group.getBoundingClientRect().left;
      const rows = [...group.querySelectorAll(".key-row")];
      const isClear = rows.every((row) => {
        const words = row.querySelector("dd")?.getBoundingClientRect().left ?? 0;
        return [...row.querySelectorAll("kbd")].every((key) => key.getBoundingClientRect().right <= words);
      });
      return { begins: [...new Set(rows.map((row) => Math.round((row.querySelector("dd")?.getBoundingClientRect().left ?? 0) - begin)))], isClear };
    }));
    assert.ok(groups.length > 4);
    for (const { begins, isClear } of groups) assert.ok(begins.length <= 1 && isClear, `${JSON.stringify(options)}: ${begins.join(", ")}`);
  }
});

test("boxes to tick begin where words do, on a phone as beside a mouse", async (t) => {
  for (const options of [{}, phone]) {
    const demo = await open(t, "#/curve?sample=heart", options);
    if (options === phone) await demo.byId("sheet-up").click();
    await demo.still();
    const [box, words] = await Promise.all([demo.byId("closed").boundingBox(), demo.page.locator("label", { hasText: "Space" }).boundingBox()]);
    assert.ok(box !== null && words !== null);
    // The box is 16 px wide, in the middle of its target.
    const from = box.x + box.width / 2 - 8;
    assert.ok(Math.abs(from - words.x) <= 0.5, `${from} beside ${words.x}`);
  }
});

test("a finger that draws with the pen is told how to go on, how to close and how to finish, and no longer once it has", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", phone);
  await demo.byId("tool-pen").tap();
  const first = /^Tap to place the first point/;
  assert.match(await demo.textOf("hint"), first);
  const places = [{ x: 60, y: 160 }, { x: 120, y: 130 }, { x: 150, y: 190 }];
  for (const place of places) {
    await demo.tap([place]);
    await demo.page.waitForTimeout(450);
    assert.match(await demo.textOf("hint"), /corner.*smooth.*closes.*finishes/);
  }
  const takeBack = (): Promise<void> => demo.byId("btn-undo").tap().then(() => demo.idle());
  for (let i = 0; i < places.length; i += 1) await takeBack();
  assert.match(await demo.textOf("hint"), first, "all of it was taken back");
  await demo.byId("btn-redo").tap();
  await demo.idle();
  assert.match(await demo.textOf("hint"), /corner.*finishes/, "it goes on after all");
  await demo.tap([{ x: 120, y: 130 }]);
  await demo.page.waitForTimeout(450);
  await demo.tap([{ x: 150, y: 190 }], 2);
  assert.match(await demo.textOf("hint"), first, "it is finished");
});
