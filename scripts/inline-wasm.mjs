// The wasm as text inside JavaScript, so that the package starts with no await and no second request.
//
// One character per byte: byte b becomes the code point (b + shift) mod 256. In UTF-8 that compresses to a few per
// cent more than the wasm itself, where base64 costs a third. Shift and quote are those for which the
// text is smallest after gzip.

import { gzipSync } from "node:zlib";

const QUOTES = ['"', "'", "`"];
/** So many shifts, those of the shortest texts, are tried with gzip; the best is always among the first few. */
const TRIED = 8;

/** How a byte is written after the shift, inside the given quotes. */
function written(byte, shift, quote) {
  const code = (byte + shift) & 255;
  const character = String.fromCharCode(code);
  if (code === 0) return "\\x00"; // legal in a literal, but makes tools take the file for a binary one
  if (code === 13) return "\\r";
  if (code === 10 && quote !== "`") return "\\n";
  if (character === "\\" || character === quote || (character === "$" && quote === "`")) return `\\${character}`;
  return character;
}

const alphabet = (shift, quote) => Array.from({ length: 256 }, (_, byte) => written(byte, shift, quote));

/** The smallest literal of the bytes, and the shift that it was made with. */
export function smallestLiteral(bytes) {
  const counts = new Float64Array(256);
  for (const byte of bytes) counts[byte] += 1;
  const candidates = [];
  for (let shift = 0; shift < 256; shift++) {
    for (const quote of QUOTES) {
      const letters = alphabet(shift, quote);
      const length = letters.reduce((sum, letter, byte) => sum + counts[byte] * Buffer.byteLength(letter), 0);
      candidates.push({ shift, quote, letters, length });
    }
  }
  candidates.sort((a, b) => a.length - b.length);
  let best = { text: "", shift: 0, size: Number.POSITIVE_INFINITY };
  for (const { shift, quote, letters } of candidates.slice(0, TRIED)) {
    const text = quote + Array.from(bytes, (byte) => letters[byte]).join("") + quote;
    if (/<\/script|<!--/i.test(text)) continue; // a page may carry the module inside a script element
    const size = gzipSync(text, { level: 9 }).length;
    if (size < best.size) best = { text, shift, size };
  }
  if (best.text === "") throw new Error("every literal would end a script element");
  return best;
}

/**
 * Reads the text's UTF-8 where JavaScript has put it and writes its bytes over it: every code point is below 256, so one
 * or two bytes become one, and what is written never overtakes what is read.
 */
const DECODER = `
(module
  (memory (import "" "memory") 0)
  (func (export "decode") (param $end i32) (param $shift i32) (result i32)
    (local $from i32) (local $to i32) (local $code i32)
    (loop $next
      (local.set $code (i32.load8_u (local.get $from)))
      (if (i32.ge_u (local.get $code) (i32.const 128))
        (then
          (local.set $from (i32.add (local.get $from) (i32.const 1)))
          (local.set $code
            (i32.or (i32.shl (local.get $code) (i32.const 6)) (i32.and (i32.load8_u (local.get $from)) (i32.const 63))))))
      (i32.store8 (local.get $to) (i32.sub (local.get $code) (local.get $shift)))
      (local.set $to (i32.add (local.get $to) (i32.const 1)))
      (local.set $from (i32.add (local.get $from) (i32.const 1)))
      (br_if $next (i32.lt_u (local.get $from) (local.get $end))))
    (local.get $to)))
`;

/** The decoder's bytes, one character each. The package is asked for here: in a fresh clone it comes after this file. */
async function decoder() {
  const { default: binaryen } = await import("binaryen");
  const module = binaryen.parseText(DECODER);
  module.optimize();
  return JSON.stringify(String.fromCharCode(...module.emitBinary()));
}

/** What stands for the literal while the face is bundled and minified. */
export const PLACEHOLDER = '"@wasm@"';

/** A module that exports `wasmBytes()`, its declarations, and the literal in it. No address: the bytes are there. */
export async function inlineModule(bytes) {
  const { text, shift } = smallestLiteral(bytes);
  const code = `import { decoded } from "./decode.ts";

export const wasmAddress = undefined;

export const wasmBytes = () => decoded(${PLACEHOLDER}, ${shift}, ${await decoder()});
`;
  const declarations = `/** The wasm that is inlined in the package; E_NOT_READY in the slim one. */
export declare function wasmBytes(): Uint8Array<ArrayBuffer>;
/** Where the wasm lies beside the slim package; undefined where it is inside. */
export declare const wasmAddress: (() => URL) | undefined;
`;
  return { code: code.replace(PLACEHOLDER, () => text), declarations, text };
}
