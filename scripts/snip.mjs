// Cuts the text of panics out of the wasm.
//
// A panic of this build ends in a trap and nothing prints its message: the face turns the trap into an error with a
// code and replaces the instance. But the code that would format the message stays linked, and is larger than the
// mathematics. So the bodies of the functions that begin a panic become one `unreachable`; wasm-opt then drops what
// only they called. So do those of formatting, which is there for panics and for `Debug`: no message is made in the
// wasm. And so does, of each `&dyn Fn`, what would call it as an owned one: a borrowed one never is.
// Usage: node snip.mjs IN OUT

import { readFileSync, writeFileSync } from "node:fs";

import binaryen from "binaryen";

const [, , input, output] = process.argv;
const PANICS = /core(\[[0-9a-f]+\])?::(panicking|slice::index::slice_\w+_fail|result::unwrap_failed|option::(expect|unwrap)_failed|cell::panic_)|alloc(\[[0-9a-f]+\])?::(vec::Vec<.*>>::\w+::assert_failed|raw_vec::handle_error|raw_vec::capacity_overflow|alloc::handle_alloc_error)|rust_begin_unwind|rust_panic|std(\[[0-9a-f]+\])?::panicking|__rustc(\[[0-9a-f]+\])?::(rust_begin_unwind|__rust_alloc_error_handler)|rust_oom|core(\[[0-9a-f]+\])?::fmt::|core::ops::function::FnOnce::call_once\{\{vtable\.shim\}\}/;
const PATHS = /(\/|src\/)[\w./@+-]+?\.rs/g;
const MESSAGES = new RegExp(
  [
    "index out of bounds: the len is | but the index is |slice index starts at | but ends at |range (start|end) index ",
    '" out of range for slice of length |(insertion|removal) index \\(is |\\) should be <=? len \\(is |min > max\\. min = |, max = ',
    "dest is out of bounds|copy_from_slice: source slice length \\(|\\) does not match destination slice length \\(|mid > len|Matrix index out of bounds\\.|capacity overflow|chunk size must be non-zero",
    "Matrix slicing out of bounds\\.|Matrix elements swap index out of bounds\\.|The input vector must not be empty\\.|Maximum number of permutations exceeded\\.",
    "Allocation from iterator error: the iterator did not yield the correct number of elements\\.|`at` split index \\(is |window size must be non-zero",
    "assertion failed: (step != 0|mid <= self\\.len\\(\\)|irow1 < self\\.nrows\\(\\) && irow2 < self\\.nrows\\(\\))",
    "assertion `left | right` failed(: )?|attempt to divide by zero|attempt to calculate the remainder with a divisor of zero|attempt to calculate the remainder with overflow|0123456789abcdef|0x0123456789ABCDEF",
    "0001020304\\d+9899",
  ].join("|"),
  "g",
);

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
// The face starts the engine by itself and hands it nothing but numbers: what the bindings would start it with is never
// called.
for (const name of ["__wbindgen_start", "__wbindgen_externrefs", "__abort_handler", "__instance_terminated"]) wasm.removeExport(name);
if (count === 0) throw new Error("no panic function was found: are the names still in the wasm?");
// What those messages were made of stays behind in the data: zeros of the same length compress to nothing, and the
// wasm does not depend on the folder that it was compiled in.
const bytes = Buffer.from(wasm.emitBinary());
for (const { start, end, address } of segments(bytes)) {
  const text = bytes.toString("latin1", start, end);
  // Of printing only the code can be cut: its tables are 2 kB.
  if (text.includes("or either was NaN")) throw new Error("a clamp of floats between bounds that are no constants links their printing; larger and smaller do not");
  for (const { 0: path, index } of text.matchAll(PATHS)) forgetPlaces(address + index, path.length);
  for (const { 0: found, index } of [...text.matchAll(PATHS), ...text.matchAll(MESSAGES)]) bytes.fill(0, start + index, start + index + found.length);
}
writeFileSync(output, bytes);
console.log(`${count} functions`);

/** The initial contents of memory: where they are in the file, and where they go. */
function segments(file) {
  let at = 8;
  const number = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = file[at++];
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  };
  while (at < file.length) {
    const section = file[at++];
    const length = number();
    if (section !== 11) {
      at += length;
      continue;
    }
    return Array.from({ length: number() }, () => {
      // Active, and at a constant address: 0, i32.const, address, end.
      if (file[at++] !== 0 || file[at++] !== 0x41) throw new Error("data that is not at a constant address");
      const address = number();
      at += 1;
      const size = number();
      at += size;
      return { start: at - size, end: at, address };
    });
  }
  return [];
}

/**
 * A place in the source is the address and the length of the path, line and column, four bytes each: nobody asks for it
 * any more.
 */
function forgetPlaces(address, length) {
  const place = Buffer.alloc(8);
  place.writeUInt32LE(address, 0);
  place.writeUInt32LE(length, 4);
  for (const { start, end } of segments(bytes)) {
    for (let at = bytes.indexOf(place, start); at >= 0 && at + 16 <= end; at = bytes.indexOf(place, at + 16)) bytes.fill(0, at, at + 16);
  }
}
