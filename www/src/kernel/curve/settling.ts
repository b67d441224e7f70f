import { LocalCurve } from "expline/slim";
import { plainPoint } from "../../document/curve/contours.ts";
import { baseCount, type Contour, type ControlPoint, type CurveDocument } from "../../document/document.ts";
import { curveOf } from "./curve-cache.ts";

/** What finer control points do after every change. */

/** The contour with its finer points where a library curve has them. */
export function written(contour: Contour, curve: LocalCurve): Contour {
  const fine = curve.patches.flatMap(({ displacements }, k): ControlPoint[] => {
    const at = curve.patchPoints(k);
    return Array.from({ length: at.length / 2 }, (_, i) => ({
      ...plainPoint(at[2 * i] ?? 0, at[2 * i + 1] ?? 0),
      moved: { dx: (displacements[2 * i] ?? 0) + 0, dy: (displacements[2 * i + 1] ?? 0) + 0 },
    }));
  });
  const places = curve.patches.map(({ level, first, displacements }) => ({ level, first, count: displacements.length / 2 }));
  return { ...contour, points: [...contour.points.slice(0, baseCount(contour)), ...fine], places };
}

/**
 * After a change: finer points that were moved keep their new places, and all others follow the points on the curve, so
 * that moving a point of the curve takes the detail along.
 */
export function settled(before: CurveDocument, after: CurveDocument): CurveDocument {
  if (after.contours.every((contour, i) => contour.places === undefined || contour === before.contours[i])) return after;
  return { ...after, contours: after.contours.map((contour, i) => (contour.places === undefined ? contour : settledContour(after, before.contours[i], contour))) };
}

function settledContour(document: CurveDocument, before: Contour | undefined, contour: Contour): Contour {
  const curve = curveOf(document, contour);
  if (contour === before || !(curve instanceof LocalCurve)) return contour;
  const fresh = new LocalCurve({ points: curve.points, closed: contour.closed, roots: curve.roots, patches: curve.patches });
  let index = baseCount(contour);
  const known = before?.places === contour.places ? before : undefined;
  for (const [k, { count }] of (contour.places ?? []).entries()) {
    for (let i = 0; i < count; i += 1, index += 1) {
      const [point, old] = [contour.points[index], known?.points[index]];
      if (point !== undefined && old !== undefined && (point.x !== old.x || point.y !== old.y)) fresh.setPatchPoint(k, i, point.x, point.y);
    }
  }
  return written(contour, fresh);
}
