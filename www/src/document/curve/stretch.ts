import { lengthOf, omegaOf, type Contour, type ControlPoint, type CurveDocument } from "../document.ts";

/**
 * Two segments on either side of a point of a contour with tangents, as an open contour by themselves: nothing farther
 * away depends on the point.
 */
export function stretchAround(document: CurveDocument, contour: Contour, index: number): { readonly contour: Contour; readonly index: number } {
  const count = contour.points.length;
  const first = contour.closed ? index - 2 : Math.max(0, index - 2);
  const last = contour.closed ? index + 2 : Math.min(count - 1, index + 2);
  const [segments, points]: [number[], ControlPoint[]] = [[], []];
  for (let i = first; i <= last; i += 1) {
    const point = contour.points[(i + count) % count];
    if (point !== undefined) points.push(point);
    if (i < last) segments.push((i + count) % count);
  }
  return {
    index: index - first,
    contour: {
      family: "hermite",
      closed: false,
      points,
      space: contour.space ?? document.space,
      omega: segments.map((segment) => omegaOf(document, contour, segment)),
      lengths: segments.map((segment) => lengthOf(contour, segment)),
    },
  };
}
