// The face: TypeScript and the bound wasm → ES modules, with the wasm inside and beside them, their declarations, and
// the command line.
//
// `expline.js` only names what the ES modules offer, so that a bundler leaves out those of which nothing is used.

import { cpSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename } from "node:path";
import { gzipSync } from "node:zlib";

import { DECODER_TEXT, TEXT } from "./inline-wasm.mjs";
import { BINDINGS, KINDS, OVER } from "./kinds.mjs";
import { namesOf, withSharedNames } from "./shared-names.mjs";
import { at, run, step } from "./steps.mjs";
import { writeThirdPartyLicenses } from "./third-party.mjs";

/** What the slim entry has where the other has the wasm. */
const nothingInside = (file, start) => `
  import { ExplineError } from "${file === "expline" ? "./core/error.js" : "./core.js"}";
  export const wasmAddress = () => new URL("${file}_bg.wasm", import.meta.url);
  export function wasmBytes(op) {
    throw new ExplineError("E_NOT_READY", op, "expline/slim has no engine inside; await ${start}() first");
  }
  export const besideCore = undefined;
`;

/**
 * What Node has instead: it reads the file when the engine is first asked for. Nothing waits, and nothing is parsed
 * that is not used.
 *
 * Tools that carry programs off with the files that they read look for calls and addresses written like these. Where a
 * test runner has made CommonJS of the module, import.meta has nothing; where it says that the module comes from a
 * server, its folder is still right. A bundler that does not know the file leaves it behind; where the package is
 * still installed, above the bundle, it is found there.
 */
const fileBeside = (file, start) => `
  import { ExplineError } from "./core/error.js";
  const fileUrl = (path) => process.getBuiltinModule("node:url").pathToFileURL(path);
  export const wasmAddress = () => {
    if (import.meta.dirname !== undefined) return fileUrl(import.meta.dirname + "/${file}_bg.wasm");
    return import.meta.url === undefined ? fileUrl(__dirname + "/${file}_bg.wasm") : new URL("${file}_bg.wasm", import.meta.url);
  };
  const installed = () => process.getBuiltinModule("node:module").createRequire((import.meta.dirname ?? __dirname) + "/").resolve("expline/${file}_bg.wasm");
  export function wasmBytes(op) {
    const fs = process.getBuiltinModule("node:fs");
    try {
      return import.meta.dirname === undefined ? fs.readFileSync(__dirname + "/${file}_bg.wasm") : fs.readFileSync(import.meta.dirname + "/${file}_bg.wasm");
    } catch (cause) {
      try {
        return fs.readFileSync(installed());
      } catch {
        throw new ExplineError("E_NOT_READY", op, "${file}_bg.wasm cannot be read beside the program (" + cause.message.slice(0, 120) + "); await ${start}({ bytes }) first", { cause });
      }
    }
  }
  export const besideCore = undefined;
`;

/**
 * One ES module of the face, minified, with `contents` in place of the module that holds the wasm.
 *
 * What the others need of the core they import from the core's ES module, through `ts/core.ts`.
 */
async function bundleFace(name, contents, prefix) {
  const { build } = await import("esbuild");
  const setup = (bundler) => {
    bundler.onLoad({ filter: /-bytes\.js$/ }, () => ({ contents, resolveDir: at("ts") }));
    bundler.onResolve({ filter: /\/(core|spline|surface)\.js$/ }, ({ path }) => ({ path: `${prefix}${basename(path)}`, external: true }));
  };
  const { outputFiles } = await build({
    entryPoints: [at(`ts/${name}.ts`)],
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

/** The names of `ts/index.ts`, from the ES modules of one of the two editions. */
async function bundleEntry(prefix) {
  const { build } = await import("esbuild");
  const setup = (bundler) =>
    bundler.onResolve({ filter: /^\.\/(core|edit|fit|json|spline|surface|trace)\.js$/ }, ({ path }) => ({ path: path.replace("./", `./${prefix}`), external: true }));
  const options = { entryPoints: [at("ts/index.ts")], write: false, bundle: true, format: "esm", minify: true, logLevel: "error" };
  const { outputFiles } = await build({ ...options, plugins: [{ name: "editions", setup }] });
  return outputFiles[0].text;
}

/** A literal, which was chosen to the byte: no bundler sees it. */
const literalIn = (name) => JSON.parse(readFileSync(at(BINDINGS, `${name}.json`), "utf8"));

/**
 * A module with its literals before or behind the code, where gzip makes less of both: which that is depends on where
 * its blocks end.
 */
function withLiterals(code, literals) {
  if (literals.length === 0) return code;
  const [first, last] = [`var ${literals};${code}`, `${code}var ${literals};\n`];
  return gzipSync(first, { level: 9 }).length < gzipSync(last, { level: 9 }).length ? first : last;
}

/** The ES modules of one of the two editions, and the entry that names what they offer. */
async function writeEdition(out, prefix) {
  const entry = await bundleEntry(prefix);
  const modules = new Map();
  for (const { name, file, start, bytes } of KINDS) {
    const contents = prefix === "" ? readFileSync(at(BINDINGS, `${bytes}.js`), "utf8") : nothingInside(file, start);
    modules.set(`${prefix}${name}.js`, await bundleFace(name, contents, `./${prefix}`));
  }
  for (const name of OVER) modules.set(`${prefix}${name}.js`, await bundleFace(name, "", `./${prefix}`));
  const offered = namesOf(entry);
  for (const [file, code] of withSharedNames(modules, offered)) {
    const kind = KINDS.find(({ name }) => file === `${name}.js`);
    const names = kind === undefined ? [] : kind.name === "core" ? [[TEXT, kind.bytes], [DECODER_TEXT, "wasm-decoder"]] : [[TEXT, kind.bytes]];
    writeFileSync(at("pkg", file), withLiterals(code, names.map(([name, from]) => `${name}=${literalIn(from)}`)));
  }
  writeFileSync(at("pkg", `${out}.js`), entry);
}

/** What `require` gets in Node. */
const FOR_REQUIRE = `"use strict";
// Whoever requires and whoever imports get the same, where that can be; test runners have a require that takes no ES
// modules.
try {
  module.exports = require("./node.js");
} catch {
  module.exports = require("./node-commonjs.cjs");
}
`;

/** The whole interface in one file, for Node: as an ES module, and for a `require` that takes none. */
async function bundleNode() {
  const { build } = await import("esbuild");
  const setup = (bundler) =>
    bundler.onLoad({ filter: /-bytes\.js$/ }, ({ path }) => {
      const { file, start } = KINDS.find(({ bytes }) => path.endsWith(`/${bytes}.js`));
      return { contents: fileBeside(file, start), resolveDir: at("ts") };
    });
  // Node shows the line of an error that nobody catches: not all of the package.
  const options = { entryPoints: [at("ts/index.ts")], bundle: true, platform: "node", target: "node20", minify: true, lineLimit: 120, legalComments: "none", logLevel: "error" };
  const plugins = [{ name: "wasm-bytes", setup }];
  await build({ ...options, plugins, format: "esm", outfile: at("pkg/node.js") });
  await build({ ...options, plugins, format: "cjs", outfile: at("pkg/node-commonjs.cjs"), define: { "import.meta.dirname": "undefined", "import.meta.url": "undefined" } });
  writeFileSync(at("pkg/node.cjs"), FOR_REQUIRE);
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

/** The declarations for files that are CommonJS: compilers refuse those of ES modules there, though `require` works. */
function declareForRequire() {
  cpSync(at("pkg/types"), at("pkg/types-cjs"), { recursive: true });
  writeFileSync(at("pkg/types-cjs/package.json"), `${JSON.stringify({ type: "commonjs" })}\n`);
}

/** All ES modules and the command line, in pkg/. */
export async function buildFace() {
  const inputs = ["ts", "cli", BINDINGS, "tsconfig.base.json", "package.json", "package-lock.json", "Cargo.lock", "scripts"];
  const files = [...KINDS.flatMap(({ name, file }) => [`${name}.js`, `slim-${name}.js`, `${file}_bg.wasm`]), ...OVER.flatMap((name) => [`${name}.js`, `slim-${name}.js`]), "expline.js", "slim.js", "node.js", "node.cjs", "node-commonjs.cjs", "cli.js", "types/index.d.ts", "types-cjs/package.json"];
  const outputs = [...files.map((file) => `pkg/${file}`), "THIRD_PARTY_LICENSES"];
  await step("face", { inputs, outputs }, async () => {
    rmSync(at("pkg"), { recursive: true, force: true });
    await run("node", [at("node_modules/typescript/bin/tsc"), "-p", at("ts/tsconfig.json")]);
    declareForRequire();
    for (const [out, prefix] of [["expline", ""], ["slim", "slim-"]]) await writeEdition(out, prefix);
    for (const { file } of KINDS) cpSync(at(BINDINGS, `${file}_bg.wasm`), at(`pkg/${file}_bg.wasm`));
    await bundleNode();
    writeThirdPartyLicenses(await bundleCommandLine());
  });
}
