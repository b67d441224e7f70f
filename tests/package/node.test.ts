// The packed package in plain Node: no await before the first call, in the main thread and in workers, with types.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { test } from "node:test";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { Worker } from "node:worker_threads";

const consumer = join(process.cwd(), "build", "consumer");

/** A circle of radius 5 through two points, and how far from 5 its points are. */
const CIRCLE = `
  const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 2 });
  const points = curve.sample(100);
  let worst = 0;
  for (let i = 0; i < points.length; i += 2) worst = Math.max(worst, Math.abs(Math.hypot(points[i], points[i + 1]) - 5));
`;

/** A few ulp of the radius; a cubic circle of four pieces is off by 1.4e-3. */
const EXACT = 1e-14;

function node(code: string, ...flags: string[]): string {
  return execFileSync(process.execPath, [...flags, "--input-type=module", "-e", code], { cwd: consumer, encoding: "utf8" });
}

test("a circle is exact right after the import, with no await", () => {
  const worst = Number(node(`import { HermiteCurve } from "expline"; ${CIRCLE} console.log(worst);`));
  assert.ok(worst <= EXACT, `off by ${worst}`);
});

/** What makes Node take the package as bundlers do, with the wasm inside. */
const AS_BUNDLERS = "--conditions=module";

test("Node reads the wasm file only when it is needed; bundlers take the wasm inside the module", () => {
  const code = `
    import { HermiteCurve, TensorSurface, fitSparse, traceImage } from "expline";
    const file = import.meta.resolve("expline").split("/").at(-1);
    ${CIRCLE}
    const surface = TensorSurface.sphere(1).mesh(3, 3).positions.length;
    const { knots } = fitSparse([0, 0, 4, 0, 4, 4, 0, 4]);
    const { contours } = traceImage({ width: 4, height: 4, data: new Uint8Array(16) });
    console.log(JSON.stringify([file, worst <= ${EXACT}, surface, knots.length > 0, contours.length]));
  `;
  assert.equal(node(code).trim(), JSON.stringify(["node.js", true, 27, true, 1]));
  assert.equal(node(code, AS_BUNDLERS).trim(), JSON.stringify(["expline.js", true, 27, true, 1]));
});

test("the wasm inside the modules computes what the files beside them do, to the last bit, in every kind of work", () => {
  const code = `
    import { createHash } from "node:crypto";
    import { HermiteCurve, InterpolatingCurve, TensorSurface, fitSparse, parsePath, roots, traceImage } from "expline";
    const wave = (count, scale) => Float64Array.from({ length: count }, (_, i) => scale * Math.round(100 * Math.sin(i * i)));
    const curve = new HermiteCurve({ points: wave(40, 1), tangents: wave(40, 2) });
    const spline = new InterpolatingCurve({ points: wave(24, 1), roots: roots.ellipse(12), closed: true });
    const data = Uint8Array.from({ length: 1024 }, (_, i) => (Math.hypot((i % 32) - 16, (i >> 5) - 16) < 11 ? 0 : 255));
    const results = [
      curve.sample(500), curve.flatten(0.1), [curve.length(), ...Object.values(curve.nearest(3, 4)).flat()], curve.toPathD().d, curve.toCubics(0.1),
      parsePath("M0 0C1 2 3 4 5 6A7 8 9 0 1 2 3Z")[0].sample(99),
      spline.sample(500), spline.flatten(0.1), [spline.length(), ...Object.values(spline.nearest(3, 4)).flat()], spline.refine(2).points, spline.toCubics(0.1),
      TensorSurface.torus(3, 1).mesh(20, 20), fitSparse(wave(80, 1)).curve, traceImage({ width: 32, height: 32, data }).contours,
    ];
    const plain = (_, value) => (ArrayBuffer.isView(value) ? Array.from(value) : value);
    console.log(JSON.stringify(results.map((result) => createHash("sha256").update(JSON.stringify(result, plain)).digest("hex"))));
  `;
  const beside = JSON.parse(node(code)) as readonly string[];
  assert.equal(new Set(beside).size, 14, "no two results are alike");
  assert.deepEqual(JSON.parse(node(code, AS_BUNDLERS)), beside);
});

test("an error that nobody catches is shown with its name and a line of the package, not with all of it", () => {
  const code = `import { HermiteCurve } from "expline"; HermiteCurve.through([0, 0, 1, NaN, 1, 1]);`;
  const { status, stderr } = spawnSync(process.execPath, ["--input-type=module", "-e", code], { cwd: consumer, encoding: "utf8" });
  assert.equal(status, 1);
  assert.match(stderr, /^ExplineError: HermiteCurve\.through: points\[3\] is NaN/m);
  const longest = Math.max(...stderr.split("\n").map((line) => line.length));
  assert.ok(longest < 1000, `a line of ${longest} characters`);
});

test("a file of CommonJS gets the package by require, the same that others import", () => {
  const code = `
    const { HermiteCurve } = require("expline");
    const { movePoint } = require("expline/edit");
    ${CIRCLE}
    import("expline").then((all) => console.log(JSON.stringify([worst <= ${EXACT}, all.HermiteCurve === HermiteCurve, all.movePoint === movePoint])));
  `;
  const { stdout, stderr } = spawnSync(process.execPath, ["-e", code], { cwd: consumer, encoding: "utf8" });
  assert.deepEqual(JSON.parse(stdout), [true, true, true]);
  assert.equal(stderr, "", "no warning of Node's");
});

test("a require that takes no ES modules, as Jest has one, gets the whole package, too", () => {
  const code = `
    const { HermiteCurve, default: init, traceImage, version } = require("expline");
    const { movePoint } = require("expline/edit");
    ${CIRCLE}
    movePoint(curve, 0, 5, 0);
    const { contours } = traceImage({ width: 4, height: 4, data: new Uint8Array(16) });
    init().then(() => console.log(JSON.stringify([worst <= ${EXACT}, contours.length, version])));
  `;
  const said = execFileSync(process.execPath, ["--no-experimental-require-module", "-e", code], { cwd: consumer, encoding: "utf8" });
  const { version } = JSON.parse(readFileSync(join(consumer, "node_modules", "expline", "package.json"), "utf8")) as { version: string };
  assert.deepEqual(JSON.parse(said), [true, 1, version]);
});

interface Targets {
  readonly [condition: string]: string | Targets;
}

/** The file that is taken of a package's exports by who knows these conditions. */
function taken(target: string | Targets, conditions: readonly string[]): string {
  if (typeof target === "string") return target;
  const found = Object.keys(target).find((name) => name === "default" || conditions.includes(name));
  return taken((found && target[found]) ?? assert.fail("nothing is taken"), conditions);
}

test("tools that know no exports find the package that bundlers have, and bundlers for Node the wasm inside", () => {
  const { main, exports } = JSON.parse(readFileSync(join(consumer, "node_modules", "expline", "package.json"), "utf8")) as { main: string; exports: Record<string, Targets> };
  const all = exports["."] ?? {};
  const pages = ["import", "module", "browser"];
  const inNode = ["node", "import", "module", "module-sync", "require"];
  assert.deepEqual([taken(all, pages), taken(all, inNode), taken(all, ["browser", "require"]), taken(all, ["deno", "node", "import"])], Array(4).fill(main));
});

test("a program that is carried off with what its tools find of the package runs: they know the condition node, and calls that read files", () => {
  const installed = join(consumer, "node_modules", "expline");
  const { exports } = JSON.parse(readFileSync(join(installed, "package.json"), "utf8")) as { exports: Record<string, Targets> };
  for (const way of ["import", "require"]) {
    const folder = join(consumer, `traced-${way}`);
    const there = join(folder, "node_modules", "expline");
    mkdirSync(join(there, "pkg"), { recursive: true });
    copyFileSync(join(installed, "package.json"), join(there, "package.json"));
    const files = [taken(exports["."] ?? {}, ["node", way])];
    for (const file of files) {
      copyFileSync(join(installed, file), join(there, file));
      if (file.endsWith(".wasm")) continue;
      const code = readFileSync(join(installed, file), "utf8").replace(/\\?\n/g, "");
      const found = [...code.matchAll(/(?:readFileSync\((?:__dirname|import\.meta\.dirname)\+|require\()"\.?\/([\w.-]+)"\)/g)].map(([, name]) => `./pkg/${name ?? ""}`);
      for (const [, name] of way === "import" ? code.matchAll(/readFileSync\(import\.meta\.dirname\+"\/([\w.-]+)"/g) : []) {
        assert.ok(code.includes(`new URL("${name ?? ""}",import.meta.url)`), "tools that look for addresses find it, too");
      }
      files.push(...new Set(found.filter((name) => !files.includes(name))));
    }
    const program = `${way === "import" ? 'import { HermiteCurve, TensorSurface, fitSparse, traceImage } from "expline"' : 'const { HermiteCurve, TensorSurface, fitSparse, traceImage } = require("expline")'};
      ${CIRCLE}
      const { knots } = fitSparse([0, 0, 4, 0, 4, 4, 0, 4]);
      const { contours } = traceImage({ width: 4, height: 4, data: new Uint8Array(16) });
      console.log(JSON.stringify([worst <= ${EXACT}, TensorSurface.sphere(1).mesh(3, 3).positions.length, knots.length > 0, contours.length]));
    `;
    const file = join(folder, way === "import" ? "program.mjs" : "program.cjs");
    writeFileSync(file, program);
    assert.equal(execFileSync(process.execPath, [file], { encoding: "utf8" }).trim(), JSON.stringify([true, 27, true, 1]), way);
  }
});

test("made CommonJS by a test runner's transform, the module finds its wasm file all the same", async () => {
  const { transform } = await import("esbuild");
  const folder = join(consumer, "transformed");
  mkdirSync(folder, { recursive: true });
  const from = join(consumer, "node_modules", "expline", "pkg");
  // Such a transform leaves nothing of import.meta, which is what the warning says.
  const { code } = await transform(readFileSync(join(from, "node.js"), "utf8"), { format: "cjs", logLevel: "silent" });
  writeFileSync(join(folder, "node.cjs"), code);
  copyFileSync(join(from, "expline_bg.wasm"), join(folder, "expline_bg.wasm"));
  const said = execFileSync(process.execPath, ["-e", `const { HermiteCurve } = require("./transformed/node.cjs"); ${CIRCLE} console.log(worst)`], { cwd: consumer, encoding: "utf8" });
  assert.ok(Number(said) <= EXACT, said);
});

test("a program that was carried off without its wasm file says what to do", () => {
  const folder = mkdtempSync(join(tmpdir(), "expline-carried-"));
  const from = join(consumer, "node_modules", "expline", "pkg");
  writeFileSync(join(folder, "node.mjs"), readFileSync(join(from, "node.js")));
  const code = `
    import { readFileSync } from "node:fs";
    const { HermiteCurve, initSync } = await import(${JSON.stringify(pathToFileURL(join(folder, "node.mjs")).href)});
    const said = [];
    try { HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 2 }); } catch (error) { said.push(error.code, /ENOENT.*await init/.test(error.message)); }
    initSync({ bytes: readFileSync(${JSON.stringify(join(from, "expline_bg.wasm"))}) });
    ${CIRCLE}
    console.log(JSON.stringify([...said, worst <= ${EXACT}]));
  `;
  assert.equal(node(code).trim(), JSON.stringify(["E_NOT_READY", true, true]));
  rmSync(folder, { recursive: true });
});

test("a bundle for Node that has left the wasm files behind finds those of the package that is installed", async () => {
  const { build } = await import("esbuild");
  const source = join(consumer, "left-behind.mjs");
  writeFileSync(source, `
    import { HermiteCurve, fitSparse, traceImage } from "expline";
    ${CIRCLE}
    const { knots } = fitSparse([0, 0, 4, 0, 4, 4, 0, 4]);
    const { contours } = traceImage({ width: 4, height: 4, data: new Uint8Array(16) });
    console.log(JSON.stringify([worst <= ${EXACT}, knots.length > 0, contours.length]));
  `);
  for (const [format, name] of [["esm", "bundle.mjs"], ["cjs", "bundle.cjs"]] as const) {
    const outfile = join(consumer, "left-behind", name);
    await build({ entryPoints: [source], outfile, bundle: true, platform: "node", conditions: ["own"], format, logLevel: "silent" });
    assert.equal(execFileSync(process.execPath, [outfile], { encoding: "utf8" }).trim(), JSON.stringify([true, true, 1]), format);
  }
});

test("LC-024: the import alone touches neither WebAssembly, nor the network, nor the global object", () => {
  const said = node(`
    for (const name of ["Module", "Instance"]) WebAssembly[name] = class { constructor() { throw new Error("used " + name); } };
    for (const name of ["compile", "instantiate", "instantiateStreaming", "compileStreaming"]) {
      WebAssembly[name] = () => { throw new Error("used " + name); };
    }
    globalThis.fetch = () => { throw new Error("used fetch"); };
    const before = Object.getOwnPropertyNames(globalThis).length;
    await import("expline");
    console.log(Object.getOwnPropertyNames(globalThis).length - before);
  `);
  assert.equal(said.trim(), "0");
});

test("a worker thread needs no await either", async () => {
  const code = `import { parentPort } from "node:worker_threads"; import { HermiteCurve } from "expline"; ${CIRCLE} parentPort.postMessage(worst);`;
  const file = join(consumer, "worker.mjs");
  writeFileSync(file, code);
  const worker = new Worker(file);
  const worst = await new Promise<number>((resolve, reject) => worker.once("message", resolve).once("error", reject));
  await worker.terminate();
  assert.ok(worst <= EXACT, `off by ${worst}`);
});

test("init takes the wasm file of the package, and the version is that of its package.json", () => {
  const said = node(`
    import { readFileSync } from "node:fs";
    import { createRequire } from "node:module";
    import init, { HermiteCurve, version } from "expline";
    const require = createRequire(import.meta.url);
    await init({ bytes: readFileSync(require.resolve("expline/expline_bg.wasm")) });
    ${CIRCLE}
    console.log(JSON.stringify({ worst, version, manifest: require("expline/package.json").version }));
  `);
  const { worst, version, manifest } = JSON.parse(said) as { worst: number; version: string; manifest: string };
  assert.ok(worst <= EXACT, `off by ${worst}`);
  assert.equal(version, manifest);
});

test("the slim entry says that it has no wasm inside, and finds the file beside it", () => {
  const said = node(`
    import init, { HermiteCurve } from "expline/slim";
    let code = "", op = "";
    try { HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 2 }); } catch (error) { ({ code, op } = error); }
    await init();
    ${CIRCLE}
    console.log(JSON.stringify({ code, op, worst }));
  `);
  const { code, op, worst } = JSON.parse(said) as { code: string; op: string; worst: number };
  assert.deepEqual([code, op], ["E_NOT_READY", "HermiteCurve.ellipse"]);
  assert.ok(worst <= EXACT, `off by ${worst}`);
});

test("in the slim entry what comes out of fits and traces waits for init, too, and surfaces do not", () => {
  const said = node(`
    import init, { InterpolatingCurve, TensorSurface, fitSparse, initFit, initSpline, initSurface, initTrace, traceImage } from "expline/slim";
    await Promise.all([initFit(), initSpline(), initSurface(), initTrace()]);
    const square = [0, 0, 4, 0, 4, 4, 0, 4];
    const calls = {
      fit: () => fitSparse(square).curve.length(),
      trace: () => traceImage({ width: 4, height: 4, data: new Uint8Array(16) }).toSvg(),
      toPathD: () => new InterpolatingCurve({ points: square }).toPathD(),
      length: () => new InterpolatingCurve({ points: square }).length(),
      surface: () => TensorSurface.sphere(1).toObj({ rows: 3, cols: 3 }),
    };
    const waiting = () => Object.keys(calls).filter((name) => {
      try { calls[name](); return false; } catch (error) { return error.code === "E_NOT_READY" && /await init\\(\\)/.test(error.message); }
    });
    const before = waiting();
    await init();
    console.log(JSON.stringify([before, waiting()]));
  `);
  assert.deepEqual(JSON.parse(said), [["fit", "trace", "toPathD"], []]);
});

test("the declarations hold for a strict project, with every kind of module resolution", () => {
  const folder = join(consumer, "typed");
  mkdirSync(folder, { recursive: true });
  const code = `
    import init, { ExplineError, HermiteCurve, InterpolatingCurve, SparseFitter, TensorSurface, fitSparse, initSync, parsePath, traceImage, version } from "expline";
    import type { Curve } from "expline";
    import { movePoint } from "expline/edit";
    import slim, { HermiteCurve as SlimCurve } from "expline/slim";
    await init();
    await slim();
    export const verbs: unknown[] = [movePoint, SlimCurve];
    const curve: HermiteCurve = HermiteCurve.ellipse({ center: [0, 0], radii: [2, 1], count: 3 });
    const point: Float64Array = curve.evaluate(0.5, 1);
    const { d, maxError }: { d: string; maxError: number } = curve.toPathD({ tolerance: 0.01, arcs: true });
    const first: HermiteCurve | undefined = parsePath(d)[0];
    export const all = [point, maxError, first, version, initSync, new Error() instanceof ExplineError];
    // What map makes of points, and GeoJSON has, is number[][].
    const places: number[][] = [[0, 0], [4, 1], [9, 9]].map(([x = 0, y = 0]) => [y, x]);
    const traced: HermiteCurve[] = traceImage({ width: 1, height: 1, data: new Uint8Array(1) }).contours.map((contour) => contour.curve);
    const fitted: HermiteCurve = fitSparse(places, { closed: false }).curve.insert(0.5);
    const lengths = (curve: Curve): Float64Array => curve.sampleByLength(Math.round(curve.parameterAtLength(1)));
    export const more = [HermiteCurve.through(places), traced, fitted, lengths(new InterpolatingCurve({ points: places }))];
    // A project whose library has no part for \`using\` may write it nevertheless, and bytes are what a Blob takes.
    { using fitter = new SparseFitter(places); fitter.solve(); }
    export const file: Uint8Array<ArrayBuffer> = TensorSurface.sphere(1).toGltf();
    // @ts-expect-error a radius is not a word
    HermiteCurve.ellipse({ center: [0, 0], radii: ["2", 1], count: 3 });
  `;
  writeFileSync(join(folder, "use.ts"), code);
  const tsc = join(process.cwd(), "node_modules", "typescript", "bin", "tsc");
  const node = { types: ["node"], typeRoots: [join(process.cwd(), "node_modules", "@types")], lib: ["es2022"] };
  // A page, and a program of Node whose libraries know of no browser.
  const page = { types: [], lib: ["es2022", "dom"] };
  // "node10" knows nothing of exports.
  for (const [module, moduleResolution, own] of [["esnext", "bundler", page], ["esnext", "node10", page], ["nodenext", "nodenext", node]] as const) {
    const compilerOptions = { module, moduleResolution, strict: true, noEmit: true, target: "es2022", skipLibCheck: false, exactOptionalPropertyTypes: true, ...own };
    writeFileSync(join(folder, "tsconfig.json"), JSON.stringify({ compilerOptions, files: ["use.ts"] }));
    assert.equal(spawnSync(process.execPath, [tsc, "-p", folder], { encoding: "utf8" }).stdout, "", moduleResolution);
  }
});

test("nothing in the tarball names the folder that it was built in", () => {
  for (const file of ["pkg/core.js", "pkg/spline.js", "pkg/expline_spline_bg.wasm", "pkg/surface.js", "pkg/expline_surface_bg.wasm", "pkg/fit.js", "pkg/cli.js", "pkg/node.js", "pkg/node-commonjs.cjs", "pkg/expline_bg.wasm", "pkg/expline_fit_bg.wasm", "THIRD_PARTY_LICENSES"]) {
    const text = readFileSync(join(consumer, "node_modules", "expline", file), "latin1");
    assert.ok(!text.includes(process.cwd()), `${file} names ${process.cwd()}`);
    assert.ok(!/\/(home|root|Users)\//.test(text), `${file} names a home folder`);
  }
});

test("the licences of what is linked are there, those of allocator and bindings too", () => {
  const text = readFileSync(join(consumer, "node_modules", "expline", "THIRD_PARTY_LICENSES"), "utf8");
  const linked = ["nalgebra", "libm", "wide", "talc", "lock_api", "scopeguard", "allocator-api2", "wasm-bindgen", "js-sys", "jpeg-js"];
  for (const name of linked) assert.match(text, new RegExp(`^${name} [0-9.]+: `, "m"), `${name} is not listed`);
  assert.ok(!/^(?:proptest|kurbo|serde|fast-png) /m.test(text), "what only tests use is listed");
});
