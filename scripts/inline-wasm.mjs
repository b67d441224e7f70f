// The wasm as text inside JavaScript, so that the package starts with no await and no second request.
//
// One character per byte: byte b becomes the code point (b + shift) mod 256. In UTF-8 that compresses to a few per
// cent more than the wasm itself, where base64 costs a third. The shift is the one for which the text is
// smallest after gzip, the quote the one that needs the fewest escapes.

import { gzipSync } from "node:zlib";

const QUOTES = ['"', "'", "`"];

function literal(bytes, shift, quote) {
  let text = quote;
  for (let i = 0; i < bytes.length; i++) {
    const code = (bytes[i] + shift) & 255;
    const character = String.fromCharCode(code);
    if (code === 0) text += "\\x00"; // legal in a literal, but makes tools take the file for a binary one
    else if (code === 13) text += "\\r";
    else if (code === 10 && quote !== "`") text += "\\n";
    else if (character === "\\" || character === quote) text += `\\${character}`;
    else if (character === "$" && quote === "`") text += "\\$";
    else text += character;
  }
  return text + quote;
}

/** The smallest literal of the bytes, and the shift that it was made with. */
export function smallestLiteral(bytes) {
  let best = { text: "", shift: 0, size: Number.POSITIVE_INFINITY };
  for (let shift = 0; shift < 256; shift++) {
    const [text] = QUOTES.map((quote) => literal(bytes, shift, quote)).sort((a, b) => a.length - b.length);
    if (/<\/script|<!--/i.test(text)) continue; // a page may carry the module inside a script element
    const size = gzipSync(text, { level: 6 }).length;
    if (size < best.size) best = { text, shift, size };
  }
  return best;
}

/** What stands for the literal while the face is bundled and minified. */
export const PLACEHOLDER = '"@wasm@"';

/** A module that exports `wasmBytes()`, its declarations, and the literal in it. No address: the bytes are there. */
export function inlineModule(bytes) {
  const { text, shift } = smallestLiteral(bytes);
  const code = `const text = ${PLACEHOLDER};

export const wasmAddress = undefined;

export function wasmBytes() {
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = text.charCodeAt(i) - ${shift};
  return bytes;
}
`;
  const declarations = `/** The wasm that is inlined in the package; E_NOT_READY in the slim one. */
export declare function wasmBytes(): Uint8Array<ArrayBuffer>;
/** Where the wasm lies beside the slim package; undefined where it is inside. */
export declare const wasmAddress: (() => URL) | undefined;
`;
  return { code: code.replace(PLACEHOLDER, () => text), declarations, text };
}
