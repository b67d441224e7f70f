// The package: Rust → wasm → bindings (wasm.mjs) → ES modules with the wasm inside, and their declarations (face.mjs).

import { buildFace } from "./face.mjs";
import { printSizes } from "./sizes.mjs";
import { buildBindings, buildWasm, buildXtask } from "./wasm.mjs";

/** Everything that the package is made of, and its measured size and start-up time. */
export async function buildPackage() {
  await buildXtask();
  await buildWasm();
  await buildBindings();
  await buildFace();
  await printSizes();
}
