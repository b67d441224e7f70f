import type { HermiteCurve } from "expline/slim";
import type { ControlPoint } from "../../../document/document.ts";
import { kindOf } from "../../../document/curve/offset.ts";

/** The points of library curves as control points of the document. */

/** Point `i`, whose segments have the lengths `before` and `after`. */
export function pointOf(curve: HermiteCurve, i: number, before: number, after: number): ControlPoint {
  const { points, tangents, tangentsIn } = arraysOf(curve);
  const at = (list: Float64Array, k: number): number => list[k] ?? 0;
  const handles = {
    in: { dx: (-at(tangentsIn, 2 * i) * before) / 3, dy: (-at(tangentsIn, 2 * i + 1) * before) / 3 },
    out: { dx: (at(tangents, 2 * i) * after) / 3, dy: (at(tangents, 2 * i + 1) * after) / 3 },
  };
  const clean = { in: withoutNegativeZero(handles.in), out: withoutNegativeZero(handles.out) };
  return { x: at(points, 2 * i), y: at(points, 2 * i + 1), kind: kindOf(clean), ...clean };
}

function withoutNegativeZero(offset: { dx: number; dy: number }): { dx: number; dy: number } {
  return { dx: offset.dx + 0, dy: offset.dy + 0 };
}

interface Arrays {
  readonly points: Float64Array;
  readonly tangents: Float64Array;
  readonly tangentsIn: Float64Array;
  readonly lengths: Float64Array;
}

const arrays = new WeakMap<HermiteCurve, Arrays>();

/** The curve's arrays; its getters copy, so they are asked once. */
export function arraysOf(curve: HermiteCurve): Arrays {
  const known = arrays.get(curve);
  if (known !== undefined) return known;
  const fresh = { points: curve.points, tangents: curve.tangents, tangentsIn: curve.tangentsIn, lengths: curve.lengths };
  arrays.set(curve, fresh);
  return fresh;
}
