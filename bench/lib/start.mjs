// Rows about starting: what a process waits for before its first point.

import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

const PROGRAM = fileURLToPath(new URL("../start.mjs", import.meta.url));

/** Milliseconds of so many fresh processes; the import's share of the last one is kept for the note. */
function contestant(name) {
  let share = 0;
  const measure = (times) => {
    let sum = 0;
    for (let i = 0; i < times; i++) {
      const [imported, first] = execFileSync(process.execPath, [PROGRAM, name], { encoding: "utf8" }).split(" ").map(Number);
      share = imported;
      sum += imported + first;
    }
    return sum;
  };
  return { name, measure, units: 1, note: () => `the import ${share.toFixed(1)} ms` };
}

function start() {
  const ours = contestant("expline");
  return { unit: "start", contestants: [ours, ...["bezier-js", "curve-interpolator", "paper"].map(contestant)], targets: [], limits: [["expline", 5]] };
}

/** Titles and what makes the contestants. */
export const startRows = [["a fresh Node process: import and first point", start]];
