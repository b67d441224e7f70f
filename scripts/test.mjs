// npm test: sets up, builds and runs every check there is, but for those that have passed on what there is now;
// `npm test -- rust demo` runs only those groups, whatever has passed, and `npm test -- demo/curve` of a group's test
// files only those with "curve" in their names.
//
// A build that fails ends the run at once. A check that fails is reported, and the others still run. The last line
// is "N passed, N failed", and the status is 0 only when nothing failed.

import { ensureChromium } from "./browser.mjs";
import { check, runAgain, suite, total } from "./checks.mjs";
import { buildDemo } from "./demo.mjs";
import { testNode } from "./node-tests.mjs";
import { buildPackage } from "./package.mjs";
import { installPacked } from "./packed.mjs";
import { testNative, testWasmInChromium, testWasmInNode } from "./rust-tests.mjs";
import { serve } from "./serve.mjs";
import { setUp } from "./setup.mjs";
import { SITE, buildSite } from "./site.mjs";
import { checkSize } from "./sizes.mjs";
import { StepError, at, door, run, seconds } from "./steps.mjs";
import { checkTree } from "./tree.mjs";
import { buildXtask } from "./wasm.mjs";

const TARGET = ["--target", "wasm32-unknown-unknown"];
const GROUPS = ["rust", "wasm", "js", "package", "www", "demo", "site"];
/** Groups of test files that can be run one by one; cargo has ways of its own. */
const FILES = ["js", "package", "www", "demo", "site"];

/**
 * What a suite does not read, so that a change of it is no reason to run it again. The native Rust tests have no line:
 * those of the house look at everything.
 */
const UNREAD = {
  wasm: /^(www|site|cli|ts|docs|bench|examples)\/|^tests\/(demo|js|package|site)\/|^[A-Z]+\.md$/,
  js: /^(www|site|docs|bench|examples)\/|^tests\/(demo|package|site|.*\.rs$)|^[A-Z]+\.md$/,
  package: /^www\/|^tests\/(demo|js|site|.*\.rs$)/,
  www: /^(docs|cli|bench|examples)\/|^tests\/(demo|js|package|site|.*\.rs$)|^[A-Z]+\.md$/,
  demo: /^(site|docs|cli|bench|examples|www\/tests)\/|^tests\/(js|package|site|.*\.rs$)|^[A-Z]+\.md$/,
  site: /^(cli|www\/tests)\/|^tests\/(js|package|.*\.rs$)/,
};

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
  await suite("Rust tests in wasm, Node", testWasmInNode, { unread: UNREAD.wasm });
  await suite("Rust tests in wasm, Chromium", testWasmInChromium, { unread: UNREAD.wasm });
}

/** A suite of test files: all of a group, or those with one of `parts` in their names. */
const files = (name, group, folder, out, { parts, env }) =>
  suite(name, () => testNode(folder, out, { parts, env }), { unread: UNREAD[group], inParts: parts.length > 0 });

async function js(parts) {
  await check("types of the tests", tsc("tests/tsconfig.json"));
  await installPacked();
  await files("the packed package in Node", "js", "tests/js", "build/consumer/js", { parts });
}

async function packaged(parts) {
  await installPacked();
  await files("the packed package elsewhere", "package", "tests/package", "build/consumer/package", { parts });
}

async function www(parts) {
  await check("types of the demo", tsc("www/tsconfig.json"));
  await files("the demo's parts", "www", "www/tests", "build/tests/www", { parts });
}

async function demo(parts) {
  await buildDemo();
  const { url, close } = await serve(at("www", "dist"), { port: 0 });
  try {
    await files("the demo in Chromium", "demo", "tests/demo", "build/tests/demo", { parts, env: { DEMO_URL: url } });
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
    await files("the documentation in Chromium", "site", "tests/site", "build/tests/site", { parts, env: { SITE_URL: `${url}docs/` } });
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
  if (asked.length > 0) runAgain();
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
  if (total.earlier > 0) console.log(`${total.earlier} of them passed in an earlier run: nothing that they read has changed; npm test -- ${GROUPS.join(" ")} runs them again`);
  if (total.failedSteps.length > 0) console.log(`✗ failed: ${total.failedSteps.join("; ")}`);
  console.log(`${total.passed} passed, ${total.failed} failed`);
  process.exit(total.failed > 0 ? 1 : 0);
});
