/** The wasm of tracing: started when something is traced for the first time, replaced when it dies. */
import type { InitOutput } from "../../build/bindings/expline_trace.js";
import { wasmAddress, wasmBytes } from "../../build/bindings/trace-bytes.js";
import { type Engine, type InitOptions, type InitSyncOptions, begin, beginSync, doorOf, lengthOfArray, wrongLength } from "../core.js";
import { type Kind, OpenWork } from "../tasks/open-work.js";

/** The functions of the wasm that the package calls. @internal */
export type TraceKernel = InitOutput;

const traces: Engine<TraceKernel> = { op: "initTrace", mark: "trace_open", bytes: wasmBytes, address: wasmAddress };

/**
 * Loads the engine for tracing early, or from elsewhere. Not needed before the first picture: without it the wasm
 * inside the package is compiled when it is first used. `expline/slim` needs it before `traceImage`; `traceImageAsync`
 * waits for it by itself. The curves that come out are Hermite curves: `toSvg`, and whatever is asked of them but for
 * their data, needs `init()` as well there.
 *
 * @throws {ExplineError} E_INIT with `reason` csp, network, mime, compile, version, memory or unsupported.
 */
export function initTrace(options?: InitOptions): Promise<void> {
  return begin(traces, options);
}

/**
 * Starts the engine for tracing from bytes or from a module, without waiting; changes nothing where one runs already.
 */
export function initTraceSync(options: InitSyncOptions): void {
  beginSync(traces, "initTraceSync", options);
}

/** Rows of bytes, as they are given. @internal */
export interface Pixels {
  readonly data: Uint8Array;
  readonly width: number;
  readonly height: number;
  /** Bytes of a pixel. */
  readonly channels: number;
}

/** How far a picture is. @internal */
export interface Step {
  readonly done: boolean;
  /** Number of the stage. */
  readonly stage: number;
  readonly completed: number;
  readonly total: number;
}

/** What a step says of the work. */
const enum Answer {
  GoesOn,
  Done,
  /** The colours are known: the rows are wanted again. */
  Again,
}

/** About so many bytes cross at once: rows of 64 kB take some 50 microseconds. */
const BLOCK = 1 << 16;

/** How many rows of so many bytes cross at once. */
function rowsOf(bytes: number): number {
  return Math.max(1, Math.floor(BLOCK / bytes));
}

/** What the engine is asked through. @internal */
export const door = /* @__PURE__ */ doorOf(traces);
const { call, instance, peek, result, write, writeBytes } = door;
const TRACE: Kind<TraceKernel> = { engine: traces, close: (kernel, number) => kernel.trace_close(number) };

/**
 * A picture in the engine. It stays where it is, in JavaScript; an instance that dies takes nothing along, and the next
 * begins anew.
 * @internal
 */
export class Picture {
  readonly #work: OpenWork<TraceKernel>;
  readonly #pixels: Pixels;
  /** Rows that the engine has. */
  #rows = 0;

  /** `options`: a record of options. */
  constructor(op: string, pixels: Pixels, options: Float64Array) {
    this.#pixels = pixels;
    this.#work = new OpenWork(op, TRACE, (now) => {
      this.#rows = 0;
      write(now, options);
      return call(now, (kernel) => kernel.trace_open(options.length));
    });
  }

  /** Goes on for about so many microseconds: the engine gets some rows, or works. */
  step(op: string, budget: number): Step {
    const number = this.#work.number(op);
    const { height } = this.#pixels;
    if (this.#rows < height) {
      this.#fill(op, number, budget);
      return { done: false, stage: 0, completed: this.#rows, total: height };
    }
    const answer = call(op, (kernel) => kernel.trace_step(number, budget)) as Answer;
    if (answer === Answer.Again) this.#rows = 0;
    return { done: answer === Answer.Done, stage: result(0), completed: result(1), total: result(2) };
  }

  /** Its shades in even light; undefined where light is even already, or is none on paper. Instead of tracing. */
  inEvenLight(op: string): Uint8Array<ArrayBuffer> | undefined {
    const number = this.#work.number(op);
    this.#fill(op, number, Infinity);
    if (call(op, (kernel) => kernel.trace_even_light(number)) === 0) return undefined;
    const { width, height } = this.#pixels;
    const shades = new Uint8Array(width * height);
    const rows = rowsOf(width);
    for (let row = 0; row < height; row += rows) {
      const count = call(op, (kernel) => kernel.trace_shades(number, row, Math.min(rows, height - row)));
      const { kernel } = instance();
      shades.set(new Uint8Array(kernel.memory.buffer, kernel.text_address(count) >>> 0, count), row * width);
    }
    return shades;
  }

  #fill(op: string, number: number, budget: number): void {
    const { data, width, height, channels } = this.#pixels;
    const bytes = width * channels;
    const block = rowsOf(bytes);
    const end = performance.now() + budget / 1000;
    // It was all there at first, but it is not ours: its buffer may have been transferred or resized since.
    const length = lengthOfArray(op, "data", data);
    if (length < height * bytes) throw wrongLength(op, "data", length, `${height * bytes}, as at first`);
    do {
      const next = Math.min(this.#rows + block, height);
      const count = writeBytes(op, data.subarray(this.#rows * bytes, next * bytes));
      call(op, (kernel) => kernel.trace_rows(number, count));
      this.#rows = next;
    } while (this.#rows < height && performance.now() < end);
  }

  /** The speckle that would leave as many contours as there may be, after an error that says that there are more. */
  offer(op: string): number | undefined {
    const number = this.#work.number(op);
    const known = call(op, (kernel) => kernel.trace_offer(number)) === 1;
    return known ? result(0) : undefined;
  }

  /** What was found, as the kernel describes it: valid until the next call. */
  describe(op: string): Float64Array {
    const number = this.#work.number(op);
    return peek(call(op, (kernel) => kernel.trace_describe(number)));
  }

  /** Gives the memory back; a second call does nothing. */
  close(): void {
    this.#work.close();
  }
}
