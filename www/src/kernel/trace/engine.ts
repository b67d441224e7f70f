import { evenLight, initTrace, traceImageAsync, type Trace, type TraceOptions } from "expline/slim";
import traceUrl from "expline/expline_trace_bg.wasm?url";
import type { Pixels } from "./picture.ts";

/** The tracer of the library, at the pixels that the page looks at. */

export type { Trace, TraceOptions };

export function startTraceEngine(): Promise<void> {
  return initTrace({ wasmUrl: traceUrl });
}

export function tracePixels({ data, columns, rows }: Pixels, options: TraceOptions): Promise<Trace> {
  return traceImageAsync({ data, width: columns, height: rows }, options);
}

/** The shades by which ink is told from paper in uneven light; null where the light is even. */
export function shadesInEvenLight({ data, columns, rows }: Pixels): Uint8Array<ArrayBuffer> | null {
  return evenLight({ data, width: columns, height: rows })?.data ?? null;
}
