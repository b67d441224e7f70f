import type { Sketch } from "./editor.ts";

/** No gesture has drawn anything. */
export const nothingSketched: Sketch = { guides: [], marquee: null, rubber: null, stroke: [], finger: null, proposal: null };
