import init, { ExplineError, initSpline, version } from "expline/slim";
import wasmUrl from "expline/expline_bg.wasm?url";
import splineUrl from "expline/expline_spline_bg.wasm?url";

/** Starting the engine, and its failures in words that the page can act on. */

export const engineVersion: string = version;

export type EngineFailure = { readonly reason: "blocked" | "unsupported" | "failed"; readonly detail: string };

/** Resolves to null when the engine runs, else to why it does not. */
export async function startEngine(): Promise<EngineFailure | null> {
  if (typeof WebAssembly === "undefined") return { reason: "unsupported", detail: "This browser has no WebAssembly." };
  try {
    // Any document may hold curves of either family.
    await Promise.all([init({ wasmUrl }), initSpline({ wasmUrl: splineUrl })]);
    return null;
  } catch (error) {
    return { reason: isBlocked(error) ? "blocked" : "failed", detail: error instanceof Error ? error.message : String(error) };
  }
}

/** Browsers word it differently; all of them name the policy or the directive. */
function isBlocked(error: unknown): boolean {
  const text = error instanceof Error ? `${error.name} ${error.message} ${String(error.cause ?? "")}` : String(error);
  return /content security policy|unsafe-eval|wasm-eval|csp/i.test(text);
}

/** The code of a library error, or null for anything else. */
export function errorCode(error: unknown): string | null {
  return error instanceof ExplineError ? error.code : null;
}
