// A wasm module that is the package's own, but for one function that stops the instance: no such door is in the
// package.

import { readFileSync } from "node:fs";

import binaryen from "binaryen";

/** The package's wasm with the exported function `name` replaced by a trap. */
export function trapping(name: string, file = "pkg/expline_bg.wasm"): Uint8Array<ArrayBuffer> {
  const module = binaryen.readBinary(new Uint8Array(readFileSync(file)));
  const inner = binaryen.getExportInfo(module.getExport(name)).value;
  const { params, results } = binaryen.getFunctionInfo(module.getFunction(inner));
  module.removeFunction(inner);
  module.addFunction(inner, params, results, [], module.unreachable());
  return new Uint8Array(module.emitBinary());
}
