// Every piece of code of the guides runs as pasted, and prints what it says; what the playground begins with runs, too.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { transform } from "esbuild";

import { EXAMPLES } from "../../site/playground/examples.ts";
import { runs, snippetsIn } from "./snippet.ts";

const GUIDES = join(process.cwd(), "docs", "guide");
const read = (name: string): string => readFileSync(join(GUIDES, name), "utf8");
const guides = readdirSync(GUIDES);

for (const name of guides) {
  for (const [i, code] of snippetsIn(read(name), "js").entries()) {
    test(`code ${i + 1} of ${name} runs, and prints what it says`, () => {
      runs(`${name.replace(".md", "")}-${i}`, code);
    });
  }
}

test("other code of the guides is sound: it parses, and imports what there is", async () => {
  const library = (await import("expline")) as Record<string, unknown>;
  const known = new Set(["js", "jsx", "mjs", "sh"]);
  for (const name of guides) {
    const text = read(name);
    for (const [, language = ""] of text.matchAll(/^```(\w+)$/gm)) assert.ok(known.has(language), `${name} has code of ${language}, which nothing looks at`);
    for (const code of ["jsx", "mjs"].flatMap((language) => snippetsIn(text, language))) {
      const { warnings } = await transform(code, { loader: "jsx" });
      assert.deepEqual(warnings, [], name);
      const names = /import \{ ([^}]+) \} from "expline"/.exec(code)?.[1]?.split(", ") ?? [];
      assert.deepEqual(names.filter((each) => !(each in library)), [], name);
    }
  }
});

test("the guide to workers has the README's worker, which is tested there", () => {
  const readme = readFileSync(join(process.cwd(), "README.md"), "utf8");
  assert.deepEqual(snippetsIn(read("workers.md"), "mjs"), snippetsIn(readme, "mjs"));
});

for (const { name, code } of EXAMPLES) {
  test(`the playground's example “${name}” runs in Node as well`, () => {
    runs(`example-${name.toLowerCase().replace(/\W+/g, "-")}`, code);
  });
}

test("guides are short: two screens of text at most", () => {
  const longest = 950;
  // Code and tables are looked up, not read.
  const words = (text: string): number => text.replace(/^```[\s\S]*?^```$|^\|.*$/gm, "").split(/\s+/).length;
  assert.deepEqual(guides.filter((name) => words(read(name)) > longest), []);
});
