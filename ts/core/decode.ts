/** The inlined wasm, from text back to bytes. */
import { TEXT, decoder } from "../../build/bindings/wasm-decoder.js";
import { latin, utf8 } from "./utf8.js";

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
  const given = utf8(text);
  const start = TEXT + given.length;
  const memory = new Memory({ initial: Math.ceil((start + size) / PAGE) });
  const bytes = new Uint8Array(memory.buffer as ArrayBuffer);
  bytes.set(given, TEXT);
  const module = new Module(latin(decoder));
  const { decode } = new Instance(module, { "": { memory } }).exports as unknown as Decoder;
  return bytes.subarray(start, decode(start, shift, start));
}
