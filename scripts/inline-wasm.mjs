// The wasm as text inside JavaScript, so that the package starts with no await and no second request.
//
// The wasm is sorted into streams first (split-wasm.mjs), and what the core's streams have too is copied from there
// (copy-runs.mjs). Then, one character per byte, the frequent bytes become the code points that UTF-8 writes as one
// byte, the others those of two. That compresses to a few per cent more than the bytes themselves, where base64 costs a
// third. Which code point is the first, and the quote, are those for which the text is smallest after gzip.

import { gzipSync } from "node:zlib";

import { withRuns } from "./copy-runs.mjs";
import { FREQUENT, STREAMS, decoderBytes } from "./decoder.mjs";
import { withNumberedLocals } from "./number-locals.mjs";
import { splitWasm } from "./split-wasm.mjs";

const QUOTES = ['"', "'", "`"];
/** So many shifts, those of the shortest texts, are tried with gzip; the best is always among the first few. */
const TRIED = 8;
/** The shortest runs that are worth copying from the core: the best is taken. */
const SHORTEST_RUNS = [16, 20, 24, 32];

/** How a code point is written inside the given quotes. */
function written(code, quote) {
  const character = String.fromCharCode(code);
  if (code === 0) return "\\x00"; // legal in a literal, but makes tools take the file for a binary one
  if (code === 13) return "\\r";
  if (code === 10 && quote !== "`") return "\\n";
  if (character === "\\" || character === quote || (character === "$" && quote === "`")) return `\\${character}`;
  return character;
}

/** The code point of each byte, as the decoder reads them: from which on the frequent ones are. */
function codesFrom(shift) {
  const isFrequent = (byte) => byte < FREQUENT || byte % 8 === 0;
  let [frequent, other] = [shift, 128];
  return Array.from({ length: 256 }, (_, byte) => (isFrequent(byte) ? frequent++ % 128 : other++));
}

/** Those of the decoder itself, which JavaScript reads. */
const codesAfter = (shift) => Array.from({ length: 256 }, (_, byte) => (byte + shift) & 255);

/** The smallest literal of the bytes, and the shift that it was made with, of so many that are tried with gzip. */
function smallestLiteral(bytes, codes, tried) {
  const counts = new Float64Array(256);
  for (const byte of bytes) counts[byte] += 1;
  const candidates = [];
  for (let shift = 0; shift < 256; shift++) {
    for (const quote of QUOTES) {
      const letters = codes(shift).map((code) => written(code, quote));
      const length = letters.reduce((sum, letter, byte) => sum + counts[byte] * Buffer.byteLength(letter), 0);
      candidates.push({ shift, quote, letters, length });
    }
  }
  candidates.sort((a, b) => a.length - b.length);
  let best = { text: "", shift: 0, size: Number.POSITIVE_INFINITY };
  for (const { shift, quote, letters } of candidates.slice(0, tried)) {
    const text = quote + Array.from(bytes, (byte) => letters[byte]).join("") + quote;
    if (/<\/script|<!--/i.test(text)) continue; // a page may carry the module inside a script element
    const size = gzipSync(text, { level: 9 }).length;
    if (size < best.size) best = { text, shift, size };
  }
  if (best.text === "") throw new Error("every literal would end a script element");
  return best;
}

/**
 * The names of the literals, which come before or behind all of a module's code: between the code that uses them they
 * would be longer, because gzip makes a code for sixteen thousand symbols at a time, whatever they are. No bundler sees
 * them.
 */
export const TEXT = "$w";
export const DECODER_TEXT = "$d";

/** The module with the decoder's bytes, one character each, and its literal. */
export async function decoderModule() {
  const { text, shift } = smallestLiteral(await decoderBytes(), codesAfter, Number.POSITIVE_INFINITY);
  const code = `export const decoder = () => ${DECODER_TEXT};\nexport const SHIFT = ${shift};\nexport const STREAMS = ${STREAMS};\n`;
  const declarations = `/** The wasm that reads inlined wasm, one character each byte. */
export declare function decoder(): string;
/** How much larger its characters are than its bytes. */
export declare const SHIFT: number;
/** Where it puts together the streams of a wasm. */
export declare const STREAMS: number;
`;
  return { code, declarations, text };
}

/** What the decoder makes of a literal, as the package does it. */
function decoded(decoder, { text, shift, room }, other = { text: "''", shift: 0 }) {
  const utf8 = (literal) => new TextEncoder().encode(new Function(`return ${literal}`)());
  const [own, others] = [utf8(text), utf8(other.text)];
  const from = STREAMS + room;
  const there = from + own.length;
  const memory = new WebAssembly.Memory({ initial: Math.ceil((there + others.length + 1) / 65536) });
  const bytes = new Uint8Array(memory.buffer);
  bytes.set(own, from);
  bytes.set(others, there);
  const { plain, fill, decode } = new WebAssembly.Instance(new WebAssembly.Module(decoder), { "": { memory } }).exports;
  plain(from, there, shift);
  plain(there, there + others.length, other.shift);
  const out = fill(from, there);
  return Buffer.from(bytes.subarray(out, decode(out)));
}

/**
 * A wasm as it is inlined: its literal and the literal's shift, the room for its streams and itself, and what another
 * can copy from it: its bytes and the kinds of operations in it. `core` is the core's; of the core it is undefined.
 */
export async function inlined(wasm, core) {
  const numbered = withNumberedLocals(wasm);
  const { bytes: streams, kinds } = splitWasm(numbered, core?.kinds);
  const size = (bytes) => gzipSync(bytes, { level: 9 }).length;
  const candidates = core === undefined ? [withRuns(streams, [], 1)] : SHORTEST_RUNS.map((shortest) => withRuns(streams, core.bytes, shortest));
  const bytes = candidates.reduce((best, next) => (size(next) < size(best) ? next : best));
  const made = { ...smallestLiteral(bytes, codesFrom, TRIED), room: streams.length + numbered.length, bytes, kinds };
  if (!decoded(await decoderBytes(), made, core).equals(Buffer.from(numbered))) throw new Error("the inlined wasm is not what it was");
  return made;
}

/**
 * The core's module: exports `wasmBytes()`, and what those of the others read theirs with. No address: the bytes are
 * there.
 */
const coreModule = ({ shift, room }) => `import { decoded } from "./core/decode.ts";

export const wasmAddress = undefined;
export const wasmBytes = () => decoded(${room}, ${TEXT}, ${shift});
export const besideCore = (room, own, shift) => decoded(room, own, shift, ${TEXT}, ${shift});
`;

const otherModule = ({ shift, room }) => `import { besideCore } from "./core.js";

export const wasmAddress = undefined;
export const wasmBytes = () => besideCore(${room}, ${TEXT}, ${shift});
`;

const DECLARATIONS = `/** The wasm that is inlined in the package; E_NOT_READY in the slim one. */
export declare function wasmBytes(): Uint8Array<ArrayBuffer>;
/** Where the wasm lies beside the slim package; undefined where it is inside. */
export declare const wasmAddress: (() => URL) | undefined;
`;
const OF_CORE = `/** The inlined wasm of another kind of work, from its text, with what it has in common with the core's. */
export declare function besideCore(room: number, text: string, shift: number): Uint8Array<ArrayBuffer>;
`;

/** The module of an inlined wasm, and its declarations. */
export function inlineModule(made, isCore) {
  return isCore ? { code: coreModule(made), declarations: DECLARATIONS + OF_CORE } : { code: otherModule(made), declarations: DECLARATIONS };
}
