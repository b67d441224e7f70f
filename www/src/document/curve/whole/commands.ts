import { nothingSelected, type Contour, type CurveDocument, type PointRef, type Selection } from "../../document.ts";
import { only, replaceContour, type Command } from "../commands.ts";
import { reversedContour, startedAt, withClosed } from "./rearranging.ts";

/** Changes of whole contours: closed, reversed, begun elsewhere, added. */

export function closeContour(index: number, closed: boolean): Command {
  return {
    name: closed ? "Close contour" : "Open contour",
    apply: (curve) => {
      const contour = curve.contours[index];
      return contour === undefined ? curve : replaceContour(curve, index, withClosed(curve, contour, closed));
    },
  };
}

export function reverseContour(index: number): Command {
  return {
    name: "Reverse",
    apply: (curve) => {
      const contour = curve.contours[index];
      return contour === undefined ? curve : replaceContour(curve, index, reversedContour(contour));
    },
    select: nothingSelected,
  };
}

export function startContourAt(ref: PointRef): Command {
  return {
    name: "Start here",
    apply: (curve) => {
      const contour = curve.contours[ref.contour];
      return contour === undefined ? curve : replaceContour(curve, ref.contour, startedAt(contour, ref.index));
    },
    select: only({ contour: ref.contour, index: 0 }),
  };
}

/** More than this would hide what was added under the marks of its being chosen. */
const mostChosen = 64;

/** Adds contours; `choose` chooses their points, so that they can be moved at once. */
export function addContours(name: string, contours: readonly Contour[], choose: boolean): Command {
  const points = contours.reduce((sum, contour) => sum + contour.points.length, 0);
  return {
    name,
    apply: (curve) => ({ ...curve, contours: [...curve.contours, ...contours] }),
    select: (after) => (choose && points <= mostChosen ? lastContours(after, contours.length) : nothingSelected),
  };
}

function lastContours(curve: CurveDocument, count: number): Selection {
  const first = curve.contours.length - count;
  const points = curve.contours.slice(first).flatMap((contour, k) => contour.points.map((_, index) => ({ contour: first + k, index })));
  return { points, handle: null };
}

/** Copies of the chosen contours' points, moved a little so that they can be seen. */
export function duplicateContours(indices: readonly number[], by: number): { copies: (curve: CurveDocument) => Contour[] } {
  return {
    copies: (curve) =>
      indices.flatMap((index) => {
        const contour = curve.contours[index];
        if (contour === undefined) return [];
        return [{ ...contour, points: contour.points.map((point) => ({ ...point, x: point.x + by, y: point.y + by })) }];
      }),
  };
}

/** Some contours over all others, or below them; the order among them stays, and what is chosen stays chosen. */
export function restacked(indices: readonly number[], selection: Selection, end: "front" | "back"): Command {
  const orderOf = ({ contours }: CurveDocument): number[] => {
    const all = [...contours.keys()];
    const [some, others] = [all.filter((index) => indices.includes(index)), all.filter((index) => !indices.includes(index))];
    return end === "front" ? [...others, ...some] : [...some, ...others];
  };
  return {
    name: end === "front" ? "Bring to front" : "Send to back",
    apply: (curve) => ({ ...curve, contours: orderOf(curve).flatMap((index) => curve.contours[index] ?? []) }),
    select(after) {
      // As many as before, so in the same order.
      const order = orderOf(after);
      return { points: selection.points.map(({ contour, index }) => ({ contour: order.indexOf(contour), index })), handle: null };
    },
  };
}
