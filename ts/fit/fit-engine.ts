/** The wasm of fitting: started when something is fitted for the first time, replaced when it dies. */
import type { InitOutput } from "../../build/bindings/expline_fit.js";
import { wasmAddress, wasmBytes } from "../../build/bindings/fit-bytes.js";
import { type Engine, type InitOptions, type InitSyncOptions, begin, beginSync, doorOf } from "../core.js";
import { type Kind, OpenWork } from "../tasks/open-work.js";

/** The functions of the wasm that the package calls. @internal */
export type FitKernel = InitOutput;

const fits: Engine<FitKernel> = { op: "initFit", mark: "fit_open", bytes: wasmBytes, address: wasmAddress };

/**
 * Loads the engine for fitting early, or from elsewhere. Not needed before the first fit: without it the wasm inside
 * the package is compiled when it is first used. `expline/slim` needs it before `fitSparse`; `fitSparseAsync` waits for
 * it by itself. The curves that come out are Hermite curves: whatever is asked of them, but for their data, needs
 * `init()` as well there.
 *
 * @throws {ExplineError} E_INIT with `reason` csp, network, mime, compile, version, memory or unsupported.
 */
export function initFit(options?: InitOptions): Promise<void> {
  return begin(fits, options);
}

/**
 * Starts the engine for fitting from bytes or from a module, without waiting; changes nothing where one runs already.
 */
export function initFitSync(options: InitSyncOptions): void {
  beginSync(fits, "initFitSync", options);
}

const { call, peek, result, write } = /* @__PURE__ */ doorOf(fits);
const FIT: Kind<FitKernel> = { engine: fits, close: (kernel, number) => kernel.fit_close(number) };

/** How far a run is. @internal */
export interface Step {
  readonly done: boolean;
  readonly iteration: number;
  readonly gap: number;
}

/** What is asked for, as the kernel numbers it. @internal */
export const enum Asked {
  Noise,
  Lambda,
  Smoothing,
  Tolerance,
}

/** What a run is asked for: up to two numbers. @internal */
export interface Question {
  readonly kind: Asked;
  readonly first: number;
  readonly second: number;
  /** How many degrees the fit has. */
  readonly degrees: number;
}

/**
 * A fit in the engine: its data are kept here, so that an instance that dies takes nothing along. A run that was under
 * way in it begins anew.
 * @internal
 */
export class Resident {
  readonly #work: OpenWork<FitKernel>;
  #question: Question | undefined;

  /** `input`: a record of options, points, parameters, weights. */
  constructor(op: string, input: readonly Float64Array[]) {
    const total = input.reduce((sum, array) => sum + array.length, 0);
    this.#work = new OpenWork(op, FIT, (now) => {
      write(now, ...input);
      return call(now, (kernel) => kernel.fit_open(total), input[1]);
    });
  }

  /** The number in the living instance; opened again, with what was asked, where that is a new one. */
  #number(op: string): number {
    const question = this.#question;
    return this.#work.number(op, (number) => {
      if (question !== undefined) this.#put(op, number, question);
    });
  }

  #put(op: string, number: number, { kind, first, second, degrees }: Question): void {
    call(op, (kernel) => kernel.fit_ask(number, kind, first, second, degrees));
  }

  /** Starts a run. */
  ask(op: string, question: Question): void {
    const number = this.#number(op);
    this.#question = undefined;
    this.#put(op, number, question);
    this.#question = question;
  }

  /** The noise of the points, as given or as found. */
  noise(op: string): number {
    const number = this.#number(op);
    call(op, (kernel) => kernel.fit_noise(number));
    return result(0);
  }

  /** Goes on for about so many microseconds. */
  step(op: string, budget: number): Step {
    const number = this.#number(op);
    const done = call(op, (kernel) => kernel.fit_step(number, budget)) === 1;
    return { done, iteration: result(0), gap: result(1) };
  }

  /** The best that the run has found, as the kernel describes it: valid until the next call. */
  describe(op: string): Float64Array {
    const number = this.#number(op);
    return peek(call(op, (kernel) => kernel.fit_describe(number)));
  }

  /** Gives the memory back; a second call does nothing. */
  close(): void {
    this.#work.close();
  }
}
