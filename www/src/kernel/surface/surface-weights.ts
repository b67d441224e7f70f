import type { NetRef, SurfaceDocument } from "../../document/surface/surface.ts";
import { extentOf, netPoints } from "./surface-mesh.ts";
import { surfaceOf, withNetPoints } from "./surface.ts";

/** How strongly one point of the net acts, along the two lines of constant parameter that cross at it. */
export interface Ridge {
  /** Places on the surface, and the normals there: x, y and z in turn. */
  readonly places: Float64Array;
  readonly normals: Float64Array;
  /** How far each place goes when the point moves by one. */
  readonly weights: Float64Array;
}

const perSegment = 24;
const mostPlaces = 480;

const known = new WeakMap<SurfaceDocument, { readonly key: string; readonly ridges: readonly Ridge[] }>();

export function ridgesOf(document: SurfaceDocument, ref: NetRef): readonly Ridge[] {
  const key = `${ref.u} ${ref.v} ${ref.detail ?? ""}`;
  const last = known.get(document);
  if (last?.key === key) return last.ridges;
  const ridges = measured(document, ref);
  known.set(document, { key, ridges });
  return ridges;
}

function measured(document: SurfaceDocument, ref: NetRef): Ridge[] {
  const surface = surfaceOf(document);
  const point = netPoints(document).find(({ ref: { u, v, detail } }) => u === ref.u && v === ref.v && detail === ref.detail);
  if (surface === null || point === undefined) return [];
  // Surfaces are linear in their points: a step of the surface's own size tells the weights, and loses no digits.
  const step = extentOf(document).radius;
  const [x, y, z] = point.at;
  const moved = surfaceOf(withNetPoints(document, [{ ...ref, x: x + step, y, z }]));
  if (moved === null) return [];
  return (["u", "v"] as const).map((along) => {
    const [from, to] = surface.domain[along];
    const [least, most] = surface.domain[along === "u" ? "v" : "u"];
    const count = Math.min(mostPlaces, Math.round((to - from) * perSegment)) + 1;
    const run = Float64Array.from({ length: count }, (_, i) => from + ((to - from) * i) / (count - 1));
    const own = point.parameter[along === "u" ? 1 : 0];
    const fixed = new Float64Array(count).fill(Math.max(least, Math.min(most, own)));
    const [u, v] = along === "u" ? [run, fixed] : [fixed, run];
    const places = surface.evaluate(u, v);
    const shifted = moved.evaluate(u, v);
    return { places, normals: surface.normal(u, v), weights: run.map((_, i) => ((shifted[3 * i] ?? 0) - (places[3 * i] ?? 0)) / step) };
  });
}
