// What has passed, and on what: a check need not run again while nothing that it reads has changed.
//
// Told by contents, as the steps of the build are, and by everything in the tree but what is said to be unread: a
// file that nobody thought of makes a check run once too often, never once too seldom.

import { mkdirSync, readFileSync, realpathSync, statSync, writeFileSync } from "node:fs";

import { StepError, at, fingerprint, root, run } from "./steps.mjs";

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

/** One hash over all that a check may read; undefined when it can't be told. */
async function readable(unread) {
  const files = await filesOfTree();
  return files && fingerprint(files.filter((name) => !unread.test(name)).map((name) => at(name)), surroundings());
}

const NOTHING = /^$/;

/**
 * What check `name` may read now, without the files that `unread` matches: `earlier` is what it came to on the same,
 * if it passed, and `keep(result)` says that it has now; what was edited meanwhile was not what was looked at.
 */
export async function passedOn(name, unread = NOTHING) {
  const file = `${FOLDER}/${name.replace(/[^\w-]+/g, "-")}.json`;
  const now = await readable(unread);
  let known;
  try {
    known = JSON.parse(readFileSync(file, "utf8"));
  } catch {
    known = {};
  }
  return {
    earlier: now !== undefined && known.read === now ? known.result : undefined,
    async keep(result) {
      if (now === undefined || (await readable(unread)) !== now) return;
      mkdirSync(FOLDER, { recursive: true });
      writeFileSync(file, `${JSON.stringify({ read: now, result })}\n`);
    },
  };
}
