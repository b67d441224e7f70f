// What a fresh clone needs before anything can be built: the Rust toolchain of rust-toolchain.toml, the npm packages
// of package-lock.json. Uses Node's own modules only, since it runs before any package is there.

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";

import { StepError, at, run, step } from "./steps.mjs";

const TARGET = "wasm32-unknown-unknown";

async function rustc(...parameters) {
  return (await run("rustc", parameters)).trim();
}

async function rustIsReady() {
  try {
    const channel = /channel = "([^"]+)"/.exec(readFileSync(at("rust-toolchain.toml"), "utf8"))?.[1] ?? "";
    const version = await rustc("--version");
    return version.includes(channel) && existsSync(join(await rustc("--print", "sysroot"), "lib", "rustlib", TARGET));
  } catch {
    return false;
  }
}

async function installRust() {
  try {
    await run("rustup", ["--version"]);
  } catch {
    throw new StepError("rustup is missing; install it from https://rustup.rs and run this again");
  }
  // Obeys rust-toolchain.toml (channel, components, targets), also where rustup's automatic installation is off.
  await run("rustup", ["toolchain", "install", "--no-self-update"]);
  if (!(await rustIsReady())) await run("rustup", ["target", "add", TARGET]);
}

/** Rust with the wasm target, and the npm packages. */
export async function setUp() {
  const [major = 0, minor = 0] = process.versions.node.split(".").map(Number);
  if (major < 20 || major === 21 || (major === 20 && minor < 19) || (major === 22 && minor < 12)) {
    throw new StepError(`Node ${process.versions.node} is too old; 20.19, 22.12 or newer is needed`);
  }
  if (!(await rustIsReady())) await step("rust toolchain", {}, installRust);
  await step("npm packages", { inputs: ["package-lock.json"], outputs: ["node_modules/.package-lock.json"] }, async () => {
    await run("npm", ["ci", "--ignore-scripts", "--no-audit", "--no-fund"]);
  });
}
