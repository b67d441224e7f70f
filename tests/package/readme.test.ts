// Every snippet of the README runs as pasted, and every name of its table is there. Where a line says
// `console.log(…); // → text`, it prints that text.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { join } from "node:path";

import { transform } from "esbuild";

import { type Recorded, inserted } from "../../bench/tables.mjs";

const consumer = join(process.cwd(), "build", "consumer");
const text = readFileSync(join(process.cwd(), "README.md"), "utf8");

function snippets(language: string): string[] {
  return [...text.matchAll(new RegExp(`^\`\`\`${language}\\n([\\s\\S]*?)^\`\`\`$`, "gm"))].map(([, code]) => code ?? "");
}

for (const [i, code] of snippets("js").entries()) {
  test(`snippet ${i + 1} of the README runs, and prints what it says`, () => {
    const file = join(consumer, `snippet-${i}.mjs`);
    writeFileSync(file, code);
    const { stdout, stderr, status } = spawnSync(process.execPath, [file], { encoding: "utf8" });
    assert.equal(status, 0, stderr);
    const expected = [...code.matchAll(/^console\.log\(.*\); \/\/ → (.*)$/gm)].map(([, line]) => line);
    if (expected.length > 0) assert.deepEqual(stdout.trimEnd().split("\n"), expected);
  });
}

test("the React snippet is sound JSX, and imports what there is", async () => {
  const [code = ""] = snippets("jsx");
  const { warnings } = await transform(code, { loader: "jsx" });
  assert.deepEqual(warnings, []);
  const names = /import \{ ([^}]+) \} from "expline"/.exec(code)?.[1]?.split(", ") ?? [];
  const library = (await import("expline")) as Record<string, unknown>;
  assert.ok(names.length > 0 && names.every((name) => name in library), "an import that is not there");
});

test("every call in the README's table exists", async () => {
  const library = (await import("expline")) as Record<string, unknown>;
  const { BSplineCurve, HermiteCurve, InterpolatingCurve, SparseFitter, TensorSurface, roots } = await import("expline");
  const owners = [HermiteCurve, InterpolatingCurve, BSplineCurve, TensorSurface, SparseFitter].flatMap((owner) => [owner, owner.prototype]);
  const table = text.slice(text.indexOf("## API at a glance")).match(/^\| .*$/gm) ?? [];
  const calls = table.flatMap((row) => [...(row.split(" | ")[0] ?? "").matchAll(/(?<![\w}])\.?([a-z]\w+)(?=\()/g)].map(([, name = ""]) => name));
  assert.ok(calls.length > 20, "the table was not found");
  const known = (name: string) => [library, roots, ...owners].some((owner) => name in owner);
  assert.deepEqual(calls.filter((name) => !known(name)), []);
});

test("the README's tables of times are those of the run that was kept", () => {
  const recorded = JSON.parse(readFileSync(join(process.cwd(), "bench", "recorded.json"), "utf8")) as Recorded;
  assert.ok(recorded.rows.length > 15, "a whole run");
  assert.equal(inserted(text, recorded), text, "`npm run bench -- --record` makes them");
});
