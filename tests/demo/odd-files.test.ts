import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { useBrowser, type Demo } from "./page.ts";

/** Files that are broken, packed, or of kinds that browsers do not know. */

const { open } = useBrowser();

type Dropped = readonly [name: string, type: string, content: string | Uint8Array];

async function dropAll(demo: Demo, files: readonly Dropped[]): Promise<void> {
  const all = files.map(([name, type, content]) => [name, type, [...(typeof content === "string" ? new TextEncoder().encode(content) : content)]] as const);
  await demo.page.evaluate((given) => {
    const data = new DataTransfer();
    for (const [name, type, bytes] of given) data.items.add(new File([Uint8Array.from(bytes)], name, { type }));
    document.querySelector("canvas")?.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, all);
}

async function drop(demo: Demo, ...file: Dropped): Promise<void> {
  await dropAll(demo, [file]);
}

/** A black disc on white as a bitmap. */
function disc(radius: number): Uint8Array {
  const size = 128;
  const bytes = new Uint8Array(54 + 3 * size * size).fill(255, 54);
  const header = new DataView(bytes.buffer);
  header.setUint16(0, 0x424d);
  for (const [at, value] of [[2, bytes.length], [10, 54], [14, 40], [18, size], [22, size], [26, 0x180001]] as const) header.setUint32(at, value, true);
  for (let y = 0; y < size; y += 1) for (let x = 0; x < size; x += 1) if (Math.hypot(x - 64, y - 64) < radius) bytes.fill(0, 54 + 3 * (y * size + x), 57 + 3 * (y * size + x));
  return bytes;
}

/** What is said of it, by its id. */
async function refused(demo: Demo, id: string): Promise<string> {
  const error = demo.page.locator(`[data-testid="error"][data-error="${id}"]`);
  await error.waitFor();
  return (await error.textContent()) ?? "";
}

test("a list of points that breaks off, and a JSON file that does, are told about brackets and not about rows", async (t) => {
  const demo = await open(t);
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill("[[10, 20], [30");
  await demo.byId("import-apply").click();
  assert.match(await refused(demo, "points-list"), /JSON.*bracket/u);
  await demo.press("Escape");
  await demo.byId("import-dialog").waitFor({ state: "detached" });
  await drop(demo, "points.json", "application/json", "[1,2");
  assert.match(await refused(demo, "points-list"), /JSON.*bracket/u);
});

test("a packed SVG is unpacked, whatever it is called, and one that is broken or far too much is refused by what is wrong with it", async (t) => {
  const demo = await open(t);
  const packed = gzipSync('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h40v40h-40z"/></svg>');
  for (const [name, type] of [["logo.svgz", "image/svg+xml"], ["logo.svgz", ""], ["logo.svgz", "image/svg+xml-compressed"], ["logo.svg", "image/svg+xml"], ["logo.svg.gz", "application/gzip"]] as const) {
    await drop(demo, name, type, packed);
    await demo.until(() => demo.points(), ({ length }) => length === 4, `${name}, ${type}`);
    assert.deepEqual((await demo.points()).map(({ x, y }) => [x, y]), [[0, 0], [40, 0], [40, 40], [0, 40]]);
    await demo.click("btn-clear");
  }
  await drop(demo, "broken.svgz", "image/svg+xml", packed.subarray(0, 30));
  assert.match(await refused(demo, "file-type"), /broken\.svgz/u);
  await drop(demo, "bomb.svgz", "image/svg+xml", gzipSync(new Uint8Array(40 * 1024 * 1024)));
  await refused(demo, "svg-big");
  assert.equal((await demo.points()).length, 0);
});

test("a picture of a kind that this browser has no decoder for is not said to be incomplete", async (t) => {
  const demo = await open(t);
  await drop(demo, "photo.heic", "image/heic", Uint8Array.of(0, 0, 0, 24, 102, 116, 121, 112, 104, 101, 105, 99, 0, 0, 0, 0));
  assert.match(await refused(demo, "image-type"), /not a picture this browser can read \(photo\.heic\)/u);
  await drop(demo, "poster.psd", "image/vnd.adobe.photoshop", "8BPS\0\u0001\0\0\0\0\0\0\0\u0003\0\0");
  await demo.byId("error").filter({ hasText: "not a picture this browser can read (poster.psd)" }).waitFor();
  await drop(demo, "half.png", "image/png", Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 0));
  assert.match(await refused(demo, "image-broken"), /half\.png could not be decoded/u);
});

test("of several files every drawing is opened, then one picture, and the rest is said to have been left", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  // What was left is said before the picture is there; and is not taken away by it.
  await demo.page.context().route(/\/trace-worker-[^/]*\.js/u, (route) => void setTimeout(() => void route.continue(), 1000));
  const square = (x: number): string => `<svg xmlns="http://www.w3.org/2000/svg"><path d="M${x} 0h40v40h-40z"/></svg>`;
  await dropAll(demo, [["first.bmp", "image/bmp", disc(40)], ["a.svg", "image/svg+xml", square(0)], ["second.bmp", "image/bmp", disc(50)], ["b.svg", "image/svg+xml", square(60)]]);
  await demo.byId("trace-source").filter({ hasText: "first.bmp" }).waitFor();
  assert.match(await refused(demo, "files-left"), /1 file was not opened/u);
  assert.deepEqual((await demo.state()).curve.contours.map(({ points }) => points[0]?.x), [0, 60]);
  await demo.byId("tab-curve").click();
  await dropAll(demo, Array.from({ length: 23 }, (_, i) => [`${i}.svg`, "image/svg+xml", square(100 + 50 * i)] as const));
  await demo.byId("error").filter({ hasText: "3 files were not opened" }).waitFor();
  assert.equal((await demo.state()).curve.contours.length, 22);
});

const shore = [[13.37, 52.5], [13.4, 52.51], [13.45, 52.49], [13.37, 52.5]];
const map = JSON.stringify({
  type: "FeatureCollection",
  name: "L'Aquila (north)",
  features: [
    { type: "Feature", bbox: [13, 52, 14, 53], properties: { id: 3, heights: [1, 2, 3, 4] }, geometry: { type: "Polygon", coordinates: [shore] } },
    { type: "Feature", properties: null, geometry: { type: "Point", coordinates: [13.4, 52.5] } },
  ],
});

for (const type of ["application/geo+json", ""]) {
  test(`a map that is dropped as GeoJSON, of type ${JSON.stringify(type)}, comes in as its lines`, async (t) => {
    const demo = await open(t, "#/curve?sample=heart");
    await drop(demo, "lake.geojson", type, map);
    await demo.byId("toast").filter({ hasText: "one place on no line was left out" }).waitFor();
    const { contours } = (await demo.state()).curve;
    assert.deepEqual(contours.map(({ closed, points }) => [closed, points.map(({ x, y }) => [x, y])]), [[true, shore.slice(0, 3)]]);
  });
}
