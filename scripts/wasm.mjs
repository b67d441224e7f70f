// Rust → a wasm for each kind of work → its bindings, and the wasm as text.

import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";

import { decoderModule, inlineModule, inlined } from "./inline-wasm.mjs";
import { BINDINGS, KINDS } from "./kinds.mjs";
import { at, run, sideBySide, step } from "./steps.mjs";

const RUST = ["src", "Cargo.toml", "Cargo.lock", "rust-toolchain.toml", ".cargo/config.toml"];
const XTASK = ["xtask", "Cargo.lock", "rust-toolchain.toml"];
const BOUND = "build/bound";
const INLINING = ["inline-wasm", "decoder", "copy-runs", "split-wasm", "number-locals", "wasm-functions"].map((name) => `scripts/${name}.mjs`);

/**
 * No object lies below address 1024, where the stack ends, so an address and what is added to it never overflow: the
 * sum is the offset of a load or a store.
 */
const ADDRESSES = "--low-memory-unused";

/**
 * wasm-opt, too, leaves functions functions there. Those of one room next to each other, which is the order of their
 * names, are less after compression: gzip looks back 32 kB only.
 */
const NOT_INLINED = ["-fimfs=0", "-aimfs=0", "-ocimfs=0"];

/** Data stay whole: the zeros between them are less after compression than where the parts begin would be. */
const WHOLE_DATA = "--skip-pass=memory-packing";

/** Features change what the crate is: with a folder for each kind none is built anew because another was. */
const target = ({ name }) => (name === "core" ? "target" : `target/${name}`);

/** What cargo leaves of a kind. */
const raw = (kind) => `${target(kind)}/wasm32-unknown-unknown/release/expline.wasm`;

/** What every browser since 2023 and Node 20 can run. */
const FEATURES = ["simd", "bulk-memory", "nontrapping-float-to-int", "sign-ext", "mutable-globals", "reference-types", "multivalue"].map(
  (feature) => `--enable-${feature}`,
);

/** The bindings tool and the wasm test runner, at exactly the version of Cargo.lock. */
export async function buildXtask() {
  await step("bindings tool", { inputs: XTASK, outputs: ["target/xtask/xtask"] }, async () => {
    await run("cargo", ["build", "--locked", "-p", "xtask", "--profile", "xtask"]);
  });
}

/**
 * The flags of .cargo/config.toml, and how much the compiler may copy; loops that run who knows how often are never
 * there several times.
 */
function flags({ inline, unroll, unswitch }) {
  const [, list = ""] = /^rustflags = \[([^\]]*)\]/m.exec(readFileSync(at(".cargo/config.toml"), "utf8")) ?? [];
  const copies = [`inline-threshold=${inline}`, `unroll-threshold=${unroll}`, "unroll-runtime=false", `unswitch-threshold=${unswitch}`];
  return [...JSON.parse(`[${list.replace(/,\s*$/, "")}]`), "-C", `llvm-args=${copies.map((option) => `-${option}`).join(" ")}`];
}

/** Every kind, side by side: the last part of each build, the longest, uses one core only. */
export async function buildWasm() {
  const inputs = [...RUST, "scripts/wasm.mjs", "scripts/kinds.mjs"];
  await step("wasm", { inputs, outputs: KINDS.map(raw) }, async () => {
    await sideBySide(KINDS, async (kind) => {
      const env = { CARGO_ENCODED_RUSTFLAGS: flags(kind).join("\x1f"), CARGO_TARGET_DIR: at(target(kind)) };
      const features = ["--no-default-features", "--features", kind.feature];
      // Of a wasm alone, without the library for Rust beside it, the compiler knows more to be called from one place
      // only.
      const library = ["rustc", "--lib", "--crate-type", "cdylib"];
      await run("cargo", [...library, "--locked", "-p", "expline", "--release", "--target", "wasm32-unknown-unknown", ...features], { env });
    });
  });
}

/** The wasm that reads inlined wasm. */
async function buildDecoder() {
  const outputs = ["wasm-decoder.js", "wasm-decoder.json", "wasm-decoder.d.ts"].map((f) => `${BINDINGS}/${f}`);
  await step("decoder", { inputs: INLINING, outputs }, async () => {
    const { code, declarations, text } = await decoderModule();
    mkdirSync(at(BINDINGS), { recursive: true });
    writeFileSync(at(BINDINGS, "wasm-decoder.json"), JSON.stringify(text));
    writeFileSync(at(BINDINGS, "wasm-decoder.js"), code);
    writeFileSync(at(BINDINGS, "wasm-decoder.d.ts"), declarations);
  });
}

/** The bindings of a kind. */
async function bind(kind) {
  const { name, file, inline } = kind;
  const inputs = [raw(kind), "target/xtask/xtask", "scripts/snip.mjs", "scripts/wasm.mjs", "scripts/kinds.mjs"];
  const outputs = [`${file}.d.ts`, `${file}_bg.wasm`].map((f) => `${BINDINGS}/${f}`);
  await step(`bindings, ${name}`, { inputs, outputs, alone: false }, async () => {
    const flags = ["--target", "web", "--omit-default-module-path", "--remove-producers-section", "--out-name", file, "--out-dir", at(BOUND)];
    await run(at("target/xtask/xtask"), ["bindgen", at(raw(kind)), ...flags]);
    mkdirSync(at(BINDINGS), { recursive: true });
    for (const binding of [`${file}.js`, `${file}.d.ts`]) cpSync(at(BOUND, binding), at(BINDINGS, binding));
    await run("node", [at("scripts/snip.mjs"), at(BOUND, `${file}_bg.wasm`), at(BOUND, `${file}_snipped.wasm`)]);
    await run("node", [
      at("node_modules/binaryen/bin/wasm-opt"),
      ...["-O3", ADDRESSES, WHOLE_DATA, ...(inline === 0 ? NOT_INLINED : []), "--reorder-functions-by-name", ...FEATURES, "--strip-debug", "--strip-producers", "--strip-target-features"],
      ...[at(BOUND, `${file}_snipped.wasm`), "-o", at(BINDINGS, `${file}_bg.wasm`)],
    ]);
  });
}

/** Every wasm as text; the others copy from the core's, which is the first. */
async function inlineAll() {
  const inputs = [...KINDS.map(({ file }) => `${BINDINGS}/${file}_bg.wasm`), ...INLINING, "scripts/kinds.mjs"];
  const outputs = KINDS.flatMap(({ bytes }) => [".js", ".json", ".d.ts"].map((extension) => `${BINDINGS}/${bytes}${extension}`));
  await step("wasm as text", { inputs, outputs }, async () => {
    let core;
    for (const { file, bytes } of KINDS) {
      const made = await inlined(readFileSync(at(BINDINGS, `${file}_bg.wasm`)), core);
      const { code, declarations } = inlineModule(made, core === undefined);
      core ??= made;
      writeFileSync(at(BINDINGS, `${bytes}.json`), JSON.stringify(made.text));
      writeFileSync(at(BINDINGS, `${bytes}.js`), code);
      writeFileSync(at(BINDINGS, `${bytes}.d.ts`), declarations);
    }
  });
}

/** The version of the package, as a module. */
async function writeVersion() {
  const outputs = ["version.js", "version.d.ts"].map((f) => `${BINDINGS}/${f}`);
  await step("version", { inputs: ["package.json"], outputs }, async () => {
    const { version } = JSON.parse(readFileSync(at("package.json"), "utf8"));
    mkdirSync(at(BINDINGS), { recursive: true });
    writeFileSync(at(BINDINGS, "version.js"), `export const version = ${JSON.stringify(version)};\n`);
    writeFileSync(at(BINDINGS, "version.d.ts"), "/** The version of the package. */\nexport declare const version: string;\n");
  });
}

/** The bindings of every kind, the decoder of their text, and the version. */
export async function buildBindings() {
  await sideBySide(KINDS, bind);
  await inlineAll();
  await buildDecoder();
  await writeVersion();
}
