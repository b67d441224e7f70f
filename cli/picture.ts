/** Pictures from PNG and JPEG files. */
import { Failure, INPUT } from "./failure.ts";
import { readBytes, sourceName } from "./files.ts";
import { readJpeg } from "./jpeg.ts";
import { upright } from "./orientation.ts";
import { readPng } from "./png.ts";

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Red, green, blue and opacity of every pixel. */
export interface Picture extends Size {
  readonly data: Uint8Array;
}

const MOST_SIDE = 16_384;
const MOST_PIXELS = 40_000_000;

/** How files begin; what is inside counts, whatever they are called. */
const BEGINNINGS: readonly (readonly [kind: string, beginning: RegExp])[] = [
  ["PNG", /^\x89PNG\r\n\x1a\n/],
  ["JPEG", /^\xff\xd8\xff/],
  ["GIF", /^GIF8/],
  ["WebP", /^RIFF.{4}WEBP/s],
  ["AVIF", /^.{4}ftypavi[fs]/s],
  ["HEIC", /^.{4}ftyp(?:hei|hev|mif1|msf1)/s],
  ["JPEG XL", /^(?:\xff\x0a|\0\0\0\x0cJXL )/],
  ["JPEG 2000", /^(?:\xff\x4f\xff\x51|\0\0\0\x0cjP {2})/],
  ["TIFF", /^(?:II\*\0|MM\0\*)/],
  ["BMP", /^BM.{4}\0{4}/s],
  ["Windows icon", /^\0\0\x01\0/],
  ["Photoshop", /^8BPS/],
  ["PDF", /^%PDF/],
  ["SVG", /^(?:\xef\xbb\xbf)?\s*<(?:svg|\?xml)/],
];

/** The most pixels of a picture, at four numbers of two bytes each, are little more. */
const MOST_MEGABYTES = 500;

/** The picture in a file, or in standard input for `-`. */
export function readPicture(file: string): Picture {
  const bytes = readBytes(file, MOST_MEGABYTES);
  const name = sourceName(file);
  if (bytes.length === 0) throw new Failure(INPUT, `${name}: it is empty`);
  const kind = kindOf(bytes);
  if (kind === undefined) throw new Failure(INPUT, `${name}: it is neither a PNG nor a JPEG`);
  if (kind !== "PNG" && kind !== "JPEG") throw new Failure(INPUT, `${name}: ${kind} is not read, only PNG and JPEG`);
  try {
    // Before anything is unpacked: a small file can hold a huge picture.
    const accept = (size: Size): void => checkSize(name, size);
    const { orientation, ...picture } = kind === "PNG" ? readPng(bytes, accept) : readJpeg(bytes, accept);
    return upright(picture, orientation);
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(INPUT, `${name}: this ${kind} cannot be read (${error instanceof Error ? error.message : String(error)})`);
  }
}

function kindOf(bytes: Uint8Array): string | undefined {
  const beginning = String.fromCharCode(...bytes.subarray(0, 64));
  return BEGINNINGS.find(([, magic]) => magic.test(beginning))?.[0];
}

function checkSize(name: string, { width, height }: Size): void {
  if (width > MOST_SIDE || height > MOST_SIDE || width * height > MOST_PIXELS) {
    throw new Failure(INPUT, `${name}: ${width} × ${height} pixels are too many; expected sides up to ${MOST_SIDE} and 40 megapixels`);
  }
  if (width < 1 || height < 1) throw new Failure(INPUT, `${name}: ${width} × ${height} pixels are none`);
}
