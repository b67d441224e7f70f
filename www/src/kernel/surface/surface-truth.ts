import type { SurfaceDocument } from "../../document/surface/surface.ts";
import { isSample, surfaceOf, type SurfaceSampleId } from "./surface.ts";

/** How far a sample is from the shape that it is named after. */

type Place = readonly [number, number, number];

/** Distance from the shape, to first order. */
const residuals: Partial<Record<SurfaceSampleId, (p: Place) => number>> = {
  "surf-sphere": ([x, y, z]) => Math.hypot(x, y, z) - 1,
  "surf-torus": ([x, y, z]) => Math.hypot(Math.hypot(x, y) - 1, z) - 0.4,
  "surf-cylinder": ([x, y]) => Math.hypot(x, y) - 0.7,
};

const known = new WeakMap<SurfaceDocument, number>();
const looked = 129;

/**
 * Largest distance of a fine mesh from the shape; undefined once the surface has been edited, or where the sample has
 * no formula.
 */
export function deviationOf(document: SurfaceDocument): number | undefined {
  const residual = residuals[document.sample as SurfaceSampleId];
  if (residual === undefined || !isSample(document)) return undefined;
  const found = known.get(document);
  if (found !== undefined) return found;
  const positions = surfaceOf(document)?.mesh(looked, looked).positions ?? new Float64Array(0);
  let worst = 0;
  for (let i = 0; i + 2 < positions.length; i += 3) {
    worst = Math.max(worst, Math.abs(residual([positions[i] ?? 0, positions[i + 1] ?? 0, positions[i + 2] ?? 0])));
  }
  known.set(document, worst);
  return worst;
}
