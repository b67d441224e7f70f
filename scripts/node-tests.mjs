// Tests written in TypeScript: bundled with esbuild (packages stay outside), run by `node --test`.

import { mkdirSync, readFileSync, rmSync } from "node:fs";
import { availableParallelism } from "node:os";
import { basename, resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { StepError, at, filesUnder, root, run } from "./steps.mjs";

/** The scripts know the clone by their own place, so they are imported from there. */
const scriptsStay = {
  name: "scripts-stay",
  setup(build) {
    build.onResolve({ filter: /\/scripts\/[\w-]+\.mjs$/ }, ({ path, resolveDir }) => ({
      path: pathToFileURL(resolve(resolveDir, path)).href,
      external: true,
    }));
  },
};

/** Bundles every *.test.ts under `folder` whose name has one of `parts` in it into `out` and gives back the files. */
async function bundle(folder, out, parts) {
  const asked = (file) => parts.length === 0 || parts.some((part) => basename(file, ".test.ts").includes(part));
  const entryPoints = filesUnder([folder]).filter((file) => file.endsWith(".test.ts") && asked(file));
  if (entryPoints.length === 0) return [];
  rmSync(at(out), { recursive: true, force: true });
  const { build } = await import("esbuild");
  await build({
    entryPoints,
    outdir: at(out),
    outbase: at(folder),
    outExtension: { ".js": ".mjs" },
    absWorkingDir: root,
    bundle: true,
    packages: "external",
    plugins: [scriptsStay],
    platform: "node",
    format: "esm",
    target: "node20",
    sourcemap: "inline",
    logLevel: "error",
  });
  return filesUnder([out]);
}

const count = (tap, word) => Number(new RegExp(`^# ${word} (\\d+)$`, "m").exec(tap)?.[1] ?? 0);

/**
 * Node 20 loses a wasm instance that a collection moves while a function asks to be compiled better, and dies of it
 * (one run in thirty of a test that calls 20,000 times without a pause): nothing is moved while something runs.
 */
const still = process.version.startsWith("v20.") ? ["--no-compact-with-stack"] : [];

/** What ended test files that did not end by themselves; the runner's summary does not say it. */
function killed(tap) {
  const signals = [...tap.matchAll(/^not ok \d+ - (.+)\n  ---\n(?:  .*\n)*?  signal: '(\w+)'$/gm)];
  return signals.map(([, file, signal]) => `\n${file} was ended by ${signal}`).join("");
}

/** What the tests themselves reported (`t.diagnostic`), without the runner's own counts. */
function diagnostics(tap) {
  const own = /^\s*# (?!Subtest|tests |suites |pass |fail |cancelled |skipped |todo |duration_ms)(.+)$/gm;
  return [...tap.matchAll(own)].map(([, line]) => line);
}

/**
 * Runs the tests under `folder`; `out` decides which `expline` they find (the package of the clone, or the packed one).
 * They run in the clone's folder, so that they can read its files. With `parts` only files that have one of them in
 * their name do.
 */
export async function testNode(folder, out, { parts = [], env = {}, limit = 1_800_000 } = {}) {
  const files = await bundle(folder, out, parts);
  const none = `${folder} has no *${parts.join("* or *")}*.test.ts\n`;
  if (files.length === 0) return { passed: 0, failed: 1, failures: none, notes: [] };
  mkdirSync(at("build/logs"), { recursive: true });
  const log = at("build/logs", `${basename(out)}.txt`);
  const reporters = ["--test-reporter=tap", "--test-reporter-destination=stdout", "--test-reporter=spec", `--test-reporter-destination=${log}`];
  let tap;
  let failures = "";
  try {
    // Left to itself the runner keeps a core free, which of two is half.
    const parallel = `--test-concurrency=${availableParallelism()}`;
    tap = await run("node", ["--enable-source-maps", ...still, "--test", parallel, ...reporters, ...files], { env, limit });
  } catch (error) {
    if (!(error instanceof StepError)) throw error;
    tap = error.output;
    const text = readFileSync(log, "utf8");
    const start = text.lastIndexOf("failing tests:");
    failures = start < 0 ? `${error.message}\n${tap.slice(-8000)}` : text.slice(start, start + 12_000);
    failures += killed(tap);
  }
  const failed = count(tap, "fail") + count(tap, "cancelled");
  return { passed: count(tap, "pass"), failed: failures && failed === 0 ? 1 : failed, failures, notes: diagnostics(tap) };
}
