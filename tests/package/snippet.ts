// Runs code of the documentation as somebody who pasted it would, in a project that has the package.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";

export const CONSUMER = join(process.cwd(), "build", "consumer");

/** The blocks of a document that are code of a language. */
export function snippetsIn(text: string, language: string): string[] {
  return [...text.matchAll(new RegExp(`^\`\`\`${language}\\n([\\s\\S]*?)^\`\`\`$`, "gm"))].map(([, code]) => code ?? "");
}

/** Runs a module there. Where a line says `console.log(…); // → text`, it has to print that text. */
export function runs(name: string, code: string): void {
  const file = join(CONSUMER, `${name}.mjs`);
  writeFileSync(file, code);
  const { stdout, stderr, status } = spawnSync(process.execPath, [file], { encoding: "utf8" });
  assert.equal(status, 0, stderr);
  const expected = [...code.matchAll(/^console\.log\(.*\); \/\/ → (.*)$/gm)].map(([, line]) => line);
  if (expected.length > 0) assert.deepEqual(stdout.trimEnd().split("\n"), expected);
}
