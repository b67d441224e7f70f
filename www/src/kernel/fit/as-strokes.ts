import { paintOf } from "../../document/painted.ts";
import { domainLength, lengthOf, segmentCount, type Contour, type CurveDocument } from "../../document/document.ts";
import type { NewStroke, Pair } from "../../document/fit/fit.ts";
import { curveOf } from "../curve/curve-cache.ts";

/** Curves as strokes of points. */

const leastPoints = 24;
/** More points than this are a slow fit: long curves are then sampled more sparsely. */
export const mostPlaces = 12_000;

/** The diagonal of the box of all contours. */
export function diagonalOf(drawing: CurveDocument, contours: readonly Contour[]): number {
  const boxes = contours.flatMap((contour) => curveOf(drawing, contour)?.bounds() ?? []);
  const box = boxes.reduce(
    (all, { minX, minY, maxX, maxY }) => [Math.min(all[0], minX), Math.min(all[1], minY), Math.max(all[2], maxX), Math.max(all[3], maxY)] as const,
    [Infinity, Infinity, -Infinity, -Infinity] as const,
  );
  return boxes.length === 0 ? 0 : Math.hypot(box[2] - box[0], box[3] - box[1]);
}

/**
 * Contours as strokes of points, so far from each other as there is room for; closed ones with their first point again
 * at the end. The points of the contours are among them, so that no corner is cut.
 */
export function placesAlong(drawing: CurveDocument, contours: readonly Contour[], apart: number, most: number): NewStroke[] {
  const lengths = contours.map((contour) => curveOf(drawing, contour)?.length() ?? 0);
  const spacing = Math.max(apart, lengths.reduce((sum, length) => sum + length, 0) / most);
  return contours.flatMap((contour, i) => {
    const places = along(drawing, contour, Math.max(leastPoints, (lengths[i] ?? 0) / spacing));
    return places.length < 4 ? [] : [{ places, ...paintOf(contour) }];
  });
}

/** About so many points, shared among the segments by their length. */
function along(drawing: CurveDocument, contour: Contour, wanted: number): Pair[] {
  const curve = curveOf(drawing, contour);
  if (curve === null) return [];
  const chords = Array.from({ length: segmentCount(contour) }, (_, i) => chordOf(contour, i));
  const total = Math.max(1e-9, chords.reduce((sum, chord) => sum + chord, 0));
  const end = domainLength(contour);
  const at: number[] = [];
  let start = 0;
  chords.forEach((chord, i) => {
    const length = lengthOf(contour, i);
    const count = Math.max(1, Math.round((wanted * chord) / total));
    for (let k = 0; k < count; k += 1) at.push(Math.min(end, start + (length * k) / count));
    start += length;
  });
  at.push(contour.closed ? 0 : end);
  const places = curve.evaluate(Float64Array.from(at));
  return at.map((_, i): Pair => [places[2 * i] ?? 0, places[2 * i + 1] ?? 0]);
}

/** From point to point, by way of the handles: about the length of a segment. */
function chordOf({ points }: Contour, i: number): number {
  const [from, to] = [points[i], points[(i + 1) % points.length]];
  if (from === undefined || to === undefined) return 0;
  const middle = Math.hypot(to.x + to.in.dx - from.x - from.out.dx, to.y + to.in.dy - from.y - from.out.dy);
  return Math.hypot(from.out.dx, from.out.dy) + middle + Math.hypot(to.in.dx, to.in.dy);
}
