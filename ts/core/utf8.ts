/** Text as bytes and back, also where the host has no `TextEncoder`: jsdom, and with it many a test of a page. */

/**
 * One byte for each character, all of which are below 256 and so much larger than their bytes, around the end.
 * @internal
 */
export function latin(text: string, shift = 0): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(text, (letter) => letter.charCodeAt(0) - shift);
}

/** Text as UTF-8; half a surrogate pair becomes U+FFFD. @internal */
export function utf8(text: string): Uint8Array<ArrayBuffer> {
  if (typeof TextEncoder === "function") return new TextEncoder().encode(text);
  // What escapes a byte each is old, but every host has it.
  return latin(unescape(encodeURIComponent(text.replace(/\p{Cs}/gu, "\ufffd"))));
}

/** What an engine has written: ASCII, all of it. @internal */
export function textOf(bytes: Uint8Array): string {
  if (typeof TextDecoder === "function") return new TextDecoder().decode(bytes);
  return bytes.reduce((text, byte) => text + String.fromCharCode(byte), "");
}
