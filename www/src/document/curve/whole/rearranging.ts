import { domainLength, omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument } from "../../document.ts";
import { kindOf } from "../offset.ts";

/**
 * A contour turned round, opened, closed, begun elsewhere. Nothing here moves the curve unless its name says so.
 */

/**
 * The same contour with every frequency written down, so that opening or closing it does not change what "auto" means.
 */
export function withPinnedOmega(curve: CurveDocument, contour: Contour): Contour {
  if (contour.omega !== undefined || contour.family === "interpolating") return contour;
  const omega: number[] = [];
  for (let segment = 0; segment < segmentCount(contour); segment += 1) omega.push(omegaOf(curve, contour, segment));
  return { ...contour, omega };
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
