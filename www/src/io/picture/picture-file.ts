import { Problem } from "../../document/problem.ts";

/** A picture's size by its first bytes: a small file that claims to be huge is refused before anything decodes it. */

const mostBytes = 25_000_000;
const mostPixels = 40_000_000;
/** Sizes stand at the beginning; a photograph's notes about its camera come first in JPEG and AVIF. */
const headBytes = 512 * 1024;

/** @throws Problem for a picture that is too large. What its bytes do not tell is for the decoder to say. */
export async function checkPicture(file: Blob, name: string): Promise<void> {
  if (file.size > mostBytes) throw new Problem("image-big", { name, kilobytes: Math.round(file.size / 1000) });
  const size = headerSize(new DataView(await file.slice(0, headBytes).arrayBuffer()));
  if (size !== null && size[0] * size[1] > mostPixels) throw new Problem("image-big", { name, width: size[0], height: size[1] });
}

type Size = readonly [width: number, height: number];

/** Width and height of PNG, GIF, BMP, JPEG, WebP and AVIF; null for anything else, and for what is cut short. */
export function headerSize(data: DataView): Size | null {
  try {
    return readSize(data);
  } catch (error) {
    if (error instanceof RangeError) return null;
    throw error;
  }
}

function readSize(data: DataView): Size | null {
  if (data.byteLength < 16) return null;
  if (data.getUint32(0) === 0x89504e47) return [data.getUint32(16), data.getUint32(20)];
  if (data.getUint32(0) === 0x47494638) return [data.getUint16(6, true), data.getUint16(8, true)];
  if (data.getUint16(0) === 0x424d) return [Math.abs(data.getInt32(18, true)), Math.abs(data.getInt32(22, true))];
  if (data.getUint16(0) === 0xffd8) return jpegSize(data);
  if (data.getUint32(0) === 0x52494646 && data.getUint32(8) === 0x57454250) return webpSize(data);
  return data.getUint32(4) === 0x66747970 ? avifSize(data) : null;
}

/** Segments follow each other until the one that begins a frame. */
function jpegSize(data: DataView): Size | null {
  let at = 2;
  for (;;) {
    const marker = data.getUint16(at);
    const isFrame = marker >= 0xffc0 && marker <= 0xffcf && marker !== 0xffc4 && marker !== 0xffc8 && marker !== 0xffcc;
    if (isFrame) return [data.getUint16(at + 7), data.getUint16(at + 5)];
    if (marker < 0xff00) return null;
    // Bytes of filling may stand before a marker.
    at += marker === 0xffff ? 1 : 2 + data.getUint16(at + 2);
  }
}

function webpSize(data: DataView): Size | null {
  switch (data.getUint32(12)) {
    case 0x56503820:
      return [data.getUint16(26, true) & 0x3fff, data.getUint16(28, true) & 0x3fff];
    case 0x5650384c: {
      const bits = data.getUint32(21, true);
      return [(bits & 0x3fff) + 1, ((bits >>> 14) & 0x3fff) + 1];
    }
    case 0x56503858:
      return [(data.getUint32(24, true) & 0xffffff) + 1, (data.getUint32(26, true) >>> 8) + 1];
    default:
      return null;
  }
}

/** The first box that gives an extent. */
function avifSize(data: DataView): Size | null {
  for (let at = 8; at + 16 <= Math.min(data.byteLength, 65_536); at += 1) {
    if (data.getUint32(at) === 0x69737065) return [data.getUint32(at + 8), data.getUint32(at + 12)];
  }
  return null;
}
