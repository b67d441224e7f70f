// PNG files of every kind: rows of samples as the format keeps them, interlaced or not, and whatever else is put beside
// them.

import { crc32, deflateSync } from "node:zlib";

/** Samples of a pixel of each kind. */
export const CHANNELS = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 } as const;

export interface Kind {
  readonly width: number;
  readonly height: number;
  /** As the format numbers it: 0 gray, 2 colour, 3 palette, 4 and 6 those with opacity. */
  readonly type: keyof typeof CHANNELS;
  readonly depth: number;
  readonly interlaced?: boolean;
  readonly sample: (x: number, y: number) => readonly number[];
  /** Chunks between the header and the pixels. */
  readonly beside?: readonly Uint8Array[];
}

/** A part of a file, with its length and checksum. */
export function chunk(name: string, content: Iterable<number>): Uint8Array {
  const data = Buffer.from([...content]);
  const named = Buffer.concat([Buffer.from(name, "latin1"), data]);
  const ends = Buffer.alloc(8);
  ends.writeUInt32BE(data.length);
  ends.writeUInt32BE(crc32(named), 4);
  return Buffer.concat([ends.subarray(0, 4), named, ends.subarray(4)]);
}

export const header = (width: number, height: number, depth: number, type: number, interlaced = false): Uint8Array =>
  chunk("IHDR", [...[width, height].flatMap((n) => [n >>> 24, (n >> 16) & 255, (n >> 8) & 255, n & 255]), depth, type, 0, 0, interlaced ? 1 : 0]);

/** A file of these chunks. */
export const fileOf = (...chunks: readonly Uint8Array[]): Uint8Array => Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), ...chunks, chunk("IEND", [])]);

/**
 * Which of the seven parts of an interlaced picture each pixel of a block of 8 by 8 belongs to: the table of the
 * standard.
 */
const PARTS = ["16462646", "77777777", "56565656", "77777777", "36463646", "77777777", "56565656", "77777777"];

/** A file of pixels; its rows use all five filters in turn. */
export function pngOf({ width, height, type, depth, interlaced = false, sample, beside = [] }: Kind): Uint8Array {
  const rows: Uint8Array[] = [];
  for (const part of interlaced ? "1234567" : " ") {
    let above: Uint8Array | undefined;
    for (let y = 0; y < height; y += 1) {
      const columns = Array.from({ length: width }, (_, x) => x).filter((x) => !interlaced || PARTS[y % 8]?.[x % 8] === part);
      if (columns.length === 0) continue;
      const row = packed(columns.flatMap((x) => [...sample(x, y)]), depth);
      rows.push(filtered(row, above, Math.max(1, (CHANNELS[type] * depth) / 8), rows.length % 5));
      above = row;
    }
  }
  const pixels = deflateSync(Buffer.concat(rows));
  const middle = pixels.length >> 1;
  return fileOf(header(width, height, depth, type, interlaced), ...beside, chunk("IDAT", pixels.subarray(0, middle)), chunk("IDAT", pixels.subarray(middle)));
}

/** Samples as bits, the highest first. */
function packed(samples: readonly number[], depth: number): Uint8Array {
  const bits = samples.map((value) => value.toString(2).padStart(depth, "0")).join("");
  return Uint8Array.from({ length: Math.ceil(bits.length / 8) }, (_, i) => Number.parseInt(bits.slice(8 * i, 8 * i + 8).padEnd(8, "0"), 2));
}

/** What is left of a row where a filter has taken away what it foretells. */
function filtered(row: Uint8Array, above: Uint8Array | undefined, left: number, filter: number): Uint8Array {
  return Uint8Array.from([filter, ...row.map((value, i) => {
    const [a, b, c] = [row[i - left] ?? 0, above?.[i] ?? 0, above?.[i - left] ?? 0];
    const nearest = [a, b, c].reduce((best, each) => (Math.abs(a + b - c - each) < Math.abs(a + b - c - best) ? each : best), a);
    return value - ([0, a, b, Math.floor((a + b) / 2), nearest][filter] ?? 0);
  })]);
}
