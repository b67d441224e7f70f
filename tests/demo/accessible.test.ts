import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { assertNone, lowContrast, namesAndTargets, overflow } from "./looked-at.ts";
import { useBrowser, type Demo } from "./page.ts";

const { open } = useBrowser();

const sizes = [
  { name: "desktop", viewport: { width: 1280, height: 800 } },
  { name: "320 × 568", viewport: { width: 320, height: 568 } },
] as const;

/** Everything that the panel can show at once. */
async function unfold(demo: Demo): Promise<void> {
  const up = demo.byId("sheet-up");
  if (await up.isVisible()) for (let i = 0; i < 2; i += 1) if (await up.isEnabled()) await up.click();
  await demo.page.evaluate(() => document.querySelectorAll("details").forEach((each) => { each.open = true; }));
  await demo.still();
}

for (const { name, viewport } of sizes) {
  for (const colorScheme of ["light", "dark"] as const) {
    test(`V27 ${name}, ${colorScheme}: names, targets, contrast and no sideways scrolling`, async (t) => {
      const demo = await open(t, "#/curve?sample=heart", { viewport, colorScheme });
      await demo.page.evaluate(() => { document.querySelector<HTMLElement>('[data-testid="stage"]')?.focus(); });
      await demo.press("]");
      // What takes time to measure is printed after all else.
      await demo.page.waitForFunction(() => document.querySelector('[data-testid="m-length"]')?.textContent !== "");
      assertNone(await namesAndTargets(demo.page));
      assertNone(await lowContrast(demo.page));
      assert.ok((await overflow(demo.page)) <= 0);
      await unfold(demo);
      assertNone(await namesAndTargets(demo.page));
      assertNone(await lowContrast(demo.page));
      assert.ok((await overflow(demo.page)) <= 0);
    });

    test(`V27 ${name}, ${colorScheme}: the dialogs, the drawer and the other modes too`, async (t) => {
      const demo = await open(t, "#/curve?sample=heart", { viewport, colorScheme });
      const { page } = demo;
      for (const [id, dialog] of [["btn-samples", "samples-dialog"], ["btn-import", "import-dialog"], ["btn-export", "export-dialog"], ["btn-help", "help-dialog"]] as const) {
        if (!(await demo.byId(id).isVisible())) await demo.byId("btn-menu").click();
        await demo.byId(id).click();
        await demo.byId(dialog).waitFor();
        await demo.still();
        assertNone(await namesAndTargets(page), dialog);
        assertNone(await lowContrast(page), dialog);
        assert.ok((await overflow(page)) <= 0, dialog);
        assert.equal(await page.evaluate(() => document.activeElement?.closest("dialog") !== null), true, `${dialog} has the focus`);
        await page.keyboard.press("Escape");
        await demo.byId(dialog).waitFor({ state: "detached" });
      }
      for (const mode of ["fit", "trace", "surface"]) {
        await demo.byId(`tab-${mode}`).click();
        await demo.idle();
        if (mode === "trace") {
          await demo.byId("empty-trace").waitFor();
          assertNone(await namesAndTargets(page), "trace, empty");
          // On a phone the raised sheet is before it; the keyboard gets there all the same.
          await demo.byId("sample-trace-star").press("Enter");
          await demo.idle();
        }
        await unfold(demo);
        assertNone(await namesAndTargets(page), mode);
        assertNone(await lowContrast(page), mode);
        assert.ok((await overflow(page)) <= 0, mode);
      }
    });
  }
}

for (const viewport of [{ width: 1280, height: 800 }, { width: 320, height: 568 }]) {
  test(`V27 text at 200 % at ${viewport.width} px scrolls nothing sideways and loses no control`, async (t) => {
    const demo = await open(t, "", { viewport });
    await demo.page.evaluate(() => { document.documentElement.style.fontSize = "200%"; });
    await demo.still();
    assert.ok((await overflow(demo.page)) <= 0, `${await overflow(demo.page)} px too wide`);
    const outside = await demo.page.evaluate(() =>
      [...document.querySelectorAll("header button, [role=tab], nav button")]
        .filter((element) => element.checkVisibility({ visibilityProperty: true }))
        .map((element) => ({ id: element.getAttribute("data-testid"), box: element.getBoundingClientRect() }))
        .filter(({ box }) => box.left < -1 || box.right > window.innerWidth + 1 || box.top < -1 || box.bottom > window.innerHeight + 1)
        .map(({ id }) => id));
    assert.deepEqual(outside, []);
  });
}

test("V27 at 320 px every control can be reached by scrolling the sheet", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", { viewport: { width: 320, height: 568 } });
  await unfold(demo);
  await demo.page.evaluate(() => { document.querySelector<HTMLElement>('[data-testid="stage"]')?.focus(); });
  await demo.press("]");
  const ids = ["family", "space", "omega", "points", "level", "closed", "pt-x", "pt-y", "pt-kind", "in-len", "in-ang", "out-len", "out-ang", "nudge-left", "nudge-up", "nudge-down", "nudge-right",
    "ov-handles", "ov-polygon", "ov-knots", "ov-comb", "ov-subdiv", "ov-fill", "ov-bezier", "ov-grid", "snap", "subdiv", "legend-point", "legend-cusp", "points-table", "btn-code", "btn-clear"];
  for (const id of ids) {
    const reached = await demo.page.evaluate((testid) => {
      const element = document.querySelector(`[data-testid="${testid}"]`);
      element?.scrollIntoView({ block: "center" });
      const box = element?.getBoundingClientRect();
      if (element == null || box === undefined) return "missing";
      const at = document.elementFromPoint(box.left + Math.min(box.width / 2, 20), box.top + Math.min(box.height / 2, 20));
      return at !== null && (element.contains(at) || at.contains(element) || at.closest(".panel") !== null) ? "" : `covered by ${at?.className ?? "nothing"}`;
    }, id);
    assert.equal(reached, "", id);
  }
});

test("forced colours and reduced motion: the page is drawn in the system's colours and nothing moves", async (t) => {
  const demo = await open(t, "", { forcedColors: "active", reducedMotion: "reduce" });
  const colours = await demo.page.evaluate(() => {
    const style = getComputedStyle(document.documentElement);
    const probe = document.createElement("span");
    probe.style.color = "CanvasText";
    document.body.append(probe);
    return { curve: style.getPropertyValue("--curve"), text: getComputedStyle(probe).color };
  });
  assert.equal(colours.curve.trim(), colours.text);
  const longest = await demo.page.evaluate(() => Math.max(0, ...[...document.querySelectorAll("*")].flatMap((element) => getComputedStyle(element).transitionDuration.split(",").map(parseFloat))));
  assert.equal(longest, 0);
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`in forced colours, ${colorScheme}, all text can be read: dialogs, panels, and the button that is meant first`, async (t) => {
    const demo = await open(t, "#/curve?sample=heart", { forcedColors: "active", colorScheme });
    for (const [id, dialog] of [["btn-import", "import-dialog"], ["btn-export", "export-dialog"], ["btn-help", "help-dialog"]] as const) {
      await demo.byId(id).click();
      await demo.byId(dialog).waitFor();
      await demo.still();
      assertNone(await lowContrast(demo.page), dialog);
      await demo.page.keyboard.press("Escape");
      await demo.byId(dialog).waitFor({ state: "detached" });
    }
    for (const hash of ["#/fit?sample=fit-star", "#/trace?sample=trace-disc", "#/surface"]) {
      await demo.page.evaluate((to) => (location.hash = to), hash);
      await demo.idle();
      assertNone(await lowContrast(demo.page), hash);
    }
    // What says how far long work has come is a colour alone.
    const fill = await demo.page.locator(".busy-fill").first().evaluate((bar) => [getComputedStyle(bar).backgroundColor, getComputedStyle(document.body).backgroundColor]);
    assert.notEqual(fill[0], fill[1]);
  });
}

test("what is chosen of a few stays within the round corners around them", async (t) => {
  const demo = await open(t);
  const poking = await demo.page.evaluate(() => [...document.querySelectorAll(".choices")].flatMap((choices) => {
    const inner = parseFloat(getComputedStyle(choices).borderTopLeftRadius) - parseFloat(getComputedStyle(choices).borderTopWidth);
    const [first, last] = [choices.firstElementChild, choices.lastElementChild].map((choice) => choice === null ? null : getComputedStyle(choice));
    const radii = [first?.borderTopLeftRadius, first?.borderBottomLeftRadius, last?.borderTopRightRadius, last?.borderBottomRightRadius].map((radius) => parseFloat(radius ?? "0"));
    return radii.every((radius) => radius >= inner) ? [] : [`${choices.textContent}: ${radii.join()} within ${inner}`];
  }));
  assert.deepEqual(poking, []);
});

test("the theme goes from the system's to light to dark and back, and stays for the next visit", async (t) => {
  const demo = await open(t, "", { colorScheme: "dark" });
  const ink = (): Promise<string> => demo.page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--ink").trim());
  const theme = demo.byId("btn-theme");
  const [system, ...next] = [await ink(), ...(await Promise.all([]))];
  assert.deepEqual(next, []);
  await theme.click();
  const light = await ink();
  await theme.click();
  assert.equal(await ink(), system, "dark is what this system has");
  assert.notEqual(light, system);
  await theme.click();
  await theme.click();
  await demo.page.reload();
  await demo.page.evaluate(() => window.explineDemo.ready);
  assert.equal(await ink(), light);
  assert.match((await theme.getAttribute("aria-label")) ?? "", /light/);
});

test("the points table is the model without the picture: read, edited and selected from", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.page.getByText("Points table").click();
  const rows = demo.byId("points-table").locator("tbody tr");
  await rows.nth(5).waitFor();
  assert.equal(await rows.count(), 6);
  const x = rows.nth(1).getByLabel("X of point 2");
  assert.equal(await x.inputValue(), "476.00");
  await x.fill("480.5");
  await x.press("Enter");
  await demo.idle();
  assert.equal((await demo.point(1)).x, 480.5);
  await rows.nth(2).getByLabel("Kind of point 3").selectOption("cusp");
  await demo.idle();
  assert.equal((await demo.point(2)).kind, "cusp");
  assert.equal(await demo.metric("legend-cusp"), 3);
  await demo.byId("legend-cusp").click();
  await demo.idle();
  assert.equal(await rows.locator("xpath=self::*[@aria-selected='true']").count(), 3);
});

test("with text twice as large nothing in the surface's export, and nothing on an empty Trace, lies over anything else", async (t) => {
  const demo = await open(t, "#/trace");
  await demo.page.evaluate(() => { document.documentElement.style.fontSize = "200%"; });
  await demo.still();
  const [card, zoom] = await Promise.all([demo.byId("empty-trace").boundingBox(), demo.page.locator(".stage-zoom").boundingBox()]);
  assert.ok(card !== null && zoom !== null && card.y + card.height <= zoom.y, JSON.stringify({ card, zoom }));
  // What a card has in it is inside of it.
  assert.deepEqual(await demo.page.locator(".empty-trace .sample").evaluateAll((cards) => cards.filter((each) => each.scrollWidth > each.clientWidth).map((each) => each.textContent)), []);
  await demo.click("tab-surface");
  await demo.click("btn-export");
  await demo.byId("export-dialog").waitFor();
  await demo.still();
  const rows = await demo.page.locator(".dialog-body > *").evaluateAll((all) => all.map((each) => each.getBoundingClientRect()).map(({ top, bottom }) => ({ top, bottom })));
  assert.ok(rows.length >= 4);
  for (const [i, { top }] of rows.entries()) assert.ok(i === 0 || top >= (rows[i - 1]?.bottom ?? 0), JSON.stringify(rows));
});

/** Boxes of what is in sight, by name; a part that is cut off counts as far as it can be seen. */
function boxesOf(page: Page, selectors: readonly string[]): Promise<{ name: string; left: number; right: number; top: number; bottom: number }[]> {
  return page.evaluate((all) => all.flatMap((name) => [...document.querySelectorAll(name)]
    .filter((element) => element.checkVisibility({ visibilityProperty: true }))
    .map((element) => element.getBoundingClientRect())
    .filter(({ width, height }) => width > 0 && height > 0)
    .map(({ left, right, top, bottom }) => ({ name, left, right, top, bottom }))), selectors);
}

test("at 320 px with text twice as large nothing lies over anything else, in any mode", async (t) => {
  const demo = await open(t, "#/curve?sample=blob-16", { viewport: { width: 320, height: 568 }, hasTouch: true, isMobile: true });
  await demo.page.evaluate(() => { document.documentElement.style.fontSize = "200%"; });
  for (const mode of ["curve", "fit", "trace", "surface"]) {
    await demo.page.evaluate((hash) => { location.hash = hash; }, mode === "trace" ? "#/trace?sample=trace-logo" : `#/${mode}`);
    await demo.still();
    const boxes = await boxesOf(demo.page, [".header", ".stage-zoom", ".tools", ".stage-hint", ".panel", ".tabs"]);
    const peek = await boxesOf(demo.page, [".sheet-peek .field-label", ".sheet-peek .slider", ".sheet-peek .slider-value"]);
    assert.ok(boxes.length >= 4 && peek.length === 3, `${mode}: ${boxes.length} parts of the page and ${peek.length} of the sheet`);
    for (const list of [boxes, peek]) {
      list.forEach((a, i) => list.slice(i + 1).forEach((b) => {
        const over = Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
        assert.ok(!over, `${mode}: ${JSON.stringify([a, b])}`);
      }));
      for (const { name, left, right } of list) assert.ok(left >= 0 && right <= 320, `${mode}: ${name} from ${left} to ${right}`);
    }
  }
});

test("at 320 px with text twice as large every entry of the menu and every button of a dialog is within the screen", async (t) => {
  const demo = await open(t, "#/curve?sample=blob-16", { viewport: { width: 320, height: 568 }, hasTouch: true, isMobile: true });
  await demo.page.evaluate(() => { document.documentElement.style.fontSize = "200%"; });
  for (const [id, dialog] of [["btn-samples", "samples-dialog"], ["btn-import", "import-dialog"], ["btn-export", "export-dialog"], ["btn-help", "help-dialog"]] as const) {
    await demo.byId("btn-menu").click();
    const entries = await boxesOf(demo.page, [".header-menu > *"]);
    assert.equal(entries.length, 6);
    for (const { left, right } of entries) assert.ok(left >= 0 && right <= 320, `${left} to ${right}`);
    await demo.byId(id).click();
    await demo.byId(dialog).waitFor();
    await demo.still();
    for (const { name, left, right } of await boxesOf(demo.page, [".dialog button", ".dialog select", ".dialog input", ".dialog textarea", ".dialog p"])) {
      assert.ok(left >= 0 && right <= 320, `${dialog}: ${name} from ${left} to ${right}`);
    }
    await demo.page.keyboard.press("Escape");
    await demo.byId(dialog).waitFor({ state: "detached" });
  }
});

for (const mode of ["curve", "fit", "trace", "surface"] as const) {
  test(`in the panel of ${mode} Tab goes from row to row, as one reads`, async (t) => {
    const demo = await open(t, `#/${mode}`);
    const steps = await demo.page.evaluate(() => {
      const all = [...document.querySelectorAll<HTMLElement>(".panel-scroll :is(button, input, select, summary)")].filter((each) => each.checkVisibility());
      return all.slice(1).flatMap((each, i) => {
        const [before, after] = [all[i], each].map((one) => one?.getBoundingClientRect() ?? new DOMRect());
        const goesOn = before !== undefined && after !== undefined && (after.top >= before.bottom - 1 || (after.bottom > before.top && after.left > before.left));
        return goesOn ? [] : [`${all[i]?.dataset["testid"]} to ${each.dataset["testid"]}`];
      });
    });
    assert.deepEqual(steps, []);
  });
}

test("letters on the canvas grow with the page's text", async (t) => {
  const demo = await open(t);
  await demo.page.evaluate(() => {
    const { prototype } = CanvasRenderingContext2D;
    const write = prototype.fillText;
    prototype.fillText = function written(this: CanvasRenderingContext2D, ...given: Parameters<typeof write>) {
      document.body.dataset["font"] = this.font;
      write.apply(this, given);
    };
    document.documentElement.style.fontSize = "200%";
  });
  await demo.still();
  await demo.byId("zoom-in").click();
  await demo.idle();
  // Small text is three quarters of the root's size.
  assert.match((await demo.page.evaluate(() => document.body.dataset["font"])) ?? "", /^24px /);
});

for (const options of [{ viewport: { width: 1440, height: 900 } }, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, { viewport: { width: 320, height: 568 }, hasTouch: true, isMobile: true }]) {
  test(`at ${options.viewport.width} px with text twice as large neither the hint nor the zoom box lies over a drawing that was fitted`, async (t) => {
    const demo = await open(t, "", options);
    await demo.page.evaluate(() => { document.documentElement.style.fontSize = "200%"; });
    await demo.still();
    for (const sample of ["circle-2", "heart", "blob-16"]) {
      await demo.page.evaluate((id) => { location.hash = `#/curve?sample=${id}`; }, sample);
      await demo.until(() => demo.state(), ({ curve }) => (curve as { sample?: string }).sample === sample, sample);
      await demo.focusStage();
      await demo.press("f");
      await demo.still();
      const boxes = await boxesOf(demo.page, [".stage-hint", ".stage-zoom"]);
      assert.equal(boxes.length, 2);
      for (const [x, y] of await demo.sample(300)) {
        const at = await demo.toScreen(x, y);
        const over = boxes.find(({ left, right, top, bottom }) => at.x > left && at.x < right && at.y > top && at.y < bottom);
        assert.equal(over, undefined, `${sample}: ${JSON.stringify([at, over])}`);
      }
    }
  });
}

test("with text twice as large on a phone the words about the Bézier do not lie over the circle", async (t) => {
  for (const viewport of [{ width: 320, height: 568 }, { width: 390, height: 844 }]) {
    const demo = await open(t, "", { viewport, hasTouch: true, isMobile: true });
    await demo.page.evaluate(() => {
      const { prototype } = CanvasRenderingContext2D;
      const write = prototype.fillText;
      prototype.fillText = function written(this: CanvasRenderingContext2D, ...given: Parameters<typeof write>) {
        const [text, x, y] = given;
        const [{ left, top }, { width }] = [this.canvas.getBoundingClientRect(), this.measureText(text)];
        document.body.dataset["words"] = JSON.stringify([...JSON.parse(document.body.dataset["words"] ?? "[]"), { text, left: left + x, right: left + x + width, top: top + y - 16, bottom: top + y }]);
        write.apply(this, given);
      };
      document.documentElement.style.fontSize = "200%";
    });
    await demo.still();
    await demo.byId("zoom-out").click();
    await demo.page.evaluate(() => { document.body.dataset["words"] = "[]"; });
    await demo.byId("zoom-fit").click();
    await demo.still();
    const words = JSON.parse((await demo.page.evaluate(() => document.body.dataset["words"])) ?? "[]") as { text: string; left: number; right: number; top: number; bottom: number }[];
    if (viewport.width > 320) assert.match(words.map(({ text }) => text).join(" "), /4-arc Bézier.*error × 500/u);
    for (const [x, y] of await demo.sample(300)) {
      const at = await demo.toScreen(x, y);
      const over = words.find(({ left, right, top, bottom }) => at.x > left && at.x < right && at.y > top && at.y < bottom);
      assert.equal(over, undefined, `${viewport.width} px: ${JSON.stringify([at, over])}`);
    }
  }
});
