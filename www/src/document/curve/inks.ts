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

/** What has one colour and follows each other, together. */
export function runsOf<T extends { readonly ink?: string }>(all: readonly T[]): readonly (readonly T[])[] {
  const runs: T[][] = [];
  all.forEach((each, i) => {
    if (i > 0 && all[i - 1]?.ink === each.ink) runs.at(-1)?.push(each);
    else runs.push([each]);
  });
  return runs;
}

const known = new WeakMap<CurveDocument, readonly InkLayer[]>();

/** Contours of one colour that follow each other, the lowest first; the drawing itself where no contour has a colour. */
export function inkLayers(curve: CurveDocument): readonly InkLayer[] {
  const found = known.get(curve);
  if (found !== undefined) return found;
  const layers = curve.contours.every(({ ink }) => ink === undefined)
    ? [{ drawing: curve }]
    : runsOf(curve.contours).map((contours): InkLayer => {
      const ink = contours[0]?.ink;
      return { ...(ink === undefined ? {} : { ink }), drawing: { ...curve, contours } };
    });
  known.set(curve, layers);
  return layers;
}
