import assert from "node:assert/strict";
import { test } from "node:test";
import { inflateSync } from "node:zlib";
import { useBrowser, type Demo } from "./page.ts";

/** What is on the page can be seen, read to its end and pressed, and stays where it is while it is pressed. */

const { open } = useBrowser();

const tablet = { viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true } as const;
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } as const;

async function imported(demo: Demo, text: string): Promise<void> {
  await demo.page.evaluate((pasted) => {
    const data = new DataTransfer();
    data.setData("text/plain", pasted);
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, text);
  await demo.page.locator(".toast").first().waitFor();
  await demo.idle();
}

test("the stage that Tab leads to has a ring around it, in every mode", async (t) => {
  const demo = await open(t, "", { reducedMotion: "reduce" });
  for (const mode of ["curve", "fit", "trace", "surface"]) {
    await demo.click(`tab-${mode}`);
    await demo.page.keyboard.press("Tab");
    await demo.focusStage();
    await demo.still();
    const box = await demo.byId("stage").boundingBox();
    assert.ok(box !== null);
    const clip = { x: box.x, y: box.y + box.height / 2, width: 2, height: 1 };
    const edge = await demo.page.screenshot({ clip });
    await demo.byId(`tab-${mode}`).focus();
    await demo.still();
    assert.notDeepEqual(edge, await demo.page.screenshot({ clip }), mode);
  }
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`whatever colour a line or mark has, it stands out 3 : 1 from the stage and the panel, ${colorScheme}`, async (t) => {
    const demo = await open(t, "", { colorScheme });
    const faint = await demo.page.evaluate(() => {
      const style = getComputedStyle(document.documentElement);
      const luminance = (name: string): number => {
        const parts = style.getPropertyValue(`--${name}`).match(/[\d.]+/gu)?.slice(0, 3).map((each) => Number(each) / 255) ?? [];
        const [r = NaN, g = NaN, b = NaN] = parts.map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const ratio = (a: string, b: string): number => {
        const [x, y] = [luminance(a), luminance(b)];
        return (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
      };
      const names = ["border", "line", "focus", "point", "curve", "handle", "linear", "cubic", "coinc", "cusp", "original", "err", "warn", "heat-0", "heat-1", "heat-2", "heat-3", "heat-4"];
      return names.flatMap((name) => ["canvas", "panel"].map((paper) => ({ name, paper, found: ratio(name, paper) }))).filter(({ found }) => !(found >= 3));
    });
    assert.deepEqual(faint, []);
  });
}

test("what a field has in it as an example can be read in the dark", async (t) => {
  const demo = await open(t, "", { colorScheme: "dark" });
  await demo.byId("btn-import").click();
  const [shown, text] = await demo.byId("import-text").evaluate((field) => [getComputedStyle(field, "::placeholder").color, getComputedStyle(document.documentElement).getPropertyValue("--ink2")]);
  assert.equal(shown, text);
});

test("points that somebody clicked are seen beside the curve that was fitted to them", async (t) => {
  const demo = await open(t, "#/fit");
  await imported(demo, "100,100\n220,90\n300,200\n260,330\n120,340\n60,220");
  await demo.byId("ov-knots").uncheck();
  await demo.idle();
  // The datum that is farthest from the curve.
  const [data, curve] = [(await demo.state()).fit.data, await demo.sample(2000)];
  const away = data.map(([x, y]) => Math.min(...curve.map(([a, b]) => Math.hypot(a - x, b - y))));
  const [x = NaN, y = NaN] = data[away.indexOf(Math.max(...away))] ?? [];
  const at = await demo.toScreen(x, y);
  const ink = await demo.page.evaluate(({ x: left, y: top }) => {
    const canvas = document.querySelector("canvas");
    const box = canvas?.getBoundingClientRect() ?? new DOMRect();
    const { data: pixels } = canvas?.getContext("2d")?.getImageData(Math.round(left - box.left) - 4, Math.round(top - box.top) - 4, 8, 8) ?? { data: [] };
    let dark = 0;
    for (let i = 0; i < pixels.length; i += 4) dark += (pixels[i] ?? 255) < 200 ? 1 : 0;
    return dark;
  }, at);
  // A disc of five pixels across has twenty.
  assert.ok(ink >= 16, `${ink} pixels`);
});

test("every number of the points table can be read to its last digit", async (t) => {
  const demo = await open(t, "", tablet);
  await imported(demo, "M-123456.789 -987654.321C-122856 -987654 -122456 -987254 -122456.789 -986854.2S-123156 -986054 -123456.789 -986454.321z");
  await demo.page.locator(".panel-toggle").click();
  await demo.page.getByText("Points table").click();
  const fields = demo.byId("points-table").locator("input");
  await fields.nth(5).waitFor();
  assert.equal(await fields.first().inputValue(), "-123456.79");
  assert.deepEqual(await fields.evaluateAll((all) => all.filter((each) => each.scrollWidth > each.clientWidth).map((each) => each.ariaLabel)), []);
});

test("a finger can press what a message offers, and what takes it away", async (t) => {
  const demo = await open(t, "", phone);
  await imported(demo, "M0 0C50 0 100 50 100 100S50 200 0 100z");
  // While it rises it stands at parts of a pixel, and what is measured is rounded.
  await demo.still();
  for (const each of await demo.page.locator(".toast button").all()) {
    const box = await each.boundingBox();
    assert.ok(box !== null && Math.min(box.width, box.height) >= 44, JSON.stringify(box));
  }
});

test("a slider that is dragged from end to end stays where it is, and as long as it is", async (t) => {
  const demo = await open(t);
  for (const [hash, id] of [["#/curve?sample=blob-16", "level"], ["#/fit?sample=fit-star", "fit-noise"], ["#/trace?sample=trace-logo", "trace-alpha"]] as const) {
    await demo.page.evaluate((to) => { location.hash = to; }, hash);
    await demo.byId(id).scrollIntoViewIfNeeded();
    await demo.still();
    const boxOf = async (): Promise<string> => JSON.stringify(await demo.byId(id).boundingBox());
    const before = await boxOf();
    const { x, y, width, height } = JSON.parse(before) as DOMRect;
    await demo.page.mouse.move(x + 8, y + height / 2);
    await demo.page.mouse.down();
    for (let i = 0; i <= 12; i += 1) {
      await demo.page.mouse.move(x + 8 + ((width - 16) * i) / 12, y + height / 2);
      await demo.page.waitForTimeout(20);
      assert.equal(await boxOf(), before, id);
    }
    await demo.page.mouse.up();
    await demo.idle();
    assert.equal(await boxOf(), before, id);
  }
});

/** An element as it is painted: how light each pixel of the row through its middle is, from 0 to 1. */
async function middleRow(demo: Demo, selector: string): Promise<number[]> {
  const picture = (await demo.page.locator(selector).screenshot()).toString("base64");
  return demo.page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context?.drawImage(image, 0, 0);
    const { data } = context?.getImageData(0, Math.floor(image.height / 2), image.width, 1) ?? { data: [] };
    return Array.from({ length: image.width }, (_, i) => {
      const [r = 0, g = 0, b = 0] = [0, 1, 2].map((k) => ((data[4 * i + k] ?? 0) / 255) ** 2.2);
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    });
  }, picture);
}

for (const colorScheme of ["light", "dark"] as const) {
  test(`in forced colours, ${colorScheme}, the first button has its letters and the heat its ramp`, async (t) => {
    const demo = await open(t, "#/fit?sample=fit-star", { forcedColors: "active", colorScheme });
    const row = await middleRow(demo, "[data-testid=fit-edit]");
    const [least, most] = [Math.min(...row), Math.max(...row)];
    assert.ok((most + 0.05) / (least + 0.05) >= 4.5, `${least} and ${most}`);
    // A plate behind the letters has two sides; the letters of "Edit in Curve" have two dozen.
    const isLight = row.map((each) => each > (least + most) / 2);
    const sides = isLight.filter((each, i) => i > 0 && each !== isLight[i - 1]).length;
    assert.ok(sides >= 12, `${sides} sides`);
    await demo.byId("ov-heat").check();
    await demo.idle();
    const ramp = await middleRow(demo, ".heat-ramp");
    assert.ok(new Set(ramp.map((each) => each.toFixed(2))).size > 8, "the ramp has shades");
  });
}

/** What of a part of the page is narrower than its text: labels, numbers, choices and selects. */
function cutIn(demo: Demo, part: string): Promise<string[]> {
  return demo.page.evaluate((selector) => {
    const pen = document.createElement("canvas").getContext("2d");
    const needed = (element: Element): number => {
      if (!(element instanceof HTMLSelectElement) || pen === null) return element.scrollWidth;
      pen.font = getComputedStyle(element).font;
      return pen.measureText(element.selectedOptions[0]?.text ?? "").width + 16;
    };
    const whole = [...document.querySelectorAll(selector)].find((element) => element.checkVisibility());
    const all = [...whole?.querySelectorAll(".field-label, .number, .select, .choice span") ?? []].filter((element) => element.checkVisibility() && element.clientWidth > 1);
    const [width, most] = [whole?.scrollWidth ?? NaN, whole?.clientWidth ?? NaN];
    return [...all.filter((element) => needed(element) > element.clientWidth).map((element) => element.getAttribute("data-testid") ?? element.textContent), ...(width <= most ? [] : [`the whole: ${width} of ${most}`])];
  }, part);
}

test("with text twice as large on a phone every number, choice and select of the panel can be read to its end", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", phone);
  await demo.page.evaluate(() => { document.documentElement.style.fontSize = "200%"; });
  for (let i = 0; i < 2; i += 1) await demo.byId("sheet-up").click();
  for (const mode of ["curve", "fit", "trace", "surface"]) {
    await demo.page.evaluate((hash) => { location.hash = hash; }, mode === "trace" ? "#/trace?sample=trace-logo" : `#/${mode}${mode === "curve" ? "?sample=heart" : ""}`);
    await demo.idle();
    await demo.page.evaluate(() => document.querySelector<HTMLElement>('[data-testid="stage"]')?.focus());
    await demo.press("]");
    await demo.still();
    assert.deepEqual(await cutIn(demo, ".panel-scroll"), [], mode);
  }
});

test("with text twice as large on a phone what is chosen in the export dialog can be read to its end, and so can the sheet's slider when it is down", async (t) => {
  const demo = await open(t, "#/trace?sample=trace-logo", phone);
  await demo.page.evaluate(() => { document.documentElement.style.fontSize = "200%"; });
  await demo.still();
  assert.deepEqual(await cutIn(demo, ".sheet-peek .field"), []);
  await demo.press("Control+e");
  await demo.byId("export-dialog").waitFor();
  await demo.still();
  assert.deepEqual(await cutIn(demo, ".dialog-body"), []);
});

test("a comb leaves out what has no curvature, a segment without extent, and the rest of the picture is drawn", async (t) => {
  const demo = await open(t, "#/curve?sample=circle-8");
  const plain = await demo.pixels();
  // Two points in one place, and no handles between them.
  await demo.page.evaluate(() => {
    const state = structuredClone(window.explineDemo.getState());
    const [a, b] = state.curve.contours[0]?.points ?? [];
    if (a === undefined || b === undefined) throw new Error("there are points");
    const none = { dx: 0, dy: 0 };
    Object.assign(a, { kind: "cusp", out: none });
    Object.assign(b, { kind: "cusp", in: none, x: a.x, y: a.y });
    return window.explineDemo.setState(state);
  });
  const before = await demo.pixels();
  assert.ok((await demo.changedPixels(plain, before)) > 100, "the curve is another one");
  await demo.byId("ov-comb").check();
  await demo.idle();
  assert.ok((await demo.changedPixels(before, await demo.pixels())) > 500, "the comb of the other segments");
  assert.deepEqual(demo.complaints, []);
});

test("on paper there is the drawing alone, all of it", async (t) => {
  const demo = await open(t, "#/curve?sample=glyph");
  // As wide as a sheet: the page has its panel over the stage there.
  await demo.page.setViewportSize({ width: 794, height: 1123 });
  await demo.page.emulateMedia({ media: "print" });
  await demo.still();
  for (const part of [".header", ".rail", ".panel", ".status", ".stage-hint", ".stage-zoom"]) assert.equal(await demo.page.locator(part).isVisible(), false, part);
  const [canvas, fit] = await demo.page.locator("canvas.stage-canvas").evaluate((element) => [element.getBoundingClientRect(), getComputedStyle(element).objectFit] as const);
  assert.deepEqual([canvas.left, canvas.top, canvas.width, canvas.height, fit], [0, 0, 794, 1123, "contain"]);
});

/** The opaque pictures in what the page is printed to, each as its green values. */
async function printed(demo: Demo): Promise<number[][]> {
  const pdf = (await demo.page.pdf({ printBackground: true })).toString("latin1");
  return [...pdf.matchAll(/\/Subtype \/Image\n((?:.*\n)*?.*)>> stream\n/gu)].flatMap(({ 0: head, 1: entries = "", index }) => {
    if (/SMask|DeviceGray/u.test(entries)) return [];
    const start = index + head.length;
    const bytes = inflateSync(Buffer.from(pdf.slice(start, pdf.indexOf("endstream", start)), "latin1"));
    return [Array.from(bytes).filter((_, i) => i % 3 === 1)];
  });
}

for (const [theme, route] of [["system", "#/curve?sample=heart"], ["own", "#/surface?sample=surf-sphere"]] as const) {
  test(`on paper there is dark ink on white, and on the screen it is dark again after it, ${theme} theme`, async (t) => {
    const demo = await open(t, route, { colorScheme: theme === "system" ? "dark" : "light" });
    if (theme === "own") for (let i = 0; i < 2; i += 1) await demo.byId("btn-theme").click();
    await demo.idle();
    const before = await demo.pixels();
    const [green = []] = await printed(demo);
    assert.deepEqual([green[0], green.at(-1)], [255, 255], "paper");
    assert.ok(green.filter((value) => value === 255).length > 0.5 * green.length, "most of it is paper");
    assert.ok(green.filter((value) => value < 80).length > 0.0005 * green.length, "there is ink");
    await demo.idle();
    assert.equal(await demo.changedPixels(before, await demo.pixels()), 0);
  });
}

test("what prints a copy of the page as it is before its media change is given white paper in time", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", { colorScheme: "dark" });
  const at = (type: string): Promise<number | undefined> => demo.page.evaluate((name) => {
    window.dispatchEvent(new Event(name));
    return document.querySelector<HTMLCanvasElement>("canvas.stage-canvas")?.getContext("2d")?.getImageData(0, 0, 1, 1).data[1];
  }, type);
  assert.equal(await at("beforeprint"), 255);
  assert.ok((await at("afterprint") ?? 255) < 60);
});

test("a surface on paper is as it is on the screen, and not black", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-sphere");
  // What the graphics card was given is shown, and then gone.
  await demo.page.waitForTimeout(200);
  const black = await demo.page.evaluate(() => {
    const solid = document.querySelector<HTMLCanvasElement>("canvas.stage-solid");
    if (solid === null) return NaN;
    const copy = new OffscreenCanvas(solid.width, solid.height).getContext("2d");
    window.dispatchEvent(new Event("beforeprint"));
    copy?.drawImage(solid, 0, 0);
    const { data } = copy?.getImageData(0, 0, solid.width, solid.height) ?? { data: [] };
    return Array.from(data).filter((value, i) => i % 4 === 1 && value < 8).length / (data.length / 4);
  });
  assert.ok(black < 0.1, `${(100 * black).toFixed(0)} % are black`);
});
