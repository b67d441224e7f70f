/** PNG files of every kind: zlib unpacks them, and what is left are rows and samples. */
import { crc32, inflateSync } from "node:zlib";

import { orientationIn } from "./orientation.ts";
import type { Picture, Size } from "./picture.ts";

interface Header extends Size {
  /** Bits of a sample. */
  readonly depth: number;
  readonly type: ColorType;
  readonly interlaced: boolean;
}

/** What a pixel says, as the format numbers it. */
const enum ColorType {
  Gray = 0,
  Color = 2,
  Palette = 3,
  GrayAlpha = 4,
  ColorAlpha = 6,
}

/** Samples of a pixel, and how many bits they may have. */
const KINDS: Readonly<Record<ColorType, { readonly channels: number; readonly depths: readonly number[] }>> = {
  [ColorType.Gray]: { channels: 1, depths: [1, 2, 4, 8, 16] },
  [ColorType.Color]: { channels: 3, depths: [8, 16] },
  [ColorType.Palette]: { channels: 1, depths: [1, 2, 4, 8] },
  [ColorType.GrayAlpha]: { channels: 2, depths: [8, 16] },
  [ColorType.ColorAlpha]: { channels: 4, depths: [8, 16] },
};

/** Where the seven parts of an interlaced picture begin, and how far their columns and rows are apart. */
const ADAM7 = [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]] as const;

/** The parts that a picture is made of. */
interface Chunks {
  readonly header: Header;
  readonly palette: Uint8Array | undefined;
  readonly transparency: Uint8Array | undefined;
  readonly orientation: number;
  readonly packed: readonly Uint8Array[];
}

/**
 * The picture of a PNG and how it is to be turned; `accept` throws where its size is too much, before anything is
 * unpacked.
 */
export function readPng(bytes: Uint8Array, accept: (size: Size) => void): Picture & { readonly orientation: number } {
  const chunks = chunksOf(bytes, accept);
  const { header, orientation, packed } = chunks;
  const { width, height, interlaced, depth, type } = header;
  const bits = depth * KINDS[type].channels;
  const parts = (interlaced ? ADAM7 : [[0, 0, 1, 1] as const]).map(([left, top, across, down]) => {
    const [columns, rows] = [Math.ceil((width - left) / across), Math.ceil((height - top) / down)];
    return { left, top, across, down, columns, rows: columns > 0 ? rows : 0, line: Math.ceil((columns * bits) / 8) };
  });
  const length = parts.reduce((sum, { rows, line }) => sum + rows * (line + 1), 0);
  const data = unpacked(packed, length);
  const pixels = new Uint8Array(4 * width * height);
  const paint = painter(chunks);
  let at = 0;
  for (const { left, top, across, down, columns, rows, line } of parts) {
    let above: Uint8Array = new Uint8Array(line);
    for (let row = 0; row < rows; row += 1, at += line + 1) {
      const bytesOfRow = data.subarray(at + 1, at + 1 + line);
      unfilter(data[at] ?? 0, bytesOfRow, above, Math.max(1, bits >> 3));
      paint(samplesOf(bytesOfRow, depth), columns, pixels, 4 * ((top + row * down) * width + left), 4 * across);
      above = bytesOfRow;
    }
  }
  return { data: pixels, width, height, orientation };
}

/** So many bytes of rows, and not many more: a small file can unpack to any length. */
function unpacked(packed: readonly Uint8Array[], length: number): Uint8Array {
  let data: Uint8Array;
  try {
    data = inflateSync(Buffer.concat(packed), { maxOutputLength: length + (1 << 16) });
  } catch (error) {
    const { code, message } = error as { code?: string; message: string };
    throw new Error(code === "ERR_BUFFER_TOO_LARGE" ? "it has more pixels than it says" : `it is damaged: ${message}`, { cause: error });
  }
  if (data.length < length) throw new Error("it has fewer pixels than it says");
  return data;
}

/** What is not needed for the pixels is skipped, sound or not: other programs show such a picture, too. */
function chunksOf(bytes: Uint8Array, accept: (size: Size) => void): Chunks {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const found = new Map<string, Uint8Array>();
  const packed: Uint8Array[] = [];
  let header: Header | undefined;
  for (let at = 8; ; ) {
    if (at + 12 > bytes.length) throw new Error("it ends too early");
    const length = view.getUint32(at);
    const name = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    const end = at + 8 + length;
    if (end + 4 > bytes.length) throw new Error("it ends too early");
    const content = bytes.subarray(at + 8, end);
    const needed = /^[A-Z]/.test(name);
    if (needed && crc32(bytes.subarray(at + 4, end)) !== view.getUint32(end)) throw new Error(`it is damaged: the checksum of ${JSON.stringify(name)} is wrong`);
    at = end + 4;
    if (header === undefined) {
      header = headerOf(name, content);
      accept(header);
    } else if (name === "IDAT") packed.push(content);
    else if (name === "IEND") break;
    else if (needed && name !== "PLTE") throw new Error(`it needs ${JSON.stringify(name)}, which is not of the standard`);
    else found.set(name, content);
  }
  const exif = found.get("eXIf");
  return { header, palette: found.get("PLTE"), transparency: found.get("tRNS"), orientation: exif === undefined ? 1 : orientationIn(exif), packed };
}

function headerOf(name: string, content: Uint8Array): Header {
  if (name !== "IHDR" || content.length !== 13) throw new Error("it does not begin with a header");
  const view = new DataView(content.buffer, content.byteOffset, content.length);
  const [depth = 0, type = 0, packing, filtering, interlacing = 0] = content.subarray(8);
  if (!Object.hasOwn(KINDS, type) || !KINDS[type as ColorType].depths.includes(depth)) throw new Error(`there is no kind ${type} of ${depth} bits`);
  if (packing !== 0 || filtering !== 0 || interlacing > 1) throw new Error("it is packed in a way that is not of the standard");
  return { width: view.getUint32(0), height: view.getUint32(4), depth, type, interlaced: interlacing === 1 };
}

/**
 * Adds to each byte of a row what the filter foretold of it; `left` bytes lie between a byte and that of the pixel
 * before.
 */
function unfilter(filter: number, row: Uint8Array, above: Uint8Array, left: number): void {
  if (filter > 4) throw new Error(`it is damaged: there is no filter ${filter}`);
  for (let i = 0; filter > 0 && i < row.length; i += 1) {
    const [before, up] = [i < left ? 0 : (row[i - left] ?? 0), above[i] ?? 0];
    const foretold = filter === 1 ? before : filter === 2 ? up : filter === 3 ? (before + up) >> 1 : paeth(before, up, i < left ? 0 : (above[i - left] ?? 0));
    row[i] = (row[i] ?? 0) + foretold;
  }
}

/** Of three neighbours the one that is nearest to what a plane through them has here. */
function paeth(before: number, up: number, corner: number): number {
  const [toBefore, toUp, toCorner] = [Math.abs(up - corner), Math.abs(before - corner), Math.abs(before + up - 2 * corner)];
  return toBefore <= toUp && toBefore <= toCorner ? before : toUp <= toCorner ? up : corner;
}

/** The numbers of a row. */
function samplesOf(row: Uint8Array, depth: number): Uint8Array | Uint16Array {
  if (depth === 8) return row;
  const samples = depth === 16 ? new Uint16Array(row.length >> 1) : new Uint8Array((8 / depth) * row.length);
  for (let i = 0, bit = 0; i < samples.length; i += 1, bit += depth) {
    const byte = row[bit >> 3] ?? 0;
    samples[i] = depth === 16 ? (byte << 8) | (row[2 * i + 1] ?? 0) : (byte >> (8 - depth - (bit & 7))) & (2 ** depth - 1);
  }
  return samples;
}

type Paint = (samples: Uint8Array | Uint16Array, columns: number, pixels: Uint8Array, at: number, step: number) => void;

/** How samples of a row become red, green, blue and opacity, `step` bytes apart. */
function painter({ header: { depth, type }, palette, transparency }: Chunks): Paint {
  const { channels } = KINDS[type];
  if (type === ColorType.Palette) return paletted(palette ?? new Uint8Array(0), transparency ?? new Uint8Array(0));
  const most = 2 ** depth - 1;
  const color = channels > 2 ? 1 : 0;
  const alpha = channels % 2 === 0 ? channels - 1 : undefined;
  const absent = alpha === undefined && transparency !== undefined ? samplesOf(transparency, 16) : undefined;
  return (samples, columns, pixels, at, step) => {
    const scaled = (i: number): number => (depth === 8 ? (samples[i] ?? 0) : Math.round(((samples[i] ?? 0) * 255) / most));
    for (let column = 0, i = 0, to = at; column < columns; column += 1, i += channels, to += step) {
      pixels[to] = scaled(i);
      pixels[to + 1] = scaled(i + color);
      pixels[to + 2] = scaled(i + 2 * color);
      // The one colour that is not there.
      const gone = absent?.[0] === samples[i] && (color === 0 || (absent?.[1] === samples[i + 1] && absent?.[2] === samples[i + 2]));
      pixels[to + 3] = alpha !== undefined ? scaled(i + alpha) : gone ? 0 : 255;
    }
  };
}

function paletted(palette: Uint8Array, opacities: Uint8Array): Paint {
  return (samples, columns, pixels, at, step) => {
    for (let column = 0, to = at; column < columns; column += 1, to += step) {
      const index = samples[column] ?? 0;
      const blue = palette[3 * index + 2];
      if (blue === undefined) throw new Error("a pixel has a colour that is not in its palette");
      pixels[to] = palette[3 * index] ?? 0;
      pixels[to + 1] = palette[3 * index + 1] ?? 0;
      pixels[to + 2] = blue;
      pixels[to + 3] = opacities[index] ?? 255;
    }
  };
}
