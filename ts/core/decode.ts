/** The inlined wasm, from text back to bytes. */
import { TEXT, decoder } from "../../build/bindings/wasm-decoder.js";

/** What the decoder offers. */
interface Decoder {
  /** Reads the UTF-8 that ends there, of code points below 256 plus `shift`, writes the wasm from `out` on, and returns where that ends. */
  decode(end: number, shift: number, out: number): number;
}

const PAGE = 65536;

/**
 * The wasm of so many bytes whose text was inlined by the build. A few hundred bytes of wasm do it: cold JavaScript takes
 * milliseconds for so long a loop.
 * @internal
 */
export function decoded(text: string, shift: number, size: number): Uint8Array<ArrayBuffer> {
  const { Instance, Memory, Module } = WebAssembly;
  // A code point below 256 takes one or two bytes of UTF-8.
  const memory = new Memory({ initial: Math.ceil((TEXT + 2 * text.length + size) / PAGE) });
  const bytes = new Uint8Array(memory.buffer as ArrayBuffer);
  const start = TEXT + new TextEncoder().encodeInto(text, bytes.subarray(TEXT)).written;
  const module = new Module(Uint8Array.from(decoder, (letter) => letter.charCodeAt(0)));
  const { decode } = new Instance(module, { "": { memory } }).exports as unknown as Decoder;
  return bytes.subarray(start, decode(start, shift, start));
}
