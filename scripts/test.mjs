// npm test: sets up, builds and runs every check there is; `npm test -- rust demo` runs only those groups, and
// `npm test -- demo/curve` of a group's test files only those with "curve" in their names.
//
// A build that fails ends the run at once. A check that fails is reported, and the others still run. The last line
// is "N passed, N failed", and the status is 0 only when nothing failed.

import { buildDemo } from "./demo.mjs";
import { ensureChromium } from "./browser.mjs";
import { testNode } from "./node-tests.mjs";
import { buildPackage } from "./package.mjs";
import { installPacked } from "./packed.mjs";
import { testNative, testWasmInChromium, testWasmInNode } from "./rust-tests.mjs";
import { serve } from "./serve.mjs";
import { setUp } from "./setup.mjs";
import { SITE, buildSite } from "./site.mjs";
import { checkSize } from "./sizes.mjs";
import { StepError, at, door, run, seconds, step } from "./steps.mjs";
import { checkTree } from "./tree.mjs";
import { buildXtask } from "./wasm.mjs";

const TARGET = ["--target", "wasm32-unknown-unknown"];
const GROUPS = ["rust", "wasm", "js", "package", "www", "demo", "site"];
/** Groups of test files that can be run one by one; cargo has ways of its own. */
const FILES = ["js", "package", "www", "demo", "site"];

const total = { passed: 0, failed: 0, failedSteps: [] };

/** A check as a whole that came to nothing. */
function failed(name, error) {
  if (!(error instanceof StepError)) throw error;
  total.failed += 1;
  total.failedSteps.push(name);
  console.log(error.output.split("\n").slice(-60).join("\n"));
  console.log(`✗ ${error.message}`);
}

/** A check that passes or fails as a whole and counts as one. */
async function check(name, action) {
  try {
    await step(name, {}, action);
    total.passed += 1;
  } catch (error) {
    failed(name, error);
  }
}

/**
 * A suite of tests with counts of its own; one that cannot be built or started is one that failed, and so is one
 * without tests.
 */
async function suite(name, action) {
  let result;
  try {
    await step(name, {}, async () => {
      result = await action();
      if (result.passed + result.failed === 0) throw new StepError("no test was run");
      return `${result.passed} passed, ${result.failed} failed`;
    });
  } catch (error) {
    return failed(name, error);
  }
  for (const note of result.notes ?? []) console.log(`    ${note}`);
  total.passed += result.passed;
  total.failed += result.failed;
  if (result.failed > 0) {
    total.failedSteps.push(name);
    console.log(result.failures);
  }
}

const cargo = (...parameters) => () => run("cargo", parameters).then(() => undefined);
const rustdoc = (...more) => () =>
  run("cargo", ["doc", "--locked", "-p", "expline", "--no-deps", ...more], { env: { RUSTDOCFLAGS: "-D warnings" } }).then(() => undefined);
const tsc = (project) => () => run("node", [at("node_modules/typescript/bin/tsc"), "--noEmit", "-p", at(project)]).then(() => undefined);

async function rust() {
  await check("format", cargo("fmt", "--all", "--check", "--", "--color", "never"));
  await check("clippy, host", cargo("clippy", "--locked", "-p", "expline", "--all-targets", "--", "-D", "warnings"));
  // clippy knows #[test] and asks it for no messages, but does not know wasm_bindgen_test.
  const lenient = ["-D", "warnings", "-A", "clippy::missing_assert_message"];
  await check("clippy, wasm", cargo("clippy", "--locked", "-p", "expline", "--features", "wasm,wasm-fit,wasm-spline,wasm-surface,wasm-trace", ...TARGET, "--lib", "--tests", "--", ...lenient));
  await check("rustdoc", rustdoc());
  // A link from the interface to what is private is a fault only where what is private is left out: both are looked at.
  await check("rustdoc, private items", rustdoc("--document-private-items"));
  await suite("Rust tests, native", testNative);
}

async function wasm() {
  await buildXtask();
  await suite("Rust tests in wasm, Node", testWasmInNode);
  await suite("Rust tests in wasm, Chromium", testWasmInChromium);
}

async function js(parts) {
  await check("types of the tests", tsc("tests/tsconfig.json"));
  await installPacked();
  await suite("the packed package in Node", () => testNode("tests/js", "build/consumer/js", { parts }));
}

async function packaged(parts) {
  await installPacked();
  await suite("the packed package elsewhere", () => testNode("tests/package", "build/consumer/package", { parts }));
}

async function www(parts) {
  await check("types of the demo", tsc("www/tsconfig.json"));
  await suite("the demo's parts", () => testNode("www/tests", "build/tests/www", { parts }));
}

async function demo(parts) {
  await buildDemo();
  const { url, close } = await serve(at("www", "dist"), { port: 0 });
  try {
    await suite("the demo in Chromium", () => testNode("tests/demo", "build/tests/demo", { parts, env: { DEMO_URL: url } }));
  } finally {
    await close();
  }
}

async function site(parts) {
  await check("types of the site", tsc("site/tsconfig.json"));
  await buildDemo();
  await buildSite();
  const { url, close } = await serve(at("www", "dist"), { port: 0, beside: { docs: at(SITE) } });
  try {
    await suite("the documentation in Chromium", () => testNode("tests/site", "build/tests/site", { parts, env: { SITE_URL: `${url}docs/` } }));
  } finally {
    await close();
  }
}

/** A group, or a part of the names of a group's test files: "demo", "demo/curve". */
function readAsked(text) {
  const [group, part] = text.split("/", 2);
  if (!GROUPS.includes(group)) throw new StepError(`there is no group ${group}; the groups are ${GROUPS.join(", ")}`);
  if (part && !FILES.includes(group)) throw new StepError(`${group} runs as a whole here; its parts are cargo's: cargo test --test ${part}`);
  return { group, part };
}

await door(async () => {
  const start = performance.now();
  const asked = process.argv.slice(2).map(readAsked);
  const wanted = (name) => asked.length === 0 || asked.some(({ group }) => group === name);
  const parts = (name) => {
    const own = asked.filter(({ group }) => group === name).map(({ part }) => part);
    return own.every(Boolean) ? own : [];
  };
  await setUp();
  const chromium = await ensureChromium();
  process.env.CHROMIUM = chromium;
  if (asked.length === 0) await check("the tree's own rules", checkTree);
  if (wanted("rust")) await rust();
  if (wanted("wasm")) await wasm();
  if (FILES.some(wanted)) await buildPackage();
  if (asked.length === 0) await check("size of the package", async () => checkSize());
  if (wanted("js")) await js(parts("js"));
  if (wanted("package")) await packaged(parts("package"));
  if (wanted("www")) await www(parts("www"));
  if (wanted("demo")) await demo(parts("demo"));
  if (wanted("site")) await site(parts("site"));
  console.log(`\n${seconds(start)} in all`);
  if (total.failedSteps.length > 0) console.log(`✗ failed: ${total.failedSteps.join("; ")}`);
  console.log(`${total.passed} passed, ${total.failed} failed`);
  process.exit(total.failed > 0 ? 1 : 0);
});
