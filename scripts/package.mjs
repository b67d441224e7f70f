// The package: Rust → wasm modules → bindings → ES modules with the wasm inside, and their declarations.
//
// Hermite curves, curves of any roots, surfaces, fitting and tracing are a wasm and an ES module each; reading plain data is an ES module over
// curves and surfaces, what a pointer does to curves one over curves.
// `expline.js` only names what they offer, so that a bundler leaves out those of which nothing is used.

import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename } from "node:path";

import { PLACEHOLDER, decoderModule, inlineModule } from "./inline-wasm.mjs";
import { printSizes } from "./sizes.mjs";
import { at, run, sideBySide, step } from "./steps.mjs";
import { writeThirdPartyLicenses } from "./third-party.mjs";

const RUST = ["src", "Cargo.toml", "Cargo.lock", "rust-toolchain.toml", ".cargo/config.toml"];
const XTASK = ["xtask", "Cargo.lock", "rust-toolchain.toml"];
const BOUND = "build/bound";
const BINDINGS = "build/bindings";

/**
 * The wasm modules: feature of the crate, target folder, name of the bindings, name of the module with the bytes, and how large
 * a function may be that the compiler copies to where it is called. 0 in the small ones: functions stay functions unless they
 * say `#[inline]`, which is a tenth less to download, and hot loops say so. Solvers are hot loops all over: fitting and
 * tracing are between, 4 and 8 kB less than the compiler would make of them; tracing is as fast within 3 %.
 */
const MODULES = [
  { title: "bindings", feature: "wasm", target: "target", name: "expline", bytes: "wasm-bytes", inline: 0 },
  {
    title: "bindings for splines",
    feature: "wasm-spline",
    target: "target/spline",
    name: "expline_spline",
    bytes: "spline-bytes",
    inline: 0,
  },
  {
    title: "bindings for surfaces",
    feature: "wasm-surface",
    target: "target/surface",
    name: "expline_surface",
    bytes: "surface-bytes",
    inline: 0,
  },
  { title: "bindings for fitting", feature: "wasm-fit", target: "target/fit", name: "expline_fit", bytes: "fit-bytes", inline: 130 },
  { title: "bindings for tracing", feature: "wasm-trace", target: "target/trace", name: "expline_trace", bytes: "trace-bytes", inline: 100 },
];

/**
 * No object lies below address 1024, where the stack ends, so an address and what is added to it never overflow: the sum is the
 * offset of a load or a store.
 */
const ADDRESSES = "--low-memory-unused";

/**
 * wasm-opt, too, leaves functions functions there. Those of one room next to each other, which is the order of their names, are
 * less after compression: gzip looks back 32 kB only.
 */
const NOT_INLINED = ["-fimfs=0", "-aimfs=0", "-ocimfs=0"];

/** What cargo leaves for a module. */
const raw = ({ target }) => `${target}/wasm32-unknown-unknown/release/expline.wasm`;

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

/** The flags of .cargo/config.toml, and those of a module. */
function flags({ inline }) {
  const [, list = ""] = /^rustflags = \[([^\]]*)\]/m.exec(readFileSync(at(".cargo/config.toml"), "utf8")) ?? [];
  return [...JSON.parse(`[${list.replace(/,\s*$/, "")}]`), "-C", `llvm-args=-inline-threshold=${inline}`];
}

/** All modules, side by side: the last part of each build, the longest, uses one core only. */
async function buildWasm() {
  const inputs = [...RUST, "scripts/package.mjs"];
  await step("wasm", { inputs, outputs: MODULES.map(raw) }, async () => {
    await sideBySide(MODULES, async (module) => {
      const env = { CARGO_ENCODED_RUSTFLAGS: flags(module).join("\x1f"), CARGO_TARGET_DIR: at(module.target) };
      const features = ["--no-default-features", "--features", module.feature];
      // Of a wasm alone, without the library for Rust beside it, the compiler knows more to be called from one place only.
      const kind = ["rustc", "--lib", "--crate-type", "cdylib"];
      await run("cargo", [...kind, "--locked", "-p", "expline", "--release", "--target", "wasm32-unknown-unknown", ...features], { env });
    });
  });
}

async function buildBindings(module) {
  const { title, name, bytes } = module;
  const inputs = [raw(module), "target/xtask/xtask", "package.json", "scripts/snip.mjs", "scripts/inline-wasm.mjs", "scripts/split-wasm.mjs", "scripts/package.mjs"];
  const outputs = [`${name}.d.ts`, `${name}_bg.wasm`, `${bytes}.js`, "version.js"].map((f) => `${BINDINGS}/${f}`);
  await step(title, { inputs, outputs, alone: false }, async () => {
    const flags = ["--target", "web", "--omit-default-module-path", "--remove-producers-section", "--out-name", name, "--out-dir", at(BOUND)];
    await run(at("target/xtask/xtask"), ["bindgen", at(raw(module)), ...flags]);
    mkdirSync(at(BINDINGS), { recursive: true });
    for (const file of [`${name}.js`, `${name}.d.ts`]) cpSync(at(BOUND, file), at(BINDINGS, file));
    await run("node", [at("scripts/snip.mjs"), at(BOUND, `${name}_bg.wasm`), at(BOUND, `${name}_snipped.wasm`)]);
    await run("node", [
      at("node_modules/binaryen/bin/wasm-opt"),
      ...["-O3", ADDRESSES, ...(module.inline === 0 ? NOT_INLINED : []), "--reorder-functions-by-name", ...FEATURES, "--strip-debug", "--strip-producers", "--strip-target-features"],
      ...[at(BOUND, `${name}_snipped.wasm`), "-o", at(BINDINGS, `${name}_bg.wasm`)],
    ]);
    const { code, declarations, text } = await inlineModule(readFileSync(at(BINDINGS, `${name}_bg.wasm`)));
    writeFileSync(at(BINDINGS, `${bytes}.json`), JSON.stringify(text));
    writeFileSync(at(BINDINGS, `${bytes}.js`), code);
    writeFileSync(at(BINDINGS, `${bytes}.d.ts`), declarations);
    const { version } = JSON.parse(readFileSync(at("package.json"), "utf8"));
    writeFileSync(at(BINDINGS, "version.js"), `export const version = ${JSON.stringify(version)};\n`);
    writeFileSync(at(BINDINGS, "version.d.ts"), "/** The version of the package. */\nexport declare const version: string;\n");
  });
}

/**
 * One ES module of the face, minified, with `contents` in place of the module that holds the wasm.
 *
 * What the others need of the core they import from the core's ES module, through `ts/core.ts`.
 */
async function bundleFace(entry, contents, prefix) {
  const { build } = await import("esbuild");
  const setup = (bundler) => {
    bundler.onLoad({ filter: /-bytes\.js$/ }, () => ({ contents, resolveDir: at("ts") }));
    bundler.onResolve({ filter: /\/(core|spline|surface)\.js$/ }, ({ path }) => ({ path: `${prefix}${basename(path)}`, external: true }));
    // The core has the decoder of inlined text already.
    if (prefix !== "./") bundler.onLoad({ filter: /\/decode\.ts$/ }, () => ({ contents: "export const decoded = undefined;" }));
    if (entry !== "ts/core.ts") bundler.onResolve({ filter: /\/decode\.ts$/ }, () => ({ path: `${prefix}core.js`, external: true }));
  };
  const { outputFiles } = await build({
    entryPoints: [at(entry)],
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
const nothingInside = (file, start) => `
  import { ExplineError } from "${file === "expline" ? "./core/error.js" : "./core.js"}";
  export const wasmAddress = () => new URL("${file}_bg.wasm", import.meta.url);
  export function wasmBytes() {
    throw new ExplineError("E_NOT_READY", "engine", "expline/slim has no engine inside; await ${start}() first");
  }
`;

const FACES = [
  { entry: "ts/core.ts", name: "core", file: "expline", start: "init", bytes: "wasm-bytes" },
  { entry: "ts/spline.ts", name: "spline", file: "expline_spline", start: "initSpline", bytes: "spline-bytes" },
  { entry: "ts/surface.ts", name: "surface", file: "expline_surface", start: "initSurface", bytes: "surface-bytes" },
  { entry: "ts/fit.ts", name: "fit", file: "expline_fit", start: "initFit", bytes: "fit-bytes" },
  { entry: "ts/trace.ts", name: "trace", file: "expline_trace", start: "initTrace", bytes: "trace-bytes" },
];

/** The names of `ts/index.ts`, from the ES modules of one of the two editions. */
async function entry(prefix) {
  const { build } = await import("esbuild");
  const setup = (bundler) =>
    bundler.onResolve({ filter: /^\.\/(core|edit|fit|json|spline|surface|trace)\.js$/ }, ({ path }) => ({ path: path.replace("./", `./${prefix}`), external: true }));
  const options = { entryPoints: [at("ts/index.ts")], write: false, bundle: true, format: "esm", minify: true, logLevel: "error" };
  const { outputFiles } = await build({ ...options, plugins: [{ name: "editions", setup }] });
  return outputFiles[0].text;
}

/** What Node has instead: it reads the file when the engine is first asked for. Nothing waits, and nothing is parsed that is not used. */
const fileBeside = (file, start) => `
  import { ExplineError } from "./core/error.js";
  export const wasmAddress = () => new URL("${file}_bg.wasm", import.meta.url);
  export function wasmBytes() {
    try {
      return process.getBuiltinModule("node:fs").readFileSync(wasmAddress());
    } catch (cause) {
      throw new ExplineError("E_NOT_READY", "engine", "${file}_bg.wasm does not lie beside the program; await ${start}({ bytes }) first", { cause });
    }
  }
`;

/** The whole interface in one file, for Node. */
async function bundleNode() {
  const { build } = await import("esbuild");
  const setup = (bundler) =>
    bundler.onLoad({ filter: /-bytes\.js$/ }, ({ path }) => {
      const { file, start } = FACES.find(({ bytes }) => path.endsWith(`/${bytes}.js`));
      return { contents: fileBeside(file, start), resolveDir: at("ts") };
    });
  const options = { bundle: true, platform: "node", format: "esm", target: "node20", minify: true, legalComments: "none", logLevel: "error" };
  await build({ entryPoints: [at("ts/index.ts")], outfile: at("pkg/node.js"), ...options, plugins: [{ name: "wasm-bytes", setup }] });
}

/** The command line: one file beside the package's own modules. Gives back the names of the npm packages in it. */
async function bundleCommandLine() {
  await run("node", [at("node_modules/typescript/bin/tsc"), "-p", at("cli/tsconfig.json")]);
  const { build } = await import("esbuild");
  const setup = (bundler) => bundler.onResolve({ filter: /^expline$/ }, () => ({ path: "./node.js", external: true }));
  const options = { entryPoints: [at("cli/expline.ts")], bundle: true, platform: "node", format: "esm", target: "node20", minify: true, logLevel: "error" };
  const { metafile } = await build({ ...options, outfile: at("pkg/cli.js"), plugins: [{ name: "package", setup }], metafile: true });
  const names = Object.keys(metafile.inputs).flatMap((file) => /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1] ?? []);
  return [...new Set(names)].sort();
}

/** The wasm that reads inlined wasm. */
async function buildDecoder() {
  const outputs = ["wasm-decoder.js", "wasm-decoder.d.ts"].map((f) => `${BINDINGS}/${f}`);
  await step("decoder", { inputs: ["scripts/inline-wasm.mjs"], outputs }, async () => {
    const { code, declarations } = await decoderModule();
    mkdirSync(at(BINDINGS), { recursive: true });
    writeFileSync(at(BINDINGS, "wasm-decoder.js"), code);
    writeFileSync(at(BINDINGS, "wasm-decoder.d.ts"), declarations);
  });
}

async function buildFace() {
  const inputs = ["ts", "cli", BINDINGS, "tsconfig.base.json", "package.json", "package-lock.json", "Cargo.lock", "scripts"];
  const files = [...FACES.flatMap(({ name, file }) => [`${name}.js`, `slim-${name}.js`, `${file}_bg.wasm`]), "edit.js", "slim-edit.js", "json.js", "slim-json.js", "expline.js", "slim.js", "node.js", "cli.js", "types/index.d.ts"];
  const outputs = [...files.map((file) => `pkg/${file}`), "THIRD_PARTY_LICENSES"];
  await step("face", { inputs, outputs }, async () => {
    rmSync(at("pkg"), { recursive: true, force: true });
    await run("node", [at("node_modules/typescript/bin/tsc"), "-p", at("ts/tsconfig.json")]);
    for (const { entry, name, file, start, bytes } of FACES) {
      const literal = JSON.parse(readFileSync(at(BINDINGS, `${bytes}.json`), "utf8"));
      // The literal was chosen to the byte, so the bundler sees a short stand-in for it.
      const holder = readFileSync(at(BINDINGS, `${bytes}.js`), "utf8").replace(literal, () => PLACEHOLDER);
      const full = await bundleFace(entry, holder, "./");
      writeFileSync(at(`pkg/${name}.js`), full.replace(PLACEHOLDER, () => literal));
      writeFileSync(at(`pkg/slim-${name}.js`), await bundleFace(entry, nothingInside(file, start), "./slim-"));
      cpSync(at(BINDINGS, `${file}_bg.wasm`), at(`pkg/${file}_bg.wasm`));
    }
    for (const [out, prefix] of [["expline", ""], ["slim", "slim-"]]) {
      for (const name of ["edit", "json"]) writeFileSync(at(`pkg/${prefix}${name}.js`), await bundleFace(`ts/${name}.ts`, "", `./${prefix}`));
      writeFileSync(at(`pkg/${out}.js`), await entry(prefix));
    }
    await bundleNode();
    writeThirdPartyLicenses(await bundleCommandLine());
  });
}

/** Everything that the package is made of, and its measured size and start-up time. */
export async function buildPackage() {
  await buildXtask();
  await buildWasm();
  await sideBySide(MODULES, buildBindings);
  await buildDecoder();
  await buildFace();
  await printSizes();
}
