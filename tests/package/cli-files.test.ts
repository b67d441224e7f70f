// What the command line reads and writes over: pipes that are not ready, disks that are full, files that are their own
// result.

import assert from "node:assert/strict";
import { execFileSync, spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { closeSync, constants, existsSync, linkSync, mkdirSync, openSync, readFileSync, rmSync, symlinkSync, truncateSync, writeFileSync, writeSync } from "node:fs";
import { before, test } from "node:test";
import { text } from "node:stream/consumers";
import { setTimeout as wait } from "node:timers/promises";
import { join } from "node:path";

import { COMMAND, PNG, SQUARE, SQUARE_PATH, expline, folder } from "./command-line.ts";

before(() => mkdirSync(folder, { recursive: true }));

/** A file of this test's own. */
function file(name: string, content: string | Uint8Array): string {
  const path = join(folder, name);
  rmSync(path, { recursive: true, force: true });
  writeFileSync(path, content);
  return path;
}

/** What the command says of input that comes in parts through a pipe that answers "not yet" instead of waiting. */
async function saidOfParts(words: string, parts: readonly Uint8Array[]): Promise<{ status: number; out: string; error: string }> {
  const pipe = join(folder, "pipe");
  rmSync(pipe, { force: true });
  execFileSync("mkfifo", [pipe]);
  const reader = openSync(pipe, constants.O_RDONLY | constants.O_NONBLOCK);
  const writer = openSync(pipe, constants.O_WRONLY);
  // Node makes the first three of a child wait, so a shell hands this one on.
  const child = spawn("sh", ["-c", `exec "${COMMAND}" ${words} <&3`], { cwd: folder, stdio: ["ignore", "pipe", "pipe", reader] });
  closeSync(reader);
  const ended = once(child, "close") as Promise<[number]>;
  const said = Promise.all([text(child.stdout as NodeJS.ReadableStream), text(child.stderr as NodeJS.ReadableStream)]);
  for (const part of parts) {
    await wait(400);
    writeSync(writer, part);
  }
  closeSync(writer);
  const [[out, error], [status]] = [await said, await ended];
  return { status, out, error };
}

test("standard input that is not ready yet is waited for, points and pictures alike", async () => {
  const rows = new TextEncoder().encode(SQUARE);
  const points = await saidOfParts("fit - --tolerance 0.5 --format path", [rows.subarray(0, 100), rows.subarray(100)]);
  assert.deepEqual(points, expline(["fit", "-", "--tolerance", "0.5", "--format", "path"], SQUARE));
  const picture = await saidOfParts("trace -", [PNG.subarray(0, 50), PNG.subarray(50)]);
  assert.equal(picture.status, 0, picture.error);
  assert.match(picture.out, SQUARE_PATH);
});

test("nothing is written over what it is made of, whatever name it goes by", () => {
  const picture = file("own.png", PNG);
  const points = file("own.csv", SQUARE);
  for (const name of ["linked.png", "same.png"]) rmSync(join(folder, name), { force: true });
  symlinkSync(picture, join(folder, "linked.png"));
  linkSync(picture, join(folder, "same.png"));
  rmSync(join(folder, "own"), { recursive: true, force: true });
  mkdirSync(join(folder, "own"));
  writeFileSync(join(folder, "own", "a.svg"), PNG);
  for (const [words, named] of [
    [["trace", "own.png", "-o", "own.png"], "own.png"],
    [["trace", "own.png", "-o", "linked.png"], "linked.png"],
    [["trace", "own.png", "-o", "same.png"], "same.png"],
    [["fit", "own.csv", "-o", "./own.csv"], "./own.csv"],
    [["trace", "own.png", "own/a.svg"], "own/a.svg"],
  ] as const) {
    const { status, out, error } = expline(words);
    assert.deepEqual([status, out, error], [2, "", `expline: ${named}: it is read, and would be written over; name another file for the result\n`]);
  }
  assert.deepEqual(readFileSync(picture), Buffer.from(PNG));
  assert.equal(readFileSync(points, "utf8"), SQUARE);
  assert.equal(existsSync(join(folder, "own.svg")), false, "nothing is done before it is refused");
});

test("several pictures need a folder: a file, or a name that is a file's, is refused", () => {
  for (const name of ["a.png", "b.png"]) file(name, PNG);
  file("plain", "kept");
  rmSync(join(folder, "both.svg"), { recursive: true, force: true });
  for (const name of ["both.svg", "both.JSON", "plain"]) {
    const { status, out, error } = expline(["trace", "a.png", "b.png", "-o", name]);
    assert.deepEqual([status, out, error], [2, "", `expline: ${name}: the results of 2 pictures need a folder, and this is a file or is called like one\n`]);
  }
  assert.equal(existsSync(join(folder, "both.svg")), false);
  assert.equal(readFileSync(join(folder, "plain"), "utf8"), "kept");
  mkdirSync(join(folder, "both.svg"));
  assert.equal(expline(["trace", "a.png", "b.png", "-o", "both.svg"]).status, 0, "a folder that is there may have any name");
});

test("a disk that is full is said to be, on standard output as in a file", () => {
  file("own.csv", SQUARE);
  const full = openSync("/dev/full", "w");
  const { status, stderr } = spawnSync(COMMAND, ["fit", "own.csv"], { cwd: folder, encoding: "utf8", stdio: ["ignore", full, "pipe"] });
  closeSync(full);
  assert.deepEqual([status, stderr], [1, "expline: standard output: it cannot be written (no space is left)\n"]);
  const named = expline(["fit", "own.csv", "-o", "/dev/full"]);
  assert.deepEqual([named.status, named.error], [1, "expline: /dev/full: it cannot be written (no space is left)\n"]);
});

test("a file that never ends, or is larger than any list of points, is refused in the end", () => {
  const endless = expline(["fit", "/dev/zero"]);
  assert.deepEqual([endless.status, endless.error], [1, "expline: /dev/zero: it is larger than 64 MB\n"]);
  file("large.csv", "");
  truncateSync(join(folder, "large.csv"), 3 * 2 ** 30);
  const large = expline(["fit", "large.csv"]);
  assert.deepEqual([large.status, large.error], [1, "expline: large.csv: it is larger than 64 MB\n"]);
  const picture = expline(["trace", "large.csv"]);
  assert.deepEqual([picture.status, picture.error], [1, "expline: large.csv: it is larger than 500 MB\n"]);
});

test("of several pictures that cannot be read, each is named with its reason, up to eight of them", () => {
  const names = Array.from({ length: 10 }, (_, i) => `nowhere-${i}.png`);
  const { status, error } = expline(["trace", ...names]);
  assert.equal(status, 1);
  const said = names.slice(0, 8).map((name) => `${name}: there is no such file`);
  assert.equal(error, `expline: ${said.join("; ")}; nor could 2 more\n`);
});
