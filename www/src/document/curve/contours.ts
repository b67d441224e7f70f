import {
  domainLength, lengthOf, noOffset, omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument, type Offset,
} from "../document.ts";
import { opposite, scaled } from "./offset.ts";

/** Contours that were moved, the handles that a point has by itself, and places on a contour. */

/** A point without handles. */
export function plainPoint(x: number, y: number): ControlPoint {
  return { x: x + 0, y: y + 0, kind: "smooth", in: noOffset, out: noOffset };
}

export interface Translation {
  readonly from: Contour;
  readonly dx: number;
  readonly dy: number;
}

/** How contours that were moved as a whole came about: what is known of the old one need not be computed anew. */
const translations = new WeakMap<Contour, Translation>();

/** The contour with every point moved by one step. */
export function translated(from: Contour, dx: number, dy: number): Contour {
  const moved = { ...from, points: from.points.map((point) => ({ ...point, x: point.x + dx, y: point.y + dy })) };
  // Moves of moves count from the first: a chain would keep every place that the contour has ever been.
  const before = translations.get(from);
  return translatedAs(moved, before === undefined ? { from, dx, dy } : { from: before.from, dx: before.dx + dx, dy: before.dy + dy });
}

/** Notes of a contour that it is another one that was moved. */
export function translatedAs(moved: Contour, by: Translation): Contour {
  translations.set(moved, by);
  return moved;
}

export function translationOf(contour: Contour): Translation | undefined {
  return translations.get(contour);
}

/**
 * Handles that need no drawing: along the chord of the two neighbours, as long as makes equally spaced points of an
 * ellipse give that ellipse (ω / (2 sin ω) of the chord; half of it in the cubic limit).
 */
export function automaticHandles(curve: CurveDocument, contour: Contour, index: number): { in: Offset; out: Offset } {
  const { points, closed } = contour;
  const count = points.length;
  const here = points[index];
  const before = points[closed ? (index + count - 1) % count : index - 1];
  const after = points[closed ? (index + 1) % count : index + 1];
  if (here === undefined) return { in: { dx: 0, dy: 0 }, out: { dx: 0, dy: 0 } };
  const omega = omegaOf(curve, contour, Math.min(index, segmentCount(contour) - 1));
  if (closed && count === 2 && after !== undefined) {
    // Two points of a circle: the tangent stands across the diameter.
    const out = { dx: (after.y - here.y) * (Math.PI / 6), dy: (here.x - after.x) * (Math.PI / 6) };
    return { in: opposite(out), out };
  }
  const from = before ?? here;
  const to = after ?? here;
  const span = before === undefined || after === undefined ? 1 : factor(omega);
  const out = scaled({ dx: to.x - from.x, dy: to.y - from.y }, span / 3);
  return { in: opposite(out), out };
}

function factor(omega: number): number {
  // Beyond three quarters of a half-turn the exact length would run away; the cubic one is a sane stand-in.
  if (omega > 2.4) return 0.5;
  return omega < 1e-6 ? 0.5 : omega / (2 * Math.sin(omega));
}

/** The segment that holds `t`, and where in it, 0 … 1. */
export function locate(contour: Contour, t: number): { segment: number; x: number } {
  const last = segmentCount(contour) - 1;
  let rest = contour.closed ? wrap(t, domainLength(contour)) : t;
  for (let segment = 0; segment < last; segment += 1) {
    const length = lengthOf(contour, segment);
    if (rest < length) return { segment, x: rest / length };
    rest -= length;
  }
  return { segment: last, x: Math.min(1, rest / lengthOf(contour, last)) };
}

function wrap(t: number, period: number): number {
  const rest = t % period;
  return rest < 0 ? rest + period : rest;
}
