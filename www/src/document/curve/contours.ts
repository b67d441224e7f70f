import {
  domainLength, lengthOf, noOffset, omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument, type Offset,
} from "../document.ts";
import { kindOf, opposite, scaled } from "./offset.ts";

/**
 * Structure of a contour: turned round, opened, closed, begun elsewhere. Nothing here moves the curve unless its name
 * says so.
 */

/** A point without handles. */
export function plainPoint(x: number, y: number): ControlPoint {
  return { x: x + 0, y: y + 0, kind: "smooth", in: noOffset, out: noOffset };
}

/**
 * The same contour with every frequency written down, so that opening or closing it does not change what "auto" means.
 */
export function withPinnedOmega(curve: CurveDocument, contour: Contour): Contour {
  if (contour.omega !== undefined || contour.family === "interpolating") return contour;
  const omega: number[] = [];
  for (let segment = 0; segment < segmentCount(contour); segment += 1) omega.push(omegaOf(curve, contour, segment));
  return { ...contour, omega };
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

function turned(point: ControlPoint): ControlPoint {
  return { ...point, in: point.out, out: point.in };
}

export function reversedContour(contour: Contour): Contour {
  const points = contour.points.map(turned).reverse();
  // A closed contour keeps its first point first: the start marker stays where it is.
  const last = points[points.length - 1];
  const ordered = contour.closed && last !== undefined ? [last, ...points.slice(0, -1)] : points;
  return {
    ...contour,
    points: ordered,
    ...(contour.grid === undefined || !contour.closed ? {} : { grid: { ...contour.grid, offset: 0 - contour.grid.offset } }),
    ...(contour.omega === undefined ? {} : { omega: [...contour.omega].reverse() }),
    ...(contour.lengths === undefined ? {} : { lengths: [...contour.lengths].reverse() }),
  };
}

function rotated<T>(list: readonly T[], first: number): T[] {
  return [...list.slice(first), ...list.slice(0, first)];
}

/** A closed contour counted from another of its points. */
export function startedAt(contour: Contour, index: number): Contour {
  if (!contour.closed || index === 0) return contour;
  return {
    ...contour,
    points: rotated(contour.points, index),
    ...(contour.grid === undefined ? {} : { grid: { ...contour.grid, offset: contour.grid.offset + ((index * contour.grid.step) % 1) } }),
    ...(contour.omega === undefined ? {} : { omega: rotated(contour.omega, index) }),
    ...(contour.lengths === undefined ? {} : { lengths: rotated(contour.lengths, index) }),
  };
}

/** Some consecutive segments of a contour as an open one; `from` and `to` are indices of points, `from < to`. */
export function openPart(contour: Contour, from: number, to: number): Contour {
  const { omega, lengths, ...rest } = contour;
  return {
    ...rest,
    closed: false,
    points: contour.points.slice(from, to + 1),
    ...(omega === undefined ? {} : { omega: omega.slice(from, to) }),
    ...(lengths === undefined ? {} : { lengths: lengths.slice(from, to) }),
  };
}

/** Takes points away and leaves the gaps: what remains are the runs of two points or more between them. */
export function withoutPoints(curve: CurveDocument, contour: Contour, indices: readonly number[]): Contour[] {
  const first = indices[0];
  if (first === undefined) return [contour];
  const pinned = withPinnedOmega(curve, contour);
  const count = pinned.points.length;
  // A closed contour is counted from one of its gaps, so that no run goes over its end.
  const shift = pinned.closed ? first : 0;
  const counted = startedAt(pinned, shift);
  const gone = new Set(indices.map((index) => (index - shift + count) % count));
  const parts: Contour[] = [];
  let from = 0;
  for (let index = 0; index <= count; index += 1) {
    if (index < count && !gone.has(index)) continue;
    if (index - from >= 2) parts.push(openPart(counted, from, index - 1));
    from = index + 1;
  }
  return parts;
}

/** Closes an open contour with one more segment, or drops the last segment of a closed one. */
export function withClosed(curve: CurveDocument, contour: Contour, closed: boolean): Contour {
  if (contour.closed === closed) return contour;
  if (contour.family === "interpolating") return { ...contour, closed };
  const pinned = withPinnedOmega(curve, contour);
  const segments = segmentCount(pinned);
  if (!closed) return openPart(pinned, 0, segments - 1);
  const omega = [...(pinned.omega ?? []), pinned.omega?.[segments - 1] ?? 0];
  const lengths = pinned.lengths === undefined ? undefined : [...pinned.lengths, domainLength(pinned) / Math.max(1, segments)];
  return { ...pinned, closed, omega, ...(lengths === undefined ? {} : { lengths }) };
}

/**
 * An open contour that ends where it began, as many drawings write their outlines, is closed: one point in place of
 * two, with the handles of both. The curve does not move.
 */
export function joined(contour: Contour): Contour {
  const first = contour.points[0];
  const last = contour.points.at(-1);
  if (contour.closed || contour.points.length < 3 || first === undefined || last === undefined) return contour;
  // Relative commands come back to the start with a rounding or two on the way.
  const rounding = 1e-12 * contour.points.reduce((most, { x, y }) => Math.max(most, Math.abs(x), Math.abs(y)), 0);
  if (Math.hypot(first.x - last.x, first.y - last.y) > rounding) return contour;
  const seam = { in: last.in, out: first.out };
  return { ...contour, closed: true, points: [{ ...first, ...seam, kind: kindOf(seam) }, ...contour.points.slice(1, -1)] };
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
