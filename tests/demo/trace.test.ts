import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo, type Pair } from "./page.ts";

const { open } = useBrowser();

interface Result {
  readonly contours: number;
  readonly holes: number;
  readonly cusps: readonly { readonly x: number; readonly y: number }[];
  readonly segments: number;
  readonly rms: number;
  readonly max: number;
}

async function result(demo: Demo): Promise<Result> {
  const { trace } = (await demo.state()) as unknown as { trace: { result?: Result } };
  assert.ok(trace.result !== undefined, "there are outlines");
  return trace.result;
}

/** The document of Trace, without what came of it. */
async function asked(demo: Demo): Promise<{ sample?: string; picture?: { name: string }; settings: Record<string, unknown> }> {
  return (await demo.state()).trace as unknown as { sample?: string; picture?: { name: string }; settings: Record<string, unknown> };
}

/** The ten corners of the sample's star. */
const corners: Pair[] = Array.from({ length: 10 }, (_, i) => {
  const [angle, radius] = [(Math.PI * i) / 5 - Math.PI / 2, i % 2 === 0 ? 200 : 80];
  return [256 + radius * Math.cos(angle), 256 + radius * Math.sin(angle)];
});

function toLine([x, y]: Pair, [ax, ay]: Pair, [bx, by]: Pair): number {
  const [ux, uy] = [bx - ax, by - ay];
  const t = Math.max(0, Math.min(1, ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy)));
  return Math.hypot(x - ax - t * ux, y - ay - t * uy);
}

const toStar = (place: Pair): number => Math.min(...corners.map((corner, i) => toLine(place, corner, corners[(i + 1) % 10] ?? corner)));

test("V21 a disc is one round outline of few points, and the printed errors are those against the true circle", async (t) => {
  const demo = await open(t, "#/trace?sample=trace-disc");
  const { contours, cusps } = await result(demo);
  assert.equal(contours, 1);
  assert.equal(cusps.length, 0);
  const off = (await demo.sample(2000)).map(([x, y]) => Math.abs(Math.hypot(x - 256, y - 256) - 160));
  const [rms, max] = [Math.hypot(...off) / Math.sqrt(off.length), Math.max(...off)];
  assert.ok(rms <= 0.35 && max <= 0.8, `rms ${rms}, max ${max}`);
  assert.ok((await demo.metric("m-points")) <= 16);
  assert.ok(Math.abs((await demo.metric("m-rms")) - rms) <= 0.3);
  assert.ok(Math.abs((await demo.metric("m-max")) - max) <= 0.3);
  t.diagnostic(`disc: radius off by rms ${rms.toExponential(1)}, max ${max.toExponential(1)} px, ${await demo.metric("m-points")} points, ${(await demo.stats()).lastJobMs.toFixed(0)} ms of 1500`);
  assert.deepEqual(demo.complaints, []);
});

test("V22 a star keeps its ten corners and its straight sides, at the defaults and at Detail 80", async (t) => {
  const demo = await open(t, "#/trace?sample=trace-star");
  for (const detail of [35, 80]) {
    if (detail !== 35) await demo.slide("trace-detail", detail);
    const { cusps } = await result(demo);
    assert.equal(cusps.length, 10, `${cusps.length} corners at Detail ${detail}`);
    const nearest = corners.map(([x, y]) => Math.min(...cusps.map((cusp) => Math.hypot(cusp.x - x, cusp.y - y))));
    assert.ok(Math.max(...nearest) <= 1.5, `a corner is ${Math.max(...nearest)} px away`);
    const bent = Math.max(...(await demo.sample(2000)).map(toStar));
    assert.ok(bent <= 0.5, `a side bends by ${bent} px`);
    t.diagnostic(`star, Detail ${detail}: corners within ${Math.max(...nearest).toFixed(3)} px, sides within ${bent.toFixed(3)} px`);
  }
  assert.equal(await demo.metric("m-cusps"), 10);
  assert.equal(Number(await demo.byId("legend-cusp").getAttribute("data-value")), 10);
});

test("V22 the logo has corners on its sharp mark alone; nothing turns by 180 degrees", async (t) => {
  const demo = await open(t, "#/trace?sample=trace-logo");
  const { cusps, contours, holes, max } = await result(demo);
  assert.equal(contours, 4);
  // The pixels of ink end more than one before the bolt's tips do: that is no error, and is said by its name.
  assert.ok(max < 0.5, `${max} px from the edge`);
  assert.match(await demo.textOf("trace-beyond"), /^up to [12]\.\d px$/u);
  assert.equal(holes, 1);
  const bolt: Pair[] = [[282, 118], [188, 276], [248, 276], [224, 394], [326, 226], [262, 226]];
  for (const { x, y } of cusps) assert.ok(bolt.some(([a, b]) => Math.hypot(a - x, b - y) <= 2), `a corner at ${x}, ${y}`);
  for (const [x, y] of bolt) assert.ok(cusps.some((cusp) => Math.hypot(cusp.x - x, cusp.y - y) <= 2), `no corner at ${x}, ${y}`);
  await demo.slide("trace-corner", 180);
  assert.equal((await result(demo)).cusps.length, 0);
});

/** A picture as a file: a black square with a round hole, in the page's own encoder. */
async function png(demo: Demo, size = 96): Promise<number[]> {
  return demo.page.evaluate(async (side) => {
    const canvas = new OffscreenCanvas(side, side);
    const context = canvas.getContext("2d");
    if (context === null) return [];
    context.fillStyle = "white";
    context.fillRect(0, 0, side, side);
    context.fillStyle = "black";
    context.fillRect(side / 6, side / 6, (2 * side) / 3, (2 * side) / 3);
    context.fillStyle = "white";
    context.beginPath();
    context.arc(side / 2, side / 2, side / 5, 0, 2 * Math.PI);
    context.fill();
    return [...new Uint8Array(await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer())];
  }, size);
}

/** A file that is dropped on the stage, or pasted. */
async function bring(demo: Demo, how: "drop" | "paste", name: string, type: string, content: string | readonly number[]): Promise<void> {
  await demo.page.evaluate(([way, fileName, fileType, bytes]) => {
    const data = new DataTransfer();
    data.items.add(new File([typeof bytes === "string" ? bytes : Uint8Array.from(bytes)], fileName, { type: fileType }));
    const event = way === "drop"
      ? new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true })
      : new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true });
    document.querySelector("canvas")?.dispatchEvent(event);
  }, [how, name, type, content] as const);
}

async function traced(demo: Demo, name: string): Promise<void> {
  await demo.page.waitForFunction((wanted) => document.querySelector('[data-testid="trace-source"]')?.textContent === wanted, name);
  await demo.idle();
  assert.equal((await result(demo)).contours, 2);
  assert.equal((await result(demo)).holes, 1);
}

test("V23 a picture comes in by the field, by drop and by paste; each is named and starts at once", async (t) => {
  const demo = await open(t, "#/trace");
  const content = await png(demo);
  await demo.byId("empty-trace").waitFor();
  await demo.byId("trace-file").setInputFiles({ name: "field.png", mimeType: "image/png", buffer: Buffer.from(content) });
  await traced(demo, "field.png");
  assert.equal(await demo.byId("empty-trace").count(), 0);
  await bring(demo, "drop", "drop.png", "image/png", content);
  await traced(demo, "drop.png");
  await bring(demo, "paste", "image.png", "image/png", content);
  await traced(demo, "Pasted picture");
  await demo.press("Control+z", "Control+z");
  await traced(demo, "field.png");
  // From any other mode as well.
  await demo.byId("tab-curve").click();
  await bring(demo, "drop", "curve.png", "image/png", content);
  await traced(demo, "curve.png");
  assert.equal((await demo.state()).mode, "trace");
  assert.deepEqual(demo.complaints, []);
});

test("a picture that is pasted as text, as style sheets and a browser's tools have it, is traced; in the import's field as well", async (t) => {
  const demo = await open(t, "#/trace");
  const address = `data:image/png;base64,${Buffer.from(await png(demo)).toString("base64")}`;
  await demo.page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData("text/plain", text);
    document.querySelector("canvas")?.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, `url("${address}")`);
  await traced(demo, "Pasted picture");
  await demo.byId("tab-curve").click();
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill(address);
  await demo.byId("import-apply").click();
  await demo.byId("import-dialog").waitFor({ state: "detached" });
  await traced(demo, "Pasted picture");
  assert.equal((await demo.state()).mode, "trace");
  assert.deepEqual(demo.complaints, []);
});

test("a ring that a browser draws around what is hardly darker than paper is two circles of two points, as on paper", async (t) => {
  const demo = await open(t, "#/trace");
  for (const inside of ["#fff", "#fefefe", "#f8f9fd", "#f0f0f0"]) {
    const address = await demo.page.evaluate((fill) => {
      const canvas = Object.assign(document.createElement("canvas"), { width: 640, height: 640 });
      const context = canvas.getContext("2d");
      if (context === null) return "";
      context.fillStyle = "#fff";
      context.fillRect(0, 0, 640, 640);
      context.arc(320, 312, 200, 0, 2 * Math.PI);
      Object.assign(context, { fillStyle: fill, strokeStyle: "#1b1f24", lineWidth: 4 });
      context.fill();
      context.stroke();
      return canvas.toDataURL();
    }, inside);
    await bring(demo, "drop", `${inside}.png`, "image/png", [...Buffer.from(address.slice(address.indexOf(",") + 1), "base64")]);
    await traced(demo, `${inside}.png`);
    const { contours, segments } = await result(demo);
    assert.deepEqual([contours, segments], [2, 4], inside);
  }
});

/** A mark with a line of small letters below it, in the page's own font. */
async function captioned(demo: Demo): Promise<number[]> {
  return demo.page.evaluate(async () => {
    const canvas = new OffscreenCanvas(640, 360);
    const context = canvas.getContext("2d");
    if (context === null) return [];
    context.fillStyle = "white";
    context.fillRect(0, 0, 640, 360);
    context.fillStyle = "black";
    context.fillRect(240, 40, 160, 160);
    context.font = "10px sans-serif";
    context.fillText("Acme Industries International, since 1928", 200, 280);
    return [...new Uint8Array(await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer())];
  });
}

test("letters that were too small to be kept are told of, and come back at a click or a key", async (t) => {
  const demo = await open(t, "#/trace");
  await bring(demo, "drop", "mark.png", "image/png", await captioned(demo));
  await demo.page.waitForFunction(() => document.querySelector('[data-testid="trace-source"]')?.textContent === "mark.png");
  await demo.idle();
  const { contours } = await result(demo);
  const said = /^(\d+) shapes or holes smaller than 16 px² were left out\.$/u.exec(await demo.textOf("trace-left-out"));
  const count = Number(said?.[1]);
  assert.ok(count >= 10, `${count} are told of`);
  assert.equal(await demo.page.locator(".toast p").innerText(), said?.[0], "over the stage as well");
  await demo.page.locator(".toast-action").click();
  await demo.until(() => result(demo), (now) => now.contours === contours + count, "all of them are there");
  assert.equal(await demo.byId("trace-left-out").isVisible(), false);
  assert.equal(await demo.page.locator(".toast").count(), 0);
  await demo.press("Control+z");
  await demo.until(() => demo.byId("trace-left-out").isVisible(), (on) => on, "undone, it is said in the panel again");
  assert.equal((await result(demo)).contours, contours);
  await demo.byId("trace-keep-small").click();
  await demo.until(() => result(demo), (now) => now.contours === contours + count, "the panel keeps them, too");
  await demo.press("Control+z");
  await demo.until(() => result(demo), (now) => now.contours === contours, "undone");
  await demo.focusStage();
  await demo.press("s");
  await demo.until(() => result(demo), (now) => now.contours === contours + count, "and so does the key");
  assert.equal((await asked(demo)).settings["speckle"], 2);
  assert.deepEqual(demo.complaints, []);
});

test("nothing of that is said of the samples", async (t) => {
  for (const id of ["trace-logo", "trace-leaf", "trace-small", "trace-sketch", "trace-postcard", "trace-big"]) {
    const demo = await open(t, `#/trace?sample=${id}`);
    assert.ok((await result(demo)).contours > 0);
    assert.equal(await demo.byId("trace-left-out").isVisible(), false, id);
    await demo.page.close();
  }
});

test("an icon of 16 pixels is shown as large as other pictures", async (t) => {
  const demo = await open(t, "#/trace");
  for (const side of [400, 16]) {
    await bring(demo, "drop", `${side}.png`, "image/png", await png(demo, side));
    await traced(demo, `${side}.png`);
    const [from, to] = [await demo.toScreen(0, 0), await demo.toScreen(side, side)];
    assert.ok(to.y - from.y > 500 && to.y - from.y < 720, `${side} pixels are ${to.y - from.y} high`);
  }
});

test("of a picture of one's own the outlines are there after a reload, and what only its pixels could answer is out of reach", async (t) => {
  const demo = await open(t, "#/trace");
  await bring(demo, "drop", "own.png", "image/png", await png(demo));
  await traced(demo, "own.png");
  await demo.until(() => demo.keptTexts(), (all) => all.some(({ text }) => text.includes('"kept"')), "the outlines are kept");
  await demo.page.reload();
  await demo.page.evaluate(() => window.explineDemo.ready);
  await traced(demo, "own.png");
  for (const id of ["trace-detail", "trace-corner", "trace-speckle", "trace-flat", "trace-threshold", "trace-blur", "trace-invert", "trace-size", "trace-run", "trace-alpha"]) {
    assert.equal(await demo.byId(id).isDisabled(), true, id);
  }
  const view = (name: string): Promise<boolean> => demo.byId("trace-view").locator(`[value="${name}"]`).isDisabled();
  assert.deepEqual([await view("result"), await view("outline"), await view("source"), await view("edges")], [false, false, true, true]);
  assert.match(await demo.page.locator(".trace-about").innerText(), /drop the picture again/u);
  assert.doesNotMatch(await demo.textOf("hint"), /circle/u, "what was said of the landing sample is not said of a picture");
  await bring(demo, "drop", "own.png", "image/png", await png(demo));
  await demo.until(() => demo.byId("trace-detail").isDisabled(), (off) => !off, "with the picture there is something to be asked");
});

test("V23 what is no picture is refused by name, and the result before stays", async (t) => {
  const demo = await open(t, "#/trace?sample=trace-disc");
  const before = await asked(demo);
  const bomb = [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52, 0, 0, 0x75, 0x30, 0, 0, 0x75, 0x30, 8, 0, 0, 0, 0];
  for (const [name, type, content, id] of [
    ["note.png", "image/png", "this was a text", "image-broken"],
    ["paper.pdf", "application/pdf", "%PDF-1.7", "image-type"],
    ["bomb.png", "image/png", bomb, "image-big"],
  ] as const) {
    await bring(demo, "drop", name, type, content);
    const error = demo.page.locator(`[data-testid="error"][data-error="${id}"]`);
    await error.waitFor();
    assert.match((await error.textContent()) ?? "", new RegExp(name.replace(".", "\\.")));
    await demo.idle();
    assert.deepEqual(await asked(demo), before);
    assert.equal((await result(demo)).contours, 1);
  }
  assert.equal(await demo.byId("stage").isVisible(), true);
  // "The previous picture is kept" is over when the next one opens.
  await bring(demo, "drop", "good.png", "image/png", await png(demo));
  await traced(demo, "good.png");
  assert.equal(await demo.byId("error").count(), 0);
});

test("where there was no picture before, a broken one says nothing of a kept one", async (t) => {
  const demo = await open(t, "#/trace");
  await bring(demo, "drop", "note.png", "image/png", "this was a text");
  const error = demo.page.locator('[data-testid="error"][data-error="image-broken"]');
  await error.waitFor();
  assert.match((await error.textContent()) ?? "", /note\.png could not be decoded\. It may be incomplete\.$/);
});

test("a broken picture takes nobody to Trace: it is said where one works, and in the dialog that it was chosen in", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  const before = (await demo.state()).curve;
  const whole = await png(demo);
  for (const content of ["this was a text", whole.slice(0, 60)]) {
    await bring(demo, "drop", "scan.png", "image/png", content);
    const error = demo.page.locator('[data-testid="error"][data-error="image-broken"]');
    await error.waitFor();
    assert.match((await error.textContent()) ?? "", /scan\.png could not be decoded\. It may be incomplete\.$/u);
    await demo.idle();
    const { mode, curve } = await demo.state();
    assert.equal(mode, "curve");
    assert.deepEqual(curve, before);
    await error.getByRole("button", { name: "Dismiss" }).click();
  }
  await demo.byId("btn-import").click();
  await demo.byId("import-file").setInputFiles({ name: "scan.png", mimeType: "image/png", buffer: Buffer.from("this was a text") });
  await demo.byId("import-dialog").locator('[data-error="image-broken"]').waitFor();
  await demo.press("Escape");
  // The same way a whole one leads there.
  await bring(demo, "drop", "good.png", "image/png", whole);
  await traced(demo, "good.png");
});

test("a drawing on paper in uneven light has its own outlines, and the numbers beside it are of the paper in even light", async (t) => {
  const demo = await open(t, "#/trace");
  const content = await demo.page.evaluate(async () => {
    const canvas = new OffscreenCanvas(240, 240);
    const context = canvas.getContext("2d");
    if (context === null) return [];
    const light = context.createLinearGradient(0, 0, 240, 240);
    light.addColorStop(0, "#e8e4da");
    light.addColorStop(1, "#66625b");
    context.fillStyle = light;
    context.fillRect(0, 0, 240, 240);
    context.lineWidth = 6;
    context.strokeStyle = "#15151d";
    context.beginPath();
    context.arc(120, 120, 80, 0, 2 * Math.PI);
    context.stroke();
    return [...new Uint8Array(await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer())];
  });
  await bring(demo, "drop", "sheet.png", "image/png", content);
  await traced(demo, "sheet.png");
  const overlap = Number((await demo.textOf("m-iou")).match(/[\d.]+/u)?.[0]);
  assert.ok(overlap > 0.95, `IoU ${overlap}`);
});

/** A picture of 40 × 40 black squares on white, as a file's bytes. */
function squares(demo: Demo, step: number, side: number): Promise<number[]> {
  return demo.page.evaluate(
    async ([step, side]) => {
      const canvas = new OffscreenCanvas(40 * step, 40 * step);
      const context = canvas.getContext("2d");
      if (context === null) return [];
      context.fillStyle = "white";
      context.fillRect(0, 0, 40 * step, 40 * step);
      context.fillStyle = "black";
      for (let i = 0; i < 1600; i += 1) context.fillRect(step * (i % 40) + 1, step * Math.floor(i / 40) + 1, side, side);
      return [...new Uint8Array(await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer())];
    },
    [step, side] as const,
  );
}

test("a photograph is refused with an offer, and traced when somebody wants it", async (t) => {
  const demo = await open(t, "#/trace");
  await bring(demo, "drop", "photo.png", "image/png", await squares(demo, 5, 3));
  await demo.page.waitForFunction(() => document.querySelector('[data-testid="trace-source"]')?.textContent === "photo.png");
  await demo.idle();
  await demo.slide("trace-speckle", 0);
  const error = demo.page.locator('[data-testid="error"][data-error="trace-photo"]');
  await error.waitFor();
  assert.match((await error.textContent()) ?? "", /photograph: 160[0-9] contours/u);
  await demo.byId("offer-speckle").click();
  await demo.idle();
  assert.equal(await error.count(), 0);
});

test("what looks like a photograph by its edges is refused with an offer that helps", async (t) => {
  const demo = await open(t, "#/trace");
  await bring(demo, "drop", "squares.png", "image/png", await squares(demo, 10, 5));
  await demo.page.waitForFunction(() => document.querySelector('[data-testid="trace-source"]')?.textContent === "squares.png");
  await demo.idle();
  await demo.byId("trace-mode").locator('[value="edges"]').check();
  await demo.idle();
  await demo.slide("trace-speckle", 0);
  await demo.idle();
  const error = demo.page.locator('[data-testid="error"][data-error="trace-photo"]');
  await error.waitFor();
  await demo.byId("offer-speckle").click();
  await demo.idle();
  assert.equal(await error.count(), 0);
});
