/** The inlined wasm, from text back to bytes. */

/** What the decoder offers. */
interface Decoder {
  /** Turns the first `end` bytes of the memory, UTF-8 of code points below 256, into those less `shift`; how many. */
  decode(end: number, shift: number): number;
}

const PAGE = 65536;

/**
 * The bytes whose text, `shift` added to each, was inlined by the build. A hundred bytes of wasm do it: cold JavaScript takes
 * milliseconds for so long a loop.
 * @internal
 */
export function decoded(text: string, shift: number, decoder: string): Uint8Array<ArrayBuffer> {
  const { Instance, Memory, Module } = WebAssembly;
  // A code point below 256 takes one or two bytes of UTF-8.
  const memory = new Memory({ initial: Math.ceil((2 * text.length) / PAGE) });
  const bytes = new Uint8Array(memory.buffer as ArrayBuffer);
  const { written } = new TextEncoder().encodeInto(text, bytes);
  const module = new Module(Uint8Array.from(decoder, (letter) => letter.charCodeAt(0)));
  const { decode } = new Instance(module, { "": { memory } }).exports as unknown as Decoder;
  return bytes.subarray(0, decode(written, shift));
}
