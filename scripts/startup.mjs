// How long the package takes to start: its import, then the first call, which decodes, compiles and instantiates the wasm.

import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const ROUNDS = 7;

async function once() {
  const started = performance.now();
  const { HermiteCurve } = await import("../pkg/expline.js");
  const imported = performance.now();
  HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 2 }).evaluate(0.5);
  const called = performance.now();
  const bytes = readFileSync(new URL("../pkg/expline_bg.wasm", import.meta.url));
  const ready = performance.now();
  new WebAssembly.Module(bytes);
  return { import: imported - started, first: called - imported, compile: performance.now() - ready };
}

if (process.argv[2] === "once") {
  console.log(JSON.stringify(await once()));
} else {
  const rounds = Array.from({ length: ROUNDS }, () =>
    JSON.parse(execFileSync(process.execPath, [fileURLToPath(import.meta.url), "once"], { encoding: "utf8" })),
  );
  const median = (key) => rounds.map((r) => r[key]).sort((a, b) => a - b)[ROUNDS >> 1].toFixed(1);
  console.log(
    `start-up in Node (median of ${ROUNDS} processes): import ${median("import")} ms, first call ${median("first")} ms; ` +
      `compiling alone ${median("compile")} ms`,
  );
}
