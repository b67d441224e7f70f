import assert from "node:assert/strict";
import { test } from "node:test";
import { readFile } from "node:fs/promises";
import { useBrowser, type Demo } from "./page.ts";

const { open } = useBrowser();

interface Traced {
  readonly contours: number;
  readonly holes: number;
  readonly colors?: readonly string[];
}

async function result(demo: Demo): Promise<Traced> {
  const { trace } = (await demo.state()) as unknown as { trace: { result?: Traced } };
  assert.ok(trace.result !== undefined, "there are outlines");
  return trace.result;
}

/** The colours that the postcard is drawn in. */
const colors = ["#90cde8", "#ffb74d", "#2e7d5a", "#1b5e50", "#19548c", "#f0d6a6", "#ffffff", "#b02a30"];

function distance(a: string, b: string): number {
  const channels = (color: string): number[] => [1, 3, 5].map((at) => Number.parseInt(color.slice(at, at + 2), 16));
  return Math.max(...channels(a).map((value, i) => Math.abs(value - (channels(b)[i] ?? 0))));
}

/** How much of a picture's opaque pixels has each of these colours. */
function sharesOf(demo: Demo, png: readonly number[], wanted: readonly string[]): Promise<number[]> {
  return demo.page.evaluate(async ([bytes, hexes]) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(bytes)]));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    context?.drawImage(bitmap, 0, 0);
    const data = context?.getImageData(0, 0, bitmap.width, bitmap.height).data ?? new Uint8ClampedArray();
    const counts = new Map<string, number>();
    let opaque = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] !== 255) continue;
      opaque += 1;
      const hex = `#${[0, 1, 2].map((k) => (data[i + k] ?? 0).toString(16).padStart(2, "0")).join("")}`;
      counts.set(hex, (counts.get(hex) ?? 0) + 1);
    }
    return hexes.map((hex) => (counts.get(hex) ?? 0) / opaque);
  }, [png, wanted] as const);
}

test("flat colours are found, shown as swatches, and saved as layers; without them there is ink", async (t) => {
  const demo = await open(t, "#/trace?sample=trace-postcard");
  const found = (await result(demo)).colors ?? [];
  assert.equal(found.length, colors.length, found.join(" "));
  for (const color of colors) assert.ok(found.some((each) => distance(each, color) <= 3), `${color} among ${found.join(" ")}`);
  assert.deepEqual(await demo.byId("trace-palette").locator("li").allTextContents(), found);
  await demo.byId("trace-export").click();
  await demo.idle();
  const preview = demo.page.locator(".export-picture path");
  assert.deepEqual(await preview.evaluateAll((paths) => paths.map((path) => path.getAttribute("fill"))), found, "the preview shows what the file does");
  const [file] = await Promise.all([demo.page.waitForEvent("download"), demo.byId("export-svg").click()]);
  const svg = await readFile(await file.path(), "utf8");
  assert.deepEqual([...svg.matchAll(/fill="(#[0-9a-f]{6})"/gu)].map(([, color]) => color), found);
  const [picture] = await Promise.all([demo.page.waitForEvent("download"), demo.byId("export-png").click()]);
  const shares = await sharesOf(demo, [...(await readFile(await picture.path()))], found);
  // Each colour is somewhere, and edges between them apart nothing else is.
  assert.ok(shares.every((share) => share > 1e-4) && shares.reduce((all, share) => all + share, 0) > 0.9, shares.map((share) => share.toFixed(4)).join(" "));
  await demo.page.keyboard.press("Escape");
  await demo.byId("export-dialog").waitFor({ state: "detached" });

  await demo.byId("trace-edit").click();
  await demo.idle();
  assert.equal((await demo.state()).mode, "curve");
  await demo.byId("btn-export").click();
  const [again] = await Promise.all([demo.page.waitForEvent("download"), demo.byId("export-svg").click()]);
  const layersOf = (text: string): unknown => [...text.matchAll(/<path d="([^"]*)" fill="(#[0-9a-f]{6})"([^>]*)\/>/gu)].map(([, ...all]) => all);
  assert.deepEqual(layersOf(await readFile(await again.path(), "utf8")), layersOf(svg), "what is edited in Curve is saved as it was traced");
  const [pictureAgain] = await Promise.all([demo.page.waitForEvent("download"), demo.byId("export-png").click()]);
  assert.deepEqual(await sharesOf(demo, [...(await readFile(await pictureAgain.path()))], found), shares);
  await demo.page.keyboard.press("Escape");
  await demo.byId("tab-trace").click();
  await demo.slide("trace-colors", 2);
  assert.equal((await result(demo)).colors?.length, 2);
  assert.equal(await demo.byId("trace-threshold").isVisible(), false, "there is no threshold between colours");
  const inColor = await demo.pixels();
  await demo.byId("trace-flat").uncheck();
  await demo.idle();
  assert.equal((await result(demo)).colors, undefined);
  assert.equal(await demo.byId("trace-palette").isVisible(), false);
  assert.ok((await demo.changedPixels(inColor, await demo.pixels())) > 1000);
  assert.deepEqual(demo.complaints, []);
});

/** A yellow badge with a dark bar and a blue disc, on nothing, as a logo of somebody's own. */
async function dropLogo(demo: Demo): Promise<void> {
  await demo.page.evaluate(async () => {
    const canvas = new OffscreenCanvas(240, 240);
    const context = canvas.getContext("2d");
    if (context === null) return;
    const fill = (color: string, draw: () => void): void => {
      context.fillStyle = color;
      context.beginPath();
      draw();
      context.fill();
    };
    fill("#ffd54a", () => context.roundRect(20, 20, 200, 200, 40));
    fill("#202020", () => context.rect(60, 60, 120, 30));
    fill("#1565c0", () => context.arc(120, 150, 40, 0, 2 * Math.PI));
    const data = new DataTransfer();
    data.items.add(new File([await canvas.convertToBlob()], "logo.png", { type: "image/png" }));
    document.querySelector("canvas")?.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  });
  await demo.page.waitForFunction(() => document.querySelector('[data-testid="trace-source"]')?.textContent === "logo.png");
  await demo.idle();
}

test("of a logo in colours on nothing the dark shapes are ink and the nothing is not; its colours are offered", async (t) => {
  const demo = await open(t, "#/trace");
  await dropLogo(demo);
  assert.deepEqual([(await result(demo)).contours, (await result(demo)).holes], [2, 0], "the bar and the disc");
  const panel = demo.page.locator("section[aria-label='Colours']");
  assert.match(await panel.innerText(), /several colours/u);
  await demo.byId("toast").getByRole("button", { name: "Trace in colours" }).click();
  await demo.idle();
  const found = (await result(demo)).colors ?? [];
  for (const color of ["#ffd54a", "#202020", "#1565c0"]) assert.ok(found.some((each) => distance(each, color) <= 3), `${color} among ${found.join(" ")}`);
  assert.equal(found.length, 3);
  assert.doesNotMatch(await panel.innerText(), /several colours/u);
  await demo.press("Control+z");
  assert.equal((await result(demo)).contours, 2, "one step of the history");
});

test("lines are followed in their middle, are open where they end, and are saved as strokes", async (t) => {
  const demo = await open(t, "#/trace?sample=trace-lines");
  const { contours } = await result(demo);
  assert.ok(contours >= 5, `${contours} lines`);
  // The left wave, from (40, 430) to (130, 430): one open line in the middle of its ribbon.
  const ends: number[][] = [];
  for (let i = 0; i < contours; i += 1) {
    const points = await demo.sample(2, i);
    ends.push(points.flat());
  }
  const near = (x: number, y: number): boolean => ends.some(([a = 0, b = 0, c = 0, d = 0]) => Math.hypot(a - x, b - y) < 6 || Math.hypot(c - x, d - y) < 6);
  assert.ok(near(40, 430) && near(130, 430), JSON.stringify(ends));
  await demo.byId("trace-mode").locator('[value="brightness"]').check();
  await demo.idle();
  assert.ok((await result(demo)).contours !== contours);
});
