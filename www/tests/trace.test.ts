import assert from "node:assert/strict";
import { test } from "node:test";
import { parseState, readState, writeState } from "../src/document/file/file.ts";
import { traceSample, traceSamples } from "../src/document/trace/trace-samples.ts";
import { emptyTrace, toleranceOf, traceDefaults } from "../src/document/trace/trace.ts";
import { smoothInFit, tracedDrawing } from "../src/editor/trace/hand-over.ts";
import { drawingOf, openPicture, openTraceSample, setTrace, shownOf } from "../src/editor/trace/trace-edits.ts";
import { behindText, traceHint, traceSummary } from "../src/editor/trace/trace-hint.ts";
import { registerTraceActions } from "../src/editor/trace/trace-actions.ts";
import { howOf } from "../src/editor/trace/trace-question.ts";
import { createTraceRunner, type TraceRunner } from "../src/editor/trace/trace-runner.ts";
import { readShareHash, shareHash } from "../src/io/link/share.ts";
import type { PictureSource, TraceAnswer, TraceHow, TraceRequest, TraceResult } from "../src/kernel/trace/job.ts";
import { cornersIn, outcomeOf, type ShownPicture } from "../src/kernel/trace/outcome.ts";
import { keepPicture } from "../src/kernel/trace/pictures.ts";
import { createTraceClient, type Clock, type TraceClient, type TraceHandlers } from "../src/kernel/trace/trace-client.ts";
import { openPicture as bringPicture } from "../src/panels/files/open-picture.ts";
import { traceProgram } from "../src/panels/trace/trace-program.ts";
import { drawnDiffers } from "../src/render/drawn.ts";
import { createTraceTool } from "../src/tools/trace/trace-tool.ts";
import { contoursOfPath, Hand } from "./harness.ts";

/** A clock that goes when it is told to. */
class Waiting implements Clock {
  tasks: { at: number; task: () => void }[] = [];
  time = 0;
  after(ms: number, task: () => void): () => void {
    const entry = { at: this.time + ms, task };
    this.tasks.push(entry);
    return () => { this.tasks = this.tasks.filter((each) => each !== entry); };
  }
  pass(ms: number): void {
    this.time += ms;
    const due = this.tasks.filter(({ at }) => at <= this.time);
    this.tasks = this.tasks.filter(({ at }) => at > this.time);
    for (const { task } of due) task();
  }
}

/** A worker that does nothing but remember, and says what it is told to say. */
class Puppet extends EventTarget {
  readonly asked: TraceRequest[] = [];
  terminated = false;
  postMessage(request: TraceRequest): void {
    this.asked.push(request);
  }
  terminate(): void {
    this.terminated = true;
  }
  answer(answer: TraceAnswer): void {
    this.dispatchEvent(new MessageEvent("message", { data: answer }));
  }
}

const disc: PictureSource = { kind: "sample", key: "sample:trace-disc", id: "trace-disc" };
const how: TraceHow = howOf(emptyTrace);

/** A square of straight sides, and a triangle that is a hole in it. */
function found(): TraceResult {
  const [square, triangle] = contoursOfPath("M10 10L110 10L110 110L10 110ZM40 40L40 80L80 80Z", "trigonometric");
  assert.ok(square !== undefined && triangle !== undefined);
  const metrics = { rmse: 0.1, mae: 0.08, max: 0.3, hausdorff: 0.6, jaccard: 0.99 };
  return {
    outlines: [
      { contour: square, hole: false, layer: 0, length: 400, metrics, cubics: new Float64Array(0) },
      { contour: triangle, hole: true, layer: 0, length: 136, metrics: { ...metrics, max: 0.5 }, cubics: new Float64Array(0) },
    ],
    colors: [], segments: { lines: 7, arcs: 0, curves: 0 }, iou: 0.99, beyond: null,
    sizes: { raw: 40, gzip: 50, polygonRaw: 40, polygonGzip: 50 }, stages: { contours: 3 },
  };
}

const deaf: TraceHandlers = { progress: () => undefined, picture: () => undefined, traced: () => undefined, photo: () => undefined, failed: () => undefined, restarted: () => undefined };

function client(handlers: Partial<TraceHandlers> = {}): { traces: TraceClient; workers: Puppet[]; clock: Waiting } {
  const workers: Puppet[] = [];
  const clock = new Waiting();
  const start = (): Worker => {
    const puppet = new Puppet();
    workers.push(puppet);
    return puppet as unknown as Worker;
  };
  return { traces: createTraceClient(start, { ...deaf, ...handlers }, clock), workers, clock };
}

const ids = ({ asked }: Puppet): number[] => asked.flatMap((request) => (request.kind === "trace" ? [request.id] : []));

test("the newest request counts: an older result never replaces a newer one", () => {
  const seen: number[] = [];
  const { traces, workers } = client({ traced: (_, ms) => seen.push(ms) });
  traces.trace(disc, how);
  traces.trace(disc, { ...how, tolerance: 1 });
  const [worker] = workers;
  assert.ok(worker !== undefined);
  const [first = 0, second = 0] = ids(worker);
  worker.answer({ kind: "traced", id: first, result: found(), ms: 1 });
  assert.deepEqual(seen, []);
  assert.equal(traces.busy, true);
  worker.answer({ kind: "traced", id: second, result: found(), ms: 2 });
  assert.deepEqual(seen, [2]);
  assert.equal(traces.busy, false);
});

test("a worker that does not stop gives way to a new one, which goes on with what is wanted", () => {
  const { traces, workers, clock } = client();
  traces.trace(disc, how);
  traces.trace(disc, { ...how, size: 512 });
  clock.pass(1000);
  assert.equal(workers[0]?.terminated, true);
  assert.deepEqual(workers[1]?.asked.map((request) => request.kind === "trace" && request.how.size), [512]);
});

test("a worker that stops in time is kept, and Cancel leaves nothing under way", () => {
  const { traces, workers, clock } = client();
  traces.trace(disc, how);
  assert.equal(traces.cancel(), true);
  assert.equal(traces.busy, false);
  workers[0]?.answer({ kind: "stopped", id: ids(workers[0])[0] ?? 0 });
  clock.pass(1000);
  assert.equal(workers[0]?.terminated, false);
  assert.equal(traces.cancel(), false);
});

test("a worker that dies is replaced, its request tried once more and no oftener", () => {
  const codes: string[] = [];
  const { traces, workers } = client({ failed: (code) => codes.push(code) });
  traces.trace(disc, how);
  const die = (): boolean | undefined => workers.at(-1)?.dispatchEvent(Object.assign(new Event("error"), { message: "unreachable" }));
  die();
  assert.equal(workers.length, 2);
  assert.deepEqual(ids(workers[1] ?? new Puppet()), [1]);
  die();
  assert.deepEqual(codes, ["E_WORKER"]);
  assert.equal(traces.busy, false);
});

test("a worker whose program did not come is asked for once more, and that nothing came is no engine that stopped", async () => {
  const said: string[] = [];
  const { traces, workers } = client({ failed: (code) => said.push(code), restarted: () => said.push("restarted") });
  traces.trace(disc, how);
  const refused = assert.rejects(traces.probe(disc), { code: "E_INIT" });
  for (let i = 0; i < 2; i += 1) workers.at(-1)?.dispatchEvent(new Event("error"));
  await refused;
  assert.deepEqual([said, workers.length], [["E_INIT"], 2]);
});

test("a picture that its worker dies of is refused, and the worker replaced no oftener than once for it", async () => {
  const { traces, workers } = client();
  const refused = assert.rejects(traces.probe(disc), { code: "E_WORKER" });
  const die = (): boolean | undefined => workers.at(-1)?.dispatchEvent(Object.assign(new Event("error"), { message: "unreachable" }));
  die();
  assert.equal(workers.length, 2);
  die();
  await refused;
  await traces.idle();
  assert.equal(workers.length, 2, "nobody is left to work for");
});

test("looking at a picture disturbs no trace, and is answered with its size or with what is wrong", async () => {
  const { traces, workers } = client();
  traces.trace(disc, how);
  const good = traces.probe(disc);
  const bad = traces.probe(disc);
  const worker = workers[0];
  assert.ok(worker !== undefined);
  const [first, second] = worker.asked.flatMap((request) => (request.kind === "probe" ? [request.id] : []));
  worker.answer({ kind: "probed", id: first ?? 0, width: 3, height: 4 });
  worker.answer({ kind: "failed", id: second ?? 0, code: "E_IMAGE", message: "" });
  assert.deepEqual(await good, [3, 4]);
  await assert.rejects(bad, { code: "E_IMAGE" });
  assert.equal(traces.busy, true);
});

interface Asked {
  readonly picture: PictureSource;
  readonly how: TraceHow;
}

/** Trace on an editor, with a client that only remembers what it was asked. */
function tracing(): { hand: Hand; asked: Asked[]; clock: Waiting; runner: TraceRunner; handlers: TraceHandlers; refused: string[]; say(result?: TraceResult): void } {
  const hand = new Hand();
  const asked: Asked[] = [];
  const clock = new Waiting();
  const refused: string[] = [];
  let handlers = deaf;
  let busy = false;
  const runner = createTraceRunner({
    editor: hand.editor, clock, now: () => clock.time, until: new AbortController().signal,
    refuse: (name, code) => refused.push(`${name} ${code}`),
    connect(given) {
      handlers = given;
      return {
        get busy() {
          return busy;
        },
        trace(picture, wanted) {
          busy = true;
          asked.push({ picture, how: wanted });
        },
        cancel() {
          const was = busy;
          busy = false;
          return was;
        },
        async probe({ key }) {
          if (key === "bad") throw new Error("no picture");
          if (key === "large") await new Promise((resolve) => setTimeout(resolve, 5));
          return [640, 480];
        },
        idle: () => Promise.resolve(),
      };
    },
  });
  registerTraceActions(hand.editor, runner);
  hand.editor.modes.set("trace", { label: "", tool: createTraceTool(hand.editor) });
  return {
    hand, asked, clock, runner, handlers, refused,
    say(result = found()) {
      busy = false;
      handlers.traced(result, 12);
    },
  };
}

/** A picture is brought in, and looked at from then on. */
function bring({ editor }: Hand, name: string, key: string): void {
  editor.patch({ incoming: { name, source: { kind: "file", key, content: new Blob() }, instead: editor.state.value.trace } });
}

test("a sample is traced at once with its own settings, a slider when it has come to rest", () => {
  const { hand, asked, clock, say } = tracing();
  assert.equal(openTraceSample(hand.editor, "trace-sketch"), true);
  assert.deepEqual(asked.map(({ picture }) => picture.key), ["sample:trace-sketch"]);
  assert.equal(asked[0]?.how.speckle, traceSample("trace-sketch")?.settings.speckle);
  say();
  hand.editor.traceEdits.begin("Detail");
  for (const detail of [40, 50, 60]) {
    setTrace(hand.editor, "Detail", { detail });
    clock.pass(100);
  }
  assert.equal(asked.length, 1);
  clock.pass(60);
  hand.editor.traceEdits.commit();
  assert.equal(asked.length, 2);
  assert.equal(asked[1]?.how.tolerance, toleranceOf(60));
  assert.equal(hand.editor.state.value.undoName, "Detail");
  hand.editor.undo();
  clock.pass(200);
  assert.equal(asked[2]?.how.tolerance, asked[0]?.how.tolerance, "one step of the history for the whole drag");
});

test("a name that is no sample's is said, and the first one shown in its place", () => {
  const { hand, asked } = tracing();
  hand.editor.patch({ mode: "trace" });
  hand.editor.traceEdits.dispatch("Open sample", () => ({ trace: { ...emptyTrace, sample: "trace-none" } }));
  assert.equal(hand.editor.state.value.trace.sample, traceSamples[0]?.id);
  assert.equal(hand.editor.notices.value?.kind, "toast");
  assert.equal(asked.length, 1);
});

test("Cancel keeps the outlines that were there, says so, and Trace asks again", () => {
  const { hand, asked, runner, clock, say } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  say();
  const { outcome } = hand.editor.state.value.traceRun;
  setTrace(hand.editor, "Work size", { size: 2048 });
  clock.pass(200);
  assert.notEqual(hand.editor.state.value.traceRun.since, null);
  runner.cancel();
  const { traceRun } = hand.editor.state.value;
  assert.equal(traceRun.outcome, outcome);
  assert.equal(traceRun.since, null);
  assert.deepEqual(hand.editor.notices.value, { kind: "toast", text: "Cancelled" });
  runner.again();
  assert.equal(asked.length, 3);
  assert.deepEqual(asked[2]?.how, asked[1]?.how);
});

test("outlines whose settings were changed by a cancelled trace are said to be of those before, and go to Fit as exact as they were made", () => {
  const { hand, runner, clock, say } = tracing();
  const { editor } = hand;
  openTraceSample(editor, "trace-disc");
  say();
  runner.cancel();
  assert.equal(editor.state.value.traceRun.behind, false, "nothing was under way, nothing has changed");
  runner.again();
  runner.cancel();
  assert.equal(editor.state.value.traceRun.behind, false, "the same once more");
  const before = editor.state.value.trace.settings.detail;
  setTrace(editor, "Detail", { detail: 90 });
  clock.pass(200);
  assert.equal(editor.state.value.traceRun.behind, false, "not while the new ones are on their way");
  runner.cancel();
  assert.equal(traceHint(editor.state.value), behindText);
  assert.ok(traceSummary(editor.state.value).includes(behindText));
  smoothInFit(editor);
  assert.equal(editor.state.value.fit.targetError, Number((2 * toleranceOf(before)).toPrecision(2)));
  editor.patch({ mode: "trace" });
  runner.again();
  say();
  assert.equal(editor.state.value.traceRun.behind, false);
  assert.notEqual(traceHint(editor.state.value), behindText);
  setTrace(editor, "Detail", { detail: 70 });
  clock.pass(200);
  runner.cancel();
  editor.undo();
  clock.pass(200);
  assert.equal(editor.state.value.traceRun.behind, false, "what is undone is asked for anew");
});

test("a photograph is refused, and traced when somebody wants it all the same", () => {
  const { hand, asked, clock, handlers } = tracing();
  openPicture(hand.editor, { name: "cat.jpg", width: 640, height: 480, key: keepPicture(new Blob()) });
  hand.editor.patch({ mode: "trace" });
  handlers.photo(4321, 60);
  assert.deepEqual(hand.editor.state.value.traceRun.failure, { id: "trace-photo", count: 4321, speckle: 60 });
  const most = asked[0]?.how.mostContours ?? 0;
  assert.equal(most, 1500);
  hand.run("trace-anyway");
  clock.pass(200);
  assert.ok((asked[1]?.how.mostContours ?? 0) > 4321);
});

test("progress changes nothing that a stage draws, and is over with the job", () => {
  const { hand, handlers, say } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  say();
  hand.run("trace-run");
  const before = hand.editor.state.value;
  handlers.progress("splines", 0.5, 3, 6);
  const now = hand.editor.state.value;
  assert.deepEqual({ ...now, traceProgress: null }, { ...before, traceProgress: null });
  assert.equal(now.traceRun, before.traceRun);
  assert.equal(now.traceProgress?.value, 0.5);
  assert.equal(drawnDiffers(now, before), false);
  say();
  assert.equal(hand.editor.state.value.traceProgress, null);
  assert.equal(drawnDiffers(hand.editor.state.value, now), true);
});

test("a picture without edges is said to have none", () => {
  const { hand, say } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  say({ ...found(), outlines: [] });
  assert.equal(hand.editor.state.value.traceRun.failure?.id, "trace-none");
});

test("of two pictures the one that was brought in last stays, though the other one is looked at longer", async () => {
  const { hand } = tracing();
  for (const [name, key] of [["large.png", "large"], ["small.png", "small"]] as const) {
    bring(hand, name, key);
  }
  await new Promise((resolve) => setTimeout(resolve, 20));
  assert.equal(hand.editor.state.value.trace.picture?.name, "small.png");
});

test("a sample that is opened while a picture is being looked at stays; a slider that is moved meanwhile keeps no picture out", async () => {
  const { hand } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  bring(hand, "large.png", "large");
  openTraceSample(hand.editor, "trace-star");
  await new Promise((resolve) => setTimeout(resolve, 20));
  assert.deepEqual([hand.editor.state.value.trace.sample, hand.editor.state.value.undoName], ["trace-star", `Open ${traceSample("trace-star")?.title ?? ""}`]);
  bring(hand, "large.png", "large");
  setTrace(hand.editor, "Detail", { detail: 60 });
  await new Promise((resolve) => setTimeout(resolve, 20));
  assert.equal(hand.editor.state.value.trace.picture?.name, "large.png");
});

test("an engine that failed is asked again when somebody comes back to the mode, and not with every change", () => {
  const { hand, asked, handlers } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  handlers.failed("E_INIT", "no connection");
  hand.editor.patch({ hint: "" });
  hand.editor.patch({ mode: "curve" });
  assert.equal(asked.length, 1);
  hand.editor.patch({ mode: "trace" });
  assert.equal(asked.length, 2);
  handlers.traced(found(), 12);
  hand.editor.patch({ mode: "curve" });
  hand.editor.patch({ mode: "trace" });
  assert.equal(asked.length, 2, "what is there is not traced again");
});

test("the views of a picture that nobody waits for any more give their pixels back", () => {
  let closed = 0;
  const bitmap = { close: () => (closed += 1) } as unknown as ImageBitmap;
  const { traces, workers } = client();
  traces.trace(disc, how);
  traces.trace(disc, how);
  const answer = (id: number): TraceAnswer => ({ kind: "picture", id, width: 1, height: 1, analysed: [1, 1], source: bitmap, edges: bitmap, threshold: 0, colored: false });
  const [first = 0, second = 0] = (workers[0]?.asked ?? []).flatMap((request) => (request.kind === "trace" ? [request.id] : []));
  workers[0]?.answer(answer(second));
  assert.equal(closed, 0);
  workers[0]?.answer(answer(first));
  assert.equal(closed, 2);
});

test("an error about a picture goes when the next one is brought, and what is said while that is on its way stays", async () => {
  const { hand } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  const seen: (string | undefined)[] = [];
  hand.editor.notices.subscribe((notice) => seen.push(notice?.kind));
  hand.editor.notify({ kind: "error", id: "image-broken", text: "trunc.png could not be decoded. The previous picture is kept." });
  const coming = bringPicture(hand, "logo.png", new Blob());
  hand.editor.notify({ kind: "error", id: "files-left", text: "1 file was not opened." });
  await coming;
  await new Promise((resolve) => setTimeout(resolve));
  assert.equal(hand.editor.state.value.trace.picture?.name, "logo.png");
  assert.deepEqual(seen, ["error", "well", "error", "announce"]);
});

test("of two pictures that are brought at a time the later is opened, and the earlier, which is none, is not said to have been kept from it", async () => {
  const { hand, refused } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  bring(hand, "note.png", "bad");
  bring(hand, "logo.png", keepPicture(new Blob()));
  await new Promise((resolve) => setTimeout(resolve));
  assert.equal(hand.editor.state.value.trace.picture?.name, "logo.png");
  assert.deepEqual(refused, []);
});

test("a file that is no picture leaves what is there, and one that is starts at once", async () => {
  const { hand, asked, refused, runner, say } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  say();
  const before = hand.editor.state.value.trace;
  bring(hand, "note.png", "bad");
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(refused, ["note.png "]);
  assert.equal(hand.editor.state.value.trace, before);
  bring(hand, "logo.png", keepPicture(new Blob()));
  await new Promise((resolve) => setTimeout(resolve));
  assert.equal(hand.editor.state.value.trace.picture?.name, "logo.png");
  assert.equal(asked.length, 2);
  say();
  await runner.idle();
});

test("a double-click makes a corner smooth, another makes it what it was to the last bit, and the tracer is not asked", () => {
  const { hand, asked, clock, say } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  say();
  const before = drawingOf(hand.editor.state.value);
  assert.equal(cornersIn(before ?? assert.fail("there are outlines")).length, 7);
  hand.doubleClick(110, 10);
  const after = drawingOf(hand.editor.state.value);
  assert.ok(after !== null);
  assert.equal(cornersIn(after).length, 6);
  const smooth = after.contours[0]?.points.find(({ x, y }) => x === 110 && y === 10);
  assert.equal(smooth?.kind, "smooth");
  assert.equal(hand.editor.state.value.undoName, "Smooth corner");
  hand.doubleClick(110, 10);
  assert.deepEqual(drawingOf(hand.editor.state.value), before);
  clock.pass(500);
  assert.equal(asked.length, 1);
});

test("the numbers beside a corner that was smoothed are of what is shown: its segments are counted anew, and what only the tracer knows is left out", () => {
  const { hand, say } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  say();
  const before = shownOf(hand.editor.state.value);
  hand.doubleClick(110, 10);
  const shown = shownOf(hand.editor.state.value);
  assert.equal(shown?.drawing.contours[1], before?.drawing.contours[1], "the other outline stays the same object");
  assert.deepEqual(shown?.segments, { lines: 5, arcs: 0, curves: 2 });
  assert.deepEqual([shown.rms, shown.max, shown.beyond, shown.iou, shown.sizes], [null, null, null, null, null]);
  assert.ok(!traceSummary(hand.editor.state.value).includes("No place is farther"));
  hand.doubleClick(110, 10);
  assert.equal(shownOf(hand.editor.state.value), before);
});

test("the program beside flat colours says nothing of ink, which the panel hides then", () => {
  const { hand } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  setTrace(hand.editor, "Ink", { mode: "edges", threshold: 100, invert: true });
  const ofInk = /source: "edges"|threshold: 100|invert: true/gu;
  assert.equal(traceProgram(hand.editor.state.value).match(ofInk)?.length, 3);
  setTrace(hand.editor, "Flat colours", { colors: 4 });
  const program = traceProgram(hand.editor.state.value);
  assert.equal(program.match(ofInk), null, program);
  assert.match(program, /colors: 4/u);
});

test("beside flat colours, which no threshold parts, the view of edges speaks of steep places", () => {
  const { hand } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  const picture = { key: "sample:trace-disc", name: "Disc", width: 512, height: 512, analysed: [512, 512], threshold: 99, colored: false } as const;
  const { traceRun, traceView } = hand.editor.state.value;
  hand.editor.patch({ hint: "", traceRun: { ...traceRun, picture: picture as unknown as ShownPicture }, traceView: { ...traceView, view: "edges" } });
  assert.match(traceHint(hand.editor.state.value), /99 of 255/u);
  setTrace(hand.editor, "Flat colours", { colors: 4 });
  assert.equal(traceHint(hand.editor.state.value), "Bright means a strong edge.");
});

test("a drag moves the paper and nothing else", () => {
  const { hand, say } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  say();
  const { view, trace } = hand.editor.state.value;
  hand.drag({ x: 60, y: 60 }, 30, 20);
  const after = hand.editor.state.value;
  assert.equal(after.trace, trace);
  assert.ok(after.view.x < view.x && after.view.y < view.y);
});

test("keys step from point to point, toggle a corner and take it back", () => {
  const { hand, say } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  say();
  hand.run("trace-next").run("trace-next");
  assert.deepEqual(hand.editor.state.value.traceView.chosen, { contour: 0, index: 1 });
  hand.run("trace-corner");
  assert.equal(hand.editor.state.value.trace.corners.length, 1);
  hand.run("undo");
  assert.equal(hand.editor.state.value.trace.corners.length, 0);
});

test("Smooth in Fit hands over every outline with its corners, Edit in Curve every point, and Trace keeps its own", () => {
  const { hand, say } = tracing();
  openTraceSample(hand.editor, "trace-disc");
  say();
  hand.run("trace-smooth-in-fit");
  const { fit, mode } = hand.editor.state.value;
  assert.equal(mode, "fit");
  assert.equal(fit.starts.length, 1);
  for (const [x, y] of [[10, 10], [110, 110], [40, 80]] as const) assert.ok(fit.data.some((point) => Math.hypot(point[0] - x, point[1] - y) < 1e-9), `${x}, ${y}`);
  hand.editor.patch({ mode: "trace" });
  hand.run("trace-edit");
  assert.equal(hand.editor.state.value.mode, "curve");
  assert.deepEqual(hand.curve.contours.map(({ points }) => points.length), [4, 3]);
  assert.equal(hand.editor.state.value.traceRun.outcome?.holes.length, 2);
});

test("the errors of all outlines are one number: the root mean square by length, and the largest", () => {
  const { rms, max } = outcomeOf(found(), undefined);
  assert.ok(Math.abs((rms ?? 0) - 0.1) < 1e-12);
  assert.equal(max, 0.5);
});

test("a trace survives a file and a link: the sample by its name, a picture of one's own by its outlines", async () => {
  const { hand } = tracing();
  const state = hand.editor.getState();
  const settings = { ...traceDefaults, detail: 70, threshold: 99, invert: true } as const;
  const corners = [{ x: 1.5, y: 2, kind: "cusp" }] as const;
  const sample = { ...state, trace: { sample: "trace-star", settings, corners } };
  assert.deepEqual(parseState(writeState(sample)).state.trace, sample.trace);
  assert.deepEqual((await readShareHash(await shareHash(sample))).trace, sample.trace);
  const kept = { ...state, trace: { settings, corners: [], kept: { name: "logo.png", width: 10, height: 20, contours: outcomeOf(found(), undefined).drawing.contours } } };
  assert.deepEqual((await readShareHash(await shareHash(kept))).trace, kept.trace);
});

test("outlines that came without their picture are shown, and can be handed on", () => {
  const { hand, asked } = tracing();
  const state = hand.editor.getState();
  const round = contoursOfPath("M60 60A9 9 0 0 0 78 60A9 9 0 0 0 60 60Z", "trigonometric");
  // A line encloses nothing, whichever way it turns.
  const line = contoursOfPath("M0 0L0 9L9 9L9 0", "trigonometric");
  const contours = [...outcomeOf(found(), undefined).drawing.contours, ...round, ...line];
  hand.editor.setState(readState({ ...state, mode: "trace", trace: { settings: {}, kept: { name: "logo.png", width: 120, height: 120, contours } } }));
  const { traceRun } = hand.editor.state.value;
  assert.equal(asked.length, 0);
  assert.deepEqual(traceRun.outcome?.holes, [false, true, true, false]);
  assert.equal(traceRun.outcome?.rms, null);
  // There is nothing to be traced, and of the picture nothing to be seen.
  const { trace } = hand.editor.state.value;
  hand.run("trace-invert").run("trace-smoother").run("trace-run");
  assert.equal(hand.editor.state.value.trace, trace);
  assert.equal(hand.run("trace-next-view").editor.state.value.traceView.view, "outline");
  assert.equal(hand.run("trace-next-view").editor.state.value.traceView.view, "result");
  assert.doesNotMatch(traceHint(hand.editor.state.value), /see only the picture/u);
});

test("centre lines are lines in a file and in Curve, closed ones, too; outlines are areas", () => {
  const contours = contoursOfPath("M60 60A9 9 0 0 0 78 60A9 9 0 0 0 60 60Z", "trigonometric");
  for (const [mode, filling] of [["lines", "none"], ["brightness", undefined]] as const) {
    const { hand } = tracing();
    hand.editor.setState(readState({ ...hand.editor.getState(), mode: "trace", trace: { settings: { mode }, kept: { name: "a.png", width: 120, height: 120, contours } } }));
    assert.equal(tracedDrawing(hand.editor.state.value)?.filling, filling);
    hand.run("trace-edit");
    assert.deepEqual([hand.curve.contours.length, hand.curve.filling], [1, filling]);
  }
});

for (const [what, trace, path] of [
  ["a detail beyond the slider", { settings: { detail: 101 } }, "$.trace.settings.detail"],
  ["a threshold that is text", { settings: { threshold: "dark" } }, "$.trace.settings.threshold"],
  ["a work size that is none", { settings: { size: 1e9 } }, "$.trace.settings.size"],
  ["a corner without a kind", { settings: {}, corners: [{ x: 0, y: 0 }] }, "$.trace.corners[0].kind"],
  ["a picture of no size", { settings: {}, kept: { name: "a", width: 0, height: 1, contours: [] } }, "$.trace.kept.width"],
  ["outlines that are none", { settings: {}, kept: { name: "a", width: 1, height: 1, contours: [{ closed: 1 }] } }, "$.trace.kept.contours[0].points"],
] as const) {
  test(`a file with ${what} is refused by its place`, () => {
    const state = JSON.parse(writeState(new Hand().editor.getState())) as object;
    assert.throws(() => readState({ ...state, trace }), { path });
  });
}
