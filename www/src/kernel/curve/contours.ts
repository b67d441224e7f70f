import { parsePath, tangentWeights, type HermiteCurve } from "expline/slim";
import {
  domainLength, lengthOf, noOffset, omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument, type Space,
} from "../../document/document.ts";
import { locate } from "../../document/curve/contours.ts";
import { kindOf, scaled } from "../../document/curve/offset.ts";
import { curveOf, hermiteOf } from "./curve-cache.ts";

/** Edits that need the curve itself: exact insertion, healing removal, refinement, and reading curves back as contours. */

function pointOf(curve: HermiteCurve, i: number, before: number, after: number): ControlPoint {
  const { points, tangents, tangentsIn } = arraysOf(curve);
  const at = (list: Float64Array, k: number): number => list[k] ?? 0;
  const handles = {
    in: { dx: (-at(tangentsIn, 2 * i) * before) / 3, dy: (-at(tangentsIn, 2 * i + 1) * before) / 3 },
    out: { dx: (at(tangents, 2 * i) * after) / 3, dy: (at(tangents, 2 * i + 1) * after) / 3 },
  };
  const clean = { in: withoutNegativeZero(handles.in), out: withoutNegativeZero(handles.out) };
  return { x: at(points, 2 * i), y: at(points, 2 * i + 1), kind: kindOf(clean), ...clean };
}

function withoutNegativeZero(offset: { dx: number; dy: number }): { dx: number; dy: number } {
  return { dx: offset.dx + 0, dy: offset.dy + 0 };
}

interface Arrays {
  readonly points: Float64Array;
  readonly tangents: Float64Array;
  readonly tangentsIn: Float64Array;
  readonly lengths: Float64Array;
}

const arrays = new WeakMap<HermiteCurve, Arrays>();

/** The curve's arrays; its getters copy, so they are asked once. */
function arraysOf(curve: HermiteCurve): Arrays {
  const known = arrays.get(curve);
  if (known !== undefined) return known;
  const fresh = { points: curve.points, tangents: curve.tangents, tangentsIn: curve.tangentsIn, lengths: curve.lengths };
  arrays.set(curve, fresh);
  return fresh;
}

/** A library curve as a contour of the document, with every frequency and length written down where it is not the ordinary one. */
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

/** The free side of an open end has no handle of its own to read: it mirrors the other, ready for the contour to go on. */
function asEnd(point: ControlPoint, first: boolean): ControlPoint {
  const used = first ? point.out : point.in;
  const mirror = { dx: 0 - used.dx, dy: 0 - used.dy };
  return { ...point, kind: "symmetric", in: first ? mirror : used, out: first ? used : mirror };
}

/** Contours of a path's `d`; throws `ExplineError` with the place where it stops making sense. */
export function contoursOfPath(d: string, space: Space): Contour[] {
  return parsePath(d).map((curve) => contourFrom(curve, space));
}

/** How far the place at `x` of a segment goes with a step of one of its leaving handle, and with one of its arriving handle. */
export function handleWeights(document: CurveDocument, contour: Contour, segment: number, x: number): readonly [number, number] {
  const curve = hermiteOf(document, contour);
  if (curve === null) return [0, 0];
  let start = 0;
  for (let i = 0; i < segment; i += 1) start += lengthOf(contour, i);
  const length = lengthOf(contour, segment);
  const [leaving, arriving] = tangentWeights(curve, start + x * length);
  // A handle is a third of its tangent over the length of the segment, and the arriving one points back.
  return [(3 * leaving) / length, (-3 * arriving) / length];
}

/** How far the place at `x` of a segment goes with a step of the point before it, and with one of the point behind it. */
export function pointWeights(document: CurveDocument, contour: Contour, segment: number, x: number): readonly [number, number] {
  const [from, to] = [segment, (segment + 1) % contour.points.length];
  // A curve is linear in its points: one that is nothing but a unit of one in x and of the other in y shows what each of them weighs.
  const probe = contour.points.map((point, i) => ({ ...point, x: i === from ? 1 : 0, y: i === to ? 1 : 0, in: noOffset, out: noOffset }));
  const curve = hermiteOf(document, { ...contour, points: probe });
  if (curve === null) return [0, 0];
  let start = 0;
  for (let i = 0; i < segment; i += 1) start += lengthOf(contour, i);
  const [before = 0, behind = 0] = curve.evaluate(start + x * lengthOf(contour, segment));
  return [before, behind];
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

/** The contour without one point, its neighbours' handles chosen anew for the least change of shape; with the change measured. */
export function healed(document: CurveDocument, contour: Contour, index: number): { contour: Contour; deviation: number } | null {
  const curve = hermiteOf(document, contour);
  if (curve === null || contour.points.length < 3) return null;
  const result = curve.remove(index);
  const space = contour.space ?? document.space;
  const read = contourFrom(result.curve, space);
  const untouched = contour.points.filter((_, i) => i !== index);
  const count = untouched.length;
  // An end of an open contour leaves no gap: its segment goes with it and nothing is joined.
  const isEnd = !contour.closed && (index === 0 || index === count);
  const before = isEnd ? -1 : (index + count - 1) % count;
  const after = isEnd ? -1 : index % count;
  const points = untouched.map((point, i) => {
    const fresh = read.points[i];
    if (fresh === undefined) return point;
    let joined = point;
    if (i === before) joined = { ...joined, out: fresh.out };
    if (i === after) joined = { ...joined, in: fresh.in };
    return joined === point ? point : { ...joined, kind: point.kind === "cusp" ? "cusp" as const : kindOf(joined) };
  });
  const { omega: own, lengths: _lengths, ...rest } = contour;
  const plain: Contour = { ...rest, points, ...(read.lengths === undefined ? {} : { lengths: read.lengths }) };
  // The healed segment may have a frequency of its own; then all of them are written down.
  const follows = (read.omega ?? []).every((omega, segment) => Math.abs(omega - omegaOf(document, plain, segment)) <= 1e-12 * Math.abs(omega));
  return { deviation: result.maxError, contour: own === undefined && follows ? plain : { ...plain, omega: read.omega ?? [] } };
}

function isOrdinary(document: CurveDocument, contour: Contour): boolean {
  return document.omega === "auto" && contour.omega === undefined && contour.lengths === undefined;
}

/** The same curve with twice the points; the new ones remember the level that made them. */
export function refined(document: CurveDocument, contour: Contour, level: number): Contour {
  const curve = hermiteOf(document, contour);
  if (curve === null) return contour;
  const finer = curve.refine(2);
  const segments = segmentCount(contour);
  const points: ControlPoint[] = [];
  contour.points.forEach((point, i) => {
    points.push({ ...point, in: scaled(point.in, 0.5), out: scaled(point.out, 0.5) });
    if (i < segments) {
      const half = lengthOf(contour, i) / 2;
      points.push({ ...pointOf(finer, 2 * i + 1, half, half), level });
    }
  });
  // Where the frequency follows from the whole, lengths of 1 serve the finer contour as well.
  if (isOrdinary(document, contour)) return { ...contour, points };
  const lengths: number[] = [];
  const omega: number[] = [];
  for (let segment = 0; segment < segments; segment += 1) {
    const half = lengthOf(contour, segment) / 2;
    lengths.push(half, half);
    omega.push(omegaOf(document, contour, segment), omegaOf(document, contour, segment));
  }
  return { ...contour, points, lengths, ...(contour.omega === undefined ? {} : { omega }) };
}

/** `count` points at equal parameter distance. Exact where the frequency is one for all. */
export function resampled(document: CurveDocument, contour: Contour, count: number): Contour {
  const curve = curveOf(document, contour);
  if (curve === null) return contour;
  const period = domainLength(contour);
  const segments = contour.closed ? count : count - 1;
  const step = period / segments;
  const t = Float64Array.from({ length: count }, (_, i) => (i === segments ? period : i * step));
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
