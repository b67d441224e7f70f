// THIRD_PARTY_LICENSES: the licences of every crate that is linked into the wasm, and of every npm package that is
// bundled into the command line, taken from themselves.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

import { KINDS } from "./kinds.mjs";
import { at, environment, root } from "./steps.mjs";

const TARGET = "wasm32-unknown-unknown";
/** Bindings and allocator are linked with these only: the crate has no default features. */
const FEATURES = ["--features", KINDS.map(({ feature }) => feature).join()];

function cargo(...parameters) {
  const options = { cwd: root, env: environment(), encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] };
  return execFileSync("cargo", parameters, options);
}

/** The packages that the wasm is built from: normal dependencies, no procedural macros and no build scripts. */
function linkedPackages() {
  const { packages } = JSON.parse(cargo("metadata", "--locked", "--format-version", "1", "--filter-platform", TARGET, ...FEATURES));
  const tree = ["--locked", "-e", "normal,no-proc-macro", "--target", TARGET, "-p", "expline", "--prefix", "none", ...FEATURES];
  const linked = new Set(cargo("tree", ...tree, "--format", "{p}").split("\n").map((line) => line.split(" ").slice(0, 2).join(" ")));
  const isLinked = (p) => p.name !== "expline" && linked.has(`${p.name} v${p.version}`);
  return packages.filter(isLinked).sort((a, b) => (a.name < b.name ? -1 : 1));
}

/** npm packages by name, in the same form as crates. */
function bundledPackages(names) {
  return names.map((name) => {
    const manifest = at("node_modules", name, "package.json");
    const { version, license } = JSON.parse(readFileSync(manifest, "utf8"));
    return { name, version, license, manifest_path: manifest };
  });
}

function licenceTexts(manifest) {
  const folder = dirname(manifest);
  const names = readdirSync(folder).filter((n) => /^(licen[cs]e|copying|notice)/i.test(n)).sort();
  return names.filter((n) => existsSync(join(folder, n))).map((n) => readFileSync(join(folder, n), "utf8").trim());
}

/**
 * Writes the file; equal texts are printed once, under the names of all that carry them. `bundled`: names of npm
 * packages.
 */
export function writeThirdPartyLicenses(bundled) {
  const [crates, modules] = [linkedPackages(), bundledPackages(bundled)];
  const texts = new Map();
  for (const p of [...crates, ...modules]) {
    for (const text of licenceTexts(p.manifest_path)) texts.set(text, [...(texts.get(text) ?? []), p.name]);
  }
  const list = (packages) => packages.map((p) => `${p.name} ${p.version}: ${p.license ?? "see its text"}`).join("\n");
  const parts = [...texts].map(([text, names]) => `${"-".repeat(78)}\n${names.join(", ")}\n${"-".repeat(78)}\n\n${text}\n`);
  const heads = [
    `The wasm of expline links the following crates, besides Rust's own library (MIT OR Apache-2.0).\n\n${list(crates)}\n`,
    `Its command line, pkg/cli.js, reads pictures with the following npm packages.\n\n${list(modules)}\n`,
  ];
  writeFileSync(at("THIRD_PARTY_LICENSES"), `${heads.join("\n")}\n${parts.join("\n")}`);
}
