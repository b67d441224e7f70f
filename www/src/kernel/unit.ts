import type { CurveDocument } from "../document/document.ts";
import { unitIn } from "../document/unit.ts";
import { documentBounds } from "./curve/samples.ts";

const units = new WeakMap<CurveDocument, number>();

/** The step that suits a drawing: arrows move by it, and numbers are printed to a hundredth of it. */
export function unitOf(curve: CurveDocument): number {
  const unit = units.get(curve) ?? unitIn(documentBounds(curve));
  units.set(curve, unit);
  return unit;
}
