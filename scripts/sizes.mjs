// What the package weighs and how long it takes to start, measured at every build; the weight has a limit.

import { readFileSync } from "node:fs";
import { brotliCompressSync, gzipSync } from "node:zlib";

import { KINDS } from "./kinds.mjs";
import { StepError, at, run } from "./steps.mjs";

/**
 * Face and wasm of each kind of work in bytes, gzipped: what may not be exceeded today. The aim is 60,000 for curves
 * and surfaces together; docs/DESIGN.md says what was tried.
 */
const LIMITS = { "core.js": 64_300, "spline.js": 52_300, "surface.js": 41_700, "fit.js": 152_900, "trace.js": 153_250 };

/** What is printed, and the files of the package. */
const FILES = KINDS.flatMap(({ name, file, work }) => [
  [`${name}.js (${work})`, `${name}.js`],
  ["… the face alone", `slim-${name}.js`],
  [`… ${file}_bg.wasm`, `${file}_bg.wasm`],
  ...(name === "core" ? [["edit.js (pointers)", "edit.js"]] : []),
]);

const kB = (bytes) => `${(bytes / 1000).toFixed(1).padStart(6)} kB`;

function measure(bytes) {
  return { raw: bytes.length, gzip: gzipSync(bytes, { level: 9 }).length, brotli: brotliCompressSync(bytes).length };
}

/** Prints the sizes and the start-up time. */
export async function printSizes() {
  for (const [name, file] of FILES) {
    const { raw, gzip, brotli } = measure(readFileSync(at("pkg", file)));
    console.log(`  ${name.padEnd(24)} raw ${kB(raw)}   gzip ${kB(gzip)}   brotli ${kB(brotli)}`);
  }
  console.log(`  ${(await run("node", [at("scripts/startup.mjs")])).trim()}`);
}

/** Face and wasm of each kind of work, gzipped, stay under its limit. */
export function checkSize() {
  for (const [file, limit] of Object.entries(LIMITS)) {
    const { gzip } = measure(readFileSync(at("pkg", file)));
    if (gzip > limit) throw new StepError(`size: ${file} has ${gzip} bytes gzipped; the limit is ${limit}`);
  }
}
