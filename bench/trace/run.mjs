// Tracers side by side on pictures whose outlines are known. Usage: node bench/trace/run.mjs NATIVE-PROGRAM [part of a section's name] [--keep FOLDER] [--worst]

import { mkdirSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";

import { kept } from "./lib/pictures.mjs";
import { COLUMNS, LEGEND, behind, measured, table } from "./lib/quality.mjs";
import { GOALS, RECORDED } from "./lib/recorded.mjs";
import { tracers } from "./lib/tracers.mjs";

const [program, ...rest] = process.argv.slice(2);
const flag = (name) => rest.indexOf(name);
const folder = flag("--keep") >= 0 ? rest[flag("--keep") + 1] : undefined;
const only = rest.find((word, i) => !word.startsWith("--") && rest[i - 1] !== "--keep") ?? "";

const verdicts = [];

function judge(title, condition, rows) {
  const ours = rows[0].row;
  for (const [key, goal] of Object.entries(GOALS[condition] ?? {})) {
    const [, heading, digits, better] = COLUMNS.find(([k]) => k === key);
    const reached = better === "large" ? ours[key] >= goal : ours[key] <= goal;
    verdicts.push(`${reached ? "✓" : "✗"} ${title}: ${heading} ${ours[key].toFixed(digits)}; wanted ${better === "large" ? "at least" : "at most"} ${goal}`);
  }
  for (const text of behind(ours, rows.filter(({ name }) => !name.startsWith("expline")))) verdicts.push(`✗ ${title}: behind in ${text}`);
}

/** The pictures of which a row's distance is largest. */
function worst({ scores }) {
  const known = scores.filter((s) => s).sort((a, b) => b.hausdorff - a.hausdorff);
  const line = (s) =>
    `  ${s.id}: haus ${s.hausdorff.toFixed(2)}, mean ${s.mean.toFixed(3)}, segments ${s.segments}/${s.segmentsTrue}, corners missed ${s.cornersTrue - s.cornersHit} false ${s.cornersFalse + s.cornersDouble}, kinks ${s.kinks}`;
  console.log(`${known.map(line).join("\n")}\n`);
}

async function outlines(name, set, contestants) {
  for (const condition of set.conditions) {
    const title = `${name}, ${condition}`;
    if (!title.includes(only)) continue;
    const keep = (tracer, shape, { svg }) => {
      if (!folder) return;
      mkdirSync(join(folder, tracer), { recursive: true });
      writeFileSync(join(folder, tracer, `${shape.id}_${condition}.svg`), svg);
    };
    const results = await measured(set, condition, contestants, keep);
    const rows = [...results, ...(name === "outlines" ? RECORDED[condition] : [])];
    console.log(table(title, rows));
    if (flag("--worst") >= 0) worst(results[0]);
    judge(title, condition, rows);
  }
}

console.log(`${cpus()[0].model}, ${cpus().length} cores, Node ${process.versions.node}\n\n${LEGEND}\n`);
const { contestants, close } = await tracers(program);
try {
  await outlines("outlines", kept(), contestants);
} finally {
  close();
}
console.log("¹ recorded on the same pictures by the same definitions, not run now.\n");
console.log(verdicts.join("\n"));
