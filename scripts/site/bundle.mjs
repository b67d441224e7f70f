// The site's own code and styles: bundled with the package as a user's bundler would, so that a page loads what its
// figures import and no more. That takes a bundler that looks through the module of all names, as Vite's.

import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";

import { build } from "esbuild";
import { build as buildWithVite } from "vite";

import { at, root } from "../steps.mjs";

const SHARED = { absWorkingDir: root, bundle: true, minify: true, format: "esm", target: "es2022", logLevel: "error", legalComments: "none" };

/** The npm packages that were built in, with their licences, for whoever gets the files. */
function licencesOf(files) {
  const names = new Set(files.flatMap((path) => /\/node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1] ?? []));
  const texts = [...names].sort().map((name) => {
    const folder = at("node_modules", name);
    const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
    return `${name} ${version}: ${license}\n\n${file === undefined ? "" : readFileSync(join(folder, file), "utf8").trim()}\n`;
  });
  return `The scripts of this site hold the following packages, besides expline.\n\n${texts.join(`\n${"-".repeat(78)}\n\n`)}`;
}

/** One file of code as a text. */
async function text(entry, options = {}) {
  const { outputFiles } = await build({ ...SHARED, entryPoints: [at(entry)], write: false, ...options });
  return outputFiles[0].text;
}

const NAMES = { entryFileNames: "[name].js", chunkFileNames: "[name]-[hash:8].js" };

/** The scripts of the pages; gives back the files that they are made of. */
async function writeScripts(assets) {
  const input = Object.fromEntries(["page", "figures", "playground/playground"].map((name) => [basename(name), at("site", `${name}.ts`)]));
  const { output } = await buildWithVite({
    configFile: false,
    root: at("site"),
    logLevel: "warn",
    publicDir: false,
    build: { outDir: assets, emptyOutDir: false, target: "es2022", modulePreload: false, chunkSizeWarningLimit: 600, rolldownOptions: { input, output: NAMES } },
  });
  return output.flatMap(({ modules }) => Object.keys(modules ?? {}));
}

/** The frame in which the playground runs code: one file, whose policy knows its script by its hash. */
async function writeFrame(assets) {
  const code = await text("site/playground/frame.ts", { format: "iife" });
  const hash = createHash("sha256").update(code).digest("base64");
  const policy = `default-src 'none'; script-src 'sha256-${hash}' blob: 'wasm-unsafe-eval'; worker-src blob:`;
  const head = `<!doctype html><html lang="en"><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${policy}"><title>Playground</title>`;
  writeFileSync(join(assets, "sandbox.html"), `${head}<script>${code}</script></html>\n`);
}

/** Writes scripts and styles into the folder `assets` of the site. */
export async function bundleSite(out) {
  const assets = join(out, "assets");
  const files = await writeScripts(assets);
  await build({ ...SHARED, entryPoints: [at("site/styles/page.css")], outdir: assets, entryNames: "[name]" });
  writeFileSync(join(assets, "early.js"), await text("site/early.ts", { format: "iife" }));
  await writeFrame(assets);
  writeFileSync(join(assets, "library.js"), await text("site/playground/library.ts"));
  writeFileSync(join(assets, "worker.js"), await text("site/playground/worker.ts", { format: "iife" }));
  writeFileSync(join(out, "licences.txt"), licencesOf(files));
}
