import { locate } from "../../document/curve/contours.ts";
import { nothingSelected, type Contour, type CurveDocument, type Grid, type Selection } from "../../document/document.ts";
import type { Segment } from "../../editor/curve/bending.ts";

/** The segment that a place of the curve belongs to, and the two points that are chosen with it. */

export function segmentAt({ contours }: CurveDocument, contour: number, t: number): Segment {
  const shape = contours[contour];
  const { segment, x } = shape === undefined ? { segment: 0, x: 0 } : locate(shape, t);
  return { contour, index: segment, x };
}

export function endsAt({ contours }: CurveDocument, contour: number, t: number): Selection {
  const shape = contours[contour];
  if (shape === undefined) return nothingSelected;
  const indices = shape.grid === undefined ? besideInOrder(shape, t) : besideOnGrid(shape, shape.grid, t);
  return { points: indices.map((index) => ({ contour, index })), handle: null };
}

function besideInOrder(shape: Contour, t: number): readonly number[] {
  const { segment } = locate(shape, t);
  return [segment, (segment + 1) % shape.points.length];
}

/** Of refined control points, the two whose parameters enclose `t`. */
function besideOnGrid({ points, closed }: Contour, { offset, step }: Grid, t: number): readonly number[] {
  const count = points.length;
  const before = Math.floor((t - offset) / step);
  const within = (index: number): number => (closed ? ((index % count) + count) % count : Math.max(0, Math.min(count - 1, index)));
  return [within(before), within(before + 1)];
}
