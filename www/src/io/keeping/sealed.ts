import type { KeptText } from "./database.ts";
import { hashed, headOf, keyOf, printed, type Unsealed } from "./seal.ts";
import { prefix } from "./store.ts";

/**
 * A kept drawing as it is written: which generation of which session it is, when it was made, and a checksum over all
 * of it.
 */
export interface Sealed extends Unsealed {
  readonly key: string;
  readonly json: string;
}

/**
 * What `seal` makes, of a text in pieces: `rest` is waited for between two of them, as often as it likes to be asked.
 */
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
  if (space !== 8 || printed(hashed(body)) !== text.slice(0, space)) return null;
  const line = body.indexOf("\n");
  const [generation, time] = body.slice(0, line).split(" ").map(Number);
  if (generation === undefined || time === undefined) return null;
  return { key, session: sessionOf(key), generation, time, json: body.slice(line + 1) };
}

/** Newest first. */
export function byAge(a: Sealed, b: Sealed): number {
  return b.time - a.time || b.generation - a.generation;
}
