// Fits that are stopped, watched, repeated, forgotten and interrupted by the death of their engine.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { test } from "node:test";
import { setTimeout as pause } from "node:timers/promises";
import { Worker } from "node:worker_threads";
import { pathToFileURL } from "node:url";

import { ExplineError, HermiteCurve, type SparseFit, SparseFitter, fitSparse, fitSparseAsync } from "expline";

import { noisyCircle } from "./fit-data.ts";
const POINTS = noisyCircle(400, 0.01, 7);
const OPTIONS = { degree: 3, smoothing: 0.4 } as const;

/** Every bit of a fit. */
function bits(fit: SparseFit): string {
  return createHash("sha256").update(JSON.stringify([fit.curve, fit.knots, fit.objective, fit.gap, fit.maxError, Array.from(fit.parameters)])).digest("hex");
}

test("FT-036: the same fit gives the same bits again, also after a cancelled run, a warm fitter and in short tasks", async () => {
  const before = bits(fitSparse(POINTS, OPTIONS));
  const stop = new AbortController();
  const cancelled = fitSparseAsync(noisyCircle(20_000, 0.01, 2), { ...OPTIONS, signal: stop.signal, onProgress: () => stop.abort() });
  await assert.rejects(cancelled, { name: "ExplineError", code: "E_CANCELLED" });
  using fitter = new SparseFitter(POINTS, OPTIONS);
  fitter.solve({ smoothing: 0.7 });
  assert.equal(bits(fitSparse(POINTS, OPTIONS)), before);
  assert.equal(bits(await fitSparseAsync(POINTS, OPTIONS)), before);
  assert.equal(bits(new SparseFitter(POINTS, OPTIONS).solve()), before);
});

test("the fit is the same in another process, in a worker and from the slim entry", async () => {
  const code = `
    import { createHash } from "node:crypto";
    const points = new Float64Array(${JSON.stringify(Array.from(POINTS))});
    const digest = (fit) => createHash("sha256").update(JSON.stringify([fit.curve, fit.knots, fit.objective, fit.gap, fit.maxError, Array.from(fit.parameters)])).digest("hex");
  `;
  const own = bits(fitSparse(POINTS, OPTIONS));
  const node = (text: string): string => execFileSync(process.execPath, ["--input-type=module", "-e", text], { encoding: "utf8" }).trim();
  assert.equal(node(`import { fitSparse } from "expline"; ${code} console.log(digest(fitSparse(points, ${JSON.stringify(OPTIONS)})));`), own);
  assert.equal(node(`import init, { fitSparseAsync } from "expline/slim"; ${code} await init(); console.log(digest(await fitSparseAsync(points, ${JSON.stringify(OPTIONS)})));`), own);
  const address = pathToFileURL("pkg/expline.js").href;
  const worker = new Worker(
    `import { parentPort } from "node:worker_threads"; import { fitSparse } from ${JSON.stringify(address)}; ${code} parentPort.postMessage(digest(fitSparse(points, ${JSON.stringify(OPTIONS)})));`,
    { eval: true, stdout: true, stderr: true, execArgv: ["--input-type=module"] },
  );
  const said = await new Promise((resolve, reject) => worker.once("message", resolve).once("error", reject));
  await worker.terminate();
  assert.equal(said, own);
});

test("the slim entry's fitSparse says that it waits for initFit, which finds its file", () => {
  const said = execFileSync(process.execPath, ["--input-type=module", "-e", `
    import init, { fitSparse, initFit } from "expline/slim";
    await init();
    let code;
    try { fitSparse([0, 0, 1, 0, 1, 1]); } catch (error) { code = error.code; }
    await initFit();
    console.log(code, fitSparse([0, 0, 4, 0, 4, 4, 0, 4]).curve.closed);
  `], { encoding: "utf8" }).trim();
  assert.equal(said, "E_NOT_READY true");
});

test("an abort at whichever step is an abort, also at the last one", async () => {
  const many = noisyCircle(3000, 0.01, 2);
  const fitter = new SparseFitter(many, OPTIONS);
  for (const work of [(watch: object) => fitSparseAsync(many, { ...OPTIONS, ...watch }), (watch: object) => fitter.solveAsync(watch)]) {
    let steps = 0;
    await work({ onProgress: () => (steps += 1) });
    assert.ok(steps > 1, "there are several");
    for (let last = 1; last <= steps; last += 1) {
      const stop = new AbortController();
      let step = 0;
      const onProgress = (): void => {
        if ((step += 1) === last) stop.abort();
      };
      await assert.rejects(work({ signal: stop.signal, onProgress }), { code: "E_CANCELLED" }, `step ${last} of ${steps}`);
    }
  }
  fitter.dispose();
});

test("FT-023, FT-024: an aborted signal rejects at once, one that is aborted later within a step", async () => {
  await assert.rejects(fitSparseAsync(POINTS, { signal: AbortSignal.abort("enough") }), (error) => {
    assert.ok(error instanceof ExplineError);
    assert.equal(error.code, "E_CANCELLED");
    assert.equal(error.cause, "enough");
    return true;
  });
  assert.throws(() => fitSparse(POINTS, { signal: AbortSignal.abort() }), { code: "E_CANCELLED" });
  const stop = new AbortController();
  const work = fitSparseAsync(noisyCircle(100_000, 0.01, 4), { signal: stop.signal });
  const outcome = work.then(() => "done", (error: ExplineError) => error.code);
  await pause(5);
  stop.abort();
  assert.ok(["E_CANCELLED", "done"].includes(await outcome));
});

test("a fit in short tasks lets timers through, and reports iterations that rise", async () => {
  let turns = 0;
  const timer = setInterval(() => (turns += 1), 1);
  const seen: { iteration: number; gap: number }[] = [];
  await fitSparseAsync(noisyCircle(40_000, 0.01, 3), { smoothing: 0.3, onProgress: (progress) => seen.push(progress) });
  clearInterval(timer);
  assert.ok(turns > 0, "no timer came through");
  assert.ok(seen.length > 1);
  seen.forEach(({ iteration, gap }, i) => {
    assert.ok(iteration >= (seen[i - 1]?.iteration ?? 0));
    assert.ok(gap >= 0 && gap <= 1);
  });
});

test("a fit that searches for the fewest knots says a gap of 1 all the time, and what ends it is the cause", async () => {
  for (const options of [{ tolerance: 0.05 }, {}]) {
    const seen: number[] = [];
    const { gap } = await fitSparseAsync(noisyCircle(5_000, 0.01, 3), { ...options, onProgress: (progress) => seen.push(progress.gap) });
    assert.ok(seen.length > 1);
    assert.deepEqual(new Set([...seen, gap]), new Set([1]));
  }
  const reason = new Error("the dialog was closed");
  await assert.rejects(fitSparseAsync(POINTS, { signal: AbortSignal.abort(reason) }), { code: "E_CANCELLED", cause: reason });
});

test("HY-014: what a progress callback throws reaches the caller as it is, and nothing is broken", async () => {
  const own = new TypeError("mine");
  const onProgress = (): never => {
    throw own;
  };
  assert.throws(() => fitSparse(POINTS, { ...OPTIONS, onProgress }), (error) => error === own);
  await assert.rejects(fitSparseAsync(POINTS, { ...OPTIONS, onProgress }), (error) => error === own);
  using fitter = new SparseFitter(POINTS, OPTIONS);
  assert.throws(() => fitter.solve({ onProgress }), (error) => error === own);
  assert.ok(fitter.solve().knots.length > 0);
});

test("LC-007, LC-009: a fitter is busy for its own callback, and usable afterwards", () => {
  using fitter = new SparseFitter(POINTS, OPTIONS);
  const codes: string[] = [];
  const attempt = (call: () => unknown): void => {
    try {
      call();
    } catch (error) {
      codes.push((error as ExplineError).code);
    }
  };
  fitter.solve({
    onProgress: () => {
      if (codes.length > 0) return;
      attempt(() => fitter.solve());
      attempt(() => fitter.dispose());
    },
  });
  assert.deepEqual(codes, ["E_BUSY", "E_BUSY"]);
  assert.ok(fitter.solve().knots.length > 0);
});

test("a fitter at work is not disposed of between its tasks either, but is as soon as its promise has settled", async () => {
  const fitter = new SparseFitter(POINTS, OPTIONS);
  const solved = fitter.solveAsync();
  assert.throws(() => fitter.dispose(), { code: "E_BUSY" });
  assert.ok((await solved.finally(() => fitter.dispose())).knots.length > 0);
  assert.throws(() => fitter.solve(), { code: "E_DISPOSED" });
});

test("a fitter tells and obeys those it was made for, unless a solve names others", async () => {
  let own = 0;
  let other = 0;
  using fitter = new SparseFitter(POINTS, { ...OPTIONS, onProgress: () => (own += 1) });
  fitter.solve();
  const afterOne = own;
  await fitter.solveAsync({ smoothing: 0.5 });
  const afterTwo = own;
  assert.ok(0 < afterOne && afterOne < afterTwo, "both kinds of solve tell");
  fitter.solve({ onProgress: () => (other += 1) });
  await fitter.solveAsync({ onProgress: () => (other += 1) });
  assert.ok(own === afterTwo && other > 1, "only those who are named");

  const stop = new AbortController();
  using stopped = new SparseFitter(POINTS, { ...OPTIONS, signal: stop.signal });
  stop.abort("enough");
  assert.throws(() => stopped.solve(), { code: "E_CANCELLED", cause: "enough" });
  await assert.rejects(stopped.solveAsync(), { code: "E_CANCELLED", cause: "enough" });
  assert.ok((await stopped.solveAsync({ signal: new AbortController().signal })).knots.length > 0, "a signal of its own");
  assert.ok(stopped.solve({ signal: new AbortController().signal }).knots.length > 0, "a signal of its own, at once");
});

test("a fitter that was disposed of says so, twice if need be", async () => {
  const fitter = new SparseFitter(POINTS, OPTIONS);
  fitter.dispose();
  fitter.dispose();
  fitter[Symbol.dispose]();
  assert.throws(() => fitter.solve(), { name: "ExplineError", code: "E_DISPOSED" });
  await assert.rejects(fitter.solveAsync(), { code: "E_DISPOSED" });
});

test("a forged fitter is refused", () => {
  const { solve, dispose } = SparseFitter.prototype;
  for (const forged of [{}, null, HermiteCurve.through([0, 0, 1, 1]), new Proxy(new SparseFitter(POINTS), {})]) {
    assert.throws(() => solve.call(forged as never), { code: "E_TYPE", arg: "this" });
    assert.throws(() => dispose.call(forged as never), { code: "E_TYPE", arg: "this" });
  }
});

test("solves of a fitter are those of fits from nothing to the last bit, and within the gap where one of 1e-3 is enough", () => {
  for (const finish of ["none", "full"] as const) {
    using fitter = new SparseFitter(POINTS, { degree: 3, finish });
    for (const smoothing of [0.3, 0.31, 0.5, 0.2, 0.9, 0.3]) {
      const [again, cold] = [fitter.solve({ smoothing }), fitSparse(POINTS, { degree: 3, finish, smoothing })];
      assert.equal(bits(again), bits(cold), `${finish} at ${smoothing}`);
    }
  }
  const live = { degree: 3, finish: "none", gap: 1e-3 } as const;
  using fitter = new SparseFitter(POINTS, live);
  for (const smoothing of [0.3, 0.31, 0.5, 0.2, 0.9, 0.3]) {
    const [warm, cold] = [fitter.solve({ smoothing }), fitSparse(POINTS, { ...live, smoothing })];
    // Both are above the optimum, by no more than their gaps.
    const most = Math.max(warm.gap * warm.objective, cold.gap * cold.objective);
    assert.ok(Math.abs(warm.objective - cold.objective) <= most * (1 + 1e-9), `${warm.objective} and ${cold.objective} at ${smoothing}`);
  }
});

test("at no place of the slider a knot that slides onto another breaks the fit", () => {
  const points = noisyCircle(200, 0.0125, 2);
  using fitter = new SparseFitter(points, { degree: 3 });
  for (let i = 0; i <= 60; i += 1) {
    const smoothing = i / 60;
    const [cold, warm] = [fitSparse(points, { degree: 3, smoothing }), fitter.solve({ smoothing })];
    for (const fit of [cold, warm]) assert.ok(Number.isFinite(fit.maxError) && fit.maxError < 2, `${fit.maxError} at ${smoothing}`);
  }
});

test("a deadline gives the best so far, which says so", () => {
  const fit = fitSparse(noisyCircle(100_000, 0.01, 2), { smoothing: 0.3, deadline: 0 });
  assert.equal(fit.status, "deadline");
  assert.ok([fit.maxError, fit.qfe, fit.gap, ...fit.curve.sample(100)].every(Number.isFinite));
});

test("many fits, and fitters that nobody disposes of, leave no memory behind", () => {
  const before = process.memoryUsage().rss;
  for (let i = 0; i < 300; i += 1) fitSparse(POINTS, { smoothing: 0.5, degree: 1 });
  const grown = (process.memoryUsage().rss - before) / 1e6;
  assert.ok(grown < 150, `${grown} MB`);
});

test("a curve that keeps thousands of knots finds room in the engine", () => {
  // Each way to do without one of them was a list of all the others: gigabytes, where one in a few is looked at.
  const fit = fitSparse(noisyCircle(30_000, 0.01, 3), { closed: false, tolerance: 0.005 });
  assert.equal(fit.status, "converged");
  assert.ok(fit.maxError <= 0.005 && fit.knots.length > 5000, `${fit.knots.length} knots, ${fit.maxError} off`);
});
