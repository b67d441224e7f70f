import { initTrace, traceImageAsync, type Trace, type TraceOptions } from "expline/slim";
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
