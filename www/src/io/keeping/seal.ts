import type { KeptText } from "./database.ts";
import { prefix } from "./store.ts";

/** What the page needs from the start to keep a drawing: `sealed.ts` reads what is written here. */

export interface Unsealed {
  readonly session: string;
  readonly generation: number;
  /** Milliseconds since 1970. */
  readonly time: number;
}

/**
 * FNV-1a over the UTF-16 units: enough to tell a torn or flipped write from a whole one. Goes on with what a text
 * before had.
 */
export function hashed(text: string, before = 0x811c9dc5): number {
  let hash = before;
  for (let i = 0; i < text.length; i += 1) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return hash;
}

export function printed(hash: number): string {
  return (hash >>> 0).toString(16).padStart(8, "0");
}

export function headOf({ generation, time }: Unsealed): string {
  return `${generation} ${time}\n`;
}

/** Two generations of a session take turns, so that a torn write leaves the one before. */
export function keyOf({ session, generation }: Unsealed): string {
  return `${prefix}${session}.${generation % 2}`;
}

export function seal({ json, ...what }: Unsealed & { readonly json: string }): KeptText {
  const body = headOf(what) + json;
  return { key: keyOf(what), text: `${printed(hashed(body))} ${body}` };
}
