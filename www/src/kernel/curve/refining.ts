import { lengthOf, omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument } from "../../document/document.ts";
import { scaled } from "../../document/curve/offset.ts";
import { pointOf } from "./points/control-points.ts";
import { hermiteOf } from "./curve-cache.ts";

/** Hermite contours of finer levels. */

/** Whether its frequency follows from the whole, and every length is 1. */
export function isOrdinary(document: CurveDocument, contour: Contour): boolean {
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
