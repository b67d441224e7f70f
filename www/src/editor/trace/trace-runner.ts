import { firstTraceSample, traceSample } from "../../document/trace/trace-samples.ts";
import { isEmptyTrace, toleranceOf, traceDefaults, type TraceDocument } from "../../document/trace/trace.ts";
import type { PictureSource, TraceHow } from "../../kernel/trace/job.ts";
import { outcomeOf, outcomeOfKept } from "../../kernel/trace/outcome.ts";
import { dropPicture, pictureOf } from "../../kernel/trace/pictures.ts";
import { createWaiters } from "../../kernel/worker-desk.ts";
import { ProbeError, type Clock, type TraceClient, type TraceHandlers } from "../../kernel/trace/trace-client.ts";
import type { Editor } from "../editor.ts";
import { openedSample, openPicture, showBox } from "./trace-edits.ts";
import { noTraceRun, type Incoming, type TraceRun } from "./trace-state.ts";

/** Keeps the outlines up to date with the document: asks for traces, and puts what comes back into the state. */

/** A picture with more outlines than this is a photograph, unless somebody says that it is none. */
const mostOutlines = 1500;
/** And this is where even somebody who wants all of them is told no. */
const mostAnyway = 20_000;
/** A slider that moves on is not asked for at every step. */
const restMs = 150;

export interface TraceRunner {
  /** Once more, whether or not something has changed. */
  again(): void;
  cancel(): void;
  idle(): Promise<void>;
}

export interface TraceRunnerOptions {
  readonly editor: Editor;
  connect(handlers: TraceHandlers): TraceClient;
  /** Says that a picture could not be opened; the page has the words. */
  refuse(name: string, code: string): void;
  readonly clock: Clock;
  now(): number;
  readonly until: AbortSignal;
}

export function howOf({ settings, anyway }: TraceDocument): TraceHow {
  const { detail, corner, speckle, mode, threshold, blur, invert, colors, size } = settings;
  return {
    size, source: mode, threshold, blur, invert, colors, speckle, tolerance: toleranceOf(detail),
    corner: (Math.max(leastCorner, corner) * Math.PI) / 180,
    mostContours: anyway === true ? mostAnyway : mostOutlines,
  };
}

/** Degrees; below, every wave of a noisy line would be a corner. */
const leastCorner = 5;

function sourceOf(trace: TraceDocument): PictureSource | null {
  if (trace.sample !== undefined) return { kind: "sample", key: `sample:${trace.sample}`, id: trace.sample };
  return trace.picture === undefined ? null : pictureOf(trace.picture.key);
}

export function createTraceRunner({ editor, connect, refuse, clock, now, until }: TraceRunnerOptions): TraceRunner {
  /** The document that was asked for last, and the one that the outlines are of. */
  let asked: TraceDocument | null = null;
  let waiting: (() => void) | null = null;
  let opening = 0;

  const run = (change: Partial<TraceRun>): void => editor.patch({ traceRun: { ...editor.state.value.traceRun, ...change } });
  const done = { progress: null, since: null } as const;
  const { idle, settle } = createWaiters(() => waiting === null && opening === 0 && !client.busy);

  const client = connect({
    progress(stage, value, doneOf, total) {
      run({ progress: { stage, value, done: doneOf, total } });
    },
    picture(answer, { key }) {
      const { trace, traceRun } = editor.state.value;
      const name = trace.picture?.name ?? traceSample(trace.sample ?? "")?.title ?? "";
      const { width, height, analysed, source, edges, threshold } = answer;
      const other = traceRun.picture?.key !== key;
      closePicture(traceRun.picture);
      run({ picture: { key, name, width, height, analysed, source, edges, threshold }, ...(other ? { outcome: null, failure: null } : {}) });
    },
    traced(result, ms) {
      const { trace } = editor.state.value;
      if (result.outlines.length === 0) run({ ...done, outcome: null, failure: { id: "trace-none" }, lastMs: ms });
      else run({ ...done, outcome: outcomeOf(result, trace.sample), failure: null, lastMs: ms });
      editor.patch({ traceView: { ...editor.state.value.traceView, chosen: null, over: null } });
      settle();
    },
    photo(count, speckle) {
      run({ ...done, failure: { id: "trace-photo", count, speckle } });
      settle();
    },
    failed(code) {
      run({ ...done, failure: code === "E_IMAGE" ? { id: "image-broken" } : { id: "engine", code: code === "" ? "unknown" : code } });
      settle();
    },
    restarted() {
      editor.notify({ kind: "error", id: "engine", text: "The engine that traces stopped and was started again. Your picture is safe." });
    },
  });

  function ask(): void {
    waiting = null;
    const { trace } = editor.state.value;
    const source = sourceOf(trace);
    asked = trace;
    if (source === null) {
      client.cancel();
      closePicture(editor.state.value.traceRun.picture);
      editor.patch({ traceRun: trace.kept === undefined ? noTraceRun : { ...noTraceRun, outcome: outcomeOfKept(trace.kept) } });
      return settle();
    }
    run({ since: now(), progress: { stage: "decoding", value: 0, done: 0, total: 1 } });
    client.trace(source, howOf(trace));
  }

  function soon(wait: boolean): void {
    cancelWait();
    if (!wait) return ask();
    const stop = clock.after(restMs, ask);
    waiting = stop;
  }

  function cancelWait(): void {
    waiting?.();
    waiting = null;
  }

  /** A sample that is only named gets its own settings; a name that is none is said and forgotten. */
  function ensure(): void {
    const { trace } = editor.state.value;
    if (trace.sample === undefined) return;
    const sample = traceSample(trace.sample);
    if (sample === undefined) {
      editor.notify({ kind: "toast", text: `There is no sample named ${trace.sample}.` });
      return editor.traceEdits.amend(() => ({ trace: openedSample(firstTraceSample) }));
    }
    // An address names it and nothing else; a shared link and a file have settings.
    if (trace.settings !== traceDefaults) return;
    editor.traceEdits.amend(({ trace: named }) => ({ trace: { ...named, settings: openedSample(sample).settings } }));
    showBox(editor, sample);
    editor.patch({ hint: sample.note });
  }

  async function open({ name, source }: Incoming): Promise<void> {
    opening += 1;
    editor.patch({ incoming: null });
    try {
      const [width, height] = await client.probe(source);
      openPicture(editor, { name, width, height, key: source.key });
      editor.notify({ kind: "announce", text: `${name} opened, ${width} by ${height} pixels` });
    } catch (error) {
      dropPicture(source.key);
      refuse(name, error instanceof ProbeError ? error.code : "");
    }
    opening -= 1;
    settle();
  }

  function update(): void {
    const { mode, incoming } = editor.state.value;
    if (incoming !== null) void open(incoming);
    if (mode !== "trace") return;
    ensure();
    const { trace } = editor.state.value;
    if (asked === trace) return;
    const before = asked;
    // Corners are decided on the page; the tracer need not know.
    if (before !== null && sameQuestion(before, trace)) {
      asked = trace;
      return;
    }
    asked = trace;
    // A new picture starts at once.
    soon(before !== null && sourceOf(before)?.key === sourceOf(trace)?.key);
  }

  editor.state.subscribe((state, before) => {
    if (state.trace !== before.trace || state.mode !== before.mode || state.incoming !== before.incoming) update();
  }, { until });
  until.addEventListener("abort", cancelWait, { once: true });
  update();

  return {
    again() {
      if (!isEmptyTrace(editor.state.value.trace)) soon(false);
    },
    cancel() {
      cancelWait();
      if (client.cancel()) editor.notify({ kind: "toast", text: "Cancelled" });
      run(done);
      settle();
    },
    idle,
  };
}

function sameQuestion(a: TraceDocument, b: TraceDocument): boolean {
  return a.settings === b.settings && a.sample === b.sample && a.picture === b.picture && a.kept === b.kept && a.anyway === b.anyway;
}

/** A bitmap holds its pixels outside of the script's memory until it is closed. */
function closePicture(picture: TraceRun["picture"]): void {
  picture?.source.close();
  picture?.edges.close();
}
