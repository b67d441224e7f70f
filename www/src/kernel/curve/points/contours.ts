import type { HermiteCurve } from "expline/slim";
import { domainLength, lengthOf, omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument, type Space } from "../../../document/document.ts";
import { locate } from "../../../document/curve/contours.ts";
import { kindOf, scaled } from "../../../document/curve/offset.ts";
import { stretchAround } from "../../../document/curve/stretch.ts";
import { arraysOf, pointOf } from "./control-points.ts";
import { curveOf, hermiteOf } from "../curve-cache.ts";
import { isOrdinary } from "../refining.ts";
import { within } from "../samples.ts";

/**
 * Edits that need the curve itself: exact insertion, healing removal, other numbers of points, and reading curves back
 * as contours.
 */

/**
 * A library curve as a contour of the document, with every frequency and length written down where it is not the
 * ordinary one.
 */
export function contourFrom(curve: HermiteCurve, space: Space): Contour {
  const { points, lengths } = arraysOf(curve);
  const count = points.length / 2;
  const segments = lengths.length;
  const length = (segment: number): number => lengths[segment] ?? 1;
  const list = Array.from({ length: count }, (_, i) => {
    const before = curve.closed ? length((i + segments - 1) % segments) : length(Math.max(0, i - 1));
    const after = length(Math.min(i, segments - 1));
    return pointOf(curve, i, before, after);
  });
  return {
    family: "hermite",
    closed: curve.closed,
    points: list.map((point, i) => (curve.closed || (i > 0 && i < count - 1) ? point : asEnd(point, i === 0))),
    support: 1,
    omega: Array.from(curve.omega),
    ...(lengths.every((value) => value === 1) ? {} : { lengths: Array.from(lengths) }),
    ...(curve.space === space ? {} : { space: curve.space }),
  };
}

/**
 * The free side of an open end has no handle of its own to read: it mirrors the other, ready for the contour to go on.
 */
function asEnd(point: ControlPoint, first: boolean): ControlPoint {
  const used = first ? point.out : point.in;
  const mirror = { dx: 0 - used.dx, dy: 0 - used.dy };
  return { ...point, kind: "symmetric", in: first ? mirror : used, out: first ? used : mirror };
}

function spliced(list: readonly number[], at: number, remove: number, ...add: number[]): number[] {
  return [...list.slice(0, at), ...add, ...list.slice(at + remove)];
}

/** The same curve with one more point, at parameter `t`. Every other point keeps its bits. */
export function inserted(document: CurveDocument, contour: Contour, t: number): { contour: Contour; index: number } | null {
  const curve = hermiteOf(document, contour);
  if (curve === null) return null;
  const { segment, x } = locate(contour, t);
  // On a point there is nothing to insert.
  if (!(x > 1e-9 && x < 1 - 1e-9)) return null;
  const length = lengthOf(contour, segment);
  const index = segment + 1;
  const fresh = pointOf(curve.insert(t), index, length * x, length * (1 - x));
  const count = contour.points.length;
  const points = contour.points.map((point, i) => {
    let shorter = point;
    if (i === segment) shorter = { ...shorter, out: scaled(shorter.out, x) };
    if (i === index % count) shorter = { ...shorter, in: scaled(shorter.in, 1 - x) };
    // A shorter handle on one side is no longer symmetric, but still one smooth line.
    return shorter !== point && shorter.kind === "symmetric" ? { ...shorter, kind: kindOf(shorter) === "cusp" ? "symmetric" as const : kindOf(shorter) } : shorter;
  });
  points.splice(index, 0, fresh);
  const lengths = Array.from({ length: segmentCount(contour) }, (_, s) => lengthOf(contour, s));
  return {
    index,
    contour: {
      ...contour,
      points,
      lengths: spliced(lengths, segment, 1, length * x, length - length * x),
      ...(contour.omega === undefined ? {} : { omega: spliced(contour.omega, segment, 1, contour.omega[segment] ?? 0, contour.omega[segment] ?? 0) }),
    },
  };
}

/**
 * The contour without one point, its neighbours' handles chosen anew for the least change of shape; with the change
 * measured.
 */
export function healed(document: CurveDocument, contour: Contour, index: number): { contour: Contour; deviation: number } | null {
  if (contour.points.length < 3) return null;
  // Two segments become one: of a contour of very many nothing else is looked at.
  const near = stretchAround(document, contour, index);
  const result = hermiteOf(document, near.contour)?.remove(near.index);
  if (result === undefined) return null;
  const read = contourFrom(result.curve, contour.space ?? document.space);
  const points = contour.points.filter((_, i) => i !== index);
  const [count, segments] = [points.length, segmentCount(contour)];
  // An end of an open contour leaves no gap: its segment goes with it and nothing is joined.
  const isEnd = !contour.closed && (index === 0 || index === count);
  const [before, after] = [(index + count - 1) % count, index % count];
  const joined = (at: number, fresh: Partial<ControlPoint>): void => {
    const point = points[at];
    if (point === undefined) return;
    const next = { ...point, ...fresh };
    points[at] = { ...next, kind: point.kind === "cusp" ? "cusp" as const : kindOf(next) };
  };
  const [left, right] = [read.points[near.index - 1], read.points[near.index]];
  if (!isEnd && left !== undefined && right !== undefined) {
    joined(before, { out: left.out });
    joined(after, { in: right.in });
  }
  const gone = isEnd && index > 0 ? index - 1 : index;
  const [old, merged] = [(index + segments - 1) % segments, near.index - 1];
  const shortened = (of: (segment: number) => number, fresh: number): number[] => {
    const list = Array.from({ length: segments }, (_, segment) => of(segment));
    if (!isEnd) list[old] = fresh;
    return spliced(list, gone, 1);
  };
  const lengths = shortened((segment) => lengthOf(contour, segment), read.lengths?.[merged] ?? 1);
  const { omega: own, lengths: _lengths, ...rest } = contour;
  const plain: Contour = { ...rest, points, ...(lengths.every((length) => length === 1) ? {} : { lengths }) };
  // The healed segment may have a frequency of its own; then all of them are written down.
  const omega = isEnd ? 0 : read.omega?.[merged] ?? 0;
  const follows = isEnd || Math.abs(omega - omegaOf(document, plain, before)) <= 1e-12 * Math.abs(omega);
  if (own === undefined && follows) return { deviation: result.maxError, contour: plain };
  return { deviation: result.maxError, contour: { ...plain, omega: shortened((segment) => omegaOf(document, contour, segment), omega) } };
}

/** `count` points at equal parameter distance. Exact where the frequency is one for all. */
export function resampled(document: CurveDocument, contour: Contour, count: number): Contour {
  const curve = curveOf(document, contour);
  if (curve === null) return contour;
  const period = domainLength(contour);
  const segments = contour.closed ? count : count - 1;
  const step = period / segments;
  const t = within(curve, Float64Array.from({ length: count }, (_, i) => (i === segments ? period : i * step)));
  const places = curve.evaluate(t);
  const tangents = curve.evaluate(t, 1);
  const points = Array.from({ length: count }, (_, i) => {
    const out = { dx: ((tangents[2 * i] ?? 0) * step) / 3, dy: ((tangents[2 * i + 1] ?? 0) * step) / 3 };
    const fresh: ControlPoint = {
      x: places[2 * i] ?? 0, y: places[2 * i + 1] ?? 0, kind: "symmetric", in: { dx: 0 - out.dx, dy: 0 - out.dy }, out,
    };
    return atOldPoint(contour, t[i] ?? 0, step) ?? fresh;
  });
  const { omega: own, lengths: _lengths, ...rest } = contour;
  const even = isOrdinary(document, contour) || step === 1 ? {} : { lengths: Array.from({ length: segments }, () => step) };
  const mean = own === undefined ? undefined : weightedMean(contour, own);
  return { ...rest, points, ...even, ...(mean === undefined ? {} : { omega: Array.from({ length: segments }, () => mean) }) };
}

function weightedMean(contour: Contour, omega: readonly number[]): number {
  return omega.reduce((sum, value, segment) => sum + value * lengthOf(contour, segment), 0) / domainLength(contour);
}

/** A new point that falls on an old one keeps its two sides: corners stay corners. */
function atOldPoint(contour: Contour, t: number, step: number): ControlPoint | null {
  const { segment, x } = locate(contour, t);
  if (x > 1e-9 && x < 1 - 1e-9) return null;
  const index = (segment + (x > 0.5 ? 1 : 0)) % contour.points.length;
  const point = contour.points[index];
  if (point === undefined) return null;
  const segments = segmentCount(contour);
  const { level: _level, ...plain } = point;
  const before = lengthOf(contour, contour.closed ? (index + segments - 1) % segments : Math.max(0, index - 1));
  return { ...plain, in: scaled(point.in, step / before), out: scaled(point.out, step / lengthOf(contour, Math.min(index, segments - 1))) };
}
