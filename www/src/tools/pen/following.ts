import type { Contour } from "../../document/document.ts";

/**
 * Finds the contour that the pen draws again after changes that are not the pen's: undo, what is deleted, moved or
 * brought in meanwhile.
 */
export class Following {
  /** Every state of the contour that was seen: undo and redo bring them back. Null: nothing is drawn. */
  #seen: WeakSet<Contour> | null = null;

  /** Where it is; null: nowhere. `at` is where it was in `before`, null where it was undone. */
  find(at: number | null, before: readonly Contour[], now: readonly Contour[]): number | null {
    const found = this.#place(at, before, now);
    const contour = found === null ? undefined : now[found];
    if (contour !== undefined) (this.#seen ??= new WeakSet()).add(contour);
    return found;
  }

  forget(): void {
    this.#seen = null;
  }

  #place(at: number | null, before: readonly Contour[], now: readonly Contour[]): number | null {
    const [old, there] = at === null ? [] : [before[at], now[at]];
    // It has just been begun.
    if (at !== null && old === undefined) return at;
    const same = old === undefined ? -1 : now.indexOf(old);
    if (same >= 0) return same;
    // Edits of contours leave them in their places.
    if (old !== undefined && there !== undefined && now.length === before.length && isEdited(old, there)) return at;
    const seen = this.#seen;
    const known = seen === null ? -1 : now.findIndex((contour) => seen.has(contour));
    return known < 0 ? null : known;
  }
}

/** Whether a contour can be what an edit has made of another: it has points of it, or all of them were moved. */
function isEdited({ points: before }: Contour, { points: now }: Contour): boolean {
  return now.length === before.length || now.some((point) => before.includes(point));
}
