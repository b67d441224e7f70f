import type { DemoState } from "../../document/document.ts";
import { parseState } from "../../document/file/file.ts";
import { remove } from "./database.ts";
import { allKept } from "./keeping.ts";
import { byAge, sessionOf, unseal } from "./sealed.ts";

/** A drawing that was kept. */
export interface Kept {
  readonly state: DemoState;
  /** When it was last changed, in milliseconds since 1970. */
  readonly time: number;
  /** A copy of the same session that cannot be read any more, as it is. */
  readonly damaged?: { readonly text: string; forget(): Promise<void> };
}

/**
 * The newest drawing of which a generation can still be read, of one session before all others; null where there is
 * none.
 */
export async function newestKept(own: string | null): Promise<Kept | null> {
  const all = await allKept();
  const whole = all.flatMap((kept) => unseal(kept) ?? []).sort((a, b) => Number(b.session === own) - Number(a.session === own) || byAge(a, b));
  for (const sealed of whole) {
    const { state } = read(sealed.json) ?? {};
    if (state === undefined) continue;
    const broken = all.find((kept) => sessionOf(kept.key) === sealed.session && kept.key !== sealed.key && unseal(kept) === null);
    const damaged = broken === undefined ? {} : { damaged: { text: broken.text, forget: () => remove([broken.key]) } };
    return { state, time: sealed.time, ...damaged };
  }
  return null;
}

/**
 * Null for what is damaged in a way that the checksum does not see, or from a newer page: another generation serves.
 */
function read(json: string): { readonly state: DemoState } | null {
  try {
    return parseState(json);
  } catch {
    return null;
  }
}
