import { segmentCount, type Contour, type Selection } from "../../document.ts";

/**
 * The segments of a contour that are chosen by their two ends. All of them where no two neighbours are chosen but some
 * point is, where nothing is chosen at all, and of an interpolating contour, which has one frequency; none where only
 * others are.
 */
export function chosenSegments(contour: Contour, index: number, { points }: Selection): number[] {
  const ends = new Set(points.flatMap((ref) => (ref.contour === index ? [ref.index] : [])));
  if (ends.size === 0 && points.length > 0) return [];
  const all = [...Array(segmentCount(contour)).keys()];
  const both = all.filter((segment) => ends.has(segment) && ends.has((segment + 1) % contour.points.length));
  return both.length === 0 || contour.family === "interpolating" ? all : both;
}
