import { tangentWeights } from "expline/slim";
import { lengthOf, noOffset, omegaOf, type Contour, type ControlPoint, type CurveDocument } from "../../document/document.ts";
import { hermiteOf } from "./curve-cache.ts";

/** What points and handles weigh at a place of the curve: how far it goes with them. */

/**
 * How far the place at `x` of a segment goes with a step of one of its leaving handle, and with one of its arriving
 * handle.
 */
export function handleWeights(document: CurveDocument, contour: Contour, segment: number, x: number): readonly [number, number] {
  const curve = hermiteOf(document, contour);
  if (curve === null) return [0, 0];
  let start = 0;
  for (let i = 0; i < segment; i += 1) start += lengthOf(contour, i);
  const length = lengthOf(contour, segment);
  const [leaving, arriving] = tangentWeights(curve, start + x * length);
  // A handle is a third of its tangent over the length of the segment, and the arriving one points back.
  return [(3 * leaving) / length, (-3 * arriving) / length];
}

/**
 * How far the place at `x` of a segment goes with a step of the point before it, and with one of the point behind it.
 */
export function pointWeights(document: CurveDocument, contour: Contour, segment: number, x: number): readonly [number, number] {
  const length = lengthOf(contour, segment);
  // A segment is linear in its two points: one that is nothing but a unit of one in x and of the other in y shows what
  // each of them weighs.
  const points = [[1, 0], [0, 1]].map(([x = 0, y = 0]): ControlPoint => ({ x, y, kind: "cusp", in: noOffset, out: noOffset }));
  const { space } = contour;
  const probe: Contour = { family: "hermite", closed: false, points, lengths: [length], omega: [omegaOf(document, contour, segment)], ...(space === undefined ? {} : { space }) };
  const curve = contour.family === "hermite" ? hermiteOf(document, probe) : null;
  if (curve === null) return [0, 0];
  const [before = 0, behind = 0] = curve.evaluate(x * length);
  return [before, behind];
}
