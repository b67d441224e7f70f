// Hosts that have JavaScript and WebAssembly and little else: jsdom, as test runners make it, knows neither TextEncoder
// nor MessageChannel.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { join } from "node:path";

const consumer = join(process.cwd(), "build", "consumer");

const WORK = `
  const { HermiteCurve, TensorSurface, fitSparseAsync, parsePath, traceImageAsync } = await import("expline");
  const said = [];
  const [path] = parsePath("M0 0A5 5 0 0 1 10 0L5 8Z");
  said.push(path.toPathD({ decimals: 3 }).d);
  for (const call of [() => HermiteCurve.ellipse({ center: [0, 0], radii: [-1, 1], count: 2 }), () => parsePath("M0 0L1 1é"), () => parsePath("M0 0\\ud800")]) {
    try { call(); } catch (error) { said.push(error.message); }
  }
  const points = Float64Array.from({ length: 2000 }, (_, i) => (i % 2 ? Math.sin : Math.cos)(i / 300) * 80 + Math.sin(97 * i));
  const { knots, maxError } = await fitSparseAsync(points);
  said.push(knots.length, maxError);
  const { contours } = await traceImageAsync({ width: 64, height: 64, data: Uint8Array.from({ length: 4096 }, (_, i) => (i * 7919) % 251) });
  said.push(contours.length);
  const glb = TensorSurface.sphere(1).toGltf({ rows: 4, cols: 4, name: "Kugel ö 𝒮" });
  const json = glb.slice(20, 20 + new DataView(glb.buffer).getUint32(12, true));
  said.push(glb.length % 4, JSON.parse(Buffer.from(json).toString("utf8")).nodes[0].name);
  console.log(JSON.stringify(said));
`;

/** What a program says in Node where the wasm is inside the module, as bundlers and test runners of pages take it. */
function node(code: string): string {
  return execFileSync(process.execPath, ["--conditions=module", "--input-type=module", "-e", code], { cwd: consumer, encoding: "utf8" });
}

test("where there is no TextEncoder, no TextDecoder and no MessageChannel, all works as it does elsewhere", () => {
  const bare = `for (const name of ["TextEncoder", "TextDecoder", "MessageChannel", "setImmediate"]) delete globalThis[name];`;
  const said = node(bare + WORK);
  assert.equal(said, node(WORK));
  const [, , , , , , , remainder, name] = JSON.parse(said) as unknown[];
  assert.deepEqual([remainder, name], [0, "Kugel ö 𝒮"]);
});
