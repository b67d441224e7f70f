import type { CurveDocument } from "./document.ts";
import { isPainted, paintOf, runsOf, type Line, type Painted } from "./painted.ts";

/** An area of one colour, or lines, as a drawing of its own; without a paint it has that of all drawings. */
export interface PaintLayer extends Painted {
  readonly drawing: CurveDocument;
}

/** A path of a file, in place of the one of all: areas of a colour, or lines. */
export interface PaintedPath {
  /** Absent: the ink of files. */
  readonly color?: string;
  /** It has no area. */
  readonly isLine?: boolean;
  /** Absent: an area has none, and a line is thin. */
  readonly line?: Line;
  readonly d: string;
}

const known = new WeakMap<CurveDocument, readonly PaintLayer[]>();

/** Contours of one paint that follow each other, the lowest first; the drawing itself where no contour has a paint. */
export function paintLayers(curve: CurveDocument): readonly PaintLayer[] {
  const found = known.get(curve);
  if (found !== undefined) return found;
  const layers = curve.contours.some(isPainted)
    ? runsOf(curve.contours).map((contours): PaintLayer => ({ ...paintOf(contours[0] ?? {}), drawing: { ...curve, contours } }))
    : [{ drawing: curve }];
  known.set(curve, layers);
  return layers;
}
