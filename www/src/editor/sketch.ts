import type { Sketch } from "./editor.ts";

/** No gesture has drawn anything. */
export const nothingSketched: Sketch = { guides: [], marquee: null, rubber: null, stroke: [], joint: null, finger: null, proposal: null };
