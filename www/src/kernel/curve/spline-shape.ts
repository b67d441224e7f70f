import { BSplineCurve, InterpolatingCurve, LocalCurve } from "expline/slim";
import { rootsOf } from "../../document/curve/roots.ts";
import { baseCount, type Contour, type CurveDocument } from "../../document/document.ts";
import type { Root } from "../../document/surface/surface.ts";

/** An interpolating contour as the library takes it: plain numbers, which a worker can be sent. */
export interface SplineShape {
  readonly points: Float64Array;
  readonly closed: boolean;
  readonly roots: readonly Root[];
  /** Of a refined one. */
  readonly grid?: { readonly step: number; readonly offset: number };
  /** The displacements of the finer control points, place by place. */
  readonly patches?: readonly { level: number; first: number; displacements: number[] }[];
}

export function splineShape(document: CurveDocument, contour: Contour): SplineShape {
  const { closed, grid, places } = contour;
  const points = new Float64Array(2 * baseCount(contour));
  contour.points.slice(0, points.length / 2).forEach(({ x, y }, i) => points.set([x, y], 2 * i));
  const shared = { points, closed, roots: rootsOf(document, contour) };
  if (places !== undefined) return { ...shared, patches: patchesOf(contour) };
  return grid === undefined ? shared : { ...shared, grid: { step: grid.step, offset: grid.offset } };
}

export function splineOf({ grid, patches, ...shared }: SplineShape): InterpolatingCurve | BSplineCurve | LocalCurve {
  if (patches !== undefined) return new LocalCurve({ ...shared, patches: [...patches] });
  return grid === undefined ? new InterpolatingCurve(shared) : new BSplineCurve({ ...shared, ...grid });
}

function patchesOf(contour: Contour): { level: number; first: number; displacements: number[] }[] {
  let from = baseCount(contour);
  return (contour.places ?? []).map(({ level, first, count }) => {
    const fine = contour.points.slice(from, from + count);
    from += count;
    return { level, first, displacements: fine.flatMap(({ moved }) => [moved?.dx ?? 0, moved?.dy ?? 0]) };
  });
}
