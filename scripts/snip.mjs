// Cuts the text of panics out of the wasm.
//
// A panic of this build ends in a trap and nothing prints its message: the face turns the trap into an error with a
// code and replaces the instance. But the code that would format the message stays linked, and is larger than the
// mathematics. So the bodies of the functions that begin a panic become one `unreachable`; wasm-opt then drops what
// only they called. Usage: node snip.mjs IN OUT

import { readFileSync, writeFileSync } from "node:fs";

import binaryen from "binaryen";

const [, , input, output] = process.argv;
const PANICS = /core(\[[0-9a-f]+\])?::(panicking|slice::index::slice_\w+_fail|result::unwrap_failed|option::(expect|unwrap)_failed|cell::panic_)|alloc(\[[0-9a-f]+\])?::(raw_vec::handle_error|raw_vec::capacity_overflow|alloc::handle_alloc_error)|rust_begin_unwind|rust_panic|std(\[[0-9a-f]+\])?::panicking|__rustc(\[[0-9a-f]+\])?::(rust_begin_unwind|__rust_alloc_error_handler)|rust_oom/;
const MESSAGES = /(\/|src\/)[\w./@+-]+?\.rs|index out of bounds: the len is | but the index is /g;

binaryen.setDebugInfo(true); // names stay until wasm-opt, for those who look into what is large
const wasm = binaryen.readBinary(readFileSync(input));
let count = 0;
for (let i = wasm.getNumFunctions() - 1; i >= 0; i--) {
  const { name, base, params, results } = binaryen.getFunctionInfo(wasm.getFunctionByIndex(i));
  if (base !== "" || !PANICS.test(name)) continue;
  wasm.removeFunction(name);
  wasm.addFunction(name, params, results, [], wasm.unreachable());
  count += 1;
}
if (count === 0) throw new Error("no panic function was found: are the names still in the wasm?");
// What those messages were made of stays behind in the data: zeros of the same length compress to nothing, and the
// wasm no longer depends on the folder that it was compiled in.
const text = Buffer.from(wasm.emitBinary()).toString("latin1");
writeFileSync(output, Buffer.from(text.replace(MESSAGES, (found) => "\0".repeat(found.length)), "latin1"));
console.log(`${count} functions`);
