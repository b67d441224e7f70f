// Pictures that the command line reads: every kind is what other programs see in it, and what cannot be read is said in
// one line.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { deflateSync } from "node:zlib";
import { join } from "node:path";

import { encode as encodePng } from "fast-png";
import { decode as decodeJpeg, encode as encodeJpeg } from "jpeg-js";

import { PNG, expline, folder } from "./command-line.ts";
import { FOUR_INKS, PLAIN_COLORS, SHARED_COLORS } from "./jpeg-kinds.ts";
import { CHANNELS, type Kind, chunk, fileOf, header, pngOf } from "./png-kinds.ts";

const [WIDTH, HEIGHT] = [37, 29];

type Color = readonly [number, number, number, number];

/** Red, green, blue and opacity of each pixel, in a PNG of the plainest kind. */
function plain(width: number, height: number, color: (x: number, y: number) => Color): Uint8Array {
  const data = Uint8Array.from(Array.from({ length: width * height }, (_, i) => color(i % width, Math.floor(i / width))).flat());
  return encodePng({ width, height, channels: 4, data });
}

/** Each pair of pictures gives the same text. */
function same(name: string, pairs: readonly { readonly what: string; readonly read: Uint8Array; readonly seen: Uint8Array }[]): void {
  const place = join(folder, name);
  rmSync(place, { recursive: true, force: true });
  mkdirSync(place, { recursive: true });
  const files = pairs.flatMap(({ read, seen }, i) => {
    writeFileSync(join(place, `${i}-read`), read);
    writeFileSync(join(place, `${i}-seen`), seen);
    return [`${name}/${i}-read`, `${name}/${i}-seen`];
  });
  const { status, error } = expline(["trace", ...files, "--colors", "6", "-o", name]);
  assert.deepEqual([status, error], [0, ""]);
  const text = (file: string): string => readFileSync(join(place, `${file}.svg`), "utf8");
  pairs.forEach(({ what }, i) => {
    assert.match(text(`${i}-seen`), /<path/, `${what}: there is something in it`);
    assert.equal(text(`${i}-read`), text(`${i}-seen`), what);
  });
}

/** How much of a pixel a disc covers, in 255ths: shades of every size along its edge. */
function covered(x: number, y: number, radius = 10): number {
  const inside = radius + 0.5 - Math.hypot(x + 0.5 - 19.2, y + 0.5 - 13.7);
  return Math.round(255 * Math.max(0, Math.min(1, inside)));
}

const PALETTE = Array.from({ length: 256 }, (_, i) => [i, (i * 3) & 255, 255 - i] as const);

/**
 * The samples of a pixel of a kind, and what is to be seen there. Of 16 bits the lower ones round to another eight than
 * they leave when cut off.
 */
function pixel({ type, depth }: Pick<Kind, "type" | "depth">, x: number, y: number): { readonly samples: number[]; readonly color: Color } {
  const most = 2 ** depth - 1;
  const levels = [covered(x, y), covered(y, x), covered(x + 5, y), 255 - (covered(x, y - 4) >> 1)].map((level) => Math.round((level * Math.min(most, 255)) / 255));
  const samples = levels.slice(0, CHANNELS[type]).map((level) => (depth === 16 && level > 0 ? 257 * level - 120 : level));
  const [first = 0, second = 0, third = 0, fourth = 0] = levels.map((level) => Math.round((255 * level) / Math.min(most, 255)));
  const [index = 0] = samples;
  if (type === 3) return { samples, color: [...(PALETTE[index] ?? [0, 0, 0]), 255] };
  return { samples, color: type === 0 ? [first, first, first, 255] : type === 4 ? [first, first, first, second] : [first, second, third, type === 6 ? fourth : 255] };
}

const KINDS = ([[0, 1], [0, 2], [0, 4], [0, 8], [0, 16], [2, 8], [2, 16], [3, 1], [3, 2], [3, 4], [3, 8], [4, 8], [4, 16], [6, 8], [6, 16]] as const).map(([type, depth]) => ({ type, depth }));

/** A picture of a kind with what a palette needs, and what else is put beside its pixels. */
function pictured(kind: Pick<Kind, "type" | "depth">, interlaced: boolean, beside: readonly Uint8Array[] = []): Uint8Array {
  const palette = kind.type === 3 ? [chunk("PLTE", PALETTE.slice(0, 2 ** kind.depth).flat())] : [];
  return pngOf({ ...kind, width: WIDTH, height: HEIGHT, interlaced, sample: (x, y) => pixel(kind, x, y).samples, beside: [...palette, ...beside] });
}

test("PNG of all fifteen kinds, interlaced or not, are their pixels, in the nearest eight bits", () => {
  const pairs = KINDS.flatMap((kind) => [false, true].map((interlaced) => ({
    what: `kind ${kind.type} of ${kind.depth} bits${interlaced ? ", interlaced" : ""}`,
    read: pictured(kind, interlaced),
    seen: plain(WIDTH, HEIGHT, (x, y) => pixel(kind, x, y).color),
  })));
  same("kinds", pairs);
});

test("PNG whose palette has opacities, or with one colour that is not there, are seen through", () => {
  const pairs = KINDS.filter(({ type }) => type < 4).map((kind) => {
    const paper = pixel(kind, 0, 0);
    const gone = (x: number, y: number): boolean => pixel(kind, x, y).samples.every((value, i) => value === paper.samples[i]);
    const transparency = kind.type === 3 ? Array.from({ length: (paper.samples[0] ?? 0) + 1 }, () => 0) : paper.samples.flatMap((value) => [value >> 8, value & 255]);
    return {
      what: `kind ${kind.type} of ${kind.depth} bits`,
      read: pictured(kind, false, [chunk("tRNS", transparency)]),
      seen: plain(WIDTH, HEIGHT, (x, y) => (gone(x, y) ? [0, 0, 0, 0] : pixel(kind, x, y).color)),
    };
  });
  same("transparent", pairs);
});

test("what lies beside the pixels of a PNG does them no harm, sound or not", () => {
  const kind = { type: 2, depth: 8 } as const;
  const seen = plain(WIDTH, HEIGHT, (x, y) => pixel(kind, x, y).color);
  const text = new TextEncoder();
  const broken = Buffer.from(chunk("tIME", [7, 234, 1, 1, 0, 0, 0]));
  broken[broken.length - 1] = (broken[broken.length - 1] ?? 0) ^ 1;
  const pairs = ([
    ["a palette that is only suggested", [chunk("PLTE", PALETTE.flat())]],
    ["a profile that is none", [chunk("iCCP", text.encode("ICC\0\0no profile"))]],
    ["a text without a key", [chunk("tEXt", text.encode("\0made by hand"))]],
    ["a size in metres that is cut off", [chunk("pHYs", [1, 2, 3])]],
    ["brightness of another kind", [chunk("gAMA", [0, 1, 134, 160])]],
    ["a time with a wrong checksum", [broken]],
    ["something that is nobody's", [chunk("exPl", [1, 2, 3])]],
  ] as const).map(([what, beside]) => ({ what, read: pictured(kind, false, beside), seen }));
  same("beside", pairs);
});

/** Where the first row and the first column of a file are to be seen: the table of the Exif standard. */
const ORIENTATIONS = [["top", "left"], ["top", "right"], ["bottom", "right"], ["bottom", "left"], ["left", "top"], ["right", "top"], ["right", "bottom"], ["left", "bottom"]] as const;

/** Exif data that say one thing only, in either order of bytes. */
function exif(orientation: number, little: boolean): Uint8Array {
  const view = new DataView(new ArrayBuffer(26));
  view.setUint16(0, little ? 0x4949 : 0x4d4d);
  view.setUint16(2, 42, little);
  view.setUint32(4, 8, little);
  view.setUint16(8, 1, little);
  view.setUint16(10, 0x0112, little);
  view.setUint16(12, 3, little);
  view.setUint32(14, 1, little);
  view.setUint16(18, orientation, little);
  return new Uint8Array(view.buffer);
}

/** A JPEG with Exif data behind its first mark. */
const withExif = (jpeg: Uint8Array, data: Uint8Array): Uint8Array =>
  Buffer.concat([jpeg.subarray(0, 2), Uint8Array.of(0xff, 0xe1, 0, data.length + 8), new TextEncoder().encode("Exif\0\0"), data, jpeg.subarray(2)]);

test("Exif tells which way up a picture is, of JPEG and of PNG", () => {
  const shade = (x: number, y: number): number => 255 - covered(x, y, x > 19 ? 12 : 7);
  const data = Uint8Array.from({ length: 4 * WIDTH * HEIGHT }, (_, i) => (i % 4 === 3 ? 255 : shade((i >> 2) % WIDTH, Math.floor((i >> 2) / WIDTH))));
  const jpeg = encodeJpeg({ width: WIDTH, height: HEIGHT, data }, 90).data;
  const stored = decodeJpeg(jpeg, { useTArray: true }).data;
  const pairs = ORIENTATIONS.flatMap(([row, column], i) => {
    const [width, height] = row === "top" || row === "bottom" ? [WIDTH, HEIGHT] : [HEIGHT, WIDTH];
    const distance = (side: string, x: number, y: number): number => (side === "top" ? y : side === "bottom" ? height - 1 - y : side === "left" ? x : width - 1 - x);
    const at = (x: number, y: number): readonly [number, number] => [distance(column, x, y), distance(row, x, y)];
    const gray = (level: number): Color => [level, level, level, 255];
    const told = exif(i + 1, i % 2 === 0);
    return [
      { what: `JPEG, ${i + 1}`, read: withExif(jpeg, told), seen: plain(width, height, (x, y) => gray(stored[4 * (at(x, y)[1] * WIDTH + at(x, y)[0])] ?? 0)) },
      {
        what: `PNG, ${i + 1}`,
        read: pngOf({ width: WIDTH, height: HEIGHT, type: 0, depth: 8, sample: (x, y) => [shade(x, y)], beside: [chunk("eXIf", told)] }),
        seen: plain(width, height, (x, y) => gray(shade(...at(x, y)))),
      },
    ];
  });
  same("upright", pairs);
  const odd = [exif(9, true), exif(0, false), exif(6, true).subarray(0, 15), new Uint8Array(0), Uint8Array.from({ length: 12 }, () => 255)];
  const seen = plain(WIDTH, HEIGHT, (x, y) => [0, 1, 2].map(() => stored[4 * (y * WIDTH + x)] ?? 0).concat(255) as unknown as Color);
  same("odd", odd.map((told, i) => ({ what: `Exif that tells nothing, ${i}`, read: withExif(jpeg, told), seen })));
});

interface Traced {
  readonly layers: readonly { readonly color: string }[];
  readonly contours: readonly { readonly layer: number; readonly curve: { readonly points: readonly number[] } }[];
}

/** What a trace in colours finds. */
function traced(picture: Uint8Array, colors: string): Traced {
  const { status, out, error } = expline(["trace", "-", "--colors", colors, "--format", "json"], picture);
  assert.deepEqual([status, error], [0, ""]);
  return JSON.parse(out) as Traced;
}

test("colours that four pixels of a JPEG share are smooth between them: an edge that only they show is round", () => {
  const { contours } = traced(SHARED_COLORS, "#cc0000,#006800");
  const points = contours.filter(({ layer }) => layer === 1).flatMap(({ curve }) => curve.points);
  const far = points.flatMap((x, i) => (i % 2 === 0 ? [Math.abs(Math.hypot(x - 22.3, (points[i + 1] ?? 0) - 19.6) - 13.4)] : []));
  assert.ok(far.length > 0);
  // A sample is two pixels wide, and its weight is known to some hundredths; samples that are repeated give stairs of
  // up to 1.1.
  assert.ok(Math.max(...far) <= 0.35, `${Math.max(...far)} pixels away`);
});

test("JPEG kept as plain colours, or as inks, have the colours that were meant", () => {
  for (const [what, picture] of [["plain colours", PLAIN_COLORS], ["four inks", FOUR_INKS]] as const) {
    const colors = traced(picture, "2").layers.map(({ color }) => color);
    // What JPEG of that quality changes in flat colours.
    const near = (color: string | undefined, wanted: readonly number[]): boolean =>
      wanted.every((level, i) => Math.abs(Number.parseInt(color?.slice(1 + 2 * i, 3 + 2 * i) ?? "", 16) - level) <= 4);
    assert.ok(colors.length === 2 && near(colors[0], [255, 255, 255]) && near(colors[1], [204, 0, 0]), `${what}: ${colors.join(", ")}`);
  }
});

test("a JPEG that only does not say that it ends is read", () => {
  const jpeg = SHARED_COLORS;
  assert.deepEqual(traced(jpeg.subarray(0, -2), "3"), traced(jpeg, "3"));
});

/** The JPEG with another byte in its frame's header, so many behind the mark. */
function altered(at: number, ...bytes: readonly number[]): Uint8Array {
  const jpeg = Uint8Array.from(SHARED_COLORS);
  jpeg.set(bytes, jpeg.findIndex((byte, i) => byte === 0xff && jpeg[i + 1] === 0xc0) + at);
  return jpeg;
}

const ascii = (text: string): Uint8Array => Buffer.from(text.padEnd(40, "\0"), "latin1");
const wrongChecksum = Uint8Array.from(PNG);
wrongChecksum[45] = (wrongChecksum[45] ?? 0) ^ 1;

for (const [what, words, input] of [
  ["an empty file", /it is empty/, new Uint8Array(0)],
  ["a GIF", /GIF is not read, only PNG and JPEG/, ascii("GIF89a")],
  ["a WebP", /WebP is not read, only PNG and JPEG/, ascii("RIFF\x24\0\0\0WEBPVP8 ")],
  ["an AVIF", /AVIF is not read, only PNG and JPEG/, ascii("\0\0\0\x20ftypavif")],
  ["a HEIC", /HEIC is not read, only PNG and JPEG/, ascii("\0\0\0\x20ftypheic")],
  ["a TIFF", /TIFF is not read, only PNG and JPEG/, ascii("II*\0")],
  ["a BMP", /BMP is not read, only PNG and JPEG/, ascii("BM\x36\0\0\0")],
  ["an SVG", /SVG is not read, only PNG and JPEG/, ascii('<?xml version="1.0"?>\n<svg>')],
  ["something else", /it is neither a PNG nor a JPEG/, ascii("P6 2 2 255")],
  ["a PNG that ends in its header", /this PNG cannot be read \(it ends too early\)/, PNG.subarray(0, 20)],
  ["a PNG without its end", /this PNG cannot be read \(it ends too early\)/, PNG.subarray(0, -12)],
  ["a PNG with a bit turned", /this PNG cannot be read \(it is damaged: the checksum of "IDAT" is wrong\)/, wrongChecksum],
  ["a PNG with fewer rows than it says", /\(it has fewer pixels than it says\)/, fileOf(header(9, 9, 8, 0), chunk("IDAT", deflateSync(new Uint8Array(80))))],
  ["a small PNG that unpacks to a hundred megabytes", /\(it has more pixels than it says\)/, fileOf(header(9, 9, 8, 0), chunk("IDAT", deflateSync(new Uint8Array(1e8))))],
  ["a PNG of a kind that there is not", /\(there is no kind 3 of 16 bits\)/, fileOf(header(9, 9, 16, 3))],
  ["a PNG that needs what nobody knows", /\(it needs "CgBI", which is not of the standard\)/, fileOf(header(9, 9, 8, 0), chunk("CgBI", []))],
  ["a huge PNG", /4294967295 × 1 pixels are too many; expected sides up to 16384/, fileOf(header(0xffffffff, 1, 8, 0))],
  ["a PNG without rows", /9 × 0 pixels are none/, fileOf(header(9, 0, 8, 0))],
  ["half a JPEG", /this JPEG cannot be read \(it is damaged or cut off: [^\n]+\)/, SHARED_COLORS.subarray(0, 470)],
  ["half a progressive JPEG", /this JPEG cannot be read \(it is damaged or cut off: [^\n]+\)/, FOUR_INKS.subarray(0, -300)],
  ["the first bytes of a JPEG", /this JPEG cannot be read \(it ends too early\)/, SHARED_COLORS.subarray(0, 4)],
  ["a huge JPEG", /65000 × 65000 pixels are too many; expected sides up to 16384/, altered(5, 0xfd, 0xe8, 0xfd, 0xe8)],
  ["a JPEG of twelve bits", /\(it has 12 bits a sample; expected 8\)/, altered(4, 12)],
  ["a JPEG without losses", /\(it is coded in a way that few programs read: [^\n]+\)/, altered(1, 0xc3)],
] as const) {
  test(`${what}: status 1 and one clear line`, () => {
    const { status, out, error } = expline(["trace", "-"], input);
    assert.deepEqual([status, out], [1, ""]);
    assert.match(error, words);
    assert.match(error, /^expline: standard input: [^\n]+\n$/);
  });
}
