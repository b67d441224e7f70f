import type { DemoState } from "../document/document.ts";
import { parseState } from "../document/file.ts";
import { sealedWrites } from "./autosave.ts";

/** A drawing that was kept. */
export interface Kept {
  readonly state: DemoState;
  readonly session: string;
  /** When it was last changed, in milliseconds since 1970. */
  readonly time: number;
}

/** The latest generation of every session that can still be read, newest first. */
export function keptDrawings(storage: Storage | null): Kept[] {
  const latest = new Map<string, Kept & { readonly generation: number }>();
  for (const { session, generation, time, json } of sealedWrites(storage)) {
    const known = latest.get(session);
    if (known !== undefined && known.generation > generation) continue;
    try {
      latest.set(session, { session, generation, time, state: parseState(json).state });
    } catch {
      // Damaged in a way that the checksum does not see, or from a newer page: the other generation serves.
    }
  }
  return [...latest.values()].sort((a, b) => b.time - a.time).map(({ session, time, state }) => ({ session, time, state }));
}
