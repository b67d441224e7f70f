// The wasm as text inside JavaScript, so that the package starts with no await and no second request.
//
// The wasm is sorted into streams first (split-wasm.mjs). Then, one character per byte, byte b becomes the code point (b + shift) mod 256. In UTF-8 that compresses to a few per
// cent more than the wasm itself, where base64 costs a third. Shift and quote are those for which the
// text is smallest after gzip.

import { gzipSync } from "node:zlib";

import { splitWasm } from "./split-wasm.mjs";

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

/** Where the decoder expects the text; before it are its own tables. */
const TEXT = 4096;

/**
 * Reads the text's UTF-8 where JavaScript has put it and writes its bytes over it: every code point is below 256, so one
 * or two bytes become one, and what is written never overtakes what is read. Then puts together what split-wasm.mjs took apart,
 * from `out` on, and returns where that ends. At 0 it keeps where each row begins, at 1024 how far each stream is read.
 */
const DECODER = `
(module
  (memory (import "" "memory") 0)
  (func (export "decode") (param $end i32) (param $shift i32) (param $out i32) (result i32)
    (local $from i32) (local $to i32) (local $byte i32) (local $i i32) (local $streams i32) (local $mode i32)
    (local $bytes i32) (local $items i32) (local $value i32)
    (local.set $from (i32.const ${TEXT}))
    (local.set $to (i32.const ${TEXT}))
    (loop $next
      (local.set $byte (i32.load8_u (local.get $from)))
      (if (i32.ge_u (local.get $byte) (i32.const 128))
        (then
          (local.set $from (i32.add (local.get $from) (i32.const 1)))
          (local.set $byte
            (i32.or (i32.shl (local.get $byte) (i32.const 6)) (i32.and (i32.load8_u (local.get $from)) (i32.const 63))))))
      (i32.store8 (local.get $to) (i32.sub (local.get $byte) (local.get $shift)))
      (local.set $to (i32.add (local.get $to) (i32.const 1)))
      (local.set $from (i32.add (local.get $from) (i32.const 1)))
      (br_if $next (i32.lt_u (local.get $from) (local.get $end))))

    ;; Where rows and streams begin.
    (local.set $streams (i32.shl (i32.load8_u (i32.const ${TEXT})) (i32.const 2)))
    (local.set $from (i32.add (i32.const ${TEXT + 2}) (local.get $streams)))
    (loop $row
      (i32.store (local.get $i) (local.get $from))
      (local.set $byte (i32.load8_u (local.get $from)))
      (local.set $from
        (i32.add
          (i32.add (local.get $from) (i32.const 1))
          (i32.add (i32.and (local.get $byte) (i32.const 15)) (i32.shr_u (local.get $byte) (i32.const 4)))))
      (local.set $i (i32.add (local.get $i) (i32.const 4)))
      (br_if $row
        (i32.ne
          (i32.and (i32.shr_u (local.get $i) (i32.const 2)) (i32.const 255))
          (i32.load8_u (i32.const ${TEXT + 1})))))
    (local.set $i (i32.const 0))
    (loop $stream
      (i32.store offset=1024 (local.get $i) (local.get $from))
      (local.set $from (i32.add (local.get $from) (i32.and (i32.load offset=${TEXT + 2} (local.get $i)) (i32.const 0xffffff))))
      (local.set $i (i32.add (local.get $i) (i32.const 4)))
      (br_if $stream (i32.lt_u (local.get $i) (local.get $streams))))

    ;; Of the first stream, $from is where it is read and $end where it ends.
    (local.set $from (i32.load (i32.const 1024)))
    (local.set $end (i32.load (i32.const 1028)))
    (loop $operation
      (local.set $to (i32.load (i32.shl (i32.load8_u (local.get $from)) (i32.const 2))))
      (local.set $bytes (i32.and (i32.load8_u (local.get $to)) (i32.const 15)))
      (local.set $items (i32.shr_u (i32.load8_u (local.get $to)) (i32.const 4)))
      (loop $byte
        (if (local.get $bytes)
          (then
            (i32.store8 (local.get $out) (i32.load8_u offset=1 (local.get $to)))
            (local.set $to (i32.add (local.get $to) (i32.const 1)))
            (local.set $out (i32.add (local.get $out) (i32.const 1)))
            (local.set $bytes (i32.sub (local.get $bytes) (i32.const 1)))
            (br $byte))))
      (loop $item
        (if (local.get $items)
          (then
            (local.set $items (i32.sub (local.get $items) (i32.const 1)))
            (local.set $to (i32.add (local.get $to) (i32.const 1)))
            (local.set $i (i32.shl (i32.load8_u (local.get $to)) (i32.const 2)))
            (local.set $mode (i32.load8_u offset=${TEXT + 5} (local.get $i)))
            (if (i32.eq (local.get $mode) (i32.const 254))
              (then
                ;; A number in units of the alignment, which was written last.
                (local.set $shift (i32.load8_u (i32.sub (local.get $out) (i32.const 1))))
                (local.set $value (i32.const 0))
                (loop $read
                  (local.set $byte (call $next (local.get $i)))
                  (local.set $value
                    (i32.or (local.get $value) (i32.shl (i32.and (local.get $byte) (i32.const 127)) (local.get $shift))))
                  (local.set $shift (i32.add (local.get $shift) (i32.const 7)))
                  (br_if $read (i32.and (local.get $byte) (i32.const 128))))
                (loop $write
                  (local.set $byte (i32.and (local.get $value) (i32.const 127)))
                  (local.set $value (i32.shr_u (local.get $value) (i32.const 7)))
                  (if (local.get $value) (then (local.set $byte (i32.or (local.get $byte) (i32.const 128)))))
                  (i32.store8 (local.get $out) (local.get $byte))
                  (local.set $out (i32.add (local.get $out) (i32.const 1)))
                  (br_if $write (local.get $value)))
                (br $item)))
            (if (i32.eq (local.get $mode) (i32.const 255))
              (then (local.set $mode (call $next (local.get $i)))))
            ;; A LEB128 goes on as long as its bytes say, anything else $mode bytes long.
            (loop $copy
              (local.set $byte (call $next (local.get $i)))
              (i32.store8 (local.get $out) (local.get $byte))
              (local.set $out (i32.add (local.get $out) (i32.const 1)))
              (br_if $copy
                (select
                  (local.tee $mode (i32.sub (local.get $mode) (i32.const 1)))
                  (i32.and (local.get $byte) (i32.const 128))
                  (i32.ge_s (local.get $mode) (i32.const 0)))))
            (br $item))))
      (local.set $from (i32.add (local.get $from) (i32.const 1)))
      (br_if $operation (i32.lt_u (local.get $from) (local.get $end))))
    (local.get $out))

  ;; The next byte of a stream.
  (func $next (param $i i32) (result i32)
    (local $from i32)
    (local.set $from (i32.load offset=1024 (local.get $i)))
    (i32.store offset=1024 (local.get $i) (i32.add (local.get $from) (i32.const 1)))
    (i32.load8_u (local.get $from))))
`;

/** The module with the decoder's bytes, one character each. The package is asked for here: in a fresh clone it comes after this file. */
export async function decoderModule() {
  const { default: binaryen } = await import("binaryen");
  const module = binaryen.parseText(DECODER);
  if (!module.validate()) throw new Error("the decoder is not valid");
  binaryen.setOptimizeLevel(2);
  binaryen.setShrinkLevel(2);
  module.optimize();
  const decoder = module.emitBinary();
  const code = `export const decoder = ${JSON.stringify(String.fromCharCode(...decoder))};\nexport const TEXT = ${TEXT};\n`;
  const declarations = `/** The wasm that reads inlined wasm, one character each byte. */
export declare const decoder: string;
/** Where it expects the text. */
export declare const TEXT: number;
`;
  return { code, declarations, decoder };
}

/** What the decoder makes of a literal, as the package does it. */
function decoded(decoder, literal, shift) {
  const text = new Function(`return ${literal}`)();
  const memory = new WebAssembly.Memory({ initial: Math.ceil((TEXT + 6 * text.length) / 65536) });
  const bytes = new Uint8Array(memory.buffer);
  const start = TEXT + new TextEncoder().encodeInto(text, bytes.subarray(TEXT)).written;
  const { decode } = new WebAssembly.Instance(new WebAssembly.Module(decoder), { "": { memory } }).exports;
  return Buffer.from(bytes.subarray(start, decode(start, shift, start)));
}

/** What stands for the literal while the face is bundled and minified. */
export const PLACEHOLDER = '"@wasm@"';

/** A module that exports `wasmBytes()`, its declarations, and the literal in it. No address: the bytes are there. */
export async function inlineModule(bytes) {
  const { text, shift } = smallestLiteral(splitWasm(bytes));
  const { decoder } = await decoderModule();
  if (!decoded(decoder, text, shift).equals(bytes)) throw new Error("the inlined wasm is not what it was");
  const code = `import { decoded } from "./core/decode.ts";

export const wasmAddress = undefined;

export const wasmBytes = () => decoded(${PLACEHOLDER}, ${shift}, ${bytes.length});
`;
  const declarations = `/** The wasm that is inlined in the package; E_NOT_READY in the slim one. */
export declare function wasmBytes(): Uint8Array<ArrayBuffer>;
/** Where the wasm lies beside the slim package; undefined where it is inside. */
export declare const wasmAddress: (() => URL) | undefined;
`;
  return { code: code.replace(PLACEHOLDER, () => text), declarations, text };
}
