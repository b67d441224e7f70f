// The side-by-side table. Usage: node bench/run.mjs NATIVE-PROGRAM KURBO-WASM [--record] [part of a title]
//
// With --record the run is kept in bench/recorded.json, and the README's tables are made from it.

import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { fileURLToPath } from "node:url";

import * as expline from "expline";

import { EXPONENTIAL_OMEGA, points, tangents } from "./lib/curve.mjs";
import { evaluationRows } from "./lib/evaluation.mjs";
import { fitRows } from "./lib/fits.mjs";
import { geometryRows } from "./lib/geometry.mjs";
import { race } from "./lib/harness.mjs";
import { pathRows } from "./lib/paths.mjs";
import { Native, beziers, interpolator, kurboWasm, paperPath } from "./lib/peers.mjs";
import { smoothRows } from "./lib/smooth.mjs";
import { startRows } from "./lib/start.mjs";
import { inserted } from "./tables.mjs";

const ROUNDS = 15;

/** Nanoseconds as a person reads them. */
function time(ns) {
  if (ns < 1000) return `${ns.toPrecision(3)} ns`;
  if (ns < 1e6) return `${(ns / 1e3).toPrecision(3)} µs`;
  return `${(ns / 1e6).toPrecision(3)} ms`;
}

const [program, kurboFile, ...asked] = process.argv.slice(2);
const record = asked.includes("--record");
const only = asked.find((word) => word !== "--record") ?? "";
const native = new Native(program);
const peers = {
  expline,
  native,
  beziers,
  kurbo: kurboWasm(kurboFile),
  path: paperPath(),
  interpolator: interpolator(),
  curve: new expline.HermiteCurve({ points, tangents, space: "polynomial" }),
  exponential: new expline.HermiteCurve({ points, tangents, omega: EXPONENTIAL_OMEGA }),
};

console.log(`${cpus()[0].model}, ${cpus().length} cores, Node ${process.versions.node}; ${ROUNDS} rounds in turns, least and median\n`);
const verdicts = [];
const rows = [];
for (const [title, prepare] of [...evaluationRows, ...geometryRows, ...pathRows, ...smoothRows, ...fitRows, ...startRows]) {
  if (!title.includes(only)) continue;
  const contest = prepare(peers);
  const results = await race(contest.contestants, ROUNDS);
  const ours = results[0].least;
  const row = { title, unit: contest.unit, results: [] };
  rows.push(row);
  console.log(`${title} (per ${contest.unit})`);
  for (let i = 0; i < results.length; i++) {
    const { name, measure, note, least, median } = results[i];
    await measure(1); // the note below speaks of this contestant's own result
    const ratio = `×${(least / ours).toPrecision(3)}`;
    row.results.push({ name, least: Number(least.toPrecision(4)), median: Number(median.toPrecision(4)), note: note() });
    console.log(`  ${name.padEnd(30)} ${time(least).padStart(9)} ${time(median).padStart(9)} ${ratio.padStart(8)}   ${note()}`);
  }
  for (const [name, taken, note] of contest.recorded ?? []) console.log(`  ${name.padEnd(44)} ${taken.padStart(7)} recorded   ${note}`);
  for (const [name, wanted] of contest.targets) {
    const ratio = results.find((r) => r.name === name).least / ours;
    verdicts.push(`${ratio >= wanted ? "✓" : "✗"} ${title}: ${ratio.toPrecision(3)}× ${name}; wanted ${wanted}×`);
  }
  for (const [name, most] of contest.limits ?? []) {
    const ms = results.find((r) => r.name === name).least / 1e6;
    verdicts.push(`${ms <= most ? "✓" : "✗"} ${title}: ${ms.toPrecision(3)} ms, ${name}; wanted ${most} ms`);
  }
  console.log("");
}
native.close();
const MEMORY = "memory of a sparse fit";
if (MEMORY.includes(only)) {
  console.log(`${MEMORY}, degree 3, 2000 places for knots: what wasm takes beside its start`);
  for (const count of [25_000, 50_000, 100_000]) {
    const script = fileURLToPath(new URL("memory.mjs", import.meta.url));
    const [before, after] = execFileSync("node", [script, String(count), "2000"], { encoding: "utf8" }).split(" ").map(Number);
    const [needed, each] = [(after - before) / 2 ** 20, (after - before) / count];
    console.log(`  ${String(count).padStart(6)} points ${needed.toFixed(1).padStart(6)} MiB, ${each.toFixed(0)} bytes for each`);
  }
  console.log("");
}
console.log(verdicts.join("\n"));

if (record) {
  const place = (name) => new URL(name, import.meta.url);
  const kept = JSON.parse(readFileSync(place("recorded.json"), "utf8"));
  // A run of a few rows replaces only those.
  const others = only === "" ? [] : kept.rows.filter(({ title }) => !rows.some((row) => row.title === title));
  const run = { machine: cpus()[0].model, cores: cpus().length, node: process.versions.node, rounds: ROUNDS, rows: [...others, ...rows] };
  writeFileSync(place("recorded.json"), `${JSON.stringify(run, undefined, 1)}\n`);
  writeFileSync(place("../README.md"), inserted(readFileSync(place("../README.md"), "utf8"), run));
  console.log("\nkept in bench/recorded.json; the README's tables are made from it");
}
