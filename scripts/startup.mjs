// How long the package takes to start: its import, then the first call, which finds, compiles and instantiates the
// wasm. Node takes `node.js`, which reads the wasm file; bundlers take `expline.js`, which has it inside.

import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

const ROUNDS = 7;

const EDITIONS = ["node.js", "expline.js"];

async function once(edition) {
  const started = performance.now();
  const { HermiteCurve } = await import(`../pkg/${edition}`);
  const imported = performance.now();
  HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 2 }).evaluate(0.5);
  const called = performance.now();
  return { import: imported - started, first: called - imported };
}

const [, , edition] = process.argv;
if (edition !== undefined) {
  console.log(JSON.stringify(await once(edition)));
} else {
  const said = EDITIONS.map((name) => {
    const rounds = Array.from({ length: ROUNDS }, () =>
      JSON.parse(execFileSync(process.execPath, [fileURLToPath(import.meta.url), name], { encoding: "utf8" })),
    );
    const median = (key) => rounds.map((r) => r[key]).sort((a, b) => a - b)[ROUNDS >> 1].toFixed(1);
    return `${name} import ${median("import")} ms, first call ${median("first")} ms`;
  });
  console.log(`start-up in Node (median of ${ROUNDS} processes): ${said.join("; ")}`);
}
