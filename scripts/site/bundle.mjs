// The site's own code and styles: bundled with the package as a user's bundler would, so that a page loads what its
// figures import and no more.

import { createHash } from "node:crypto";
import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { build } from "esbuild";

import { at, root } from "../steps.mjs";

const SHARED = { absWorkingDir: root, bundle: true, minify: true, format: "esm", target: "es2022", logLevel: "error", legalComments: "none", metafile: true };

/** The npm packages in what was built, with their licences, for whoever gets the files. */
function licencesOf(metafiles) {
  const inputs = metafiles.flatMap(({ outputs }) => Object.values(outputs)).flatMap(({ inputs: own }) => Object.keys(own));
  const names = new Set(inputs.flatMap((path) => /(?:^|\/)node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1] ?? []));
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
  const { outputFiles, metafile } = await build({ ...SHARED, entryPoints: [at(entry)], write: false, ...options });
  return { code: outputFiles[0].text, metafile };
}

/** The frame in which the playground runs code: one file, whose policy knows its script by its hash. */
async function writeFrame(assets) {
  const { code } = await text("site/playground/frame.ts", { format: "iife" });
  const hash = createHash("sha256").update(code).digest("base64");
  const policy = `default-src 'none'; script-src 'sha256-${hash}' blob: 'wasm-unsafe-eval'; worker-src blob:`;
  const head = `<!doctype html><html lang="en"><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${policy}"><title>Playground</title>`;
  writeFileSync(join(assets, "sandbox.html"), `${head}<script>${code}</script></html>\n`);
}

/** Writes scripts and styles into the folder `assets` of the site. */
export async function bundleSite(out) {
  const assets = join(out, "assets");
  const entryPoints = ["page", "figures", "playground/playground"].map((name) => at("site", `${name}.ts`)).filter(existsSync);
  const pages = await build({ ...SHARED, entryPoints, outdir: assets, entryNames: "[name]", chunkNames: "part-[hash]", splitting: true });
  const styles = await build({ ...SHARED, entryPoints: [at("site/styles/page.css")], outdir: assets, entryNames: "[name]" });
  const early = await text("site/early.ts", { format: "iife" });
  writeFileSync(join(assets, "early.js"), early.code);
  if (existsSync(at("site/playground/frame.ts"))) {
    await writeFrame(assets);
    const library = await text("site/playground/library.ts");
    writeFileSync(join(assets, "library.js"), library.code);
    const worker = await text("site/playground/worker.ts");
    writeFileSync(join(assets, "worker.js"), worker.code);
  }
  writeFileSync(join(out, "licences.txt"), licencesOf([pages.metafile, styles.metafile]));
}
