// Rules about the tree itself that no compiler checks.

import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";

import { StepError, at, run } from "./steps.mjs";

/** No source file is longer than this. */
const LONGEST = 600;
/** No comment is wider, unless it holds an address: what formats code leaves comments as they are. */
const WIDEST = 120;
const COMMENT = /^\s*(\/\/|\/\*|\*)(?!.*https?:)/;
const SOURCE = /\.(rs|ts|mjs|mts|css)$/;
/** What is run in a fresh clone, where no package is installed yet. */
const DOORS = ["start", "test", "build", "bench", "bench-trace", "docs"].map((name) => `scripts/${name}.mjs`);

/** Packages that a door imports before it has installed any, directly or through other scripts. */
function earlyPackages() {
  const found = [];
  const [known, open] = [new Set(DOORS), [...DOORS]];
  for (let file = open.pop(); file !== undefined; file = open.pop()) {
    const imports = readFileSync(at(file), "utf8").matchAll(/^(?:import|export) (?:[^;"]* from )?"([^"]+)";/gm);
    for (const [, name] of imports) {
      if (name.startsWith("./")) {
        const next = join(dirname(file), name);
        if (!known.has(next)) open.push(next);
        known.add(next);
      } else if (!name.startsWith("node:")) {
        found.push(`${file} imports ${name} before any package is installed`);
      }
    }
  }
  return found;
}

/** The names by which the headings of a document can be linked to. */
function anchorsOf(text) {
  return [...text.matchAll(/^#+ (.*)$/gm)].map(([, heading]) => heading.toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, "").replaceAll(" ", "-"));
}

/** Links of the documents, and paths that they name, which lead nowhere. */
function lostWays(documents) {
  const found = [];
  for (const document of documents) {
    const text = readFileSync(at(document), "utf8");
    for (const [, target] of text.matchAll(/\]\(([^)\s]+)\)/g)) {
      if (/^https?:/.test(target)) continue;
      const [path, anchor] = target.split("#");
      const file = path === "" ? document : join(dirname(document), path);
      if (!existsSync(at(file))) found.push(`${document} links to ${target}, which is not there`);
      else if (anchor !== undefined && !anchorsOf(readFileSync(at(file), "utf8")).includes(anchor)) found.push(`${document} links to ${target}: there is no such heading`);
    }
    for (const [, path] of text.matchAll(/`((?:src|ts|cli|tests|www|site|scripts|bench|docs|examples)\/[\w./-]*)`/g)) {
      if (!existsSync(at(path))) found.push(`${document} names ${path}, which is not there`);
    }
  }
  return found;
}

/**
 * Headings of the third level that the contents of their document leave out; a document without contents leaves none
 * out.
 */
function leftOut(documents) {
  return documents.flatMap((document) => {
    const text = readFileSync(at(document), "utf8");
    const listed = new Set([...text.matchAll(/^- \[.*\]\(#(.*)\)$/gm)].map(([, anchor]) => anchor));
    const headings = anchorsOf(text.replace(/^##? .*$/gm, ""));
    return listed.size === 0 ? [] : headings.filter((anchor) => !listed.has(anchor)).map((anchor) => `the contents of ${document} lack #${anchor}`);
  });
}

/**
 * A fresh clone can start, documents lead where they say and list what they have, versions agree, lock files name no
 * host besides crates.io's index, sources stay readable in length and comments in width.
 */
export async function checkTree() {
  const files = (await run("git", ["ls-files"])).split("\n").filter((file) => existsSync(at(file)));
  const documents = files.filter((file) => file.endsWith(".md"));
  const problems = [...earlyPackages(), ...lostWays(documents), ...leftOut(documents)];
  const { version } = JSON.parse(readFileSync(at("package.json"), "utf8"));
  const crate = /^version = "([^"]+)"/m.exec(readFileSync(at("Cargo.toml"), "utf8"))?.[1];
  if (crate !== version) problems.push(`package.json says ${version}, Cargo.toml ${crate}`);
  if (/"resolved"/.test(readFileSync(at("package-lock.json"), "utf8"))) problems.push("package-lock.json names where packages came from");
  const sources = new Set(readFileSync(at("Cargo.lock"), "utf8").match(/^source = .*$/gm));
  if (sources.size > 1) problems.push(`Cargo.lock has ${sources.size} sources`);
  for (const file of files.filter((each) => SOURCE.test(each))) {
    const lines = readFileSync(at(file), "utf8").split("\n");
    if (lines.length > LONGEST) problems.push(`${file} has ${lines.length} lines; the most is ${LONGEST}`);
    for (const [i, line] of lines.entries()) {
      if (line.length > WIDEST && COMMENT.test(line)) problems.push(`${file}:${i + 1} is a comment of ${line.length} columns; the most is ${WIDEST}`);
    }
  }
  if (problems.length > 0) throw new StepError(problems[0], problems.join("\n"));
}
