// The packed package through bundlers and without one, run in Chromium under the strict policy of the demo.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { join } from "node:path";

import type { BuildOptions } from "esbuild";
import type { Browser } from "playwright-core";

import { launch } from "../../scripts/browser.mjs";
import { POLICY, serve } from "../../scripts/serve.mjs";

const consumer = join(process.cwd(), "build", "consumer");
const pages = join(consumer, "pages");
const entry = join(consumer, "app.mjs");

/** Finds the package for Rollup, which leaves that to plugins. */
const resolve = {
  name: "resolve",
  resolveId: (id: string) => (/^expline(?:\/|$)/.test(id) ? join(consumer, "node_modules/expline/pkg", `${id.split("/")[1] ?? "expline"}.js`) : null),
};

/** Puts the radius error of a two-point circle and a path's round trip into the page's title. */
const APP = `
import { HermiteCurve, parsePath } from "expline";
const points = HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 2 }).sample(64);
let worst = 0;
for (let i = 0; i < points.length; i += 2) worst = Math.max(worst, Math.abs(Math.hypot(points[i], points[i + 1]) - 5));
const { d } = parsePath("M0 0A5 5 0 0 1 10 0L5 8Z")[0].toPathD({ arcs: true, decimals: 3 });
const result = JSON.stringify({ exact: worst <= 1e-14, arc: /a/i.test(d) });
if (typeof document === "undefined") postMessage(result);
else document.title = result;
`;
const EXPECTED = JSON.stringify({ exact: true, arc: true });

let browser: Browser;

before(async () => {
  mkdirSync(pages, { recursive: true });
  writeFileSync(entry, APP);
  browser = await launch();
});

after(() => browser.close());

/** Makes a page around a script and gives back its folder. */
function page(name: string, html: string): string {
  const folder = join(pages, name);
  mkdirSync(folder, { recursive: true });
  // No charset on purpose: a bundle must not depend on the page's.
  writeFileSync(join(folder, "index.html"), `<!doctype html><html lang="en"><title>waiting</title>${html}</html>`);
  return folder;
}

/** The ES modules and wasm files of the package, beside a page. */
function copyPackage(folder: string): void {
  const from = join(consumer, "node_modules/expline/pkg");
  for (const file of readdirSync(from)) if (/\.(js|wasm)$/.test(file)) cpSync(join(from, file), join(folder, file));
}

/** Opens a folder's page and waits for its title; whatever the console or the policy complains about fails the test. */
async function titleOf(folder: string, policy: string): Promise<string> {
  const { url, close } = await serve(folder, { port: 0, policy });
  const tab = await browser.newPage();
  const complaints: string[] = [];
  const complained = new Promise<void>((resolve) => {
    const complain = (text: string) => (complaints.push(text), resolve());
    tab.on("pageerror", (error) => complain(error.message));
    tab.on("console", (message) => {
      if (message.type() === "error" && !message.location().url.includes("favicon")) complain(message.text());
    });
  });
  try {
    await tab.goto(url);
    const titled = tab.waitForFunction(() => document.title !== "waiting", undefined, { timeout: 20_000 });
    await Promise.race([titled.catch(() => undefined), complained]);
    assert.deepEqual(complaints, []);
    return await tab.title();
  } finally {
    await tab.close();
    await close();
  }
}

const MODULE = '<script type="module" src="bundle.js"></script>';

test("esbuild, with its own defaults and minified", async () => {
  const { build } = await import("esbuild");
  const folder = page("esbuild", MODULE);
  await build({ entryPoints: [entry], outfile: join(folder, "bundle.js"), bundle: true, minify: true, format: "esm", logLevel: "error" });
  assert.equal(await titleOf(folder, POLICY), EXPECTED);
});

test("esbuild, as a classic script in a page that declares no charset", async () => {
  const { build } = await import("esbuild");
  const folder = page("esbuild-classic", '<script defer src="bundle.js"></script>');
  await build({ entryPoints: [entry], outfile: join(folder, "bundle.js"), bundle: true, format: "iife", logLevel: "error" });
  assert.equal(await titleOf(folder, POLICY), EXPECTED);
});

/** Something that only the module of splines, of fitting, of surfaces, or of tracing says. */
const MARKS = { splines: "load_spline", fitting: "fit_describe", surfaces: "surface_touched", tracing: "trace_describe" } as const;

/** What a bundle has besides curves. */
function parts(file: string): string[] {
  const text = readFileSync(file, "utf8");
  return Object.entries(MARKS).flatMap(([part, mark]) => (text.includes(mark) ? [part] : []));
}

for (const [name, code, expected] of [
  ["curves", 'import { HermiteCurve } from "expline"; document.title = String(HermiteCurve.through([0, 0, 1, 1, 2, 0]).closed);', []],
  ["pointers", 'import { HermiteCurve } from "expline"; import { hitTest } from "expline/edit"; const circle = HermiteCurve.ellipse({ center: [0, 0], radii: [9, 9], count: 2 }); document.title = String(hitTest([circle], 9.5, 0, { reach: 1 }).kind === "point");', []],
  ["splines", 'import { InterpolatingCurve, roots } from "expline"; document.title = String(new InterpolatingCurve({ points: [1, 0, 0, 1, -1, 0, 0, -1], roots: roots.ellipse(4), closed: true }).length() > 6);', ["splines"]],
  ["fits", 'import { fitSparse } from "expline"; document.title = String(fitSparse([0, 0, 4, 0, 4, 4, 0, 4]).curve.closed);', ["fitting"]],
  ["surfaces", 'import { TensorSurface } from "expline"; document.title = String(TensorSurface.torus(3, 1).u.closed);', ["surfaces"]],
  ["traces", 'import { traceImage } from "expline"; document.title = String(traceImage({ width: 4, height: 4, data: new Uint8Array(16) }).contours[0].closed);', ["tracing"]],
] as const) {
  test(`a bundle of ${name} holds what it needs and no other module, whoever makes it`, async () => {
    const source = join(consumer, `${name}.mjs`);
    writeFileSync(source, code);
    const folder = page(name, MODULE);
    const { build } = await import("esbuild");
    const outfile = join(folder, "bundle.js");
    await build({ entryPoints: [source], outfile, bundle: true, minify: true, format: "esm", logLevel: "error" });
    assert.deepEqual(parts(outfile), expected, "esbuild");
    assert.equal(await titleOf(folder, POLICY), "true");

    const { rollup } = await import("@rollup/wasm-node");
    // What the plugin that resolves packages reads in package.json: nothing of the package has side effects.
    const treeshake = { moduleSideEffects: (id: string) => !id.includes("node_modules") };
    const bundle = await rollup({ input: source, plugins: [resolve], treeshake, onwarn: (warning) => assert.fail(warning.message) });
    await bundle.write({ file: join(folder, "rollup.js"), format: "es" });
    await bundle.close();
    assert.deepEqual(parts(join(folder, "rollup.js")), expected, "Rollup");

    const { default: webpack } = await import("webpack");
    await new Promise<void>((done, fail) => {
      webpack({ mode: "production", entry: source, output: { path: folder, filename: "webpack.js" }, performance: { hints: false } }, (error, stats) => {
        if (error ?? stats?.hasErrors()) fail(error ?? new Error(stats?.toString("errors-only")));
        else done();
      });
    });
    assert.deepEqual(parts(join(folder, "webpack.js")), expected, "webpack");
  });
}

test("a bundle for Node has the wasm inside: it runs wherever it is put", async () => {
  const { build } = await import("esbuild");
  const { default: webpack } = await import("webpack");
  const folder = page("for-node", "");
  const source = join(consumer, "for-node.mjs");
  writeFileSync(source, APP.replace(/if \(typeof document[\s\S]*/, "console.log(result);"));
  await build({ entryPoints: [source], outfile: join(folder, "esbuild.mjs"), bundle: true, platform: "node", format: "esm", logLevel: "error" });
  await new Promise<void>((done, fail) => {
    webpack({ mode: "production", target: "node", entry: source, output: { path: folder, filename: "webpack.cjs" } }, (error, stats) => {
      if (error ?? stats?.hasErrors()) fail(error ?? new Error(stats?.toString("errors-only")));
      else done();
    });
  });
  const { build: vite } = await import("vite");
  await vite({ root: consumer, logLevel: "error", configFile: false, ssr: { noExternal: true }, build: { ssr: source, outDir: folder, emptyOutDir: false, rollupOptions: { output: { entryFileNames: "vite.mjs" } } } });
  for (const file of ["esbuild.mjs", "webpack.cjs", "vite.mjs"]) {
    assert.equal(execFileSync(process.execPath, [join(folder, file)], { encoding: "utf8" }).trim(), EXPECTED, file);
  }
});

test("Vite", async () => {
  const { build } = await import("vite");
  const folder = page("vite", '<script type="module" src="../../app.mjs"></script>');
  await build({ root: folder, base: "./", logLevel: "error", configFile: false, build: { outDir: "dist", emptyOutDir: true, modulePreload: { polyfill: false } } });
  assert.equal(await titleOf(join(folder, "dist"), POLICY), EXPECTED);
});

for (const mode of ["built", "served by its server, which bundles the package first"]) {
  test(`a module worker, with Vite, ${mode}`, async () => {
    const { build, createServer } = await import("vite");
    const folder = page(`vite-worker-${mode === "built" ? "built" : "served"}`, '<script type="module" src="./page.js"></script>');
    writeFileSync(join(folder, "worker.js"), APP);
    writeFileSync(join(folder, "page.js"), `
      const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
      worker.onmessage = ({ data }) => (document.title = data);
      worker.onerror = ({ message }) => (document.title = message);`);
    const options = { root: folder, base: "./", logLevel: "error", configFile: false, worker: { format: "es" } } as const;
    if (mode === "built") {
      await build({ ...options, build: { outDir: "dist", emptyOutDir: true, modulePreload: { polyfill: false } } });
      assert.equal(await titleOf(join(folder, "dist"), POLICY), EXPECTED);
      return;
    }
    const server = await createServer({ ...options, base: "/", cacheDir: join(folder, "cache"), server: { port: 0, host: "127.0.0.1" } });
    const tab = await browser.newPage();
    try {
      await server.listen();
      await tab.goto(server.resolvedUrls?.local[0] ?? "");
      await tab.waitForFunction(() => document.title !== "waiting", undefined, { timeout: 20_000 });
      assert.equal(await tab.title(), EXPECTED);
    } finally {
      await tab.close();
      await server.close();
    }
  });
}

test("Rollup", async () => {
  const { rollup } = await import("@rollup/wasm-node");
  const folder = page("rollup", MODULE);
  const bundle = await rollup({ input: entry, plugins: [resolve], onwarn: (warning) => assert.fail(warning.message) });
  await bundle.write({ file: join(folder, "bundle.js"), format: "es" });
  await bundle.close();
  assert.equal(await titleOf(folder, POLICY), EXPECTED);
});

test("webpack, minified for production", async () => {
  const { default: webpack } = await import("webpack");
  const folder = page("webpack", '<script defer src="bundle.js"></script>');
  await new Promise<void>((resolve, reject) => {
    webpack({ mode: "production", entry, output: { path: folder, filename: "bundle.js" }, performance: { hints: false } }, (error, stats) => {
      if (error ?? stats?.hasErrors()) reject(error ?? new Error(stats?.toString("errors-only")));
      else resolve();
    });
  });
  assert.equal(await titleOf(folder, POLICY), EXPECTED);
});

test("no bundler: an import map and the file of the package", async () => {
  const map = JSON.stringify({ imports: { expline: "./expline.js" } });
  const folder = page("import-map", `<script type="importmap">${map}</script><script type="module" src="app.js"></script>`);
  copyPackage(folder);
  writeFileSync(join(folder, "app.js"), APP);
  // An inline import map is an inline script, which the demo's policy refuses.
  assert.equal(await titleOf(folder, POLICY.replace("script-src 'self'", "script-src 'self' 'unsafe-inline'")), EXPECTED);
});

test("a module worker", async () => {
  const folder = page("worker", MODULE);
  copyPackage(folder);
  writeFileSync(join(folder, "worker.js"), APP.replace('"expline"', '"./expline.js"'));
  const start = 'const worker = new Worker("worker.js", { type: "module" }); worker.onmessage = (e) => (document.title = e.data);';
  writeFileSync(join(folder, "bundle.js"), start);
  assert.equal(await titleOf(folder, POLICY), EXPECTED);
});

for (const [how, load] of [
  ["found by itself", 'import init, { HermiteCurve, parsePath } from "expline/slim"; await init();'],
  ["named by the page", 'import wasmUrl from "expline/expline_bg.wasm?url"; import init, { HermiteCurve, parsePath } from "expline/slim"; await init({ wasmUrl });'],
]) {
  test(`the slim entry, with Vite, its wasm ${how}`, async () => {
    const { build } = await import("vite");
    const folder = page(`slim ${how}`.replaceAll(" ", "-"), '<script type="module" src="app.js"></script>');
    writeFileSync(join(folder, "app.js"), APP.replace('import { HermiteCurve, parsePath } from "expline";', String(load)));
    const options = { outDir: "dist", emptyOutDir: true, modulePreload: { polyfill: false }, assetsInlineLimit: 0, target: "es2022" };
    await build({ root: folder, base: "./", logLevel: "error", configFile: false, build: options });
    assert.equal(await titleOf(join(folder, "dist"), POLICY), EXPECTED);
  });
}

test("the slim entry, with esbuild, its wasm named by the page; by itself esbuild leaves it out, and the error says where it is missed", async () => {
  const { build } = await import("esbuild");
  const folder = page("slim-esbuild", MODULE);
  const source = join(consumer, "slim-esbuild.mjs");
  const options: BuildOptions = { entryPoints: [source], outfile: join(folder, "bundle.js"), bundle: true, format: "esm", logLevel: "error" };
  writeFileSync(source, APP.replace('import { HermiteCurve, parsePath } from "expline";', 'import wasmUrl from "expline/expline_bg.wasm"; import init, { HermiteCurve, parsePath } from "expline/slim"; await init({ wasmUrl });'));
  await build({ ...options, loader: { ".wasm": "file" } });
  assert.equal(await titleOf(folder, POLICY), EXPECTED);

  writeFileSync(source, 'import init from "expline/slim"; try { await init(); } catch ({ reason, message }) { document.title = `${reason} ${message}`; }');
  await build(options);
  const { url, close } = await serve(folder, { port: 0, policy: POLICY });
  const tab = await browser.newPage();
  await tab.goto(url);
  await tab.waitForFunction(() => document.title !== "waiting", undefined, { timeout: 20_000 });
  const title = await tab.title();
  await tab.close();
  await close();
  assert.equal(title, `network init: "${new URL("expline_bg.wasm", url).href}" could not be read (HTTP 404); wasmUrl may say where it is [E_INIT]`);
});

test("init streams the wasm from an address", async () => {
  const folder = page("streaming", MODULE);
  copyPackage(folder);
  const app = APP.replace('import { HermiteCurve, parsePath } from "expline";', 'import init, { HermiteCurve, parsePath } from "./expline.js"; await init({ wasmUrl: "expline_bg.wasm" });');
  writeFileSync(join(folder, "bundle.js"), app);
  assert.equal(await titleOf(folder, POLICY), EXPECTED);
});
