import { fromJSON, HermiteCurve, type Curve } from "expline/slim";
import { paintOf } from "../../document/painted.ts";
import type { Painted } from "../../document/document.ts";
import type { Pair, Stroke } from "../../document/fit/fit.ts";
import { decimalsIn } from "../../document/unit.ts";
import { pathSize } from "../curve/measuring/path-size.ts";
import type { FitInput, PlainFit } from "./job.ts";
import { countByType, shownKnots, type KnotType, type ShownKnot } from "./knots.ts";

/** What came of a fit, with everything that is drawn and printed of it; computed when asked for, and kept. */

export interface FittedStroke extends Painted {
  readonly curve: Curve;
  readonly parts: readonly Curve[];
  /** The points that it was fitted to. */
  readonly points: Float64Array;
  /** The curve's parameter of each of them. */
  readonly parameters: Float64Array;
}

export interface FitOutcome {
  readonly strokes: readonly FittedStroke[];
  readonly knots: readonly ShownKnot[];
  readonly counts: Readonly<Record<KnotType, number>>;
  /** Document units. */
  readonly rms: number;
  readonly max: number;
  readonly lambda: readonly number[];
  /** 0 … 100: where the slider would be for this λ; null where no λ was involved. */
  readonly smoothing: number | null;
  /** The largest certified gap among the strokes. */
  readonly gap: number;
  /** Points that were fitted, and the diagonal of their box. */
  readonly size: number;
  readonly diagonal: number;
}

export interface ChartPoint {
  readonly smoothing: number;
  readonly knots: number;
  readonly rms: number;
}

/**
 * The strongest smoothing on the chart with such an error; null while the chart says nothing about it. The chart is
 * filled from strong to weak: what has been said once stays true of all of it.
 */
export function smoothingLike(chart: readonly ChartPoint[], rms: number): number | null {
  const at = chart.map((point) => point.rms < rms).lastIndexOf(true);
  const [before, after] = [chart[at], chart[at + 1]];
  if (before === undefined) return after?.smoothing === 0 ? 0 : null;
  if (after === undefined) return before.smoothing;
  return before.smoothing + ((rms - before.rms) / (after.rms - before.rms)) * (after.smoothing - before.smoothing);
}

export function outcomeOf(inputs: readonly Omit<FitInput, "closed">[], fits: readonly PlainFit[]): FitOutcome {
  const strokes = fits.map((fit, i) => ({
    curve: asCurve(fit.curve),
    parts: fit.parts.map(asCurve),
    points: inputs[i]?.points ?? new Float64Array(0),
    parameters: fit.parameters,
    ...paintOf(inputs[i] ?? {}),
  }));
  const knots = fits.flatMap((fit, i) => shownKnots(i, strokes[i]?.curve.domain[1] ?? 1, fit.knots));
  const size = strokes.reduce((sum, { points }) => sum + points.length / 2, 0);
  const squares = fits.reduce((sum, fit, i) => sum + (fit.rms ** 2 * (strokes[i]?.points.length ?? 0)) / 2, 0);
  const first = fits[0];
  return {
    strokes, knots, size,
    counts: countByType(knots),
    rms: Math.sqrt(squares / Math.max(1, size)),
    max: Math.max(0, ...fits.map(({ maxError }) => maxError)),
    lambda: first?.lambda ?? [],
    smoothing: first?.smoothing === undefined ? null : 100 * first.smoothing,
    gap: Math.max(0, ...fits.map(({ gap }) => gap)),
    diagonal: diagonalOf(strokes),
  };
}

function asCurve(value: object): Curve {
  const curve = fromJSON(value);
  if (!(curve instanceof HermiteCurve)) throw new TypeError("a fit of degree 3 is a Hermite curve");
  return curve;
}

function diagonalOf(strokes: readonly FittedStroke[]): number {
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { points } of strokes) {
    for (let i = 0; i + 1 < points.length; i += 2) {
      const [x, y] = [points[i] ?? 0, points[i + 1] ?? 0];
      [minX, minY, maxX, maxY] = [Math.min(minX, x), Math.min(minY, y), Math.max(maxX, x), Math.max(maxY, y)];
    }
  }
  return maxX >= minX ? Math.hypot(maxX - minX, maxY - minY) : 0;
}

const feet = new WeakMap<FittedStroke, Float64Array>();

/** The place on the curve of each point of a stroke. */
export function feetOf(stroke: FittedStroke): Float64Array {
  const known = feet.get(stroke);
  if (known !== undefined) return known;
  const fresh = stroke.curve.evaluate(stroke.parameters);
  feet.set(stroke, fresh);
  return fresh;
}

const placed = new WeakMap<FittedStroke, readonly Curve[]>();

/**
 * The straight part and the smooth part. Only their sum has a place of its own: each is moved to the middle of the
 * curve.
 */
export function partsInPlace(stroke: FittedStroke): readonly Curve[] {
  const known = placed.get(stroke);
  if (known !== undefined) return known;
  const middle = centreOf(stroke.curve);
  const fresh = stroke.parts.map((part) => {
    const { x, y } = centreOf(part);
    return part.transform([1, 0, 0, 1, middle.x - x, middle.y - y]);
  });
  placed.set(stroke, fresh);
  return fresh;
}

function centreOf(curve: Curve): { x: number; y: number } {
  const points = curve.sample(64);
  let [x, y] = [0, 0];
  for (let i = 0; i + 1 < points.length; i += 2) {
    x += points[i] ?? 0;
    y += points[i + 1] ?? 0;
  }
  return { x: (2 * x) / points.length, y: (2 * y) / points.length };
}

const cubics = new WeakMap<Curve, Float64Array>();

/** The curve as cubics, eight numbers each: a fit of degree 3 is those, exactly. */
export function cubicsOfFit(curve: Curve): Float64Array {
  const known = cubics.get(curve);
  if (known !== undefined) return known;
  const [x0, y0, x1, y1] = boxOf(curve);
  const fresh = curve.toCubics(Math.max(1e-9, 1e-7 * Math.hypot(x1 - x0, y1 - y0))).path;
  cubics.set(curve, fresh);
  return fresh;
}

function boxOf(curve: Curve): readonly [number, number, number, number] {
  const { minX, minY, maxX, maxY } = curve.bounds();
  return [minX, minY, maxX, maxY];
}

/** Points at uniform parameters. */
export function sampleFit(outcome: FitOutcome, count: number, stroke: number): Float64Array {
  return outcome.strokes[stroke]?.curve.sample(count) ?? new Float64Array(0);
}

export interface Teeth {
  readonly points: Float64Array;
  readonly tangents: Float64Array;
  readonly curvature: Float64Array;
}

/** Points, tangents and curvatures along a curve, for its comb; 0 where the speed is zero. */
export function teethOf(curve: Curve, count: number): Teeth {
  const [, end] = curve.domain;
  const at = Float64Array.from({ length: count }, (_, i) => (end * (i + 0.5)) / count);
  const points = curve.evaluate(at);
  const tangents = curve.evaluate(at, 1);
  const second = curve.evaluate(at, 2);
  const curvature = at.map((_, i) => {
    const [dx = 0, dy = 0] = tangents.subarray(2 * i, 2 * i + 2);
    const [ddx = 0, ddy = 0] = second.subarray(2 * i, 2 * i + 2);
    const speed = Math.hypot(dx, dy);
    return speed > 0 ? (dx * ddy - dy * ddx) / speed ** 3 : 0;
  });
  return { points, tangents, curvature };
}

const bytes = new WeakMap<FitOutcome, number>();

/** Size of the outcome as path text, in a drawing with this unit. */
export function bytesOfFit(outcome: FitOutcome, unit: number): number {
  const known = bytes.get(outcome);
  if (known !== undefined) return known;
  const fresh = outcome.strokes.reduce((sum, { curve }) => sum + pathSize(curve, unit), 0);
  bytes.set(outcome, fresh);
  return fresh;
}

const raw = new WeakMap<readonly Pair[], number>();

/** Size of the data as a polyline with as many decimals. */
export function bytesOfData(data: readonly Pair[], strokes: readonly Stroke[], unit: number): number {
  const known = raw.get(data);
  if (known !== undefined) return known;
  const digits = (value: number): number => String(Number(value.toFixed(decimalsIn(unit, 3)))).length;
  let fresh = 2 * strokes.length;
  for (const [x, y] of data) fresh += digits(x) + digits(y) + 2;
  raw.set(data, fresh);
  return fresh;
}
