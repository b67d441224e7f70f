/** The wasm of curves of any roots: started when the first one is made, replaced when it dies. */
import type { InitOutput } from "../../build/bindings/expline_spline.js";
import { wasmAddress, wasmBytes } from "../../build/bindings/spline-bytes.js";
import { type Engine, type InitOptions, type InitSyncOptions, begin, beginSync, doorOf } from "../core.js";

/** The functions of the wasm that the package calls. @internal */
export type SplineKernel = InitOutput;

const splines: Engine<SplineKernel> = { op: "initSpline", mark: "load_spline", bytes: wasmBytes, address: wasmAddress };

/**
 * Loads the engine of interpolating and B-spline curves and of their generators early, or from elsewhere. Not needed
 * before the first one: without it the wasm inside the package is compiled when it is first used. `expline/slim` needs
 * it before the first one, and `init()` as well for what is a Hermite curve's: `toPathD`, `toPath2D`, `asEllipse`, and
 * whatever is asked of `toHermite`'s curve.
 *
 * @throws {ExplineError} E_INIT with `reason` csp, network, mime, compile, version, memory or unsupported.
 */
export function initSpline(options?: InitOptions): Promise<void> {
  return begin(splines, options);
}

/** Starts that engine from bytes or from a module, without waiting; changes nothing where one runs already. */
export function initSplineSync(options: InitSyncOptions): void {
  beginSync(splines, "initSplineSync", options);
}

/** What the engine is asked through. @internal */
export const door = /* @__PURE__ */ doorOf(splines);
/** @internal */
export const { call, copy, peek, result, write } = door;
