// The engine for fitting dies, and takes nothing along: fitters of its time go on in the next instance.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";

import { ExplineError, HermiteCurve, SparseFitter, initFitSync } from "expline";

import { noisyCircle } from "./fit-data.ts";
import { trapping } from "./trapping.ts";

// In this process disposing of a fitter stops the engine; everything else is as it is delivered.
initFitSync({ bytes: trapping("fit_close", "pkg/expline_fit_bg.wasm") });

const POINTS = noisyCircle(200, 0.01, 5);

function stop(): void {
  const fitter = new SparseFitter(POINTS);
  assert.throws(() => fitter.dispose(), (error) => {
    assert.ok(error instanceof ExplineError);
    assert.equal(error.code, "E_INTERNAL");
    assert.equal(error.fatal, true);
    assert.ok(error.cause instanceof WebAssembly.RuntimeError);
    return true;
  });
}

test("LC-011, LC-012: after a trap a fitter from before gives the bits that it gave", () => {
  const fitter = new SparseFitter(POINTS, { degree: 3, smoothing: 0.4 });
  const first = JSON.stringify(fitter.solve());
  const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [3, 2], count: 4 });
  const before = curve.sample(50);
  stop();
  assert.deepEqual(curve.sample(50), before, "the engine of curves is another one");
  assert.equal(JSON.stringify(fitter.solve()), first);
  stop();
  assert.equal(JSON.stringify(new SparseFitter(POINTS, { degree: 3, smoothing: 0.4 }).solve()), first);
});

test("LC-014: traps in a row cost no memory", () => {
  for (let i = 0; i < 50; i += 1) stop();
  const before = process.memoryUsage().rss;
  for (let i = 0; i < 450; i += 1) stop();
  const grown = (process.memoryUsage().rss - before) / 1e6;
  assert.ok(grown < 200, `${grown} MB`);
});

test("a run that was under way when the engine died begins anew", async () => {
  const fitter = new SparseFitter(noisyCircle(20_000, 0.01, 6), { degree: 3, smoothing: 0.4 });
  let stopped = false;
  const fit = await fitter.solveAsync({
    onProgress: () => {
      if (!stopped) stop();
      stopped = true;
    },
  });
  assert.ok(stopped);
  assert.equal(fit.status, "converged");
});

test("a forgotten fitter whose engine dies as it is collected disturbs nobody", async () => {
  setFlagsFromString("--expose-gc");
  const collect = runInNewContext("gc") as () => void;
  let collected = 0;
  const seen = new FinalizationRegistry(() => (collected += 1));
  const thrown: unknown[] = [];
  const note = (error: unknown): unknown => thrown.push(error);
  process.on("uncaughtException", note);
  for (let i = 0; i < 20; i += 1) seen.register(new SparseFitter(POINTS), i);
  for (let i = 0; i < 50 && collected === 0; i += 1) {
    collect();
    await new Promise((resolve) => setImmediate(resolve));
  }
  await new Promise((resolve) => setTimeout(resolve, 20));
  process.off("uncaughtException", note);
  assert.ok(collected > 0, "the collector came by");
  assert.deepEqual(thrown, []);
  assert.equal(new SparseFitter(POINTS).solve().status, "converged");
});
