// The command line of the packed package: what it writes, what it says, and its status.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { before, test } from "node:test";
import { join } from "node:path";

const consumer = join(process.cwd(), "build", "consumer");
const folder = join(consumer, "command-line");

interface Said {
  readonly status: number | null;
  readonly out: string;
  readonly error: string;
}

/** Runs the command as npm links it. */
function expline(parameters: readonly string[], input = ""): Said {
  const { status, stdout, stderr } = spawnSync(join(consumer, "node_modules", ".bin", "expline"), parameters, { cwd: folder, encoding: "utf8", input });
  return { status, out: stdout, error: stderr };
}

/** Points of a square with sides of 100, ten on each. */
const SQUARE = Array.from({ length: 40 }, (_, i) => {
  const along = 10 * (i % 10);
  return [[along, 0], [100, along], [100 - along, 100], [0, 100 - along]][Math.floor(i / 10)]?.join(",");
}).join("\n");

before(() => {
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, "square.csv"), `x,y\n${SQUARE}\n0,0\n`);
});

test("points become an SVG within the tolerance, and one line says what came of it", () => {
  const { status, out, error } = expline(["fit", "square.csv", "--tolerance", "0.5", "-o", "out.svg"]);
  assert.deepEqual([status, error], [0, ""]);
  assert.match(out, /^out\.svg: 40 points, \d+ knots, largest distance [\d.e-]+, certified gap/);
  const svg = readFileSync(join(folder, "out.svg"), "utf8");
  assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg" viewBox="[-\d. ]+"><path [^>]*d="M[^"]+"\/><\/svg>\n$/);
});

test("standard input and output: the path alone, from points in rows", () => {
  const { status, out } = expline(["fit", "-", "--tolerance=0.5", "--format", "path"], SQUARE.replaceAll(",", " "));
  assert.equal(status, 0);
  assert.match(out, /^M[-\d.,\sA-Za-z]+\n$/);
});

test("JSON holds the curve to the last bit, with the knots and what is proved", () => {
  const { status, out } = expline(["fit", "square.csv", "--smoothing", "0.5", "--degree", "1", "--no-finish", "--format", "json"]);
  assert.equal(status, 0);
  const [fit] = JSON.parse(out) as { curve: { type: string; closed: boolean }; gap: number; status: string }[];
  assert.equal(fit?.curve.type, "HermiteCurve");
  assert.equal(fit?.curve.closed, true, "the last row repeats the first");
  assert.ok((fit?.gap ?? 1) <= 1e-6);
});

test("an empty row begins another contour", () => {
  const { status, out } = expline(["fit", "-", "--tolerance", "1", "--format", "path"], `${SQUARE}\n\n${SQUARE.split("\n").map((row) => row.replace(/^(\d+)/, "3$1")).join("\n")}`);
  assert.equal(status, 0);
  assert.equal(out.match(/M/g)?.length, 2);
});

test("help and version", () => {
  const [help, fit, version] = [expline(["--help"]), expline(["fit", "--help"]), expline(["--version"])];
  assert.match(help.out, /Usage: expline COMMAND/);
  assert.match(fit.out, /--tolerance D/);
  assert.match(version.out, /^\d+\.\d+\.\d+\n$/);
  assert.deepEqual([help.status, fit.status, version.status], [0, 0, 0]);
});

for (const [what, parameters, status, words, input] of [
  ["no command", [], 2, /a command is missing/],
  ["a command that there is not", ["trance"], 2, /no command "trance"/],
  ["no file", ["fit"], 2, /needs a file/],
  ["an option that there is not", ["fit", "square.csv", "--tolerence", "1"], 2, /no option --tolerence/],
  ["an option without its value", ["fit", "square.csv", "--tolerance"], 2, /--tolerance needs a value/],
  ["a tolerance that is a word", ["fit", "square.csv", "--tolerance", "small"], 2, /--tolerance is "small"; expected a number/],
  ["a negative tolerance", ["fit", "square.csv", "--tolerance", "-1"], 2, /tolerance is -1/],
  ["two strengths", ["fit", "square.csv", "--tolerance", "1", "--smoothing", "0.5"], 2, /only one can be given/],
  ["a file that is not there", ["fit", "nowhere.csv"], 1, /nowhere\.csv: there is no such file/],
  ["a folder", ["fit", "."], 1, /it is a folder/],
  ["a row that is no point", ["fit", "-"], 1, /standard input:2: "abc" is not a number/, "1,2\nabc,3\n"],
  ["a single number in a row", ["fit", "-"], 1, /standard input:1: "7" is not two numbers/, "7\n"],
  ["no points at all", ["fit", "-"], 1, /there are no points/, "x,y\n"],
  ["one point", ["fit", "-"], 1, /points has 1 point; expected at least/, "1,2\n"],
  ["points that are all the same", ["fit", "-"], 1, /points has no unique answer/, "1,2\n1,2\n1,2\n"],
  ["a place that cannot be written", ["fit", "square.csv", "-o", "nowhere/out.svg"], 1, /cannot be written/],
] as const) {
  test(`${what}: status ${status} and one clear line`, () => {
    const said = expline(parameters, input ?? "");
    assert.equal(said.status, status, said.error);
    assert.match(said.error, words);
    assert.match(said.error, /^expline: [^\n]+\n$/);
    assert.equal(said.out, "");
  });
}
