/** Knots as people see them: one mark for each place, named after the components that change there. */

export type KnotType = "linear" | "cubic" | "coincident";

export interface ShownKnot {
  /** Which stroke it lies on, and where. */
  readonly stroke: number;
  readonly t: number;
  readonly x: number;
  readonly y: number;
  readonly type: KnotType;
}

/** Two knots whose parameters differ by less than this part of the domain are at one place. */
const together = 1e-9;

/** The knots of one stroke, those at one place joined. They come in the order of t. */
export function shownKnots(
  stroke: number, end: number, knots: readonly { readonly t: number; readonly x: number; readonly y: number; readonly degree: number }[],
): ShownKnot[] {
  const shown: ShownKnot[] = [];
  for (const { t, x, y, degree } of knots) {
    const type: KnotType = degree === 1 ? "linear" : "cubic";
    const last = shown.at(-1);
    if (last !== undefined && t - last.t <= together * end) {
      if (last.type !== type) shown[shown.length - 1] = { ...last, type: "coincident" };
    } else {
      shown.push({ stroke, t, x, y, type });
    }
  }
  return shown;
}

export function countByType(knots: readonly ShownKnot[]): Readonly<Record<KnotType, number>> {
  const counts = { linear: 0, cubic: 0, coincident: 0 };
  for (const { type } of knots) counts[type] += 1;
  return counts;
}
