import { closedByChord, partsOf } from "../../../document/curve/parts.ts";
import type { Contour, CurveDocument } from "../../../document/document.ts";
import { bezierGhost, ellipseOf } from "../overlays/bezier-ghost.ts";
import { curveOf } from "../curve-cache.ts";
import { unitOf } from "../../unit.ts";
import { pathSize } from "./path-size.ts";
import { samplePoints } from "../samples.ts";
import { splineShape } from "../spline-shape.ts";

/** The numbers of the status bar. Each is computed when asked for, once per document. */
export interface Measures {
  readonly points: number;
  readonly contours: number;
  readonly closed: number;
  readonly cusps: number;
  readonly segments: number;
  readonly length: number;
  /** Signed, of the closed contours. */
  readonly area: number;
  /**
   * Characters of the path text at the export dialog's defaults; of long contours, which are printed part by part, up
   * to a few for each part.
   */
  readonly bytes: number;
  /** Some contour is measured in parts. */
  readonly isLong: boolean;
  /** Where one of the first contours is an ellipse: its largest distance from that ellipse, relative to the radius. */
  readonly modelError: number | undefined;
  /** The Bézier's error on the first contour (see `bezierGhost`). */
  readonly bezierError: number | undefined;
  readonly bezierShape: "ellipse" | "handles" | undefined;
}

const known = new WeakMap<CurveDocument, Measures>();

export function measureCurve(document: CurveDocument): Measures {
  const found = known.get(document);
  if (found !== undefined) return found;
  const fresh = lazily(document);
  known.set(document, fresh);
  return fresh;
}

function lazily(document: CurveDocument): Measures {
  const { contours } = document;
  const once = new Map<string, unknown>();
  const keep = <T>(name: string, compute: () => T): T => {
    if (!once.has(name)) once.set(name, compute());
    return once.get(name) as T;
  };
  const parts = (): readonly Contour[] => keep("parts", () => contours.flatMap((contour) => partsOf(document, contour)));
  const sum = (of: (index: number) => number): number => contours.reduce((total, _, index) => total + of(index), 0);
  return {
    get points() { return keep("points", () => sum((i) => contours[i]?.points.length ?? 0)); },
    contours: contours.length,
    closed: contours.filter((contour) => contour.closed).length,
    get cusps() { return keep("cusps", () => sum((i) => contours[i]?.points.filter((point) => point.kind === "cusp").length ?? 0)); },
    get segments() { return sum((i) => { const c = contours[i]; return c === undefined ? 0 : c.closed ? c.points.length : Math.max(0, c.points.length - 1); }); },
    get length() { return keep("length", () => sumOver(parts(), (part) => lengthOfPart(document, part))); },
    get area() { return keep("area", () => sumOver(contours, (contour) => areaOfContour(document, contour))); },
    get bytes() { return keep("bytes", () => sumOver(parts(), (part) => bytesOfPart(document, part))); },
    get isLong() { return parts().length > contours.length; },
    get modelError() { return keep("model", () => ellipseError(document)); },
    get bezierError() { return keep("bezier", () => firstGhost(document)?.error); },
    get bezierShape() { return keep("shape", () => firstGhost(document)?.shape); },
  };
}

type Curve = NonNullable<ReturnType<typeof curveOf>>;

/** What was measured of a curve; while one contour or part of many is dragged, the others keep theirs. */
const measured = new WeakMap<Curve, Map<string, number>>();

function kept(document: CurveDocument, contour: Contour, name: string, measure: (curve: Curve) => number): number {
  const curve = curveOf(document, contour);
  if (curve === null) return 0;
  const known = measured.get(curve) ?? new Map<string, number>();
  measured.set(curve, known);
  const value = known.get(name) ?? measure(curve);
  known.set(name, value);
  return value;
}

function lengthOfPart(document: CurveDocument, part: Contour): number {
  return kept(document, part, "length", (curve) => curve.length());
}

/** Of a contour in parts, what a part encloses with its chord. */
function areaOfPart(document: CurveDocument, contour: Contour, part: Contour): number {
  if (!contour.closed) return 0;
  return kept(document, part, "area", (curve) => (part === contour ? curve.area() : (curveOf(document, closedByChord(part))?.area() ?? 0)));
}

/** Of a contour in parts, as if each were a path of its own that begins where the last one ends. */
function bytesOfPart(document: CurveDocument, part: Contour): number {
  return kept(document, part, "bytes", (curve) => pathSize(curve, unitOf(document)));
}

function areaOfContour(document: CurveDocument, contour: Contour): number {
  const parts = partsOf(document, contour);
  const behindChords = sumOver(parts, (part) => areaOfPart(document, contour, part));
  if (!contour.closed || parts.length === 1) return behindChords;
  return behindChords + sumOver(parts, ({ points }) => {
    const [from, to] = [points[0], points.at(-1)];
    return from === undefined || to === undefined ? 0 : (from.x * to.y - to.x * from.y) / 2;
  });
}

function sumOver<T>(list: readonly T[], measure: (each: T) => number): number {
  return list.reduce((total, each) => total + measure(each), 0);
}

/** An interpolating contour has no parts: of more points than this, the numbers of one take longer than a frame has. */
const mostHere = 4000;

export function isMeasuredElsewhere({ family, points }: Contour): boolean {
  return family === "interpolating" && points.length > mostHere;
}

let underWay: Curve | null = null;

/** In a worker, one curve at a time; where there is none, here. */
function measureElsewhere(document: CurveDocument, contour: Contour, curve: Curve): void {
  if (underWay === curve) return;
  underWay = curve;
  void import("./in-worker.ts").then(({ measureInWorker }) => measureInWorker(splineShape(document, contour))).then(
    (measures) => measured.set(curve, new Map(Object.entries(measures))),
    () => measurePart(document, contour, contour),
  );
}

function measurePart(document: CurveDocument, contour: Contour, part: Contour): void {
  lengthOfPart(document, part);
  areaOfPart(document, contour, part);
  bytesOfPart(document, part);
}

/**
 * Measures length, area and size of a drawing, part by part, until all is known or the time is `spent`; says whether
 * all is. Of 100,000 points it takes seconds the first time, after an edit no more than the changed part.
 */
export function measureUntil(document: CurveDocument, spent: () => boolean): boolean {
  for (const contour of document.contours) {
    for (const part of partsOf(document, contour)) {
      const curve = curveOf(document, part);
      if (curve === null || measured.get(curve)?.has("bytes") === true) continue;
      if (isMeasuredElsewhere(part)) {
        measureElsewhere(document, part, curve);
        return false;
      }
      if (spent()) return false;
      measurePart(document, contour, part);
    }
  }
  return true;
}

function firstGhost(document: CurveDocument): ReturnType<typeof bezierGhost> {
  const first = document.contours[0];
  return first === undefined ? null : bezierGhost(document, first);
}

/**
 * So many contours are looked at for ellipses: enough for a drawing of circles, and bounded while one of thousands is
 * dragged.
 */
const mostMeasured = 16;

/** The worst over the contours that are ellipses; undefined when none is. */
function ellipseError(document: CurveDocument): number | undefined {
  let worst: number | undefined;
  for (const contour of document.contours.slice(0, mostMeasured)) {
    const ellipse = ellipseOf(document, contour);
    if (ellipse === null) continue;
    const { center, radii, rotation } = ellipse;
    const [cos, sin] = [Math.cos(rotation), Math.sin(rotation)];
    const points = samplePoints(document, contour, 512);
    for (let i = 0; i + 1 < points.length; i += 2) {
      const x = (points[i] ?? 0) - center[0];
      const y = (points[i + 1] ?? 0) - center[1];
      const error = Math.abs(Math.hypot((x * cos + y * sin) / radii[0], (y * cos - x * sin) / radii[1]) - 1);
      worst = Math.max(worst ?? 0, error);
    }
  }
  return worst;
}
