// What the package weighs and how long it takes to start, measured at every build; the weight has a limit.

import { readFileSync } from "node:fs";
import { brotliCompressSync, gzipSync } from "node:zlib";

import { StepError, at, run } from "./steps.mjs";

/** Face and wasm together, gzipped. */
const LIMIT = 90_000;

const kB = (bytes) => `${(bytes / 1000).toFixed(1).padStart(6)} kB`;

function measure(bytes) {
  return { raw: bytes.length, gzip: gzipSync(bytes, { level: 9 }).length, brotli: brotliCompressSync(bytes).length };
}

/** Prints the sizes and the start-up time; more than the limit is an error. */
export async function checkSizes() {
  const whole = readFileSync(at("pkg/expline.js"));
  const wasm = readFileSync(at("pkg/expline_bg.wasm"));
  const rows = { "expline.js (all of it)": measure(whole), "slim.js (the face alone)": measure(readFileSync(at("pkg/slim.js"))), "expline_bg.wasm": measure(wasm) };
  for (const [name, { raw, gzip, brotli }] of Object.entries(rows)) {
    console.log(`  ${name.padEnd(24)} raw ${kB(raw)}   gzip ${kB(gzip)}   brotli ${kB(brotli)}`);
  }
  const start = await run("node", [at("scripts/startup.mjs")]);
  console.log(`  ${start.trim()}`);
  const { gzip } = rows["expline.js (all of it)"];
  if (gzip > LIMIT) throw new StepError(`size: face and wasm are ${gzip} bytes gzipped; the limit is ${LIMIT}`);
}
