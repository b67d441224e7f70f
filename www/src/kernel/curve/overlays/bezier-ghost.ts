import { translationOf } from "../../../document/curve/contours.ts";
import { partsOf } from "../../../document/curve/parts.ts";
import type { Contour, CurveDocument } from "../../../document/document.ts";
import { curveOf } from "../curve-cache.ts";
import { boundsOf } from "../samples.ts";

/**
 * The Bézier to compare with. For an ellipse it is the one that editors draw: four cubics with handles of 0.5523 of
 * the radius. For anything else it is the cubic with the same points and the same handles.
 */

export interface Ghost {
  /** Eight numbers per cubic. */
  readonly path: Float64Array;
  /** Largest distance from the curve, relative to the radius of an ellipse or to half the extent of another curve. */
  readonly error: number;
  /** The same distance in document units. */
  readonly distance: number;
  readonly shape: "ellipse" | "handles";
  /**
   * For an ellipse: the Bézier with its error made `magnified` times as large, as a closed polygon; the true one cannot
   * be told apart by eye.
   */
  readonly magnified: Float64Array | null;
}

export const magnification = 500;

export interface Ellipse {
  readonly center: readonly [number, number];
  readonly radii: readonly [number, number];
  readonly rotation: number;
}

const kappa = (4 / 3) * (Math.SQRT2 - 1);
const ghosts = new WeakMap<object, Ghost>();
const ellipses = new WeakMap<object, Ellipse | null>();

/**
 * A contour of more points than anybody would draw an ellipse with is not looked at: it would be built anew as a whole
 * with every step of a drag.
 */
const mostOfEllipse = 8192;

/** The ellipse that a closed contour is, if it is one to a thousandth of its extent. */
export function ellipseOf(document: CurveDocument, contour: Contour): Ellipse | null {
  if (!contour.closed || contour.points.length > mostOfEllipse) return null;
  const box = boundsOf(document, contour);
  if (box === null) return null;
  const curve = curveOf(document, contour);
  if (curve === null) return null;
  const known = ellipses.get(curve);
  if (known !== undefined) return known;
  const found = curve.asEllipse(1e-3 * Math.max(box.maxX - box.minX, box.maxY - box.minY, 1e-9)) ?? null;
  ellipses.set(curve, found);
  return found;
}

export function bezierGhost(document: CurveDocument, contour: Contour): Ghost | null {
  const parts = partsOf(document, contour);
  if (parts.length > 1) return ofParts(document, contour, parts);
  const curve = curveOf(document, contour);
  if (curve === null) return null;
  const known = ghosts.get(curve);
  if (known !== undefined) return known;
  const ellipse = ellipseOf(document, contour);
  if (ellipse === null && contour.family === "interpolating") return null;
  const ghost = ellipse === null ? sameHandles(document, contour) : fourArcs(ellipse);
  ghosts.set(curve, ghost);
  return ghost;
}

const longGhosts = new WeakMap<Contour, Ghost>();

/** Of a contour in parts: the error is the worst of theirs, and each draws its own path. */
function ofParts(document: CurveDocument, contour: Contour, parts: readonly Contour[]): Ghost {
  const known = longGhosts.get(contour);
  if (known !== undefined) return known;
  // What was moved as a whole is as far away as before.
  const distance = parts.reduce((worst, part) => Math.max(worst, bezierGhost(document, translationOf(part)?.from ?? part)?.distance ?? 0), 0);
  const fresh: Ghost = { path: new Float64Array(0), distance, error: distance / halfExtent(document, contour), shape: "handles", magnified: null };
  longGhosts.set(contour, fresh);
  return fresh;
}

function halfExtent(document: CurveDocument, contour: Contour): number {
  const box = boundsOf(document, contour);
  return box === null ? 1 : Math.max(1e-9, Math.max(box.maxX - box.minX, box.maxY - box.minY) / 2);
}

function fourArcs(ellipse: Ellipse): Ghost {
  const path = new Float64Array(32);
  for (let quarter = 0; quarter < 4; quarter += 1) {
    const cos = [1, 0, -1, 0][quarter] ?? 0;
    const sin = [0, 1, 0, -1][quarter] ?? 0;
    const unit = [cos, sin, cos - kappa * sin, sin + kappa * cos, -sin + kappa * cos, cos + kappa * sin, -sin, cos];
    for (let k = 0; k < 8; k += 2) path.set(onEllipse(ellipse, unit[k] ?? 0, unit[k + 1] ?? 0), quarter * 8 + k);
  }
  return { path, error: fourArcError, distance: fourArcError * Math.max(...ellipse.radii), shape: "ellipse", magnified: magnifiedErrors(ellipse) };
}

const magnifiedCount = 256;

function magnifiedErrors(ellipse: Ellipse): Float64Array {
  const polygon = new Float64Array(2 * magnifiedCount);
  const perQuarter = magnifiedCount / 4;
  for (let i = 0; i < magnifiedCount; i += 1) {
    const [x, y] = quarterPoint((i % perQuarter) / perQuarter);
    const radius = Math.hypot(x, y);
    const factor = (1 + magnification * (radius - 1)) / radius;
    let [u, v] = [x * factor, y * factor];
    for (let turn = 0; turn < Math.floor(i / perQuarter); turn += 1) [u, v] = [-v, u];
    polygon.set(onEllipse(ellipse, u, v), 2 * i);
  }
  return polygon;
}

/** The Bézier of the unit circle's first quarter. */
function quarterPoint(t: number): [number, number] {
  const s = 1 - t;
  return [s * s * s + 3 * s * s * t + 3 * s * t * t * kappa, 3 * s * s * t * kappa + 3 * s * t * t + t * t * t];
}

function onEllipse({ center, radii, rotation }: Ellipse, u: number, v: number): [number, number] {
  const [x, y] = [radii[0] * u, radii[1] * v];
  const [cos, sin] = [Math.cos(rotation), Math.sin(rotation)];
  return [center[0] + x * cos - y * sin, center[1] + x * sin + y * cos];
}

/**
 * Largest radius error of the unit quarter, measured on it: the same for every circle, and for an ellipse relative to
 * its radii.
 */
const fourArcError = measureFourArcs();

function measureFourArcs(): number {
  let worst = 0;
  for (let i = 0; i <= 1000; i += 1) {
    const [x, y] = quarterPoint(i / 1000);
    worst = Math.max(worst, Math.abs(Math.hypot(x, y) - 1));
  }
  return worst;
}

/**
 * The cubics that have the contour's own points and handles; handles are drawn at a third of the tangent, as a cubic's
 * are.
 */
function sameHandles(document: CurveDocument, contour: Contour): Ghost {
  const { points, closed } = contour;
  const segments = closed ? points.length : points.length - 1;
  const path = new Float64Array(8 * segments);
  for (let segment = 0; segment < segments; segment += 1) {
    const from = points[segment];
    const to = points[(segment + 1) % points.length];
    if (from === undefined || to === undefined) continue;
    path.set([from.x, from.y, from.x + from.out.dx, from.y + from.out.dy, to.x + to.in.dx, to.y + to.in.dy, to.x, to.y], 8 * segment);
  }
  const distance = cubicDistance(document, contour, path);
  return { path, distance, error: distance / halfExtent(document, contour), shape: "handles", magnified: null };
}

const perSegment = 16;

/** Largest distance at equal parameters, which both curves share. */
function cubicDistance(document: CurveDocument, contour: Contour, path: Float64Array): number {
  const curve = curveOf(document, contour);
  if (curve === null) return 0;
  const places = new Float64Array((path.length / 8) * perSegment);
  let start = 0;
  for (let k = 0; k < places.length; k += 1) {
    const length = contour.lengths?.[Math.floor(k / perSegment)] ?? 1;
    places[k] = start + within(k) * length;
    if ((k + 1) % perSegment === 0) start += length;
  }
  const exact = curve.evaluate(places);
  let worst = 0;
  for (let k = 0; k < places.length; k += 1) {
    const [t, at] = [within(k), 8 * Math.floor(k / perSegment)];
    const off = (side: 0 | 1): number => onCubic(path, at + side, t) - (exact[2 * k + side] ?? 0);
    worst = Math.max(worst, Math.hypot(off(0), off(1)));
  }
  return worst;
}

/** Of the segment that the place is in, from 0 to 1. */
function within(k: number): number {
  return ((k % perSegment) + 0.5) / perSegment;
}

/** One coordinate. */
function onCubic(path: Float64Array, at: number, t: number): number {
  const s = 1 - t;
  return s * s * s * (path[at] ?? 0) + 3 * s * s * t * (path[at + 2] ?? 0) + 3 * s * t * t * (path[at + 4] ?? 0) + t * t * t * (path[at + 6] ?? 0);
}
