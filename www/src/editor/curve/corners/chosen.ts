import { arcsAt, isCorner } from "../../../document/curve/corners/corners.ts";
import type { Contour, CurveDocument, Selection } from "../../../document/document.ts";
import type { EditorState } from "../../editor.ts";

/** Which corners are chosen, and how round they are. */

/** How a contour came by arcs in place of corners: as long as it is this contour, they can be given another radius. */
export interface Rounding {
  /** The contour before, and which of its points are the corners. */
  readonly base: Contour;
  readonly corners: readonly number[];
  /** The radius of each corner; 0 of one that could not be rounded. */
  readonly radii: readonly number[];
  /** The first and the last point of each corner's arc; a corner twice. */
  readonly made: readonly (readonly [number, number])[];
}

/**
 * Between lines an arc shows what it was made of. Between curves, and where arcs meet, only this knows; it goes with
 * the contour.
 */
const roundings = new WeakMap<Contour, Rounding>();

export function remember(contour: Contour, rounding: Rounding): void {
  roundings.set(contour, rounding);
}

/** The chosen corners of one contour. */
export interface ChosenCorners {
  readonly contour: number;
  /** Points that are corners. */
  readonly sharp: readonly number[];
  /** Segments that are arcs in place of corners, with their radii. */
  readonly arcs: ReadonlyMap<number, number>;
  /** Where all that is chosen came of one rounding. */
  readonly rounding: Rounding | null;
  readonly isWhole: boolean;
}

/** Of more chosen points than these nobody wants to know which ones are corners with every click. */
const mostLookedAt = 10_000;

let last: { readonly curve: CurveDocument; readonly selection: Selection; readonly found: readonly ChosenCorners[] } | null = null;

export function chosenCorners({ mode, curve, selection }: Pick<EditorState, "mode" | "curve" | "selection">): readonly ChosenCorners[] {
  if (mode !== "curve" || selection.points.length > mostLookedAt) return [];
  // The panel, the stage and the menu ask one after the other.
  if (last?.curve === curve && last.selection === selection) return last.found;
  const chosen = new Map<number, Set<number>>();
  for (const { contour, index } of selection.points) chosen.set(contour, (chosen.get(contour) ?? new Set()).add(index));
  const found = [...chosen].flatMap(([index, points]) => {
    const contour = curve.contours[index];
    const corners = contour === undefined ? null : cornersOf(curve, contour, index, points);
    return corners === null || (corners.sharp.length === 0 && corners.arcs.size === 0 && corners.rounding === null) ? [] : [corners];
  });
  last = { curve, selection, found };
  return found;
}

function cornersOf(curve: CurveDocument, contour: Contour, index: number, points: ReadonlySet<number>): ChosenCorners {
  const rounding = roundings.get(contour) ?? null;
  const own = new Set(rounding?.made.flat());
  const sharp: number[] = [];
  const arcs = new Map<number, number>();
  let isOfRounding = rounding !== null && rounding.made.every(([from, to]) => points.has(from) || points.has(to));
  for (const point of points) {
    const found = arcsAt(curve, contour, point);
    for (const { segment, radius } of found) arcs.set(segment, radius);
    const isSharp = found.length === 0 && isCorner(contour, point);
    if (isSharp) sharp.push(point);
    if ((isSharp || found.length > 0) && !own.has(point)) isOfRounding = false;
  }
  return { contour: index, sharp, arcs, rounding: isOfRounding ? rounding : null, isWhole: points.size === contour.points.length };
}

/** The radii of the chosen corners, 0 of sharp ones. */
export function radiiOf(all: readonly ChosenCorners[]): number[] {
  return all.flatMap(({ sharp, arcs, rounding }) => rounding?.radii ?? [...sharp.map(() => 0), ...arcs.values()]);
}

/** The radius of all chosen corners: `NaN` where they differ, null where none is chosen. */
export function radiusOf(state: Pick<EditorState, "mode" | "curve" | "selection">): number | null {
  const [first, ...others] = radiiOf(chosenCorners(state));
  if (first === undefined) return null;
  return others.every((radius) => Math.abs(radius - first) <= 1e-6 * first) ? first : NaN;
}

/** Whether a corner is chosen that is not round. */
export function hasSharp(state: Pick<EditorState, "mode" | "curve" | "selection">): boolean {
  return chosenCorners(state).some(({ sharp }) => sharp.length > 0);
}
