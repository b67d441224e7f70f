// The package: Rust → wasm → bindings → one ES module with the wasm inside, and its declarations.

import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";

import { PLACEHOLDER, inlineModule } from "./inline-wasm.mjs";
import { printSizes } from "./sizes.mjs";
import { at, run, step } from "./steps.mjs";
import { writeThirdPartyLicenses } from "./third-party.mjs";

const RUST = ["src", "Cargo.toml", "Cargo.lock", "rust-toolchain.toml", ".cargo/config.toml"];
const XTASK = ["xtask", "Cargo.lock", "rust-toolchain.toml"];
const RAW = "target/wasm32-unknown-unknown/release/expline.wasm";
const BOUND = "build/bound";
const BINDINGS = "build/bindings";

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
 * The flags of .cargo/config.toml, and: small functions stay functions unless they say `#[inline]`. That is a tenth less
 * to download; hot loops say so.
 */
function flags() {
  const [, list = ""] = /^rustflags = \[([^\]]*)\]/m.exec(readFileSync(at(".cargo/config.toml"), "utf8")) ?? [];
  return [...JSON.parse(`[${list.replace(/,\s*$/, "")}]`), "-C", "llvm-args=-inline-threshold=0"];
}

async function buildWasm() {
  const inputs = [...RUST, "scripts/package.mjs"];
  await step("wasm", { inputs, outputs: [RAW] }, async () => {
    const env = { CARGO_ENCODED_RUSTFLAGS: flags().join("\x1f") };
    await run("cargo", ["build", "--locked", "-p", "expline", "--lib", "--release", "--target", "wasm32-unknown-unknown"], { env });
  });
}

async function buildBindings() {
  const inputs = [RAW, "target/xtask/xtask", "package.json", "scripts/snip.mjs", "scripts/inline-wasm.mjs", "scripts/package.mjs"];
  const outputs = ["expline.js", "expline.d.ts", "expline_bg.wasm", "wasm-bytes.js", "version.js"].map((f) => `${BINDINGS}/${f}`);
  await step("bindings", { inputs, outputs }, async () => {
    const flags = ["--target", "web", "--omit-default-module-path", "--remove-producers-section", "--out-dir", at(BOUND)];
    await run(at("target/xtask/xtask"), ["bindgen", at(RAW), ...flags]);
    mkdirSync(at(BINDINGS), { recursive: true });
    for (const file of ["expline.js", "expline.d.ts"]) cpSync(at(BOUND, file), at(BINDINGS, file));
    await run("node", [at("scripts/snip.mjs"), at(BOUND, "expline_bg.wasm"), at(BOUND, "snipped.wasm")]);
    await run("node", [
      at("node_modules/binaryen/bin/wasm-opt"),
      ...["-O3", ...FEATURES, "--strip-debug", "--strip-producers", "--strip-target-features"],
      ...[at(BOUND, "snipped.wasm"), "-o", at(BINDINGS, "expline_bg.wasm")],
    ]);
    const { code, declarations, text } = inlineModule(readFileSync(at(BINDINGS, "expline_bg.wasm")));
    writeFileSync(at(BINDINGS, "literal.json"), JSON.stringify(text));
    writeFileSync(at(BINDINGS, "wasm-bytes.js"), code);
    writeFileSync(at(BINDINGS, "wasm-bytes.d.ts"), declarations);
    const { version } = JSON.parse(readFileSync(at("package.json"), "utf8"));
    writeFileSync(at(BINDINGS, "version.js"), `export const version = ${JSON.stringify(version)};\n`);
    writeFileSync(at(BINDINGS, "version.d.ts"), "/** The version of the package. */\nexport declare const version: string;\n");
  });
}

/** The face as one minified module, with `contents` in place of the module that holds the wasm. */
async function bundleFace(contents) {
  const { build } = await import("esbuild");
  const setup = (bundler) => bundler.onLoad({ filter: /wasm-bytes\.js$/ }, () => ({ contents, resolveDir: at("ts") }));
  const { outputFiles } = await build({
    entryPoints: [at("ts/index.ts")],
    write: false,
    plugins: [{ name: "wasm-bytes", setup }],
    bundle: true,
    format: "esm",
    target: "es2022",
    minify: true,
    legalComments: "none",
    logLevel: "error",
  });
  return outputFiles[0].text;
}

/** What the slim entry has where the other has the wasm. */
const NOTHING_INSIDE = `
  import { ExplineError } from "./error.ts";
  export const wasmAddress = () => new URL("expline_bg.wasm", import.meta.url);
  export function wasmBytes() {
    throw new ExplineError("E_NOT_READY", "engine", "expline/slim has no engine inside; await init() first");
  }
`;

async function buildFace() {
  const inputs = ["ts", BINDINGS, "tsconfig.base.json", "package.json", "package-lock.json", "Cargo.lock", "scripts"];
  const outputs = ["pkg/expline.js", "pkg/slim.js", "pkg/types/index.d.ts", "pkg/expline_bg.wasm", "THIRD_PARTY_LICENSES"];
  await step("face", { inputs, outputs }, async () => {
    rmSync(at("pkg"), { recursive: true, force: true });
    await run("node", [at("node_modules/typescript/bin/tsc"), "-p", at("ts/tsconfig.json")]);
    const literal = JSON.parse(readFileSync(at(BINDINGS, "literal.json"), "utf8"));
    // The literal was chosen to the byte, so the bundler sees a short stand-in for it.
    const holder = readFileSync(at(BINDINGS, "wasm-bytes.js"), "utf8").replace(literal, () => PLACEHOLDER);
    writeFileSync(at("pkg/expline.js"), (await bundleFace(holder)).replace(PLACEHOLDER, () => literal));
    writeFileSync(at("pkg/slim.js"), await bundleFace(NOTHING_INSIDE));
    cpSync(at(BINDINGS, "expline_bg.wasm"), at("pkg/expline_bg.wasm"));
    writeThirdPartyLicenses();
  });
}

/** Everything that the package is made of, and its measured size and start-up time. */
export async function buildPackage() {
  await buildXtask();
  await buildWasm();
  await buildBindings();
  await buildFace();
  await printSizes();
}
