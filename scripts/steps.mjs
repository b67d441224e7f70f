// Steps: named, timed pieces of work that are skipped while nothing they read has changed.
//
// A step's stamp is one hash over the contents of its inputs; it is kept in build/stamps and compared before the
// step runs. Contents, not times of change: a fresh clone, a checkout or a touch rebuilds nothing by itself.

import { spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, lstatSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder of the clone. */
export const root = dirname(dirname(fileURLToPath(import.meta.url)));

/** A path inside the clone. */
export const at = (...parts) => join(root, ...parts);

/** A failure whose message is the one line that a person needs; `output` is what the failing command printed. */
export class StepError extends Error {
  constructor(message, output = "") {
    super(message);
    this.name = "StepError";
    this.output = output;
  }
}

/** Every file under the given files and folders, sorted; what is not there is left out. */
export function filesUnder(paths) {
  const found = [];
  const visit = (path) => {
    if (!existsSync(path)) return;
    if (lstatSync(path).isDirectory()) {
      for (const name of readdirSync(path).sort()) visit(join(path, name));
    } else {
      found.push(path);
    }
  };
  for (const path of paths) visit(at(path));
  return found;
}

/** What a file holds; one that is gone, or a link to nowhere, has none of it. */
function contents(file) {
  try {
    return readFileSync(file);
  } catch {
    return "(none)";
  }
}

/** One hash over the names and contents of files of the clone. */
export function fingerprint(files, salt) {
  const hash = createHash("sha256").update(salt);
  for (const file of files) hash.update(`\0${file.slice(root.length)}\0`).update(contents(file));
  return hash.digest("hex");
}

/** `12.3 s` */
export const seconds = (since) => `${((performance.now() - since) / 1000).toFixed(1)} s`;

/**
 * Runs `action` under a name, says how long it took, and skips it while the stamp of its inputs stands and its
 * outputs are there. Without `inputs` it always runs. What `action` returns as a string is added to the line. A step
 * that is not `alone` says its line when it is over.
 */
export async function step(name, { inputs, outputs = [], salt = "", alone = true } = {}, action) {
  const stamp = at("build", "stamps", `${name.replace(/[^\w-]+/g, "-")}.txt`);
  const before = inputs && fingerprint(filesUnder(inputs), salt);
  if (before && existsSync(stamp) && readFileSync(stamp, "utf8") === before && outputs.every((o) => existsSync(at(o)))) {
    console.log(`• ${name} … unchanged`);
    return undefined;
  }
  const start = performance.now();
  const line = `• ${name} … `;
  if (alone) process.stdout.write(line);
  const rest = alone ? "" : line;
  let said;
  try {
    said = await action();
  } catch (error) {
    console.log(`${rest}failed after ${seconds(start)}`);
    if (error instanceof StepError) throw new StepError(`${name}: ${error.message}`, error.output);
    throw error;
  }
  console.log(rest + (typeof said === "string" && said !== "" ? `${seconds(start)} (${said})` : seconds(start)));
  if (before) {
    mkdirSync(dirname(stamp), { recursive: true });
    writeFileSync(stamp, before);
  }
  return said;
}

/** The environment of every command: outputs inside the clone, flags from the project's own files. */
export function environment(extra = {}) {
  const { RUSTFLAGS, CARGO_ENCODED_RUSTFLAGS, NODE_OPTIONS, ...rest } = process.env;
  // Who builds once, in a fresh clone, has no use for what makes the next build short: 4 GB of 9.
  const once = rest.CI === undefined ? {} : { CARGO_INCREMENTAL: "0" };
  return { ...rest, ...once, CARGO_TARGET_DIR: at("target"), CARGO_TERM_COLOR: "never", ...extra };
}

/**
 * Runs a command to its end and gives back what it printed; a status other than 0 is a StepError with the output.
 * The command gets a process group of its own, so that `limit` (milliseconds) ends all that it started.
 */
export function run(command, parameters, { env = {}, cwd = root, limit = 0 } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, parameters, { cwd, env: environment(env), stdio: ["ignore", "pipe", "pipe"], detached: true });
    let output = "";
    let timer;
    const collect = (chunk) => (output += chunk);
    child.stdout.setEncoding("utf8").on("data", collect);
    child.stderr.setEncoding("utf8").on("data", collect);
    if (limit > 0) {
      timer = setTimeout(() => {
        output += `\n(stopped after ${limit / 1000} s)\n`;
        endGroup(child);
      }, limit);
    }
    const forget = children.add(child);
    child.on("error", (error) => {
      forget();
      clearTimeout(timer);
      reject(new StepError(error.code === "ENOENT" ? `${command} is not installed` : error.message, output));
    });
    child.on("close", (status) => {
      forget();
      clearTimeout(timer);
      if (status === 0) resolve(output);
      else reject(new StepError(`${[command, ...parameters].join(" ").slice(0, 120)} ended with ${status ?? "a signal"}`, output));
    });
  });
}

/**
 * Runs a command whose output goes straight to the terminal; a status other than 0 is a StepError with this message.
 */
export async function show(command, parameters, message) {
  const child = spawn(command, parameters, { cwd: root, env: environment(), stdio: "inherit" });
  const status = await new Promise((resolve) => child.on("close", resolve));
  if (status !== 0) throw new StepError(message);
}

/** Does `work` for every item, as many at once as there are cores; gives back the results in the order of the items. */
export async function sideBySide(items, work) {
  const results = [];
  const waiting = items.entries();
  const worker = async () => {
    for (const [i, item] of waiting) results[i] = await work(item);
  };
  await Promise.all(Array.from({ length: Math.min(items.length, availableParallelism()) }, worker));
  return results;
}

/** Ends a command and everything that it started. */
export function endGroup(child) {
  try {
    process.kill(-child.pid, "SIGKILL");
  } catch {
    child.kill("SIGKILL"); // the group has gone already
  }
}

/** The commands that still run; they end with this process, whatever ends it. */
export const children = {
  running: new Set(),
  add(child) {
    this.running.add(child);
    return () => this.running.delete(child);
  },
  endAll() {
    for (const child of this.running) endGroup(child);
  },
};

process.on("exit", () => children.endAll());
for (const signal of ["SIGINT", "SIGTERM", "SIGHUP"]) process.on(signal, () => process.exit(130));

/** Runs a door's main function: a StepError ends it with its output and one clear line. */
export async function door(main) {
  try {
    await main();
  } catch (error) {
    if (!(error instanceof StepError)) throw error;
    if (error.output) console.error(error.output.split("\n").slice(-80).join("\n"));
    console.error(`✗ ${error.message}`);
    process.exit(1);
  }
}
