import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { useBrowser, type Demo } from "./page.ts";

/** Files that are broken, packed, or of kinds that browsers do not know. */

const { open } = useBrowser();

async function drop(demo: Demo, name: string, type: string, content: string | Uint8Array): Promise<void> {
  const bytes = [...(typeof content === "string" ? new TextEncoder().encode(content) : content)];
  await demo.page.evaluate(([fileName, fileType, all]) => {
    const data = new DataTransfer();
    data.items.add(new File([Uint8Array.from(all)], fileName, { type: fileType }));
    document.querySelector("canvas")?.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, [name, type, bytes] as const);
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
});
