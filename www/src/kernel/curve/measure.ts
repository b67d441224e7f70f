import type { CurveDocument } from "../../document/document.ts";
import { bezierGhost, ellipseOf } from "./bezier-ghost.ts";
import { curveOf } from "./curve-cache.ts";
import { samplePoints } from "./samples.ts";

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
  /** Characters of the path text at the export dialog's defaults. */
  readonly bytes: number;
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
  const sum = (of: (index: number) => number): number => contours.reduce((total, _, index) => total + of(index), 0);
  return {
    get points() { return sum((i) => contours[i]?.points.length ?? 0); },
    contours: contours.length,
    closed: contours.filter((contour) => contour.closed).length,
    get cusps() { return sum((i) => contours[i]?.points.filter((point) => point.kind === "cusp").length ?? 0); },
    get segments() { return sum((i) => { const c = contours[i]; return c === undefined ? 0 : c.closed ? c.points.length : Math.max(0, c.points.length - 1); }); },
    get length() { return keep("length", () => sumOver(document, "length", (curve) => curve.length())); },
    get area() { return keep("area", () => sumOver(document, "area", (curve) => (curve.closed ? curve.area() : 0))); },
    get bytes() { return keep("bytes", () => sumOver(document, "bytes", (curve) => curve.toPathD({ tolerance: 0.02, decimals: 3 }).d.length)); },
    get modelError() { return keep("model", () => ellipseError(document)); },
    get bezierError() { return keep("bezier", () => firstGhost(document)?.error); },
    get bezierShape() { return keep("shape", () => firstGhost(document)?.shape); },
  };
}

type Curve = NonNullable<ReturnType<typeof curveOf>>;

/** What was measured of a curve; while one contour of many is dragged, the others keep theirs. */
const measured = new WeakMap<Curve, Map<string, number>>();

function sumOver(document: CurveDocument, name: string, measure: (curve: Curve) => number): number {
  let total = 0;
  for (const contour of document.contours) {
    const curve = curveOf(document, contour);
    if (curve === null) continue;
    const known = measured.get(curve) ?? new Map<string, number>();
    measured.set(curve, known);
    const value = known.get(name) ?? measure(curve);
    known.set(name, value);
    total += value;
  }
  return total;
}

function firstGhost(document: CurveDocument): ReturnType<typeof bezierGhost> {
  const first = document.contours[0];
  return first === undefined ? null : bezierGhost(document, first);
}

/** So many contours are looked at for ellipses: enough for a drawing of circles, and bounded while one of thousands is dragged. */
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
