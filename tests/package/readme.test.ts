// Every snippet of the README runs as pasted, and every name of its table is there. Where a line says
// `console.log(…); // → text`, it prints that text.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

import { transform } from "esbuild";

import { type Recorded, inserted } from "../../bench/tables.mjs";
import { CONSUMER, runs, snippetsIn } from "./snippet.ts";

const text = readFileSync(join(process.cwd(), "README.md"), "utf8");

const snippets = (language: string): string[] => snippetsIn(text, language);

for (const [i, code] of snippets("js").entries()) {
  test(`snippet ${i + 1} of the README runs, and prints what it says`, () => {
    runs(`snippet-${i}`, code);
  });
}

test("the worker's snippets run: a newer picture ends the work on an older one, and curves cross as they are", async () => {
  const [tracer = "", page = ""] = snippets("mjs");
  const inThread = `
    import { parentPort } from "node:worker_threads";
    globalThis.postMessage = (message) => parentPort.postMessage(message);
    globalThis.addEventListener = (_, hear) => parentPort.on("message", (data) => hear({ data }));
  `;
  writeFileSync(join(CONSUMER, "tracer.js"), inThread + tracer);
  const inPage = `
    import { Worker as Thread } from "node:worker_threads";
    globalThis.Worker = class {
      constructor(url) { this.thread = new Thread(url); this.heard = new Map(); globalThis.thread = this.thread; }
      addEventListener(_, hear) {
        this.heard.set(hear, (data) => hear({ data }));
        this.thread.on("message", this.heard.get(hear));
      }
      removeEventListener(_, hear) { this.thread.off("message", this.heard.get(hear)); }
      postMessage(message) { this.thread.postMessage(message); }
    };
    const { trace, traced } = await import("./page.mjs");
    const shade = (i) => 255 * Math.min(1, Math.max(0, Math.hypot((i % 64) - 31.5, (i >> 6) - 31.5) - 19.5));
    const disc = { width: 64, height: 64, data: Uint8Array.from({ length: 4096 }, (_, i) => shade(i)) };
    const noise = { width: 300, height: 300, data: Uint8Array.from({ length: 90000 }, (_, i) => (i * 7919) % 251) };
    trace(1, noise);
    trace(2, disc);
    trace(3, disc, { tolerance: -1 });
    const ends = await Promise.allSettled([traced(1), traced(2), traced(3)]);
    trace(4, disc);
    const [round] = await traced(4);
    const listening = globalThis.thread.listenerCount("message");
    console.log(JSON.stringify([ends.map(({ reason }) => reason?.code), round.asEllipse(0.05).radii, listening]));
    await globalThis.thread.terminate();
  `;
  writeFileSync(join(CONSUMER, "page.mjs"), page);
  writeFileSync(join(CONSUMER, "in-page.mjs"), inPage);
  const { stdout, stderr, status } = spawnSync(process.execPath, [join(CONSUMER, "in-page.mjs")], { encoding: "utf8", timeout: 60_000 });
  assert.equal(status, 0, stderr);
  const [codes, [radius], listening] = JSON.parse(stdout) as [(string | null)[], [number, number], number];
  assert.equal(listening, 0, "nobody listens to answers that have come");
  assert.deepEqual(codes, ["E_CANCELLED", "E_CANCELLED", "E_RANGE"]);
  assert.ok(Math.abs(radius - 20) < 0.05, `a disc of radius 20 has ${radius}`);
});

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

test("the README's sizes are those of the package, gzipped, within a kilobyte", () => {
  const line = /^Size, gzipped: .*$/m.exec(text)?.[0] ?? "";
  const files = {
    "curves and paths": "core.js",
    "pointer editing": "edit.js",
    "curves of any roots": "spline.js",
    surfaces: "surface.js",
    fitting: "fit.js",
    tracing: "trace.js",
  };
  for (const [words, file] of Object.entries(files)) {
    const said = Number(new RegExp(`${words} ([0-9.]+) kB`).exec(line)?.[1]);
    const { length } = gzipSync(readFileSync(join(CONSUMER, "node_modules", "expline", "pkg", file)), { level: 9 });
    assert.ok(Math.abs(length / 1000 - said) < 1, `${words}: the README says ${said} kB, ${file} has ${length} bytes`);
  }
});
