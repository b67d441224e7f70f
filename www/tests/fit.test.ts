import assert from "node:assert/strict";
import { test } from "node:test";
import { emptyFit, fitDefaults, isJoined, strokesOf, withoutDisc, withStrokes, type FitDocument, type Pair } from "../src/document/fit/fit.ts";
import { fitSample, fitSamples, samplePoints } from "../src/document/fit/fit-samples.ts";
import { readState, writeState, parseState } from "../src/document/file/file.ts";
import { bringStrokes } from "../src/editor/fit/bring.ts";
import { toggleFitOverlay } from "../src/editor/fit/fit-actions.ts";
import { chooseFitTool, clearFit, eraseAt, openFitSample, setModel, setNoise, setSmoothing, setTarget, setTargetValue } from "../src/editor/fit/fit-edits.ts";
import { mostDifferent, sameSubject, subjectOf } from "../src/editor/fit/fit-question.ts";
import { showChartPoint } from "../src/editor/fit/fit-answers.ts";
import { createFitRunner, type FitRunner } from "../src/editor/fit/fit-runner.ts";
import { readShareHash, shareHash } from "../src/io/link/share.ts";
import { createFitClient, type FitClient } from "../src/kernel/fit/fit-client.ts";
import type { FitAnswer, FitRequest, FitSubject } from "../src/kernel/fit/job.ts";
import type { FitOutcome } from "../src/kernel/fit/outcome.ts";
import { shownKnots } from "../src/kernel/fit/knots.ts";
import { createFitTool } from "../src/tools/fit/fit-tool.ts";
import { Hand } from "./harness.ts";

/** Fit without a browser: points in by hand and by sample, requests out, and no older answer over a newer one. */

function hand(): Hand {
  const made = new Hand();
  made.editor.modes.set("fit", { label: "", tool: createFitTool(made.editor) });
  made.editor.patch({ mode: "fit", fitView: made.editor.state.value.fitView });
  clearFit(made.editor);
  made.editor.fitEdits.amend(() => ({ fit: { ...fitDefaults, data: [] } }));
  return made;
}

const fitOf = (made: Hand): FitDocument => made.editor.state.value.fit;

test("samples are the same for the same seed, and other noise for another", () => {
  for (const sample of fitSamples) {
    const [one, two] = [samplePoints(sample, 2, 5), samplePoints(sample, 2, 5)];
    assert.deepEqual(one, two, sample.id);
    assert.notDeepEqual(samplePoints(sample, 2, 6).data[0], one.data[0]);
    assert.ok(one.data.every(([x, y]) => x >= 0 && x <= 900 && y >= 0 && y <= 650), `${sample.id} lies on the stage`);
  }
  const star = fitSample("fit-star");
  assert.ok(star !== undefined);
  assert.equal(samplePoints(star, 0, 1).data.length, 300);
});

test("the noise of a sample has the deviation that it says", () => {
  const circle = fitSample("fit-circle");
  assert.ok(circle !== undefined);
  const [clean, noisy] = [samplePoints(circle, 0, 1).data, samplePoints(circle, 3, 1).data];
  let sum = 0;
  noisy.forEach(([x, y], i) => {
    const [a, b] = clean[i] ?? [0, 0];
    sum += (x - a) ** 2 + (y - b) ** 2;
  });
  const sigma = Math.sqrt(sum / (2 * noisy.length));
  // 400 normal numbers: their deviation is known to 3.5 %; four times that.
  assert.ok(Math.abs(sigma / 3 - 1) < 0.15, `${sigma}`);
});

test("a stroke drawn by hand is one entry of the history, and gives way to undo", () => {
  const made = hand();
  made.drag({ x: 100, y: 100 }, 200, 50);
  assert.equal(strokesOf(fitOf(made)).length, 1);
  assert.deepEqual(fitOf(made).data.at(-1), [300, 150]);
  made.drag({ x: 100, y: 300 }, 200, 50);
  assert.equal(strokesOf(fitOf(made)).length, 2);
  made.run("undo");
  assert.equal(strokesOf(fitOf(made)).length, 1);
  made.run("undo").run("redo").run("redo");
  assert.equal(strokesOf(fitOf(made)).length, 2);
});

test("every place of a fast pen is in the stroke, not only that of each frame", () => {
  const made = hand();
  made.moveTo(100, 100).press();
  for (let x = 110; x <= 300; x += 10) made.input.move({ id: 1, kind: "mouse", button: 0, screen: { x, y: 100 }, modifiers: made.held, time: made.time });
  made.input.flush();
  made.release();
  assert.ok(fitOf(made).data.length >= 20, `${fitOf(made).data.length} points`);
});

test("Escape while drawing leaves nothing behind", () => {
  const made = hand();
  made.moveTo(100, 100).press().moveTo(200, 150);
  made.input.cancel();
  assert.equal(fitOf(made).data.length, 0);
  assert.equal(made.editor.state.value.fitView.stroke.length, 0);
});

test("a first stroke replaces a sample, the next one is added", () => {
  const made = hand();
  openFitSample(made.editor, "fit-circle");
  assert.equal(fitOf(made).sample, "fit-circle");
  made.drag({ x: 100, y: 100 }, 100, 0);
  assert.equal(fitOf(made).sample, undefined);
  assert.equal(strokesOf(fitOf(made)).length, 1);
});

test("what a sample set goes with it when one's own points take its place; what somebody has set stays", () => {
  const stroke = { places: [[0, 0], [10, 4], [20, 1], [30, 6]] as const };
  for (const bring of [
    (made: Hand) => made.drag({ x: 100, y: 100 }, 100, 0),
    (made: Hand) => bringStrokes(made.editor, { name: "Import", strokes: [stroke] }),
    (made: Hand) => bringStrokes(made.editor, { name: "Import", strokes: [stroke], instead: "all" }),
    (made: Hand) => clearFit(made.editor),
  ]) {
    const made = hand();
    openFitSample(made.editor, "fit-circle");
    assert.equal(fitOf(made).model, "cubic");
    bring(made);
    const { data: _data, starts: _starts, noise: _noise, seed: _seed, ...settings } = fitOf(made);
    const { starts: _none, noise: _quiet, seed: _first, ...usual } = fitDefaults;
    assert.deepEqual(settings, usual);
    openFitSample(made.editor, "fit-circle");
    setModel(made.editor, "linear");
    setSmoothing(made.editor, 71);
    bring(made);
    assert.equal(fitOf(made).model, "linear");
    assert.equal(fitOf(made).smoothing, 71);
  }
});

test("measured points in place of a drawing are not held to that drawing's error", () => {
  const made = hand();
  const places = [[0, 0], [1e-3, 4e-3], [2e-3, 1e-3], [3e-3, 6e-3]] as const;
  bringStrokes(made.editor, { name: "Simplify", strokes: [{ places }], within: 2, instead: "all" });
  assert.equal(fitOf(made).target, "error");
  bringStrokes(made.editor, { name: "Import", strokes: [{ places }], instead: "all" });
  assert.equal(fitOf(made).target, "off");
});

test("points are placed one by one; a double-click begins another stroke", () => {
  const made = hand();
  chooseFitTool(made.editor, "points");
  made.click(10, 10).click(50, 10).click(50, 60).doubleClick(10, 60).click(300, 300);
  assert.deepEqual(strokesOf(fitOf(made)).map(({ from, to }) => to - from), [4, 1]);
});

test("the eraser takes points away along its way, as one entry", () => {
  const made = hand();
  bringStrokes(made.editor, { name: "Import", strokes: [{ places: Array.from({ length: 50 }, (_, i): Pair => [10 * i, 200]) }] });
  chooseFitTool(made.editor, "erase");
  made.editor.patch({ view: { zoom: 1, x: 400, y: 300 } });
  made.drag({ x: 100, y: 200 }, 100, 0);
  const left = fitOf(made).data.length;
  assert.ok(left < 50 && left > 30, `${left} are left`);
  made.run("undo");
  assert.equal(fitOf(made).data.length, 50);
});

test("V is nobody's key in Fit, where it would go on drawing; the hand shows what it does", () => {
  const made = hand();
  chooseFitTool(made.editor, "draw");
  made.run("tool-select");
  assert.equal(made.editor.state.value.tool, "draw");
  made.run("tool-hand").moveTo(100, 100);
  assert.equal(made.editor.state.value.cursor, "grab");
  made.drag({ x: 100, y: 100 }, 50, 50);
  assert.equal(fitOf(made).data.length, 0);
  chooseFitTool(made.editor, "erase");
  made.run("tool-hand").moveTo(100, 100);
  assert.deepEqual([made.editor.state.value.cursor, made.editor.state.value.fitView.brush], ["grab", null]);
});

test("a tool that another finger chooses while one erases is for the next press", () => {
  const made = hand();
  bringStrokes(made.editor, { name: "Import", strokes: [{ places: Array.from({ length: 50 }, (_, i): Pair => [10 * i, 200]) }] });
  chooseFitTool(made.editor, "erase");
  made.editor.patch({ view: { zoom: 1, x: 400, y: 300 } });
  made.moveTo(100, 200).press().moveTo(150, 200);
  chooseFitTool(made.editor, "draw");
  made.release();
  assert.equal(made.editor.fitEdits.inGesture, false);
  made.run("undo");
  assert.equal(fitOf(made).data.length, 50);
});

test("erasing a whole stroke removes it, and what is left keeps its strokes", () => {
  const fit = withStrokes({ ...fitDefaults, data: [] }, [{ places: [[0, 0], [1, 0]] }, { places: [[100, 0], [101, 0], [150, 0]] }]);
  const less = withoutDisc(fit, 0.5, 0, 5);
  assert.deepEqual(strokesOf(less), [{ from: 0, to: 3 }]);
  assert.equal(withoutDisc(fit, 50, 50, 5), fit, "nothing there, nothing changed");
});

test("ends that are near each other are joined, others are not", () => {
  const ring = (part: number): Pair[] => Array.from({ length: 100 }, (_, i) => [Math.cos((part * 2 * Math.PI * i) / 99), Math.sin((part * 2 * Math.PI * i) / 99)]);
  const joined = (data: Pair[], closing: FitDocument["closing"]): boolean => isJoined({ data, closing }, { from: 0, to: data.length });
  assert.equal(joined(ring(0.99), "auto"), true);
  assert.equal(joined(ring(0.9), "auto"), false);
  assert.equal(joined(ring(0.9), "closed"), true);
  assert.equal(joined(ring(1), "open"), false);
  assert.equal(joined([[0, 0], [4, 0], [4, 3], [0, 0]], "auto"), true, "of few points, where they are one");
  assert.equal(joined([[0, 0], [4, 0], [4, 3], [0, 0.01]], "auto"), false);
});

test("the file keeps strokes, settings and a sample's name; version 1 still opens", () => {
  const made = hand();
  openFitSample(made.editor, "fit-signature");
  setNoise(made.editor, 1.5, 9);
  const state = made.editor.getState();
  assert.deepEqual(parseState(writeState(state)).state.fit, state.fit);
  const old = { ...state, version: 1, fit: { data: [[0, 0], [1, 1]], model: "cubic", smoothing: 30, mix: 50 } };
  assert.deepEqual(readState(old).fit, { ...fitDefaults, data: [[0, 0], [1, 1]], model: "cubic", smoothing: 30 });
  assert.throws(() => readState({ ...state, fit: { ...state.fit, starts: [5, 3] } }), /rising/);
  assert.deepEqual(readState({ ...state, fit: undefined }).fit, emptyFit);
});

test("two knots at one place are one mark of both kinds", () => {
  const knots = [{ t: 1, x: 0, y: 0, degree: 1 }, { t: 1, x: 0, y: 0, degree: 3 }, { t: 2, x: 1, y: 0, degree: 3 }];
  assert.deepEqual(shownKnots(0, 10, knots).map(({ type }) => type), ["coincident", "cubic"]);
});

/** A worker that answers when it is told to. */
class Puppet extends EventTarget {
  readonly asked: FitRequest[] = [];
  terminated = false;
  postMessage(request: FitRequest): void {
    this.asked.push(request);
  }
  terminate(): void {
    this.terminated = true;
  }
  answer(data: FitAnswer): void {
    this.dispatchEvent(Object.assign(new Event("message"), { data }));
  }
  get ids(): number[] {
    return this.asked.flatMap((request) => (request.kind === "fit" ? [request.id] : []));
  }
}

const what = (seed: number): FitSubject => ({ strokes: [{ points: Float64Array.of(seed, 0, 1, 1), closed: false }], degree: 3, mix: 0.5, corners: true });
const nothing = { progress: () => undefined, fitted: () => undefined, stopped: () => undefined, failed: () => undefined, chart: () => undefined, restarted: () => undefined };

function client(handlers: Partial<Parameters<typeof createFitClient>[1]> = {}): { client: FitClient; workers: Puppet[] } {
  const workers: Puppet[] = [];
  const start = (): Worker => {
    const puppet = new Puppet();
    workers.push(puppet);
    return puppet as unknown as Worker;
  };
  return { client: createFitClient(start, { ...nothing, ...handlers }), workers };
}

test("the newest request counts: those between are never sent, and an old answer is not taken for a new one", () => {
  const seen: number[] = [];
  const { client: fits, workers } = client({ fitted: (_, __, ms) => seen.push(ms) });
  const subject = what(1);
  for (const smoothing of [0.1, 0.2, 0.3, 0.4]) fits.fit(subject, { by: "smoothing", smoothing }, true);
  const [worker] = workers;
  assert.ok(worker !== undefined);
  assert.equal(worker.ids.length, 1);
  worker.answer({ kind: "fitted", subject: 1, id: worker.ids[0] ?? 0, fits: [], ms: 1 });
  assert.equal(worker.ids.length, 2, "the last of the waiting ones");
  worker.answer({ kind: "fitted", subject: 1, id: worker.ids[0] ?? 0, fits: [], ms: 2 });
  assert.deepEqual(seen, [1]);
  worker.answer({ kind: "fitted", subject: 1, id: worker.ids[1] ?? 0, fits: [], ms: 3 });
  assert.deepEqual(seen, [1, 3]);
  assert.equal(fits.busy, false);
});

test("the data are sent once for all steps of a slider", () => {
  const { client: fits, workers } = client();
  const subject = what(1);
  fits.fit(subject, { by: "smoothing", smoothing: 0.1 }, true);
  workers[0]?.answer({ kind: "fitted", subject: 1, id: 1, fits: [], ms: 1 });
  fits.fit(subject, { by: "smoothing", smoothing: 0.2 }, true);
  assert.equal(workers[0]?.asked.filter(({ kind }) => kind === "subject").length, 1);
});

test("an engine that did not start is started anew with the next request, which says again what is fitted", () => {
  const failures: string[] = [];
  const { client: fits, workers } = client({ failed: (code) => failures.push(code) });
  const subject = what(1);
  fits.fit(subject, { by: "smoothing", smoothing: 0.1 }, true);
  workers[0]?.answer({ kind: "failed", subject: 1, id: 1, code: "E_INIT", message: "no connection" });
  assert.deepEqual([failures, workers[0]?.terminated, fits.busy], [["E_INIT"], true, false]);
  fits.fit(subject, { by: "smoothing", smoothing: 0.1 }, true);
  assert.deepEqual(workers[1]?.asked.map(({ kind }) => kind), ["subject", "fit"]);
});

test("a worker that dies is replaced, and its request tried once more and no oftener", () => {
  const codes: string[] = [];
  let restarts = 0;
  const { client: fits, workers } = client({ failed: (code) => codes.push(code), restarted: () => (restarts += 1) });
  fits.fit(what(1), { by: "smoothing", smoothing: 0.1 }, false);
  const die = (): boolean | undefined => workers.at(-1)?.dispatchEvent(Object.assign(new Event("error"), { message: "unreachable" }));
  die();
  assert.equal(workers.length, 2);
  assert.equal(workers[0]?.terminated, true);
  assert.deepEqual(workers[1]?.ids, [1]);
  die();
  assert.deepEqual(codes, ["E_WORKER"]);
  assert.equal(restarts, 2);
  fits.fit(what(2), { by: "smoothing", smoothing: 0.1 }, false);
  assert.equal(workers.length, 3, "the next request starts afresh");
});

test("a worker whose program did not come is asked for once more, and that nothing came is no engine that stopped", () => {
  const said: string[] = [];
  const { client: fits, workers } = client({ failed: (code) => said.push(code), restarted: () => said.push("restarted") });
  fits.fit(what(1), { by: "smoothing", smoothing: 0.1 }, false);
  for (let i = 0; i < 2; i += 1) workers.at(-1)?.dispatchEvent(new Event("error"));
  assert.deepEqual([said, workers.length], [["E_INIT"], 2]);
});

test("a worker that dies while it fills the chart leaves the fit that is shown", () => {
  const codes: string[] = [];
  const { client: fits, workers } = client({ failed: (code) => codes.push(code) });
  const subject = what(1);
  fits.fit(subject, { by: "smoothing", smoothing: 0.1 }, false);
  workers[0]?.answer({ kind: "fitted", subject: 1, id: 1, fits: [], ms: 1 });
  fits.chart(subject, [0, 5]);
  workers[0]?.dispatchEvent(Object.assign(new Event("error"), { message: "unreachable" }));
  assert.deepEqual(codes, []);
  fits.fit(what(1), { by: "smoothing", smoothing: 0.2 }, false);
  assert.deepEqual(workers[1]?.ids, [2], "the next request starts afresh");
});

/** The runner on an editor, with a client that only remembers what it was asked. */
function running(): { made: Hand; asked: { what: FitSubject; by: string; live: boolean }[] } {
  const made = hand();
  const asked: { what: FitSubject; by: string; live: boolean }[] = [];
  const connect = (): FitClient => ({ busy: false, fit: (subject, { by }, live) => void asked.push({ what: subject, by, live }), chart: () => undefined, cancel: () => undefined, idle: () => Promise.resolve() });
  createFitRunner(made.editor, connect, () => made.time, new AbortController().signal);
  return { made, asked };
}

test("a drag of the slider asks for live fits, and its end for one from nothing", () => {
  const { made, asked } = running();
  openFitSample(made.editor, "fit-circle");
  made.editor.fitEdits.begin("Smoothing");
  for (const value of [41, 42, 43]) setSmoothing(made.editor, value);
  made.editor.fitEdits.commit();
  assert.deepEqual(asked.map(({ live }) => live), [false, true, true, true, false]);
  assert.equal(new Set(asked.map(({ what: subject }) => subject)).size, 1, "the subject stays the same");
});

test("too few points are said, not fitted", () => {
  const { made, asked } = running();
  chooseFitTool(made.editor, "points");
  made.click(10, 10).click(50, 10).click(50, 60);
  assert.equal(asked.length, 0);
  assert.deepEqual(made.editor.state.value.fitRun.failure, { id: "points-few", details: { count: 3 } });
  made.click(10, 60);
  assert.equal(asked.length, 1);
  assert.equal(made.editor.state.value.fitRun.failure, null);
});

test("all points can be erased in one drag, and that there are too few is said once it ends", () => {
  const { made, asked } = running();
  openFitSample(made.editor, "fit-circle");
  const [x, y] = fitOf(made).data[0] ?? assert.fail("the sample has points");
  made.editor.fitEdits.begin("Erase");
  eraseAt(made.editor, x, y, 1);
  eraseAt(made.editor, x, y, 1e5);
  made.editor.fitEdits.commit();
  assert.equal(fitOf(made).data.length, 0);
  assert.equal(asked.at(-1)?.live, true, "only what was left on the way was fitted");
  made.run("undo");
  assert.equal(asked.at(-1)?.live, false);
});

test("a target is asked for by its own name, and moving the slider lets go of it", () => {
  const { made, asked } = running();
  openFitSample(made.editor, "fit-circle");
  setTarget(made.editor, "error");
  assert.equal(asked.at(-1)?.by, "error");
  setSmoothing(made.editor, 70);
  assert.equal(fitOf(made).target, "off");
  assert.equal(asked.at(-1)?.by, "smoothing");
});

test("corners that are not to be kept are none: what smooth pieces alone make", () => {
  const fit = { ...fitDefaults, data: [[0, 0], [9, 0], [9, 9], [0, 9]] } satisfies FitDocument;
  const degree = (change: Partial<FitDocument>): unknown => subjectOf({ ...fit, ...change }, false)?.degree;
  assert.deepEqual(degree({}), [1, 3]);
  assert.equal(degree({ corners: false }), 3);
  assert.deepEqual(degree({ corners: false, target: "error" }), [1, 3], "there the fit itself leaves them out");
  assert.equal(degree({ model: "linear", corners: false }), 1);
  assert.equal(sameSubject({ ...fit, corners: false }, { ...fit, corners: false, target: "error" }), false);
});

test("too few points are counted within a stroke", () => {
  const fit = { ...fitDefaults, data: [[0, 0], [1, 0], [2, 0], [5, 5]], starts: [3] } satisfies FitDocument;
  assert.equal(subjectOf(fit, false), null);
  assert.equal(mostDifferent(fit), 3);
});

test("a fit that is stopped leaves the curve before, and the settings that it was made with", async () => {
  const made = hand();
  const { editor } = made;
  const workers: Puppet[] = [];
  const start = (): Worker => {
    workers.push(new Puppet());
    return workers.at(-1) as unknown as Worker;
  };
  const runner = createFitRunner(editor, (handlers) => createFitClient(start, handlers), () => 0, new AbortController().signal);
  const data = [[0, 0], [9, 0], [9, 9], [0, 9]] as const;
  editor.fitEdits.amend(() => ({ fit: { ...fitDefaults, data } }));
  const [worker] = workers;
  assert.ok(worker !== undefined);
  worker.answer({ kind: "fitted", subject: 1, id: 1, fits: [], ms: 1 });
  setTarget(editor, "knots");
  setTargetValue(editor, 300.7);
  assert.equal(editor.state.value.fit.targetKnots, 300, "at most");
  const said: string[] = [];
  editor.notices.subscribe((notice) => notice?.kind === "toast" && said.push(notice.text));
  worker.answer({ kind: "progress", subject: 1, id: worker.ids.at(-1) ?? 0, value: 0.25 });
  runner.cancel();
  worker.answer({ kind: "stopped", subject: 1, id: worker.ids.at(-1) ?? 0 });
  await runner.idle();
  assert.deepEqual([said, editor.state.value.fit.target, editor.state.value.fitRun.since], [["Cancelled"], "off", null]);
  assert.deepEqual([worker.ids.length, worker.asked.at(-1)?.kind], [2, "chart"], "nothing is fitted anew, and the chart goes on");
});

/** The runner on four points, with the workers that it started. */
function onPuppets(): { editor: Hand["editor"]; runner: FitRunner; worker: Puppet } {
  const { editor } = hand();
  const worker = new Puppet();
  const runner = createFitRunner(editor, (handlers) => createFitClient(() => worker as unknown as Worker, handlers), () => 7, new AbortController().signal);
  editor.fitEdits.amend(() => ({ fit: { ...fitDefaults, data: [[0, 0], [9, 0], [9, 9], [0, 9]] } }));
  return { editor, runner, worker };
}

test("where another fit has begun when one comes, the page goes on saying that it works", () => {
  const { editor, worker } = onPuppets();
  setSmoothing(editor, 60);
  worker.answer({ kind: "fitted", subject: 1, id: 1, fits: [], ms: 1 });
  assert.deepEqual([worker.ids, editor.state.value.fitRun.since], [[1, 2], 7]);
  assert.ok(worker.asked.every(({ kind }) => kind !== "chart"), "the chart waits");
  worker.answer({ kind: "fitted", subject: 1, id: 2, fits: [], ms: 1 });
  assert.deepEqual([editor.state.value.fitRun.since, worker.asked.at(-1)?.kind], [null, "chart"]);
});

test("a fit that came after the next was asked for has its own settings again when that one is stopped", () => {
  const { editor, runner, worker } = onPuppets();
  const before = editor.state.value.fit.smoothing;
  setSmoothing(editor, before + 20);
  worker.answer({ kind: "fitted", subject: 1, id: 1, fits: [], ms: 1 });
  runner.cancel();
  worker.answer({ kind: "stopped", subject: 1, id: 2 });
  assert.equal(editor.state.value.fit.smoothing, before);
});

test("where a target has led, the slider shows once, however far the chart is filled and whether or not its errors fall throughout", () => {
  const rising = (at: number): number => (at - 55) / 5;
  for (const [rms, expected, errors] of [
    [3, 70, rising],
    [3, 47.5, (at: number) => (at === 45 ? 2.5 : at === 50 ? 3.5 : at > 50 ? 9 : at === 30 ? 8 : 1)], // What zigzags below is no matter.
    [20, 100, rising], [0.01, 0, (at: number) => 1 + at],
  ] as const) {
    const { editor } = onPuppets();
    setTarget(editor, "error");
    const outcome = { rms, smoothing: null, knots: [] } as unknown as FitOutcome;
    editor.patch({ fitRun: { ...editor.state.value.fitRun, outcome, chart: [] } });
    const shown = [editor.state.value.fit.smoothing];
    for (let at = 100; at >= 0; at -= 5) {
      showChartPoint(editor, { smoothing: at, knots: 3, rms: errors(at) });
      const { smoothing } = editor.state.value.fit;
      if (smoothing !== shown.at(-1)) shown.push(smoothing);
    }
    assert.deepEqual(shown.slice(1), [expected], `an error of ${rms}`);
  }
});

test("the chart is that of the curve that is shown, not of one that was stopped", () => {
  const { editor, runner, worker } = onPuppets();
  worker.answer({ kind: "fitted", subject: 1, id: 1, fits: [], ms: 1 });
  setModel(editor, "linear");
  runner.cancel();
  worker.answer({ kind: "stopped", subject: 2, id: 2 });
  const told = worker.asked.filter(({ kind }) => kind === "subject" || kind === "chart");
  const [last, chart] = [told.at(-2), told.at(-1)];
  assert.ok(last?.kind === "subject" && chart?.kind === "chart");
  assert.deepEqual([editor.state.value.fit.model, last.what.degree, chart.subject], ["hybrid", [1, 3], last.subject]);
  worker.answer({ kind: "chart", subject: 2, smoothing: 50, knots: 3, rms: 1 });
  assert.deepEqual(editor.state.value.fitRun.chart, [], "what is still said of the other is not heard");
});

test("a fit that comes in spite of being stopped ends the waiting, and the settings are its own", () => {
  const { editor, runner, worker } = onPuppets();
  const before = editor.state.value.fit;
  setSmoothing(editor, before.smoothing + 20);
  runner.cancel();
  worker.answer({ kind: "fitted", subject: 1, id: 1, fits: [], ms: 1 });
  assert.deepEqual([editor.state.value.fitRun.since, editor.state.value.fit], [null, before]);
  setSmoothing(editor, before.smoothing + 10);
  setModel(editor, "linear");
  runner.cancel();
  worker.answer({ kind: "fitted", subject: 1, id: 3, fits: [], ms: 1 });
  assert.deepEqual([editor.state.value.fitRun.since, editor.state.value.fit], [null, before], "also where it is of other settings than those that were stopped");
});

test("that an outdated fit failed is not said while the next one is under way", () => {
  const { editor, worker } = onPuppets();
  setSmoothing(editor, 60);
  worker.answer({ kind: "failed", subject: 1, id: 1, code: "E_MEMORY", message: "" });
  const { failure, since } = editor.state.value.fitRun;
  assert.deepEqual([failure, since, worker.ids], [null, 7, [1, 2]]);
});

test("an engine that failed is asked again when somebody comes back to the mode or says so, and not with every change", () => {
  const { editor, runner, worker } = onPuppets();
  worker.answer({ kind: "failed", subject: 1, id: 1, code: "E_INIT", message: "no connection" });
  editor.patch({ hint: "" });
  editor.patch({ mode: "curve" });
  assert.deepEqual([worker.ids, editor.state.value.fitRun.failure?.details.code], [[1], "E_INIT"]);
  editor.patch({ mode: "fit" });
  assert.deepEqual([worker.ids, editor.state.value.fitRun.failure], [[1, 2], null]);
  worker.answer({ kind: "failed", subject: 1, id: 2, code: "E_MEMORY", message: "" });
  runner.again();
  worker.answer({ kind: "fitted", subject: 1, id: 3, fits: [], ms: 1 });
  editor.patch({ mode: "curve" });
  editor.patch({ mode: "fit" });
  assert.deepEqual(worker.ids, [1, 2, 3], "what is there is not fitted again");
});

test("the parts of a curve are asked for when they are to be seen, and only where there are two", () => {
  const made = hand();
  const { editor } = made;
  const puppet = new Puppet();
  createFitRunner(editor, (handlers) => createFitClient(() => puppet as unknown as Worker, handlers), () => 0, new AbortController().signal);
  const data = [[0, 0], [9, 0], [9, 9], [0, 9]] as const;
  const parts = (): unknown[] => puppet.asked.flatMap((request) => (request.kind === "subject" ? [request.what.parts] : []));
  editor.fitEdits.amend(() => ({ fit: { ...fitDefaults, data } }));
  puppet.answer({ kind: "fitted", subject: 1, id: 1, fits: [], ms: 1 });
  toggleFitOverlay(editor, "heat");
  assert.deepEqual(parts(), [false]);
  toggleFitOverlay(editor, "parts");
  assert.deepEqual(parts(), [false, true]);
  puppet.answer({ kind: "fitted", subject: 2, id: 2, fits: [], ms: 1 });
  setModel(editor, "cubic");
  assert.deepEqual(parts(), [false, true, false]);
});

test("a link from an emptied Fit opens as empty, and one from a Fit that nobody has opened with its first sample", async () => {
  const made = hand();
  made.drag({ x: 100, y: 100 }, 200, 50);
  setSmoothing(made.editor, 12);
  clearFit(made.editor);
  const emptied = made.editor.getState();
  assert.deepEqual((await readShareHash(await shareHash(emptied))).fit, fitOf(made));
  assert.deepEqual((await readShareHash(await shareHash({ ...emptied, fit: emptyFit }))).fit, emptyFit);
});
