import { replaceContour, type Command } from "../commands.ts";
import { noOffset, type Contour, type ControlPoint, type CurveDocument, type Offset, type PointRef } from "../../document.ts";
import { opposite } from "../offset.ts";

/** What drawing point by point does to a document: contours are begun, gone on with and closed, handles are pulled. */

type Place = Pick<ControlPoint, "x" | "y">;

export function cornerAt({ x, y }: Place): ControlPoint {
  return { x, y, kind: "cusp", in: noOffset, out: noOffset };
}

/** What the entry of a path's first point is called. */
export const startName = "Start path";

/** A contour of one point, behind all others. */
export function startContour(curve: CurveDocument, place: Place): Command {
  const fresh: Contour = { family: "hermite", closed: false, points: [cornerAt(place)], support: 1 };
  return {
    name: startName,
    apply: (document) => ({ ...document, contours: [...document.contours, fresh] }),
    select: { points: [{ contour: curve.contours.length, index: 0 }], handle: null },
  };
}

/** A corner behind the last point of an open contour; the new segment has the frequency of the one before. */
export function growContour(at: number, contour: Contour, place: Place): Command {
  const grown = { ...contour, points: [...contour.points, cornerAt(place)], ...withSegment(contour, contour.omega) };
  return {
    name: "Add point",
    apply: (document) => replaceContour(document, at, grown),
    select: { points: [{ contour: at, index: contour.points.length }], handle: null },
  };
}

/** The contour closed; no segment that it had changes its shape. */
export function closeDrawn(at: number, contour: Contour): Command {
  return {
    name: "Close path",
    apply: (document) => {
      // An open contour's automatic frequency is 0, a closed one's is not.
      const omega = contour.omega ?? (document.omega === "auto" ? contour.points.slice(1).map(() => 0) : undefined);
      return replaceContour(document, at, { ...contour, closed: true, ...withSegment(contour, omega) });
    },
    select: { points: [{ contour: at, index: 0 }], handle: null },
  };
}

function withSegment({ lengths }: Contour, omega: readonly number[] | undefined): Partial<Contour> {
  return {
    ...(omega === undefined ? {} : { omega: [...omega, omega.at(-1) ?? 0] }),
    ...(lengths === undefined ? {} : { lengths: [...lengths, 1] }),
  };
}

/** A point's leaving handle; the arriving one mirrors it, or stays where the point is `bent`. */
export function pullHandles(ref: PointRef, out: Offset, bent: boolean): Command {
  const pulled = (point: ControlPoint): ControlPoint => (bent ? { ...point, kind: "cusp", out } : { ...point, kind: "symmetric", out, in: opposite(out) });
  return {
    name: "Pull handles",
    apply: (document) => {
      const contour = document.contours[ref.contour];
      if (contour === undefined) return document;
      return replaceContour(document, ref.contour, { ...contour, points: contour.points.map((point, i) => (i === ref.index ? pulled(point) : point)) });
    },
  };
}
