// Starting, stopping, and being replaced: nothing that happens to the engine may cost anybody a curve.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { setFlagsFromString } from "node:v8";
import { pathToFileURL } from "node:url";
import { inspect } from "node:util";
import { runInNewContext } from "node:vm";
import { Worker } from "node:worker_threads";

import init, { ExponentialBSpline, ExplineError, HermiteCurve, HermiteGenerators, Interpolator, InterpolatingCurve, SparseFitter, TensorSurface, fitSparse, fromJSON, initSync, initTrace, parsePath } from "expline";

import { trapping } from "./trapping.ts";

// In this process `area` stops the engine; everything else is as it is delivered.
initSync({ bytes: trapping("area") });
const BEFORE = reference();

/** The reference work, which must not ask for an area here. */
function reference(): string {
  const curve = HermiteCurve.ellipse({ center: [1, 2], radii: [5, 3], rotation: 0.3, count: 5 });
  return JSON.stringify([Array.from(curve.sample(50)), curve.length(), curve.insert(0.3), curve.toPathD({ arcs: false })]);
}

function stop(): void {
  assert.throws(
    () => HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 2 }).area(),
    (error) => {
      assert.ok(error instanceof ExplineError);
      assert.equal(error.code, "E_INTERNAL");
      assert.equal(error.fatal, true);
      assert.ok(error.cause instanceof WebAssembly.RuntimeError);
      return true;
    },
  );
}

/** Where the package is, for those who cannot ask by its name. */
const PACKAGE = pathToFileURL("pkg/expline.js").href;

/** Hostile values get past the compiler here, as they do in JavaScript. */
const hostile = <T>(value: unknown): T => value as T;

/** Every method and getter of a curve, its own and inherited; those left out touch nothing, or only other methods. */
const METHODS = [HermiteCurve.prototype, Object.getPrototypeOf(HermiteCurve.prototype) as object]
  .flatMap((prototype) => Object.entries(Object.getOwnPropertyDescriptors(prototype)))
  .filter(([name]) => !["constructor", "dimension", "toPath2D"].includes(name))
  .map(([name, { value, get }]) => [name, (value ?? get) as (this: unknown, ...given: unknown[]) => unknown] as const);

/** Runs a module that imports the package in a process of its own. */
function node(code: string, ...flags: string[]): string {
  return execFileSync(process.execPath, [...flags, "--input-type=module", "-e", code], { encoding: "utf8" }).trim();
}

const DIGEST = `
  import { createHash } from "node:crypto";
  const hash = createHash("sha256");
  let seed = 42;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  for (let i = 0; i < 200; i += 1) {
    const n = 2 + Math.floor(6 * random());
    const points = Float64Array.from({ length: 2 * n }, () => 100 * random() - 50);
    const tangents = Float64Array.from({ length: 2 * n }, () => 60 * random() - 30);
    const space = ["trigonometric", "hyperbolic", "polynomial"][i % 3];
    const curve = new HermiteCurve({ points, tangents, closed: i % 2 === 0, space, omega: 3 * random() });
    const at = curve.nearest(10 * random(), 10 * random());
    const all = [curve.sample(64), curve.evaluate(curve.domain[1] * random(), 2), curve.flatten(0.1), curve.toCubics(0.01).path,
      curve.refine(3).tangents, curve.insert(curve.domain[1] * random()).points,
      Float64Array.of(curve.length(), at.t, at.distance, ...Object.values(curve.bounds()))];
    for (const array of all) hash.update(new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
    hash.update(curve.toPathD().d);
  }
  const digest = hash.digest("hex");
`;

test("LC-001, LC-002, LC-003: there is nothing to free, and no call consumes a curve", () => {
  const curve = HermiteCurve.through([0, 0, 1, 0, 1, 1]);
  assert.equal(Object.getOwnPropertyNames(HermiteCurve.prototype).includes("free"), false);
  curve.refine();
  curve.reverse();
  curve.split(0.5);
  curve.remove(0);
  assert.deepEqual(curve.points, Float64Array.of(0, 0, 1, 0, 1, 1));
});

test("LC-004, LC-030, LC-031: a forged this, a curve of another copy and a proxy are refused by name", async () => {
  const curve = HermiteCurve.through([0, 0, 1, 0, 1, 1]);
  const generators = new HermiteGenerators(1);
  const copy = (await import(hostile<string>(new URL("core.js?copy", PACKAGE).href))) as typeof import("expline");
  const foreign = copy.HermiteCurve.through([0, 0, 1, 0, 1, 1]);
  for (const forged of [{ __wbg_ptr: 1234 }, null, 5, foreign, new Proxy(curve, {}), generators]) {
    for (const [name, method] of METHODS) {
      assert.throws(() => method.call(forged, 1, 1, 1), { name: "ExplineError", code: "E_TYPE", arg: "this" }, `${name} of ${typeof forged}`);
    }
    if (forged === generators) continue;
    assert.throws(() => HermiteGenerators.prototype.gram.call(hostile(forged)), { name: "ExplineError", code: "E_TYPE", arg: "this" });
  }
});

test("consoles show a curve's kind, and frameworks that wrap plain objects in proxies see that it is none", () => {
  const blob = new InterpolatingCurve({ points: [0, 0, 9, 2, 10, 11, 2, 9] });
  const drawn = { HermiteCurve: HermiteCurve.through([0, 0, 1, 0, 1, 1]), InterpolatingCurve: blob, BSplineCurve: blob.refine(1), LocalCurve: blob.refineAt(1), TensorSurface: TensorSurface.sphere(1) };
  for (const [name, thing] of Object.entries(drawn)) {
    assert.equal(inspect(thing), `${name} {}`);
    assert.deepEqual(structuredClone(thing.toJSON()), thing.toJSON());
  }
  const others = { HermiteGenerators: new HermiteGenerators(1), ExponentialBSpline: new ExponentialBSpline([0, 0]), Interpolator: Interpolator.forEllipse(8), SparseFitter: new SparseFitter([0, 0, 4, 0, 4, 4, 0, 4]) };
  for (const [name, thing] of Object.entries({ ...drawn, ...others })) {
    // An interpolator shows its condition as well.
    assert.match(inspect(thing), new RegExp(`^${name} \\{`));
    assert.equal(thing.constructor.name, name);
    // The rule of Vue's `reactive` and `ref`: what is not [object Object] is kept as it is.
    assert.equal(Object.prototype.toString.call(thing), `[object ${name}]`);
  }
  assert.equal(ExplineError.name, "ExplineError");
  class Mine extends HermiteCurve {}
  assert.equal(inspect(new Mine({ points: [0, 0, 1, 0], tangents: [0, 1, 0, 1] })), "Mine {}");
});

test("LC-010: a bad argument leaves a curve as it was, and usable", () => {
  const curve = HermiteCurve.through([0, 0, 1, 0, 1, 1]);
  const before = JSON.stringify(curve);
  for (const edit of [
    () => (curve.points = hostile("x")),
    () => (curve.points = [1, 2]),
    () => (curve.tangents = [0, 0, 0, 0, 0, NaN]),
    () => (curve.tangentsIn = hostile(null)),
    () => curve.setPoint(0, 1, NaN),
    () => curve.setPoint(3, 1, 1),
    () => curve.setTangent(0, 1, 1e10),
    () => curve.setTangent(0, 1, 1, hostile("left")),
  ]) {
    assert.throws(edit, ExplineError);
    assert.equal(JSON.stringify(curve), before);
  }
  curve.setPoint(0, 5, 6);
  assert.deepEqual(curve.evaluate(0), Float64Array.of(5, 6));
});

test("LC-011, LC-012: after a trap the next call works, and curves from before are whole", () => {
  const curve = parsePath("M0 0C1 2 3 4 5 0.1A3 4 10 0 1 9 9Z")[0] as HermiteCurve;
  const [points, length] = [curve.sample(99), curve.length()];
  stop();
  assert.deepEqual(curve.sample(99), points);
  assert.equal(curve.length(), length);
  stop();
  curve.setPoint(0, -1, -1);
  assert.deepEqual(curve.evaluate(0), Float64Array.of(-1, -1));
  assert.equal(reference(), BEFORE);
});

test("LC-013, LC-014: twenty thousand traps in a row cost no memory and no curve", (t) => {
  const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 3 });
  const points = curve.sample(33);
  for (let i = 0; i < 200; i += 1) stop();
  const before = process.memoryUsage().rss;
  for (let i = 0; i < 19_800; i += 1) stop();
  const grown = (process.memoryUsage().rss - before) / 1e6;
  assert.deepEqual(curve.sample(33), points);
  assert.equal(reference(), BEFORE);
  // Each instance has 1.1 MB of its own: 19,800 of them would be 22 GB.
  assert.ok(grown < 200, `${grown} MB`);
  t.diagnostic(`memory grew by ${grown.toFixed(1)} MB over 19,800 traps`);
});

test("LC-017: a result is a copy, which survives the growth of the engine's memory", () => {
  const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 3 });
  const points = curve.sample(33);
  const kept = points.slice();
  curve.refine(200_000);
  assert.deepEqual(points, kept);
  points.fill(0);
  assert.deepEqual(curve.sample(33), kept);
});

test("LC-019: a failed init is not kept, and concurrent ones share", () => {
  const said = node(`
    import init, { HermiteCurve } from "expline";
    const failed = await init({ bytes: new Uint8Array(8) }).catch((error) => error);
    const [one, two] = [init(), init()];
    await one;
    console.log(failed.code, failed.reason, one === two, await init(), HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 2 }).evaluate(0)[0]);
  `);
  assert.equal(said, "E_INIT compile true undefined 1");
});

test("LC-020: a call before init needs no init", () => {
  const said = node(`import { HermiteCurve } from "expline"; console.log(HermiteCurve.through([0, 0, 1, 1], { closed: false }).length() > 1)`);
  assert.equal(said, "true");
});

test("LC-023, W14: why the engine cannot start is one of six words", () => {
  const reasons = {
    unsupported: "delete globalThis.WebAssembly; await tried()",
    csp: `WebAssembly.Module = class { constructor() { throw new WebAssembly.CompileError("Compiling or instantiating WebAssembly module violates the following Content Security policy directive because 'unsafe-eval' is not allowed"); } }; await tried(() => HermiteCurve.through([0, 0, 1, 1]))`,
    network: `globalThis.fetch = () => Promise.reject(new TypeError("fetch failed")); await tried(() => init({ wasmUrl: "https://nowhere.invalid/x.wasm" }))`,
    mime: `globalThis.fetch = () => Promise.resolve(new Response("<!doctype html>")); await tried(() => init({ wasmUrl: "https://nowhere.invalid/x.wasm" }))`,
    compile: "await tried(() => init({ bytes: Uint8Array.of(0, 97, 115, 109, 9, 9, 9, 9) }))",
    version: "await tried(() => init({ bytes: Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0) }))",
  };
  for (const [reason, code] of Object.entries(reasons)) {
    const said = node(`
      import init, { HermiteCurve } from "expline";
      const tried = async (call = init) => { try { await call(); console.log("no error"); } catch (error) { console.log(error.name, error.code, error.reason); } };
      ${code};
    `);
    assert.equal(said, `ExplineError E_INIT ${reason}`);
  }
});

test("init takes bytes, a module, and the address of a file", () => {
  for (const source of ["{ bytes: readFileSync(file) }", "{ module: new WebAssembly.Module(readFileSync(file)) }", "{ wasmUrl: pathToFileURL(file) }"]) {
    const said = node(`
      import { readFileSync } from "node:fs";
      import { pathToFileURL } from "node:url";
      import init, { HermiteCurve } from "expline";
      const file = "pkg/expline_bg.wasm";
      const { Module } = WebAssembly;
      await init(${source});
      WebAssembly.Module = class { constructor() { throw new Error("compiled again"); } };
      console.log(HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 2 }).evaluate(1)[0]);
    `);
    assert.equal(said, "-1");
  }
});

test("what starts an engine may come from another realm, as in test runners and frames", () => {
  const from = {
    bytes: "runInNewContext('(n) => new ArrayBuffer(n)')(file.length)",
    module: "runInNewContext('(bytes) => new WebAssembly.Module(bytes)')(file)",
    wasmUrl: "runInNewContext('(href) => new (class URL { href = href })()')(pathToFileURL('pkg/expline_bg.wasm').href)",
  };
  for (const [name, code] of Object.entries(from)) {
    const said = node(`
      import { readFileSync } from "node:fs";
      import { pathToFileURL } from "node:url";
      import { runInNewContext } from "node:vm";
      import init, { HermiteCurve } from "expline/slim";
      const file = readFileSync("pkg/expline_bg.wasm");
      const ${name} = ${code};
      if (${name} instanceof Object) throw new Error("of this realm");
      if (Object.prototype.toString.call(${name}) === "[object ArrayBuffer]") new Uint8Array(${name}).set(file);
      await init({ ${name} });
      console.log(HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 2 }).evaluate(1)[0]);
    `);
    assert.equal(said, "-1", name);
  }
});

test("what stands where options belong, and is none, is refused instead of overlooked", async () => {
  const bytes = readFileSync("pkg/expline_bg.wasm");
  const strays = [new URL("file:///a.wasm"), new AbortController().signal, Promise.resolve({}), bytes.buffer, new WebAssembly.Module(bytes), new Response(), new Map()];
  const refused = (error: unknown): boolean => error instanceof ExplineError && error.code === "E_TYPE" && error.argument === "options" && error.bound === "a plain object";
  const square = [0, 0, 4, 0, 4, 4, 0, 4];
  const line = HermiteCurve.through([0, 0, 1, 1]);
  for (const stray of strays) {
    assert.throws(() => fitSparse(square, hostile(stray)), refused);
    assert.throws(() => line.toPathD(hostile(stray)), refused);
    await assert.rejects(initTrace(hostile(stray)), refused);
    assert.throws(() => initSync(hostile(stray)), refused);
  }
  const exporting: string = "data:text/javascript,export const decimals = 3";
  // A module that only exports what is asked for, options without a prototype, and those of another realm are options.
  for (const fine of [(await import(exporting)) as object, Object.create(null), runInNewContext("({ decimals: 3 })")]) {
    assert.match(line.toPathD(hostile(fine)).d, /^M/);
  }
});

test("what is wrong with a call of init is said where an engine runs, too", async () => {
  await initTrace();
  const refused = { name: "ExplineError", code: "E_TYPE" };
  for (const options of [{ foo: 1 }, { wasmURL: "a.wasm" }, 7, "a.wasm"]) {
    await assert.rejects(initTrace(hostile(options)), refused);
    await assert.rejects(init(hostile(options)), refused);
  }
  await initTrace({});
  await init({ wasmUrl: "not-asked-for.wasm" });
});

test("an address that gives nothing says why", () => {
  const said = node(`
    import init from "expline";
    for (const wasmUrl of ["file:///nowhere/a.wasm", "nowhere/a.wasm", "https://nowhere.invalid/a.wasm"]) {
      globalThis.fetch &&= wasmUrl.startsWith("https") ? () => Promise.resolve(new Response("", { status: 404 })) : globalThis.fetch;
      await init({ wasmUrl }).catch(({ message }) => console.log(message));
    }
  `);
  const [missing, relative, gone] = said.split("\n");
  assert.match(missing ?? "", /^init: "file:\/\/\/nowhere\/a\.wasm" could not be read \(ENOENT: .*\); wasmUrl may say where it is \[E_INIT\]$/);
  assert.match(relative ?? "", /could not be read \(.*URL.*\);/);
  assert.match(gone ?? "", /could not be read \(HTTP 404\);/);
});

test("LC-026: a worker that is ended in the middle of its work harms nobody", async () => {
  const code = `import { HermiteCurve } from "expline"; for (;;) HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 9 }).flatten(1e-6);`;
  const worker = new Worker(new URL(`data:text/javascript,${encodeURIComponent(code.replace('"expline"', JSON.stringify(PACKAGE)))}`));
  await new Promise((resolve) => worker.once("online", resolve));
  await worker.terminate();
  assert.equal(reference(), BEFORE);
});

test("LC-027: a hundred thousand curves, made and dropped, leave nothing", (t) => {
  setFlagsFromString("--expose-gc");
  const gc = runInNewContext("gc") as () => void;
  const make = (count: number): void => {
    for (let i = 0; i < count; i += 1) HermiteCurve.ellipse({ center: [i, 0], radii: [1, 1], count: 8 }).evaluate(1);
  };
  const used = (): number => (gc(), process.memoryUsage().heapUsed + process.memoryUsage().arrayBuffers) / 1e6;
  make(1000);
  const before = used();
  make(100_000);
  const grown = used() - before;
  assert.ok(grown < 8, `${grown} MB`);
  t.diagnostic(`memory grew by ${grown.toFixed(2)} MB over 100 000 curves`);
});

test("more curves than slots are used in turn without mixing them up", () => {
  const curves = Array.from({ length: 50 }, (_, i) => HermiteCurve.ellipse({ center: [i, 0], radii: [1, 1], count: 2 + (i % 5) }));
  for (let round = 0; round < 3; round += 1) {
    for (const [i, curve] of curves.entries()) assert.equal(curve.evaluate(0)[0], i + 1);
    for (const [i, curve] of [...curves].reverse().entries()) assert.equal(curve.nearest(1e3, 0).x, 50 - i);
  }
});

test("LC-032, LC-033, LC-034: the boundary is never asked what it cannot answer", () => {
  assert.throws(() => parsePath(hostile(5)), { code: "E_TYPE", arg: "d" });
  const curve = HermiteCurve.through([0, 0, 1, 0, 1, 1]);
  assert.throws(() => curve.evaluate(new Float64Array(5e7)), { code: "E_LIMIT", arg: "t" });
  assert.throws(() => curve.setPoint(2 ** 32, 0, 0), { code: "E_RANGE", arg: "i" });
  assert.equal(reference(), BEFORE);
});

test("LC-036: with no stack left a call fails cleanly, and the next one works", () => {
  const curve = HermiteCurve.through([0, 0, 1, 0, 1, 1]);
  const expected = curve.sample(20);
  let seen = 0;
  const dive = (): void => {
    try {
      dive();
    } catch {
      // Every frame on the way back tries with a little more stack than the one before.
      try {
        if (seen < 400) curve.sample(20);
        seen += 1;
      } catch (error) {
        seen += 1;
        if (!(error instanceof RangeError || error instanceof ExplineError)) throw error;
      }
    }
  };
  dive();
  assert.deepEqual(curve.sample(20), expected);
  assert.equal(reference(), BEFORE);
});

test("the same bits on every tier of the engine, in a worker, and after other work", async (t) => {
  const said = (...flags: string[]): string => node(`import { HermiteCurve } from "expline"; ${DIGEST} console.log(digest)`, ...flags);
  const digest = said();
  for (const flag of ["--liftoff-only", "--no-liftoff", "--single-threaded"]) assert.equal(said(flag), digest, flag);
  const busy = `const busy = HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 9 }); for (let i = 0; i < 1000; i += 1) busy.refine().nearest(i, 1);`;
  assert.equal(node(`import { HermiteCurve } from "expline"; ${busy} ${DIGEST} console.log(digest)`), digest);
  const code = `import { parentPort } from "node:worker_threads"; import { HermiteCurve } from ${JSON.stringify(PACKAGE)}; ${DIGEST} parentPort.postMessage(digest)`;
  const worker = new Worker(new URL(`data:text/javascript,${encodeURIComponent(code)}`));
  assert.equal(await new Promise((resolve, reject) => worker.once("message", resolve).once("error", reject)), digest);
  t.diagnostic(`sha-256 of 1800 results: ${digest.slice(0, 16)}…`);
});

test("a curve that was sent to another thread as JSON is the same curve", () => {
  const curve = HermiteCurve.through([0, 0, 1, 0, 1, 1, 0.3, 2]);
  const sent = structuredClone(curve.toJSON());
  assert.deepEqual(fromJSON(sent).sample(77), curve.sample(77));
  
});
