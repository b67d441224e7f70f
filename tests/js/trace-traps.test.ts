// The engine for tracing dies, and takes nothing along: pictures under way begin anew in the next instance.

import assert from "node:assert/strict";
import { test } from "node:test";

import { ExplineError, SparseFitter, initTraceSync, traceImage, traceImageAsync } from "expline";

import { ring } from "./trace-data.ts";
import { trapping } from "./trapping.ts";

// In this process the end of every trace stops the engine; everything else is as it is delivered.
initTraceSync({ bytes: trapping("trace_close", "pkg/expline_trace_bg.wasm") });

const RING = ring(48);

function stop(): void {
  assert.throws(() => traceImage(RING), (error) => {
    assert.ok(error instanceof ExplineError);
    assert.equal(error.code, "E_INTERNAL");
    assert.equal(error.fatal, true);
    assert.ok(error.cause instanceof WebAssembly.RuntimeError);
    return true;
  });
}

test("a trap is an error that says so, and other engines live on", () => {
  using fitter = new SparseFitter([0, 0, 4, 0, 4, 4, 0, 4]);
  stop();
  assert.ok(fitter.solve().knots.length > 0);
  stop();
});

test("a picture that was under way when the engine died begins anew", async () => {
  const stages: string[] = [];
  // Its own end is a trap too: the last step is what it comes to.
  const trace = traceImageAsync(ring(300), {
    onProgress: ({ stage }) => {
      if (stage === "contours" && !stages.includes(stage)) stop();
      stages.push(stage);
    },
  });
  await assert.rejects(trace, { code: "E_INTERNAL" });
  const again = stages.lastIndexOf("pixels");
  assert.ok(again > stages.indexOf("contours"), stages.join(" "));
  assert.equal(stages.at(-1), "refinement");
});

test("traps in a row cost no memory", () => {
  for (let i = 0; i < 10; i += 1) stop();
  const before = process.memoryUsage().rss;
  for (let i = 0; i < 60; i += 1) stop();
  const grown = (process.memoryUsage().rss - before) / 1e6;
  assert.ok(grown < 200, `${grown} MB`);
});
