import { emptyCurve, type Contour, type CurveDocument } from "../../document/document.ts";
import { paintLayers } from "../../document/paint-layers.ts";
import type { CornerChoice, KeptTrace } from "../../document/trace/trace.ts";
import { withDecided } from "../../document/trace/corners.ts";
import type { TraceResult } from "./job.ts";
import { segmentsIn } from "./segments.ts";

/** What is on the stage of Trace: the picture, its outlines, and what is printed about them. */

export interface ShownPicture {
  readonly key: string;
  readonly name: string;
  /** Of the picture; what is drawn is drawn at this size. */
  readonly width: number;
  readonly height: number;
  readonly analysed: readonly [number, number];
  readonly source: ImageBitmap;
  /** Ink in black, or the steepness of the shades. */
  readonly edges: ImageBitmap;
  readonly threshold: number;
  /** Whether it is drawn in several flat colours, of which ink would be only the dark ones. */
  readonly colored: boolean;
}

export interface TraceOutcome {
  /** The outlines as they were found; a drawing that Export, Fit and Curve take. */
  readonly drawing: CurveDocument;
  readonly holes: readonly boolean[];
  /** The colours, the lowest layer first, and which of them each outline bounds; none where there is only ink. */
  readonly colors: readonly string[];
  readonly layers: readonly number[];
  readonly cubics: readonly Float64Array[];
  /**
   * Root of the mean square and largest of the distances to the sub-pixel edge, pixels of the picture; null without a
   * picture.
   */
  readonly rms: number | null;
  readonly max: number | null;
  /** How far the farthest corner is from that edge: pixels cut sharp corners off. */
  readonly beyond: number | null;
  readonly iou: number | null;
  readonly segments: TraceResult["segments"] | null;
  readonly sizes: TraceResult["sizes"] | null;
  readonly leftOut?: TraceResult["leftOut"];
  readonly stages: TraceResult["stages"];
}

export function outcomeOf({ outlines, colors, segments, iou, beyond, sizes, leftOut, stages }: TraceResult, sample: string | undefined): TraceOutcome {
  const length = outlines.reduce((sum, outline) => sum + outline.length, 0);
  const squares = outlines.reduce((sum, { metrics, length: own }) => sum + metrics.rmse ** 2 * own, 0);
  return {
    drawing: { ...emptyCurve, contours: outlines.map(({ contour }) => contour), ...(sample === undefined ? {} : { sample }) },
    holes: outlines.map(({ hole }) => hole),
    colors,
    layers: outlines.map(({ layer }) => layer),
    cubics: outlines.map(({ cubics }) => cubics),
    rms: length === 0 ? 0 : Math.sqrt(squares / length),
    max: outlines.reduce((most, { metrics }) => Math.max(most, metrics.max), 0),
    segments, iou, beyond, sizes, leftOut, stages,
  };
}

/** Outlines that came without their picture. */
export function outcomeOfKept({ contours }: KeptTrace): TraceOutcome {
  const drawing: CurveDocument = { ...emptyCurve, contours };
  const layers = paintLayers(drawing);
  const isColored = layers.every(({ ink }) => ink !== undefined);
  return {
    drawing, holes: contours.map((contour) => contour.closed && signedArea(contour) < 0),
    colors: isColored ? layers.flatMap(({ ink }) => ink ?? []) : [], layers: isColored ? layers.flatMap((layer, i) => layer.drawing.contours.map(() => i)) : [], cubics: [], rms: null, max: null, beyond: null, iou: null, segments: null, sizes: null, stages: {},
  };
}

/**
 * Twice the area of the polygon of the points and the ends of their handles, as a circle may have two points: its sign
 * tells ink from hole.
 */
function signedArea({ points }: Contour): number {
  const corners = points.flatMap(({ x, y, in: before, out: after }) => [[x + before.dx, y + before.dy], [x, y], [x + after.dx, y + after.dy]] as const);
  return corners.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = corners[(i + 1) % corners.length] ?? [x, y];
    return sum + x * nextY - nextX * y;
  }, 0);
}

/** A drawing's outlines by their colours, the lowest layer first; none where there is only ink. */
export function byColor({ colors, layers, drawing }: TraceOutcome): { readonly color: string; readonly drawing: CurveDocument }[] {
  return colors.map((color, layer) => ({ color, drawing: { ...drawing, contours: drawing.contours.filter((_, i) => layers[i] === layer) } }));
}

/** The outlines of what is in colours, the lowest first, each with its own; of ink as they are. */
export function inkedContours(outcome: TraceOutcome): readonly Contour[] {
  if (outcome.colors.length === 0) return outcome.drawing.contours;
  return byColor(outcome).flatMap(({ color, drawing }) => drawing.contours.map((contour) => ({ ...contour, ink: color })));
}

interface Decided {
  readonly corners: readonly CornerChoice[];
  readonly shown: TraceOutcome;
}

const decided = new WeakMap<TraceOutcome, Decided>();

/**
 * What is shown once corners were decided by hand: the drawing, and of the numbers those that are known of it. Where a
 * corner was smoothed, only the tracer could measure again. Contours of which nothing was decided stay the same
 * objects.
 */
export function shownOutcome(outcome: TraceOutcome, corners: readonly CornerChoice[]): TraceOutcome {
  if (corners.length === 0) return outcome;
  const known = decided.get(outcome);
  if (known?.corners === corners) return known.shown;
  const { drawing } = outcome;
  const contours = drawing.contours.map((contour) => withDecided(contour, corners));
  const still = contours.every((contour, i) => sameCurve(contour, drawing.contours[i]));
  const shown: TraceOutcome = {
    ...outcome, drawing: { ...drawing, contours },
    ...(still ? {} : { cubics: [], segments: outcome.segments === null ? null : segmentsIn(contours), rms: null, max: null, beyond: null, iou: null, sizes: null }),
  };
  decided.set(outcome, { corners, shown });
  return shown;
}

/** Whether one came of the other without a handle being touched. */
function sameCurve(a: Contour, b: Contour | undefined): boolean {
  return a === b || a.points.every((point, i) => point.in === b?.points[i]?.in && point.out === b.points[i]?.out);
}

export interface Corner {
  readonly contour: number;
  readonly index: number;
  readonly x: number;
  readonly y: number;
}

const cornersOf = new WeakMap<CurveDocument, readonly Corner[]>();

/** All corners of a drawing, outline by outline. */
export function cornersIn(drawing: CurveDocument): readonly Corner[] {
  const known = cornersOf.get(drawing);
  if (known !== undefined) return known;
  const fresh = drawing.contours.flatMap(({ points }, contour) => points.flatMap(({ kind, x, y }, index) => (kind === "cusp" ? [{ contour, index, x, y }] : [])));
  cornersOf.set(drawing, fresh);
  return fresh;
}

export function pointCount({ contours }: CurveDocument): number {
  return contours.reduce((sum, { points }) => sum + points.length, 0);
}
