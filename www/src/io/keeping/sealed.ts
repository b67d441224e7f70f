import type { KeptText } from "./database.ts";
import { prefix } from "./store.ts";

/**
 * A kept drawing as it is written: which generation of which session it is, when it was made, and a checksum over all
 * of it.
 */
export interface Sealed {
  readonly key: string;
  readonly session: string;
  readonly generation: number;
  /** Milliseconds since 1970. */
  readonly time: number;
  readonly json: string;
}

/**
 * FNV-1a over the UTF-16 units: enough to tell a torn or flipped write from a whole one. Goes on with what a text
 * before had.
 */
function hashed(text: string, before = 0x811c9dc5): number {
  let hash = before;
  for (let i = 0; i < text.length; i += 1) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return hash;
}

function checksum(text: string): string {
  return printed(hashed(text));
}

function printed(hash: number): string {
  return (hash >>> 0).toString(16).padStart(8, "0");
}

export type Unsealed = Omit<Sealed, "key" | "json">;

function headOf({ generation, time }: Unsealed): string {
  return `${generation} ${time}\n`;
}

/** Two generations of a session take turns, so that a torn write leaves the one before. */
function keyOf({ session, generation }: Unsealed): string {
  return `${prefix}${session}.${generation % 2}`;
}

export function seal({ json, ...what }: Omit<Sealed, "key">): KeptText {
  const body = headOf(what) + json;
  return { key: keyOf(what), text: `${checksum(body)} ${body}` };
}

/** The same of a text in pieces: `rest` is waited for between two of them, as often as it likes to be asked. */
export async function sealPieces(what: Unsealed, pieces: Iterable<string>, rest: () => Promise<void> | null): Promise<KeptText> {
  const parts = [headOf(what)];
  let hash = hashed(headOf(what));
  for (const piece of pieces) {
    parts.push(piece);
    hash = hashed(piece, hash);
    await rest();
  }
  return { key: keyOf(what), text: `${printed(hash)} ${parts.join("")}` };
}

/** Of a text that may be damaged: NaN where there is none. */
export function generationOf(text: string): number {
  return Number(text.split(" ", 2)[1]);
}

export function sessionOf(key: string): string {
  return key.slice(prefix.length).split(".")[0] ?? "";
}

/** Null for what is damaged. */
export function unseal({ key, text }: KeptText): Sealed | null {
  const space = text.indexOf(" ");
  const body = text.slice(space + 1);
  if (space !== 8 || checksum(body) !== text.slice(0, space)) return null;
  const line = body.indexOf("\n");
  const [generation, time] = body.slice(0, line).split(" ").map(Number);
  if (generation === undefined || time === undefined) return null;
  return { key, session: sessionOf(key), generation, time, json: body.slice(line + 1) };
}

/** Newest first. */
export function byAge(a: Sealed, b: Sealed): number {
  return b.time - a.time || b.generation - a.generation;
}
