/** The inlined wasm, from text back to bytes. */
import { SHIFT, STREAMS, decoder } from "../../build/bindings/wasm-decoder.js";
import { latin, utf8 } from "./utf8.js";

/** What the decoder offers; all numbers are places in its memory but `shift`. */
interface Decoder {
  /** Makes bytes of the UTF-8 there, of code points below 256 plus `shift`. */
  plain(from: number, end: number, shift: number): void;
  /** Puts together the streams of a wasm from its own bytes and another's, and returns where they end. */
  fill(own: number, other: number): number;
  /** Writes the wasm from `out` on, and returns where that ends. */
  decode(out: number): number;
}

const PAGE = 65536;

/**
 * The wasm whose text was inlined by the build, with so much room for its streams and itself; what it has in common
 * with another is only in the other's text. A thousand bytes of wasm do it: cold JavaScript takes milliseconds for so
 * long a loop.
 * @internal
 */
export function decoded(room: number, text: string, shift: number, other = "", otherShift = 0): Uint8Array<ArrayBuffer> {
  const { Instance, Memory, Module } = WebAssembly;
  const own = utf8(text);
  const others = utf8(other);
  const from = STREAMS + room;
  const there = from + own.length;
  const end = there + others.length;
  const memory = new Memory({ initial: Math.ceil((end + 1) / PAGE) });
  const bytes = new Uint8Array(memory.buffer as ArrayBuffer);
  bytes.set(own, from);
  bytes.set(others, there);
  const module = new Module(latin(decoder(), SHIFT));
  const { plain, fill, decode } = new Instance(module, { "": { memory } }).exports as unknown as Decoder;
  plain(from, there, shift);
  plain(there, end, otherShift);
  const out = fill(from, there);
  return bytes.subarray(out, decode(out));
}
