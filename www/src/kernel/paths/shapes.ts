import { reversedContour } from "../../document/curve/whole/rearranging.ts";
import type { Contour, CurveDocument, PointRef } from "../../document/document.ts";
import { boundsOf, samplePoints, type Bounds } from "../curve/samples.ts";

/**
 * Which contours make one shape, as people see it: an outline with the holes and the marks in it; and which way round a
 * new one becomes a hole.
 */

interface Place {
  readonly x: number;
  readonly y: number;
}

/**
 * Polygons of so many sides a segment tell inside from outside, but for a hair beside the curve, where a press means
 * the curve.
 */
const sides = 24;
const mostSides = 8192;

/** How often a closed contour goes round each of some places, and which way: the winding numbers of a polygon of it. */
function windingsOf(curve: CurveDocument, contour: Contour, places: readonly Place[]): number[] {
  const box = boundsOf(curve, contour);
  const isNear = ({ x, y }: Place): boolean => contour.closed && box !== null && x >= box.minX && x <= box.maxX && y >= box.minY && y <= box.maxY;
  if (!places.some(isNear)) return places.map(() => 0);
  const polygon = samplePoints(curve, contour, Math.min(mostSides, sides * contour.points.length));
  return places.map((place) => (isNear(place) ? windingOf(polygon, place) : 0));
}

function windingOf(polygon: Float64Array, { x, y }: Place): number {
  let winding = 0;
  let [fromX = NaN, fromY = NaN] = polygon.subarray(-2);
  for (let i = 0; i < polygon.length; i += 2) {
    const [toX = NaN, toY = NaN] = [polygon[i], polygon[i + 1]];
    const side = (toX - fromX) * (y - fromY) - (x - fromX) * (toY - fromY);
    if (fromY <= y && toY > y && side > 0) winding += 1;
    else if (fromY > y && toY <= y && side < 0) winding -= 1;
    [fromX, fromY] = [toX, toY];
  }
  return winding;
}

function goesRound(curve: CurveDocument, contour: Contour, at: Place): boolean {
  return windingsOf(curve, contour, [at])[0] !== 0;
}

/**
 * A new contour, the way round that makes of it what is meant where the winding number fills: a hole in the one
 * shape that it lies within, and one shape with what it only laps over.
 */
export function turnedForFilling(curve: CurveDocument, contour: Contour): { readonly contour: Contour; readonly cuts: boolean } {
  const own = windingsOf(curve, contour, [middleOf(contour)])[0] ?? 0;
  if (curve.filling !== "nonzero" || own === 0) return { contour, cuts: false };
  const below = curve.contours.filter(({ ink }) => ink === contour.ink).map((each) => windingsOf(curve, each, contour.points));
  const windings = contour.points.map((_, i) => below.reduce((sum, each) => sum + (each[i] ?? 0), 0));
  const way = Math.sign(windings.find((each) => each !== 0) ?? 0);
  if (way === 0) return { contour, cuts: false };
  // What two shapes cover is filled still when one contour more goes the other way round.
  const cuts = windings.every((each) => each === way);
  return { contour: (Math.sign(own) === way) === cuts ? reversedContour(contour) : contour, cuts };
}

function middleOf({ points }: Contour): Place {
  const sum = points.reduce((all, { x, y }) => ({ x: all.x + x, y: all.y + y }), { x: 0, y: 0 });
  return { x: sum.x / points.length, y: sum.y / points.length };
}

function isWithin(box: Bounds, around: Bounds): boolean {
  return box.minX >= around.minX && box.maxX <= around.maxX && box.minY >= around.minY && box.maxY <= around.maxY;
}

const extent = ({ minX, minY, maxX, maxY }: Bounds): number => (maxX - minX) * (maxY - minY);

interface Around {
  readonly contour: Contour;
  readonly index: number;
  readonly box: Bounds;
}

/** The contours that go round a place, the innermost first. */
function around(curve: CurveDocument, at: Place): Around[] {
  return curve.contours
    .flatMap((contour, index) => {
      const box = goesRound(curve, contour, at) ? boundsOf(curve, contour) : null;
      return box === null ? [] : [{ contour, index, box }];
    })
    .sort((a, b) => extent(a.box) - extent(b.box));
}

/** Whether one of some contours goes round a place, and nothing of another colour lies over it there. */
export function isInside(curve: CurveDocument, some: ReadonlySet<number>, at: Place): boolean {
  const found = around(curve, at);
  return found.some(({ contour, index }) => some.has(index) && contour.ink === found[0]?.contour.ink);
}

/**
 * The points of the shape around a place: of the colour that lies innermost there, the outermost contour that goes
 * round the place, with all of its colour that lies within. None where nothing does.
 */
export function shapeAt(curve: CurveDocument, at: Place): readonly PointRef[] {
  const found = around(curve, at);
  const [innermost] = found;
  const outermost = found.filter(({ contour }) => contour.ink === innermost?.contour.ink).at(-1);
  if (outermost === undefined) return [];
  return curve.contours.flatMap((contour, c): PointRef[] => {
    const box = boundsOf(curve, contour);
    // A contour within the box of another may still lie beside it.
    const [first] = contour.points;
    const belongs = contour === outermost.contour
      || (contour.ink === outermost.contour.ink && box !== null && first !== undefined && isWithin(box, outermost.box) && goesRound(curve, outermost.contour, first));
    return belongs ? contour.points.map((_, index) => ({ contour: c, index })) : [];
  });
}
