/** Pictures from PNG and JPEG files. */
import { type DecodedPng, decode as decodePng } from "fast-png";
import { decode as decodeJpeg } from "jpeg-js";

import { Failure, INPUT } from "./failure.ts";
import { readBytes, sourceName } from "./files.ts";

/** Red, green, blue and opacity of every pixel. */
export interface Picture {
  readonly data: Uint8Array;
  readonly width: number;
  readonly height: number;
}

const MOST_SIDE = 16_384;
const MOST_PIXELS = 40_000_000;

/** The picture in a file, or in standard input for `-`. */
export function readPicture(file: string): Picture {
  const bytes = readBytes(file);
  const name = sourceName(file);
  const kind = kindOf(bytes);
  if (kind === undefined) throw new Failure(INPUT, `${name}: it is neither a PNG nor a JPEG`);
  // Before anything is unpacked: a small file can hold a huge picture.
  const size = kind === "PNG" ? sizeOfPng(bytes) : undefined;
  if (size !== undefined) checkSize(name, size);
  try {
    const picture = kind === "PNG" ? fromPng(decodePng(bytes)) : fromJpeg(bytes);
    checkSize(name, picture);
    return picture;
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(INPUT, `${name}: this ${kind} cannot be read (${error instanceof Error ? error.message : String(error)})`);
  }
}

function kindOf(bytes: Uint8Array): "PNG" | "JPEG" | undefined {
  const starts = (...magic: number[]): boolean => magic.every((byte, i) => bytes[i] === byte);
  if (starts(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a)) return "PNG";
  return starts(0xff, 0xd8, 0xff) ? "JPEG" : undefined;
}

/** What the first chunk of a PNG says. */
function sizeOfPng(bytes: Uint8Array): { width: number; height: number } | undefined {
  if (bytes.length < 24) return undefined;
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return { width: view.getUint32(16), height: view.getUint32(20) };
}

function checkSize(name: string, { width, height }: { width: number; height: number }): void {
  if (width > MOST_SIDE || height > MOST_SIDE || width * height > MOST_PIXELS) {
    throw new Failure(INPUT, `${name}: ${width} × ${height} pixels are too many; expected sides up to ${MOST_SIDE} and 40 megapixels`);
  }
}

function fromJpeg(bytes: Uint8Array): Picture {
  const { data, width, height } = decodeJpeg(bytes, { useTArray: true, formatAsRGBA: true, maxResolutionInMP: MOST_PIXELS / 1e6, maxMemoryUsageInMB: 2048 });
  return { data, width, height };
}

/** Samples of any depth, gray or colour, by palette or not, as four bytes a pixel. */
function fromPng({ data, width, height, depth, channels, palette, transparency = new Uint16Array(0) }: DecodedPng): Picture {
  if (depth === 8 && channels === 4) return { data: Uint8Array.from(data), width, height };
  const pixels = new Uint8Array(4 * width * height);
  const line = Math.ceil((width * channels * depth) / 8);
  const most = 2 ** depth - 1;
  const sample = (row: number, i: number): number => {
    if (depth >= 8) return data[row * width * channels + i] ?? 0;
    const bit = i * depth;
    return ((data[row * line + (bit >> 3)] ?? 0) >> (8 - depth - (bit & 7))) & most;
  };
  for (let row = 0, at = 0; row < height; row += 1) {
    for (let i = 0; i < width * channels; i += channels, at += 4) {
      const first = sample(row, i);
      if (palette !== undefined) {
        pixels.set(entry(palette[first]), at);
        continue;
      }
      const [second, third] = channels > 2 ? [sample(row, i + 1), sample(row, i + 2)] : [first, first];
      // The one colour that is not there.
      const absent = first === transparency[0] && (channels < 3 || (second === transparency[1] && third === transparency[2]));
      pixels[at] = (first * 255) / most;
      pixels[at + 1] = (second * 255) / most;
      pixels[at + 2] = (third * 255) / most;
      pixels[at + 3] = channels % 2 === 0 ? (sample(row, i + channels - 1) * 255) / most : absent ? 0 : 255;
    }
  }
  return { data: pixels, width, height };
}

/** A colour of a palette. */
function entry(colour: readonly number[] | undefined): number[] {
  if (colour === undefined) throw new Error("a pixel has a colour that is not in its palette");
  const [red = 0, green = 0, blue = 0, opacity = 255] = colour;
  return [red, green, blue, opacity];
}
