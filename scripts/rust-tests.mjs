// The Rust tests: natively, in wasm under Node and in wasm in Chromium, and a check that none of the three is empty.

import { spawn } from "node:child_process";
import { readFileSync, statSync } from "node:fs";

import { launch } from "./browser.mjs";
import { StepError, at, children, endGroup, environment, root, run, sideBySide } from "./steps.mjs";

const TARGET = "wasm32-unknown-unknown";
/** The bindings that `tests/wasm.rs` calls. */
const BINDINGS = ["--features", "wasm,wasm-spline"];
const RUNNER = ["test-runner"];
/** A page that has said nothing for so long has died. */
const PATIENCE = 300_000;

/** How many tests an output of cargo's or wasm-bindgen's runner speaks of. */
function countCargo(output) {
  let passed = 0;
  let failed = 0;
  for (const [, p, f] of output.matchAll(/test result: \w+\. (\d+) passed; (\d+) failed/g)) {
    passed += Number(p);
    failed += Number(f);
  }
  return { passed, failed };
}

/** The part of an output that says what failed. */
function failuresOf(output) {
  const start = output.search(/^failures:$|^error(\[|:)|panicked at/m);
  return (start < 0 ? output : output.slice(start)).slice(0, 12_000);
}

/** A run that may fail: its counts, and what it said about failures. */
async function attempt(command, parameters, options) {
  try {
    return { ...countCargo(await run(command, parameters, options)), failures: "" };
  } catch (error) {
    if (!(error instanceof StepError)) throw error;
    const { passed, failed } = countCargo(error.output);
    return { passed, failed: Math.max(failed, 1), failures: `${error.message}\n${failuresOf(error.output)}` };
  }
}

/** Unit, promise and documentation tests on this machine. */
export function testNative() {
  return attempt("cargo", ["test", "--locked", "--no-fail-fast", "-p", "expline"]);
}

/** Compiles the promise tests for wasm: room and file of each, without those that say they are for another host. */
async function wasmTests(inBrowser) {
  const parameters = ["test", "--locked", "-p", "expline", "--target", TARGET, ...BINDINGS, "--tests", "--no-run", "--message-format=json"];
  const tests = [];
  for (const line of (await run("cargo", parameters)).split("\n")) {
    if (!line.startsWith("{")) continue;
    const { executable, target } = JSON.parse(line);
    if (!executable || !target.kind.includes("test")) continue;
    const source = readFileSync(target.src_path, "utf8");
    const hostOnly = /^#!\[cfg\(not\(target_arch = "wasm32"\)\)\]/m.test(source);
    const browserOnly = /^wasm_bindgen_test_configure!\(run_in_browser\)/m.test(source);
    if (!hostOnly && (inBrowser || !browserOnly)) tests.push({ name: target.name, file: executable, size: statSync(executable).size });
  }
  // What is longest begins first, so that nothing is left over for one core at the end; it is mostly what is largest.
  return tests.sort((a, b) => b.size - a.size);
}

/** Runs every file with `runOne` and adds up; a file that ran no test is a failure, since nobody would notice. */
async function all(inBrowser, runOne) {
  const sum = { passed: 0, failed: 0, failures: "" };
  const tests = await wasmTests(inBrowser);
  const results = await sideBySide(tests, runOne);
  for (const [i, test] of tests.entries()) {
    const { passed, failed, failures } = results[i];
    sum.passed += passed;
    sum.failed += failed;
    if (failures) sum.failures += `${test.name}: ${failures}\n`;
    if (passed + failed === 0) {
      sum.failed += 1;
      sum.failures += `${test.name} ran no test in wasm: alias wasm_bindgen_test as test, or say that it is for the host only\n`;
    }
  }
  return sum;
}

/** The promise tests in wasm under Node. */
export function testWasmInNode() {
  return all(false, ({ file }) => attempt(at("target/xtask/xtask"), [...RUNNER, file], { limit: PATIENCE }));
}

/** Starts the runner's server for one test file and gives back its address; undefined when there is nothing to run. */
function startRunner(file) {
  const env = environment({ WASM_BINDGEN_USE_BROWSER: "1", NO_HEADLESS: "1", WASM_BINDGEN_TEST_ADDRESS: "127.0.0.1:0" });
  const child = spawn(at("target/xtask/xtask"), [...RUNNER, file], { cwd: root, env, stdio: ["ignore", "pipe", "pipe"], detached: true });
  const forget = children.add(child);
  const stop = () => (forget(), endGroup(child));
  const address = new Promise((resolve, reject) => {
    let output = "";
    const read = (chunk) => {
      output += chunk;
      const found = /http:\/\/[\d.]+:\d+/.exec(output);
      if (found) resolve(found[0]);
    };
    child.stdout.setEncoding("utf8").on("data", read);
    child.stderr.setEncoding("utf8").on("data", read);
    child.on("close", () => {
      if (output.includes("no tests to run!")) resolve(undefined);
      else reject(new StepError("the wasm test runner ended before it served its page", output));
    });
  });
  return { address, stop };
}

/** Opens the runner's page for one test file and reads it until it has a result. */
async function testInPage(browser, file) {
  const { address, stop } = startRunner(file);
  try {
    const url = await address;
    if (url === undefined) return { passed: 0, failed: 0, failures: "" };
    const page = await browser.newPage();
    await page.goto(url);
    const done = () => document.querySelector("#output")?.textContent?.includes("test result: ");
    const silent = await page.waitForFunction(done, undefined, { timeout: PATIENCE }).then(() => false, () => true);
    // A page whose thread is held by a test answers nothing, not even that it is to be closed.
    const output = (await page.locator("#output").textContent({ timeout: 5_000 }).catch(() => "")) ?? "";
    const { passed, failed } = countCargo(output);
    if (silent) return { passed, failed: failed + 1, failures: `the page has said nothing for ${PATIENCE / 1000} s\n${failuresOf(output)}` };
    await page.close();
    return { passed, failed, failures: failed > 0 ? failuresOf(output) : "" };
  } finally {
    stop();
  }
}

/** The promise tests in wasm in headless Chromium, with no driver. */
export async function testWasmInChromium() {
  const browser = await launch();
  try {
    return await all(true, (test) => testInPage(browser, test.file));
  } finally {
    await browser.close();
  }
}
