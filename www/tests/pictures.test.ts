import assert from "node:assert/strict";
import { test } from "node:test";
import { Problem } from "../src/document/problem.ts";
import { traceSample, traceSamples } from "../src/document/trace/trace-samples.ts";
import { checkPicture, headerSize } from "../src/io/picture/picture-file.ts";
import { pngPaths } from "../src/io/picture/png.ts";
import { writeSvg } from "../src/io/svg/svg-write.ts";
import { pixelsOf } from "../src/kernel/trace/picture.ts";
import { hasFlatColors } from "../src/kernel/trace/pixels/flat-colors.ts";
import { coverage, drawSample } from "../src/kernel/trace/raster.ts";
import { blurred, foundThreshold, inkOf, pieceAreas, shadesOf, steepness } from "../src/kernel/trace/pixels/shades.ts";

const sum = (values: Float32Array): number => values.reduce((all, value) => all + value, 0);

const circle = (x: number, y: number, radius: number, backwards = false): Float64Array => {
  const count = 4000;
  return Float64Array.from({ length: 2 * count }, (_, i) => {
    const turn = ((backwards ? -1 : 1) * 2 * Math.PI * Math.floor(i / 2)) / count;
    return i % 2 === 0 ? x + radius * Math.cos(turn) : y + radius * Math.sin(turn);
  });
};

test("coverage is area: of a rectangle in every pixel, of a disc in all", () => {
  const rectangle = Float64Array.of(1.25, 0.5, 3.75, 0.5, 3.75, 2.5, 1.25, 2.5);
  const wanted = [0, 0.375, 0.5, 0.375, 0, 0, 0.75, 1, 0.75, 0, 0, 0.375, 0.5, 0.375, 0];
  coverage([rectangle], 5, 3, 1).forEach((share, i) => assert.ok(Math.abs(share - (wanted[i] ?? 0)) < 1e-6, `pixel ${i}: ${share}`));
  const disc = coverage([circle(32.3, 31.8, 20.4)], 64, 64, 1);
  assert.ok(Math.abs(sum(disc) - Math.PI * 20.4 ** 2) < 0.01, String(sum(disc)));
  // A slanted edge leaves half of the pixel it halves.
  const triangle = coverage([Float64Array.of(0, 0, 1, 1, 0, 1)], 1, 1, 1);
  assert.ok(Math.abs((triangle[0] ?? 0) - 0.5) < 1e-6);
});

test("a hole takes away what it encloses, and the scale scales", () => {
  const ring = coverage([circle(64, 64, 40), circle(64, 64, 20, true)], 64, 64, 0.5);
  assert.ok(Math.abs(sum(ring) - Math.PI * (400 - 100)) < 0.02, String(sum(ring)));
  // Sums of single precision.
  assert.ok((ring[32 * 64 + 32] ?? 1) < 1e-6);
});

test("outlines beyond the picture are cut at its sides, whatever their way", () => {
  const inside = coverage([circle(0, 0, 10), circle(20, 30, 4)], 20, 30, 1);
  assert.ok(Math.abs(sum(inside) - (Math.PI * 100) / 4 - (Math.PI * 16) / 4) < 0.01, String(sum(inside)));
});

test("samples are the same whenever they are drawn, and never larger than they are", () => {
  for (const sample of traceSamples) {
    const small = drawSample(sample, 128);
    assert.deepEqual(drawSample(sample, 128), small);
    assert.ok(small.width <= 128 && small.height <= 128);
    const dark = small.data.reduce((count, shade) => count + (shade < 100 ? 1 : 0), 0) / small.data.length;
    assert.ok(dark > 0.005 && dark < 0.6, `${sample.id}: ${dark} is dark`);
  }
  const tiny = traceSample("trace-small");
  assert.ok(tiny !== undefined);
  assert.equal(drawSample(tiny, 1024).width, 48);
});

test("the disc's pixels tell its radius, and the sheet has more than 400 shapes", () => {
  const disc = traceSample("trace-disc");
  const sheet = traceSample("trace-big");
  assert.ok(disc !== undefined && sheet !== undefined);
  const { data: gray } = drawSample(disc, 1024);
  const ink = gray.reduce((all, shade) => all + (255 - shade) / 255, 0);
  assert.ok(Math.abs(Math.sqrt(ink / Math.PI) - 160) < 0.01, String(Math.sqrt(ink / Math.PI)));
  const { data: shades, width, height } = drawSample(sheet, 1024);
  const pieces = pieceAreas(inkOf({ values: shades, columns: width, rows: height }, 128, false), width, height);
  assert.ok(pieces.length > 400 && pieces.length < 1500, `${pieces.length} pieces`);
});

test("shades are the luma of Rec. 709, and what is transparent is paper under either kind of ink", () => {
  const pixels = (...bytes: number[]): Parameters<typeof shadesOf>[0] => ({ width: bytes.length / 4, height: 1, columns: bytes.length / 4, rows: 1, data: Uint8ClampedArray.from(bytes) });
  assert.deepEqual([...shadesOf(pixels(255, 0, 0, 255, 0, 255, 0, 255, 255, 255, 255, 255)).values], [54, 182, 255]);
  assert.deepEqual([...shadesOf(pixels(0, 0, 0, 255, 0, 0, 0, 0)).values], [0, 255]);
  assert.deepEqual([...shadesOf(pixels(255, 255, 255, 255, 0, 0, 0, 0)).values], [255, 0]);
  const isLight = (...bytes: number[]): boolean | undefined => shadesOf(pixels(...bytes)).lightOnNothing;
  assert.equal(isLight(255, 255, 255, 255, 0, 0, 0, 0), true, "a white drawing on nothing is the ink");
  assert.equal(isLight(0, 0, 0, 255, 0, 0, 0, 0), false, "a black one is so anyway");
  assert.equal(isLight(255, 255, 255, 255, 250, 250, 250, 255), false, "paper is no drawing");
  const page = [255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 0];
  assert.equal(isLight(...page), false, "nor is a page with ink on it");
  assert.equal(shadesOf(pixels(...page)).values.at(-1), 255, "and what is clear of it is no ink");
  assert.equal(shadesOf(pixels(...page), true).values.at(-1), 0, "nor is it where light ink is asked for");
});

test("the threshold is half-way between ink and paper, however little of either there is", () => {
  const values = new Uint8Array(10_000).fill(220);
  values.fill(40, 0, 300);
  assert.equal(foundThreshold({ values, columns: 100, rows: 100 }), 130);
  assert.ok(Number.isFinite(foundThreshold({ values: new Uint8Array(4), columns: 2, rows: 2 })));
});

test("pieces are counted across rows, and joined where they meet further down", () => {
  const rows = ["#.#.", "#.#.", "###.", "...#"];
  const ink = Uint8Array.from([...rows.join("")].map((sign) => (sign === "#" ? 1 : 0)));
  // The U, the place within it, the paper on the right, the dot, and the paper below.
  assert.deepEqual([...pieceAreas(ink, 4, 4)], [7, 3, 3, 2, 1]);
  const checks = Uint8Array.from({ length: 64 }, (_, i) => (i + Math.floor(i / 8)) % 2);
  assert.equal(pieceAreas(checks, 8, 8).length, 64);
});

test("a blur keeps what is flat and the mean, and steepness is nothing where nothing changes", () => {
  const flat = { values: new Uint8Array(400).fill(77), columns: 20, rows: 20 };
  assert.deepEqual(blurred(flat, 2).values, flat.values);
  assert.ok(steepness(flat).every((value) => value === 0));
  const edge = { values: Uint8Array.from({ length: 400 }, (_, i) => (i % 20 < 10 ? 0 : 200)), columns: 20, rows: 20 };
  const soft = blurred(edge, 2).values;
  assert.ok((soft[209] ?? 0) > 40 && (soft[210] ?? 0) < 160, `${soft[209]} ${soft[210]}`);
  assert.equal(steepness(edge)[209], 200);
});

function bytes(...parts: (string | number[])[]): DataView {
  const all = parts.flatMap((part) => (typeof part === "string" ? [...part].map((sign) => sign.charCodeAt(0)) : part));
  return new DataView(Uint8Array.from([...all, ...new Array<number>(Math.max(0, 32 - all.length)).fill(0)]).buffer);
}

test("a picture's size is read from its first bytes, whatever its kind", () => {
  const png = bytes([0x89], "PNG\r\n\u001a\n", [0, 0, 0, 13], "IHDR", [0, 0, 0x75, 0x30, 0, 0, 0x01, 0x00]);
  assert.deepEqual(headerSize(png), [30_000, 256]);
  assert.deepEqual(headerSize(bytes("GIF89a", [0x40, 0x01, 0xc8, 0x00])), [320, 200]);
  assert.deepEqual(headerSize(bytes("BM", new Array<number>(16).fill(0), [10, 0, 0, 0, 0xf6, 0xff, 0xff, 0xff])), [10, 10]);
  assert.deepEqual(headerSize(bytes([0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xc2, 0, 11, 8, 0x01, 0x02, 0x03, 0x04])), [0x304, 0x102]);
  assert.deepEqual(headerSize(bytes("RIFF", [0, 0, 0, 0], "WEBPVP8X", [10, 0, 0, 0, 0, 0, 0, 0, 0x0f, 0x27, 0, 0x1f, 0x4e, 0])), [10_000, 20_000]);
  assert.deepEqual(headerSize(bytes([0, 0, 0, 16], "ftypavif", [0, 0, 0, 0, 0, 0, 0, 20], "ispe", [0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 3, 0])), [1024, 768]);
  for (const short of [bytes("hello"), bytes([0xff, 0xd8, 0xff, 0xe0, 0xff, 0xff]), new DataView(new ArrayBuffer(3))]) assert.equal(headerSize(short), null);
});

test("DM-020 a small file that claims 900 megapixels is refused before anything decodes it", async () => {
  const bomb = bytes([0x89], "PNG\r\n\u001a\n", [0, 0, 0, 13], "IHDR", [0, 0, 0x75, 0x30, 0, 0, 0x75, 0x30]);
  await assert.rejects(checkPicture(new Blob([bomb.buffer as ArrayBuffer]), "bomb.png"), (error: unknown) => {
    assert.ok(error instanceof Problem);
    assert.equal(error.id, "image-big");
    assert.deepEqual(error.details, { name: "bomb.png", width: 30_000, height: 30_000 });
    return true;
  });
  await checkPicture(new Blob(["no picture at all"]), "text.png");
});

/** A browser whose canvas gives back what it is told to. */
async function readThrough(columns: number, rows: number, byte: number): Promise<Awaited<ReturnType<typeof pixelsOf>>> {
  const before = [Reflect.get(globalThis, "createImageBitmap"), Reflect.get(globalThis, "OffscreenCanvas")] as const;
  class Canvas {
    constructor(readonly width: number, readonly height: number) {}
    getContext(): object {
      return { drawImage: () => undefined, getImageData: () => ({ data: new Uint8ClampedArray(4 * this.width * this.height).fill(byte) }) };
    }
  }
  Reflect.set(globalThis, "createImageBitmap", () => Promise.resolve({ width: columns, height: rows, close: () => undefined }));
  Reflect.set(globalThis, "OffscreenCanvas", Canvas);
  try {
    return await pixelsOf({ kind: "file", key: "1", content: new Blob([]) }, 2048);
  } finally {
    Reflect.set(globalThis, "createImageBitmap", before[0]);
    Reflect.set(globalThis, "OffscreenCanvas", before[1]);
  }
}

test("DM-026 a canvas that gives back nothing at all, as some do beyond an area, is no black picture but an error", async () => {
  await assert.rejects(readThrough(1200, 1000, 0), { name: "PictureError", code: "E_BLANK" });
  assert.equal((await readThrough(1200, 1000, 255)).columns, 1200);
  // So small a canvas is read everywhere: a black and clear picture is what it is.
  assert.equal((await readThrough(120, 100, 0)).data.length, 48_000);
});

test("coverage by the even-odd rule leaves out what is inside twice, whichever way its outline turns", () => {
  for (const backwards of [false, true]) {
    const ring = coverage([circle(32.3, 31.8, 20.4), circle(32.3, 31.8, 11.7, backwards)], 64, 64, 1, "evenodd");
    // Pixels that are cut by no edge are exact; those that are, are so for a share of one outline and not of two.
    assert.ok(Math.abs(sum(ring) - Math.PI * (20.4 ** 2 - 11.7 ** 2)) < 0.05, String(sum(ring)));
    assert.ok((ring[32 * 64 + 32] ?? 1) < 1e-6);
  }
});

test("a picture of a trace has the colours, the areas and the lines of its SVG, whatever the theme", () => {
  const layers = [{ color: "#102030", d: "M0 0H9V9Z" }, { color: "#a0b0c0", d: "M1 1H5V5Z" }];
  for (const look of [{ layers }, { filled: true }, { filled: false }]) {
    const file = { d: "M0 0H9V9H0Z", box: null, ...look };
    const svg = writeSvg({ title: "", ...file });
    const inSvg = [...svg.matchAll(/<path d="([^"]+)" fill="([^"]+)"(?: fill-rule="(\w+)")?(?: stroke="([^"]+)")?/gu)]
      .map(([, d, fill, rule = "nonzero", stroke]) => ({ d, ...(fill === "none" ? {} : { fill: { color: fill, alpha: 1, rule } }), ...(stroke === undefined ? {} : { stroke }) }));
    assert.deepEqual(pngPaths({ ...file, scale: 1, paper: null }), inSvg, svg);
  }
});

test("a drawing in several flat colours is known from ink on paper, gray tones, gradients and grain", () => {
  const side = 64;
  const picture = (colorAt: (x: number, y: number) => readonly number[]): Parameters<typeof hasFlatColors>[0] => ({
    width: side, height: side, columns: side, rows: side,
    data: Uint8ClampedArray.from(Array.from({ length: side * side }, (_, i) => {
      const [red = 0, green = 0, blue = 0, opacity = 255] = colorAt(i % side, Math.floor(i / side));
      return [red, green, blue, opacity];
    }).flat()),
  });
  const bars = (...colors: readonly (readonly number[])[]) => picture((x) => colors[Math.floor((x * colors.length) / side)] ?? []);
  const grain = (x: number, y: number): number => ((x * 7919 + y * 104_729) % 97) / 97;
  const [white, black, red, blue, yellow] = [[255, 255, 255], [20, 20, 20], [230, 57, 70], [69, 123, 157], [241, 196, 15]];
  assert.ok(hasFlatColors(bars(white, red, blue, yellow)));
  assert.ok(hasFlatColors(bars([0, 0, 0, 0], yellow, black)), "on nothing, which counts as a colour");
  assert.ok(hasFlatColors(picture((x, y) => (x < 20 ? white : x < 40 ? red : blue).map((value) => value + 5 * (grain(x, y) - 0.5)))), "as compression leaves it");
  assert.ok(!hasFlatColors(bars(white, red)), "one ink on paper");
  assert.ok(!hasFlatColors(bars(white, [128, 128, 128], black)), "grays");
  assert.ok(!hasFlatColors(picture((x) => [255 - 4 * x, 0, 4 * x])), "a gradient");
  assert.ok(!hasFlatColors(picture((x, y) => [255 * grain(x, y), 255 * grain(y, x), 255 * grain(x + 3, y)])), "grain");
  assert.ok(!hasFlatColors({ width: 2, height: 1, columns: 2, rows: 1, data: Uint8Array.of(0, 255) }), "shades alone");
});
