// The command line as npm links it, and what it is given.

import { spawnSync } from "node:child_process";
import { join } from "node:path";

import { encode as encodePng } from "fast-png";

const consumer = join(process.cwd(), "build", "consumer");

/** Where it runs. */
export const folder = join(consumer, "command-line");

interface Said {
  readonly status: number | null;
  readonly out: string;
  readonly error: string;
}

/** The command as npm links it. */
export const COMMAND = join(consumer, "node_modules", ".bin", "expline");

/** Runs the command. */
export function expline(parameters: readonly string[], input: string | Uint8Array = ""): Said {
  const { status, stdout, stderr } = spawnSync(COMMAND, parameters, { cwd: folder, encoding: "utf8", input });
  return { status, out: stdout, error: stderr };
}

/** Points of a square with sides of 100, ten on each. */
export const SQUARE = Array.from({ length: 40 }, (_, i) => {
  const along = 10 * (i % 10);
  return [[along, 0], [100, along], [100 - along, 100], [0, 100 - along]][Math.floor(i / 10)]?.join(",");
}).join("\n");

/** A black square from 10 to 30 in a picture of 40 by 32, red, green, blue and opacity. */
export const PIXELS = Uint8Array.from({ length: 4 * 40 * 32 }, (_, i) => {
  const [x, y] = [(i >> 2) % 40, Math.floor((i >> 2) / 40)];
  return i % 4 === 3 ? 255 : x >= 10 && x < 30 && y >= 6 && y < 26 ? 0 : 255;
});
export const PNG = encodePng({ width: 40, height: 32, data: PIXELS, channels: 4 });
export const SQUARE_PATH = /d="M10 6H30V26H10Z"|d="M(?:30|10) (?:6|26)[HV]\d+[HV]\d+[HV]\d+[Zz]"/;
