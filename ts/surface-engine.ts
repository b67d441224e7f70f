/** The wasm of surfaces: started when the first surface is made, replaced when it dies. */
import type { InitOutput } from "../build/bindings/expline_surface.js";
import { wasmAddress, wasmBytes } from "../build/bindings/surface-bytes.js";
import {
  type Engine,
  type Floats,
  type InitOptions,
  type Instance,
  begin,
  beginSync,
  callOf,
  instanceOf,
  peekOf,
  resultOf,
  writeTo,
} from "./core.js";

/** The functions of the wasm that the package calls. @internal */
export type SurfaceKernel = InitOutput;

const surfaces: Engine<SurfaceKernel> = { op: "initSurface", mark: "surface_load", bytes: wasmBytes, address: wasmAddress };

/**
 * Loads the engine of surfaces early, or from elsewhere. Not needed before the first surface: without it the wasm inside the package is
 * compiled when it is first used. `expline/slim` needs it before the first surface.
 *
 * @throws {ExplineError} E_INIT with `reason` csp, network, mime, compile, version, memory or unsupported.
 */
export function initSurface(options?: InitOptions): Promise<void> {
  return begin(surfaces, options);
}

/** Starts the engine of surfaces from bytes or from a module, without waiting; changes nothing where one runs already. */
export function initSurfaceSync(options: { bytes: BufferSource } | { module: WebAssembly.Module }): void {
  beginSync(surfaces, "initSurfaceSync", options);
}

/** The living instance. @internal */
export function engine(): Instance<SurfaceKernel> {
  return instanceOf(surfaces);
}

/** Runs one function of the engine. @internal */
export function call(op: string, body: (kernel: SurfaceKernel) => number, given?: number | ArrayLike<number>): number {
  return callOf(surfaces, op, body, given);
}

/** Number i of the record of scalar results. @internal */
export function result(i: number): number {
  return resultOf(engine(), i);
}

/** The output as it lies in the instance: valid until the next call. @internal */
export function peek(count: number): Float64Array {
  return peekOf(engine(), count);
}

/** A copy of the output. @internal */
export function copy(count: number): Floats {
  return peek(count).slice() as Floats;
}

/** Writes arrays one after the other to where the engine reads numbers. @internal */
export function write(op: string, ...arrays: Float64Array[]): void {
  writeTo(surfaces, op, ...arrays);
}
