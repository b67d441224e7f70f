// What has passed, and on what: a check need not run again while nothing that it reads has changed.
//
// Told by contents, as the steps of the build are, and by everything in the tree but what is said to be unread: a
// file that nobody thought of makes a check run once too often, never once too seldom.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, realpathSync, statSync, writeFileSync } from "node:fs";

import { StepError, at, root, run } from "./steps.mjs";

const FOLDER = at("build", "passed");

/** The files that git keeps or would keep; undefined where there is no git, or no clone. */
async function filesOfTree() {
  try {
    const names = await run("git", ["-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]);
    return [...new Set(names.split("\0"))].filter((name) => name !== "").sort();
  } catch (error) {
    if (!(error instanceof StepError)) throw error;
    return undefined;
  }
}

/** Programs outside the clone whose versions no file in it says, and what the tests are told from outside. */
function surroundings() {
  const told = Object.entries(process.env).filter(([name]) => name.startsWith("DEMO_"));
  const browser = process.env.CHROMIUM && realpathSync(process.env.CHROMIUM);
  const { size, mtimeMs } = browser ? statSync(browser) : {};
  return JSON.stringify([process.version, process.arch, process.platform, browser, size, mtimeMs, told]);
}

/** A file's contents; a name that git still knows and that is gone, or is a link to nowhere, has none. */
function contents(name) {
  try {
    return readFileSync(at(name));
  } catch {
    return "(none)";
  }
}

/** One hash over all that a check may read; undefined when it can't be told. */
async function fingerprint(unread) {
  const files = await filesOfTree();
  if (files === undefined) return undefined;
  const hash = createHash("sha256").update(surroundings());
  for (const name of files) if (!unread.test(name)) hash.update(`\0${name}\0`).update(contents(name));
  return hash.digest("hex");
}

const NOTHING = /^$/;

/**
 * What check `name` may read now, without the files that `unread` matches: `earlier` is what it came to on the same,
 * if it passed, and `keep(result)` says that it has now; what was edited meanwhile was not what was looked at.
 */
export async function passedOn(name, unread = NOTHING) {
  const file = `${FOLDER}/${name.replace(/[^\w-]+/g, "-")}.json`;
  const now = await fingerprint(unread);
  let known;
  try {
    known = JSON.parse(readFileSync(file, "utf8"));
  } catch {
    known = {};
  }
  return {
    earlier: now !== undefined && known.read === now ? known.result : undefined,
    async keep(result) {
      if (now === undefined || (await fingerprint(unread)) !== now) return;
      mkdirSync(FOLDER, { recursive: true });
      writeFileSync(file, `${JSON.stringify({ read: now, result })}\n`);
    },
  };
}
