import type { Contour, CurveDocument, Offset } from "../../../document/document.ts";
import { lengthOf, omegaOf } from "../../../document/document.ts";
import { dot, isLine, pointsOf, step, type Place } from "../../../document/curve/corners/corners.ts";
import type { Cut } from "../../../document/curve/corners/fillets.ts";
import { hermiteOf } from "../curve-cache.ts";

/** The two segments that meet at a corner, each followed from the corner outwards. */

/** A place on a side, the direction in which the contour runs there, and how fast by the side's own parameter. */
export interface SidePlace extends Place {
  /** From 0 at the corner to 1 at the other end. */
  readonly part: number;
  /** Of the contour's direction, not of the side's: of length 1. */
  readonly direction: Offset;
  readonly speed: number;
}

export interface Side {
  /** Null where the curve stands still, so that it has no direction. */
  at(part: number): SidePlace | null;
  nearest(x: number, y: number): { readonly part: number; readonly x: number; readonly y: number; readonly distance: number };
  /** Up to which part an arc may reach. */
  readonly most: number;
  /** No place of it is farther from the corner. */
  readonly reach: number;
  readonly isLine: boolean;
}

/** The side of a corner before it, or behind it; `half` of it where its other end is rounded as well. */
export function sideOf(document: CurveDocument, contour: Contour, segment: number, isBefore: boolean, half: boolean): Side | null {
  const ends = pointsOf(contour, segment);
  if (ends === null) return null;
  return isLine(contour, segment) ? lineSide(...(isBefore ? [ends[1], ends[0]] as const : ends), isBefore, half) : curvedSide(document, contour, segment, isBefore, half);
}

function lineSide(corner: Place, end: Place, isBefore: boolean, half: boolean): Side {
  const chord = step(corner, end);
  const length = Math.hypot(chord.dx, chord.dy);
  const outwards = { dx: chord.dx / length, dy: chord.dy / length };
  const direction = isBefore ? { dx: -outwards.dx, dy: -outwards.dy } : outwards;
  const place = (part: number): Place => (part === 1 ? { x: end.x, y: end.y } : { x: corner.x + part * chord.dx, y: corner.y + part * chord.dy });
  return {
    isLine: true,
    most: half ? 0.5 : 1,
    reach: length,
    at: (part) => ({ ...place(part), part, direction, speed: length }),
    nearest(x, y) {
      const part = Math.min(1, Math.max(0, dot(step(corner, { x, y }), chord) / (length * length)));
      const at = place(part);
      return { ...at, part, distance: Math.hypot(at.x - x, at.y - y) };
    },
  };
}

/** Below this part of the side's size, a derivative is rounding. */
const still = 1e-9;

function curvedSide(document: CurveDocument, contour: Contour, segment: number, isBefore: boolean, half: boolean): Side | null {
  const [from, to] = pointsOf(contour, segment) ?? [];
  if (from === undefined || to === undefined) return null;
  const length = lengthOf(contour, segment);
  const { space = document.space } = contour;
  const alone: Contour = { family: "hermite", closed: false, points: [from, to], space, lengths: [length], omega: [omegaOf(document, contour, segment)] };
  const curve = hermiteOf(document, alone);
  if (curve === null) return null;
  const size = curve.length(1e-6);
  if (!(size > 0)) return null;
  const parameter = (part: number): number => Math.min(length, Math.max(0, (isBefore ? 1 - part : part) * length));
  const partOf = (t: number): number => (isBefore ? 1 - t / length : t / length);
  return {
    isLine: false,
    most: half ? partOf(curve.parameterAtLength(size / 2)) : 1,
    reach: size,
    at(part) {
      const t = parameter(part);
      const [x = 0, y = 0] = curve.evaluate(t);
      const [dx = 0, dy = 0] = curve.evaluate(t, 1);
      const speed = Math.hypot(dx, dy);
      if (speed * length > still * size) return { x, y, part, direction: { dx: dx / speed, dy: dy / speed }, speed: speed * length };
      // Without a handle the curve sets out, or comes in, along its second derivative.
      const [ddx = 0, ddy = 0] = curve.evaluate(t, 2);
      const bend = Math.hypot(ddx, ddy) * (t > length / 2 ? -1 : 1);
      return bend === 0 || (t > 0 && t < length) ? null : { x, y, part, direction: { dx: ddx / bend, dy: ddy / bend }, speed: 0 };
    },
    nearest(x, y) {
      const found = curve.nearest(x, y);
      return { x: found.x, y: found.y, part: partOf(found.t), distance: found.distance };
    },
  };
}

/** The cut of a side at a place of it, by the part of its segment. */
export function cutAt({ x, y, part, direction, speed }: SidePlace, isBefore: boolean): Cut {
  return { at: { x, y }, part: isBefore ? 1 - part : part, tangent: { dx: direction.dx * speed, dy: direction.dy * speed } };
}
