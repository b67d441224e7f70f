/** JPEG files: a library unpacks their samples; what these mean is said before them. */
import { decode } from "jpeg-js";

import { type Sampling, colorsOf } from "./chroma.ts";
import { orientationIn } from "./orientation.ts";
import type { Picture, Size } from "./picture.ts";

/** What is said before the pixels. */
interface Header {
  readonly frame: Frame;
  readonly orientation: number;
  readonly jfif: boolean;
  /** How Adobe's programs say that colours are kept; undefined where they say nothing. */
  readonly adobe: number | undefined;
  /** Whether the first scan is all of the picture. */
  readonly atOnce: boolean;
}

interface Frame extends Size {
  readonly progressive: boolean;
  /** What its channels are called. */
  readonly names: string;
  readonly sampling: readonly Sampling[];
}

const enum Mark {
  FirstFrame = 0xc0,
  Progressive = 0xc2,
  LastFrame = 0xcf,
  End = 0xd9,
  Scan = 0xda,
  Jfif = 0xe0,
  Exif = 0xe1,
  Adobe = 0xee,
}

/** Marks among those of frames that are of tables. */
const TABLES = [0xc4, 0xc8, 0xcc];

/** "Adobe", a version, four bytes of flags, and no transformation. */
const INKS = Uint8Array.of(0xff, 0xd8, 0xff, Mark.Adobe, 0, 14, 0x41, 0x64, 0x6f, 0x62, 0x65, 0, 100, 0, 0, 0, 0, 0);

/** More than 40 megapixels need: 22 bytes each. */
const MOST_MEMORY_MB = 2048;

/**
 * The picture of a JPEG and how it is to be turned; `accept` throws where its size is too much, before anything is
 * unpacked.
 */
export function readJpeg(bytes: Uint8Array, accept: (size: Size) => void): Picture & { readonly orientation: number } {
  const { frame, orientation, jfif, adobe, atOnce } = headerOf(bytes);
  accept(frame);
  const colors = frame.sampling.length === 3;
  // Four channels that nobody explains are what Adobe's programs write: other programs assume it, and the library wants
  // to be told.
  const told = frame.sampling.length === 4 && adobe === undefined ? [INKS, bytes.subarray(2)] : [bytes];
  // Nothing is missing of a picture that is there at once and only does not say that it ends.
  if (atOnce) told.push(Uint8Array.of(0xff, Mark.End));
  const limits = { maxResolutionInMP: Infinity, maxMemoryUsageInMB: MOST_MEMORY_MB };
  try {
    const picture = decode(Buffer.concat(told), { useTArray: true, formatAsRGBA: true, ...(colors ? { colorTransform: false } : {}), ...limits });
    const { data, width, height } = picture;
    const direct = !jfif && (adobe === undefined ? frame.names === "RGB" : adobe === 0);
    if (colors && !direct) colorsOf(data, width, height, frame.sampling);
    return { data, width, height, orientation };
  } catch (error) {
    throw new Error(`it is damaged or cut off: ${error instanceof Error ? error.message : String(error)}`, { cause: error });
  }
}

function headerOf(bytes: Uint8Array): Header {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  let [frame, adobe, orientation, jfif]: [Frame | undefined, number | undefined, number, boolean] = [undefined, undefined, 1, false];
  for (let at = 2; ; ) {
    while (at < bytes.length && !(bytes[at] === 0xff && isMark(bytes[at + 1]))) at += 1;
    if (at + 4 > bytes.length) throw new Error("it ends too early");
    const mark = bytes[at + 1] ?? 0;
    const end = at + 2 + view.getUint16(at + 2);
    if (end > bytes.length) throw new Error("it ends too early");
    const content = bytes.subarray(at + 4, end);
    if (mark === Mark.Scan) {
      if (frame === undefined) throw new Error("its pixels come before their size");
      return { frame, orientation, jfif, adobe, atOnce: !frame.progressive && content[0] === frame.sampling.length };
    }
    if (mark >= Mark.FirstFrame && mark <= Mark.LastFrame && !TABLES.includes(mark)) frame = frameOf(mark, content);
    else if (mark === Mark.Jfif && begins(content, "JFIF\0")) jfif = true;
    else if (mark === Mark.Exif && begins(content, "Exif\0\0")) orientation = orientationIn(content.subarray(6));
    else if (mark === Mark.Adobe && begins(content, "Adobe")) adobe = content[11];
    at = end;
  }
}

/** Whether something of a length follows: neither filling, nor one of the marks that stand alone. */
const isMark = (byte = 0): boolean => byte >= 0xc0 && byte < 0xff && !(byte >= 0xd0 && byte <= Mark.End);

const begins = (content: Uint8Array, text: string): boolean => String.fromCharCode(...content.subarray(0, text.length)) === text;

function frameOf(mark: number, content: Uint8Array): Frame {
  const [depth = 0, high = 0, low = 0, left = 0, right = 0, count = 0, ...channels] = content;
  if (mark > Mark.Progressive) throw new Error("it is coded in a way that few programs read: losslessly, by arithmetic or in steps");
  if (depth !== 8) throw new Error(`it has ${depth} bits a sample; expected 8`);
  const factors = Array.from({ length: count }, (_, i) => [(channels[3 * i + 1] ?? 0) >> 4, (channels[3 * i + 1] ?? 0) & 15] as const);
  const most = [0, 1].map((k) => Math.max(...factors.map((each) => each[k] ?? 0)));
  return {
    width: 256 * left + right,
    height: 256 * high + low,
    progressive: mark === Mark.Progressive,
    names: String.fromCharCode(...Array.from({ length: count }, (_, i) => channels[3 * i] ?? 0)),
    sampling: factors.map(([across, down]) => ({ across: (most[0] ?? 1) / across, down: (most[1] ?? 1) / down })),
  };
}
