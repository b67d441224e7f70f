import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { type TestContext, test } from "node:test";
import { pathToFileURL } from "node:url";

/** What npm test remembers of its checks: tried on a small clone of its own, with the project's own script. */

interface Passed {
  passedOn(name: string, unread?: RegExp): Promise<{ earlier: unknown; keep(result: unknown): Promise<void> }>;
}

async function smallClone(t: TestContext, { git = true } = {}): Promise<{ folder: string; passedOn: Passed["passedOn"] }> {
  const folder = mkdtempSync(join(tmpdir(), "expline-passed-"));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  mkdirSync(join(folder, "scripts"));
  for (const name of ["passed.mjs", "steps.mjs"]) cpSync(join(process.cwd(), "scripts", name), join(folder, "scripts", name));
  for (const name of ["code", "words"]) writeFileSync(join(folder, name), "as it was");
  writeFileSync(join(folder, ".gitignore"), "/build\n");
  if (git) execFileSync("git", ["init", "--quiet", folder]);
  const { passedOn } = (await import(pathToFileURL(join(folder, "scripts", "passed.mjs")).href)) as Passed;
  return { folder, passedOn };
}

test("a check that passed is known while what it reads is the same, and again when that is put back", async (t) => {
  const { folder, passedOn } = await smallClone(t);
  const before = await passedOn("all");
  assert.equal(before.earlier, undefined, "nothing has passed yet");
  await before.keep(12);
  assert.equal((await passedOn("all")).earlier, 12);
  assert.equal((await passedOn("another")).earlier, undefined, "each check for itself");
  writeFileSync(join(folder, "code"), "edited");
  assert.equal((await passedOn("all")).earlier, undefined);
  writeFileSync(join(folder, "code"), "as it was");
  assert.equal((await passedOn("all")).earlier, 12);
});

test("files that git does not know yet count, and so do those that are gone", async (t) => {
  const { folder, passedOn } = await smallClone(t);
  await (await passedOn("all")).keep(1);
  writeFileSync(join(folder, "new"), "");
  assert.equal((await passedOn("all")).earlier, undefined);
  rmSync(join(folder, "new"));
  assert.equal((await passedOn("all")).earlier, 1);
  rmSync(join(folder, "words"));
  assert.equal((await passedOn("all")).earlier, undefined);
});

test("only what a check does not read may change", async (t) => {
  const { folder, passedOn } = await smallClone(t);
  const unread = /^words$/;
  await (await passedOn("some", unread)).keep(3);
  writeFileSync(join(folder, "words"), "edited");
  assert.equal((await passedOn("some", unread)).earlier, 3);
  writeFileSync(join(folder, "code"), "edited");
  assert.equal((await passedOn("some", unread)).earlier, undefined);
});

test("what is edited while a check runs was not looked at, and is not taken for it", async (t) => {
  const { folder, passedOn } = await smallClone(t);
  const running = await passedOn("all");
  writeFileSync(join(folder, "code"), "edited");
  await running.keep(1);
  assert.equal((await passedOn("all")).earlier, undefined, "not as edited");
  writeFileSync(join(folder, "code"), "as it was");
  assert.equal((await passedOn("all")).earlier, undefined, "nor as it was");
});

test("another browser, and a page that is slowed down, are reasons to look again", async (t) => {
  const { folder, passedOn } = await smallClone(t);
  const outside = { ...process.env };
  t.after(() => (process.env = outside));
  await (await passedOn("all")).keep(1);
  process.env = { ...outside, CHROMIUM: join(folder, "code") };
  assert.equal((await passedOn("all")).earlier, undefined);
  process.env = { ...outside, DEMO_SLOWNESS: "4" };
  assert.equal((await passedOn("all")).earlier, undefined);
  process.env = outside;
  assert.equal((await passedOn("all")).earlier, 1);
});

test("without git nothing is taken for what has passed", async (t) => {
  const { passedOn } = await smallClone(t, { git: false });
  await (await passedOn("all")).keep(1);
  assert.equal((await passedOn("all")).earlier, undefined);
});
