import { HermiteGenerators, Interpolator, ExponentialBSpline } from "expline/slim";
import { omegaOf, type Contour, type CurveDocument } from "../../document/document.ts";
import { rootsOf } from "../../document/curve/roots.ts";
import type { Root } from "../../document/surface/surface.ts";

/** The functions that a contour is made of, sampled for drawing. */
export interface Generators {
  /** Where the functions live: −reach … reach. */
  readonly reach: number;
  readonly functions: readonly { readonly name: string; readonly x: Float64Array; readonly y: Float64Array }[];
  /** Roots of an interpolating contour's generator; null for tangents. */
  readonly roots: readonly Root[] | null;
  /** Weights of the B-splines that make the interpolator. */
  readonly lambda: readonly number[];
}

const perUnit = 48;

function grid(reach: number): Float64Array {
  const count = Math.round(2 * reach * perUnit);
  return Float64Array.from({ length: count + 1 }, (_, i) => -reach + i / perUnit);
}

export function generatorsOf(document: CurveDocument, contour: Contour): Generators {
  if (contour.family === "hermite") {
    const space = contour.space ?? document.space;
    const x = grid(1);
    const { phi1, phi2 } = new HermiteGenerators(space === "polynomial" ? 0 : omegaOf(document, contour, 0), space).evaluate(x);
    return { reach: 1, roots: null, lambda: [], functions: [{ name: "φ₁", x, y: phi1 }, { name: "φ₂", x, y: phi2 }] };
  }
  const roots = rootsOf(document, contour);
  const spline = new ExponentialBSpline([...roots]);
  if (contour.grid !== undefined) {
    const x = grid(roots.length / 2);
    return { reach: roots.length / 2, roots, lambda: [], functions: [{ name: "β", x, y: spline.evaluate(x) }] };
  }
  const interpolator = new Interpolator([...roots]);
  const x = grid(interpolator.support);
  return {
    reach: interpolator.support, roots, lambda: Array.from(interpolator.lambda),
    functions: [{ name: "φ", x, y: interpolator.evaluate(x) }, { name: "β", x, y: spline.evaluate(x) }],
  };
}
