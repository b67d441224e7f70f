import { initSurface } from "expline/slim";
import wasmUrl from "expline/expline_surface_bg.wasm?url";

/** Starts the engine of surfaces, once. */
export function startSurfaceEngine(): Promise<void> {
  return initSurface({ wasmUrl });
}
