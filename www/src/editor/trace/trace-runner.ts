import { isEmptyTrace, type TraceDocument } from "../../document/trace/trace.ts";
import { outcomeOfKept } from "../../kernel/trace/outcome.ts";
import type { Clock, TraceClient, TraceHandlers } from "../../kernel/trace/trace-client.ts";
import { createWaiters } from "../../kernel/worker-desk.ts";
import type { Editor } from "../editor.ts";
import { closePicture, restTraceRun, traceAnswers } from "./trace-answers.ts";
import { canView, setTraceView } from "./trace-edits.ts";
import { ensureSample, openIncoming, type Refuse } from "./trace-opening.ts";
import { howOf, sameQuestion, sourceOf } from "./trace-question.ts";
import { noTraceRun, type Incoming } from "./trace-state.ts";

/** Keeps the outlines up to date with the document: asks for traces whenever it asks something else. */

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
  readonly refuse: Refuse;
  readonly clock: Clock;
  now(): number;
  readonly until: AbortSignal;
}

export function createTraceRunner(options: TraceRunnerOptions): TraceRunner {
  const { editor, until } = options;
  const runner = new Runner(options);
  editor.state.subscribe((state, before) => {
    if (state.trace !== before.trace || state.mode !== before.mode || state.incoming !== before.incoming) runner.update(state.mode !== before.mode);
  }, { until });
  until.addEventListener("abort", () => runner.dropWait(), { once: true });
  runner.update();
  return runner;
}

class Runner implements TraceRunner {
  readonly #options: TraceRunnerOptions;
  readonly #editor: Editor;
  readonly #client: TraceClient;
  readonly #waiters = createWaiters(() => this.#endWait === null && this.#opening === 0 && !this.#client.busy);
  /** The document that was asked for last. */
  #asked: TraceDocument | null = null;
  /** The document that the last trace was begun for. */
  #begun: TraceDocument | null = null;
  /** While a question waits for the next: calls it off. */
  #endWait: (() => void) | null = null;
  /** Pictures that are being looked at. */
  #opening = 0;

  constructor(options: TraceRunnerOptions) {
    this.#options = options;
    this.#editor = options.editor;
    this.#client = options.connect(traceAnswers(options.editor, this.#waiters.settle, () => this.#begun));
  }

  again(): void {
    if (!isEmptyTrace(this.#editor.state.value.trace)) this.#askNow();
  }

  cancel(): void {
    this.dropWait();
    const { trace, traceRun: { of } } = this.#editor.state.value;
    const behind = of !== null && !sameQuestion(of, trace);
    if (this.#client.cancel()) this.#editor.notify({ kind: "toast", text: "Cancelled" });
    restTraceRun(this.#editor, { behind });
    this.#waiters.settle();
  }

  idle(): Promise<void> {
    return this.#waiters.idle();
  }

  /** The state is another; `hasCome` says that the mode is. */
  update(hasCome = false): void {
    const { mode, incoming, traceRun } = this.#editor.state.value;
    if (incoming !== null) void this.#open(incoming);
    if (mode !== "trace") return;
    ensureSample(this.#editor);
    const [before, { trace }] = [this.#asked, this.#editor.state.value];
    this.#asked = trace;
    // A connection may have been lost for a moment: the next visit tries again.
    if (before === null || (hasCome && traceRun.failure?.id === "engine")) return this.#askNow();
    if (sameQuestion(before, trace)) return;
    // A new picture starts at once.
    if (sourceOf(before)?.key === sourceOf(trace)?.key) this.#askSoon();
    else this.#askNow();
  }

  dropWait(): void {
    this.#endWait?.();
    this.#endWait = null;
  }

  async #open(incoming: Incoming): Promise<void> {
    this.#opening += 1;
    await openIncoming(this.#editor, this.#client, this.#options.refuse, incoming);
    this.#opening -= 1;
    this.#waiters.settle();
  }

  #askSoon(): void {
    this.dropWait();
    this.#endWait = this.#options.clock.after(restMs, () => this.#askNow());
  }

  #askNow(): void {
    this.dropWait();
    const { trace } = this.#editor.state.value;
    const source = sourceOf(trace);
    this.#asked = this.#begun = trace;
    if (source === null) return this.#showKept(trace);
    this.#editor.patch({
      traceRun: { ...this.#editor.state.value.traceRun, since: this.#options.now(), behind: false },
      traceProgress: { stage: "decoding", value: 0, done: 0, total: 1 },
    });
    this.#client.trace(source, howOf(trace));
  }

  /** Without a picture there are the outlines that a file or a link came with, or nothing. */
  #showKept({ kept }: TraceDocument): void {
    this.#client.cancel();
    closePicture(this.#editor);
    this.#editor.patch({ traceProgress: null, traceRun: kept === undefined ? noTraceRun : { ...noTraceRun, outcome: outcomeOfKept(kept) } });
    // Of the picture itself there is nothing to be seen.
    if (!canView(this.#editor.state.value, this.#editor.state.value.traceView.view)) setTraceView(this.#editor, { view: "result" });
    this.#waiters.settle();
  }
}
