// Rules about the tree itself that no compiler checks.

import { existsSync, readFileSync } from "node:fs";

import { StepError, at, run } from "./steps.mjs";

/** No source file is longer than this. */
const LONGEST = 600;
const SOURCE = /\.(rs|ts|mjs|css)$/;

/** Versions agree, lock files name no host besides crates.io's index, sources stay readable in length. */
export async function checkTree() {
  const problems = [];
  const { version } = JSON.parse(readFileSync(at("package.json"), "utf8"));
  const crate = /^version = "([^"]+)"/m.exec(readFileSync(at("Cargo.toml"), "utf8"))?.[1];
  if (crate !== version) problems.push(`package.json says ${version}, Cargo.toml ${crate}`);
  if (/"resolved"/.test(readFileSync(at("package-lock.json"), "utf8"))) problems.push("package-lock.json names where packages came from");
  const sources = new Set(readFileSync(at("Cargo.lock"), "utf8").match(/^source = .*$/gm));
  if (sources.size > 1) problems.push(`Cargo.lock has ${sources.size} sources`);
  for (const file of (await run("git", ["ls-files"])).split("\n")) {
    if (!SOURCE.test(file) || !existsSync(at(file))) continue;
    const lines = readFileSync(at(file), "utf8").split("\n").length;
    if (lines > LONGEST) problems.push(`${file} has ${lines} lines; the most is ${LONGEST}`);
  }
  if (problems.length > 0) throw new StepError(problems[0], problems.join("\n"));
}
