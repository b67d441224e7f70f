/** The wasm of surfaces: started when the first surface is made, replaced when it dies. */
import type { InitOutput } from "../../build/bindings/expline_surface.js";
import { wasmAddress, wasmBytes } from "../../build/bindings/surface-bytes.js";
import { type Engine, type InitOptions, type InitSyncOptions, begin, beginSync, doorOf } from "../core.js";

/** The functions of the wasm that the package calls. @internal */
export type SurfaceKernel = InitOutput;

const surfaces: Engine<SurfaceKernel> = { op: "initSurface", mark: "surface_load", bytes: wasmBytes, address: wasmAddress };

/**
 * Loads the engine of surfaces early, or from elsewhere. Not needed before the first surface: without it the wasm
 * inside the package is compiled when it is first used. `expline/slim` needs it before the first surface, and nothing
 * else for surfaces.
 *
 * @throws {ExplineError} E_INIT with `reason` csp, network, mime, compile, version, memory or unsupported.
 */
export function initSurface(options?: InitOptions): Promise<void> {
  return begin(surfaces, options);
}

/**
 * Starts the engine of surfaces from bytes or from a module, without waiting; changes nothing where one runs already.
 */
export function initSurfaceSync(options: InitSyncOptions): void {
  beginSync(surfaces, "initSurfaceSync", options);
}

/** What the engine is asked through. @internal */
export const door = /* @__PURE__ */ doorOf(surfaces);
/** @internal */
export const { call, copy, peek, result, write } = door;
