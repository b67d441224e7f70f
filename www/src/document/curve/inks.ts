import type { CurveDocument } from "../document.ts";

/** An area of one colour, or lines, as a drawing of its own; without a colour it has that of all drawings. */
export interface InkLayer {
  readonly ink?: string;
  readonly drawing: CurveDocument;
}

/** A path of a file, in place of the one of all: areas of a colour, or lines. */
export interface PaintedPath {
  /** Absent: the ink of files. */
  readonly color?: string;
  readonly isLine?: boolean;
  readonly d: string;
}

/** Of contours that are lines, whatever closes them. */
export const noInk = "none";

const known = new WeakMap<CurveDocument, readonly InkLayer[]>();

/** Contours of one colour that follow each other, the lowest first; the drawing itself where no contour has a colour. */
export function inkLayers(curve: CurveDocument): readonly InkLayer[] {
  const found = known.get(curve);
  if (found !== undefined) return found;
  const { contours } = curve;
  const starts = contours.flatMap(({ ink }, i) => (i === 0 || ink !== contours[i - 1]?.ink ? [i] : []));
  const layers = contours.every(({ ink }) => ink === undefined)
    ? [{ drawing: curve }]
    : starts.map((start, k): InkLayer => {
      const ink = contours[start]?.ink;
      return { ...(ink === undefined ? {} : { ink }), drawing: { ...curve, contours: contours.slice(start, starts[k + 1]) } };
    });
  known.set(curve, layers);
  return layers;
}
