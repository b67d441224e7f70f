// Tracers side by side on pictures whose outlines are known. Usage: node bench/trace/run.mjs NATIVE-PROGRAM [part of a
// section's name] [--keep FOLDER] [--worst]

import { mkdirSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";

import { LINE_COLUMNS, LINE_GOALS, measuredLines } from "./lib/lines.mjs";
import { fastEnough, paperTimes } from "./lib/paper.mjs";
import { kept, strokes } from "./lib/pictures.mjs";
import { recognised } from "./lib/primitives.mjs";
import { COLUMNS, LEGEND, behind, measured, table } from "./lib/quality.mjs";
import { GOALS, RECORDED, RECORDED_LINES, SHEETS } from "./lib/recorded.mjs";
import { sheet, timed } from "./lib/sheets.mjs";
import { tracers } from "./lib/tracers.mjs";
import { unseen } from "./lib/unseen.mjs";

const [program, ...rest] = process.argv.slice(2);
const flag = (name) => rest.indexOf(name);
const folder = flag("--keep") >= 0 ? rest[flag("--keep") + 1] : undefined;
const only = rest.find((word, i) => !word.startsWith("--") && rest[i - 1] !== "--keep") ?? "";

const verdicts = [];
const verdict = (reached, text) => verdicts.push(`${reached ? "✓" : "✗"} ${text}`);

function judge(title, condition, rows) {
  const ours = rows[0].row;
  for (const [key, goal] of Object.entries(GOALS[condition] ?? {})) {
    const [, heading, digits, better] = COLUMNS.find(([k]) => k === key);
    const reached = better === "large" ? ours[key] >= goal : ours[key] <= goal;
    verdict(reached, `${title}: ${heading} ${ours[key].toFixed(digits)}; wanted ${better === "large" ? "at least" : "at most"} ${goal}`);
  }
  for (const text of behind(ours, rows.filter(({ name }) => !name.startsWith("expline")))) verdict(false, `${title}: behind in ${text}`);
}

/** The pictures of which a row's distance is largest. */
function worst({ scores }) {
  const known = scores.filter((s) => s).sort((a, b) => b.hausdorff - a.hausdorff);
  const line = (s) =>
    `  ${s.id}: haus ${s.hausdorff.toFixed(2)}, mean ${s.mean.toFixed(3)}, segments ${s.segments}/${s.segmentsTrue}, ` +
    `corners missed ${s.cornersTrue - s.cornersHit} false ${s.cornersFalse + s.cornersDouble}, kinks ${s.kinks}`;
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
    const rows = [...results, ...(name === "outlines" ? (RECORDED[condition] ?? []) : [])];
    console.log(table(title, rows));
    if (flag("--worst") >= 0) worst(results[0]);
    judge(title, condition, rows);
  }
}

async function lines(trace) {
  const set = strokes();
  for (const condition of set.conditions) {
    const title = `centre lines, ${condition}`;
    if (!title.includes(only)) continue;
    const { row, scores } = await measuredLines(set, condition, trace);
    const rows = [{ name: "expline, native", row }, ...RECORDED_LINES[condition]];
    const cells = rows.map(({ name, row: r }) => [name, r.failed ?? "–", ...LINE_COLUMNS.map(([key, , digits]) => r[key]?.toFixed(digits) ?? "–")]);
    const head = ["tracer", "failed", ...LINE_COLUMNS.map(([, heading]) => heading)];
    console.log(`### ${title}\n\n| ${head.join(" | ")} |\n|${"---|".repeat(head.length)}\n${cells.map((c) => `| ${c.join(" | ")} |`).join("\n")}\n`);
    const digits = (s) =>
      `mean ${s.mean.toFixed(3)}, haus ${s.hausdorff.toFixed(2)}, rec ${s.recall.toFixed(3)}, prec ${s.precision.toFixed(3)}`;
    const line = (s) => `  ${s.id}: ${digits(s)}, lines ${s.lines}/${s.linesTrue}`;
    if (flag("--worst") >= 0) console.log(scores.sort((a, b) => b.mean - a.mean).map(line).join("\n"));
    for (const [key, goal] of Object.entries(LINE_GOALS[condition])) {
      const [holds, wanted] = key === "mean" ? [row[key] <= goal, "at most"] : [row[key] >= goal, "at least"];
      verdict(holds, `${title}: ${key} ${row[key].toFixed(3)}; wanted ${wanted} ${goal}`);
    }
  }
}

async function primitives(trace) {
  if (!"primitives".includes(only)) return;
  console.log("### primitives\n\n| shape | recognised | largest error of a parameter, px |\n|---|---|---|");
  for (const { kind, all, found, error } of await recognised(trace)) {
    console.log(`| ${kind} | ${found} of ${all} | ${found > 0 ? error.toFixed(4) : "–"} |`);
    verdict(found === all && error <= 0.02, `primitives: ${kind}, ${found} of ${all}, off by ${error.toFixed(4)} px; wanted all, at most 0.02 px`);
  }
  console.log("");
}

async function sheets(contestants) {
  for (const { side, rounds, goals } of SHEETS) {
    const title = `time, sheet of ${side} × ${side}`;
    if (!title.includes(only)) continue;
    const results = await timed(sheet(kept().shapes, side), contestants, rounds);
    console.log(`### ${title}, 16 shapes, ${rounds} rounds in turns\n\n| tracer | least, ms | median, ms |\n|---|---|---|`);
    for (const { name, least, median } of results) console.log(`| ${name} | ${least.toFixed(1)} | ${median.toFixed(1)} |`);
    console.log("");
    for (const [name, goal] of goals) {
      const found = results.find((r) => r.name === name);
      if (found) verdict(found.least <= goal, `${title}: ${name} ${found.least.toFixed(1)} ms; wanted at most ${goal} ms`);
    }
  }
}

async function published() {
  const title = "time, profiles of the paper";
  if (!title.includes(only)) return;
  const { fitProfile } = await import("expline");
  const rows = paperTimes(fitProfile);
  console.log(`### ${title}\n\n| figure | edge points | printed², ms | method as printed, ms | improved, ms |\n|---|---|---|---|---|`);
  for (const r of rows) console.log(`| ${r.name} | ${r.points} | ${r.printed.toFixed(0)} | ${r.published.toFixed(1)} | ${r.improved.toFixed(1)} |`);
  console.log("");
  verdict(rows.every(fastEnough), `${title}: at most a tenth of what is printed, with the method as printed and improved`);
}

console.log(`${cpus()[0].model}, ${cpus().length} cores, Node ${process.versions.node}\n\n${LEGEND}\n`);
const { scored, timed: all, centreLines, close } = await tracers(program);
try {
  await outlines("outlines", kept(), scored);
  await outlines("unseen outlines", unseen(), scored);
  await lines(centreLines);
  await primitives(scored[0][1]);
  await sheets(all);
  await published();
} finally {
  close();
}
console.log("¹ recorded on the same pictures by the same definitions, not run now.\n² by its authors on their machine; whether edges are found within that time they do not say.\n");
console.log(verdicts.join("\n"));
