import { HermiteCurve, type BSplineCurve, type InterpolatingCurve, type LocalCurve } from "expline/slim";
import { lengthOf, omegaOf, segmentCount, type Contour, type CurveDocument, type Offset, type Space } from "../../document/document.ts";
import { splineOf, splineShape } from "./spline-shape.ts";

/**
 * Library curves of the document's contours. A contour is an immutable value, so its identity is its revision: a
 * changed contour is a new key, and the curve of one that is gone goes with it.
 */

interface Cached {
  readonly space: Space;
  /** The document's frequency; it matters only to contours without their own. */
  readonly omega: number | "auto";
  readonly curve: AnyCurve;
}

/** A contour with tangents, one of points on the curve, or one of refined control points near it. */
export type AnyCurve = HermiteCurve | InterpolatingCurve | BSplineCurve | LocalCurve;

const cache = new WeakMap<Contour, Cached>();

/**
 * The contour as a curve of the library, or null while it has fewer than two points. Throws `ExplineError` when the
 * library refuses it.
 */
export function curveOf(document: CurveDocument, contour: Contour): AnyCurve | null {
  if (contour.points.length < 2) return null;
  const space = contour.space ?? document.space;
  const found = cache.get(contour);
  if (found !== undefined && found.space === space && (contour.omega !== undefined || found.omega === document.omega)) return found.curve;
  const curve = contour.family === "hermite" ? build(document, contour, space) : splineOf(splineShape(document, contour));
  cache.set(contour, { space, omega: document.omega, curve });
  return curve;
}

/** The same for what only a curve with tangents has; null for every other. */
export function hermiteOf(document: CurveDocument, contour: Contour): HermiteCurve | null {
  const curve = curveOf(document, contour);
  return curve instanceof HermiteCurve ? curve : null;
}

/** A drawn handle is a third of the tangent vector times the parameter length of its segment. */
function tangentOf(handle: Offset, length: number): [number, number] {
  return [(3 * handle.dx) / length, (3 * handle.dy) / length];
}

function build(document: CurveDocument, contour: Contour, space: Space): HermiteCurve {
  const { points, closed } = contour;
  const count = points.length;
  const segments = segmentCount(contour);
  const places = new Float64Array(2 * count);
  const leaving = new Float64Array(2 * count);
  const arriving = new Float64Array(2 * count);
  for (const [i, { x, y, in: before, out: after }] of points.entries()) {
    // The free ends of an open contour have no segment on one side; any length serves them.
    const leaves = lengthOf(contour, Math.min(i, segments - 1));
    const arrives = lengthOf(contour, closed ? (i + segments - 1) % segments : Math.max(0, i - 1));
    [places[2 * i], places[2 * i + 1]] = [x, y];
    [leaving[2 * i], leaving[2 * i + 1]] = tangentOf(after, leaves);
    const [dx, dy] = tangentOf(before, arrives);
    [arriving[2 * i], arriving[2 * i + 1]] = [-dx, -dy];
  }
  const ordinary = contour.omega === undefined && document.omega === "auto";
  return new HermiteCurve({
    points: places,
    tangents: leaving,
    tangentsIn: arriving,
    closed,
    space,
    ...(contour.lengths === undefined ? {} : { lengths: Float64Array.from(contour.lengths) }),
    ...(ordinary && contour.lengths === undefined
      ? {}
      : { omega: Float64Array.from({ length: segments }, (_, segment) => omegaOf(document, contour, segment)) }),
  });
}
