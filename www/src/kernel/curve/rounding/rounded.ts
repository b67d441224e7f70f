import { mostTurn, leastTurn, cross, dot, isLine, segmentsAt } from "../../../document/curve/corners/corners.ts";
import { holdingArcs, withFillets, type Fillet, type Rearranged } from "../../../document/curve/corners/fillets.ts";
import type { Contour, CurveDocument } from "../../../document/document.ts";
import { cutAt, sideOf, type Side } from "./sides.ts";
import { touchingCircle } from "./touching-circle.ts";

/** Corners of a contour rounded by arcs of circles, which touch both sides and are exact. */

/** Why a corner stays as it is. */
export type Refusal = "space" | "sharp" | "room";

export interface Rounded extends Rearranged {
  /** The radius of each arc, by the corner's point. */
  readonly radii: ReadonlyMap<number, number>;
  readonly refused: ReadonlyMap<number, Refusal>;
}

/**
 * A contour with these corners rounded, none with more than the radius that is asked for: `Infinity` asks for the
 * largest. An arc ends on the two segments that meet in its corner; where both ends of a segment are rounded at once,
 * each has half of it.
 */
export function rounded(document: CurveDocument, given: Contour, corners: readonly number[], radius: number): Rounded {
  const contour = holdingArcs(document, given);
  const refused = new Map<number, Refusal>();
  const fillets = new Map<number, Fillet>();
  const all = new Set(corners);
  for (const index of all) {
    const fillet = contour === null ? "space" : !(radius > 0) ? "room" : filletAt(document, contour, all, index, radius);
    if (typeof fillet === "string") refused.set(index, fillet);
    else fillets.set(index, fillet);
  }
  const next = contour === null || fillets.size === 0 ? { contour: given, made: new Map(), stayed: new Map(given.points.map((_, i) => [i, i])) } : withFillets(contour, fillets);
  return { ...next, refused, radii: new Map([...fillets].map(([index, fillet]) => [index, fillet.radius])) };
}

function filletAt(document: CurveDocument, contour: Contour, all: ReadonlySet<number>, index: number, radius: number): Fillet | Refusal {
  const [before, after] = segmentsAt(contour, index);
  if (before === null || after === null || before === after) return "room";
  const count = contour.points.length;
  const [first, second] = [sideOf(document, contour, before, true, all.has((index + count - 1) % count)), sideOf(document, contour, after, false, all.has((index + 1) % count))];
  const [arriving, leaving] = [first?.at(0)?.direction, second?.at(0)?.direction];
  if (first === null || second === null || arriving === undefined || leaving === undefined) return "room";
  const [sine, cosine] = [cross(arriving, leaving), dot(arriving, leaving)];
  const angle = Math.atan2(Math.abs(sine), cosine);
  if (angle > mostTurn) return "sharp";
  if (angle < leastTurn) return "room";
  const corner = { before: first, after: second, turn: sine < 0 ? -1 : 1 } as const;
  if (isLine(contour, before) && isLine(contour, after)) {
    // The tangent of half the angle: a right angle's is 1, to the last bit.
    const tangent = cosine < 0 ? (1 - cosine) / Math.abs(sine) : Math.abs(sine) / (1 + cosine);
    return betweenLines(first, second, { angle, tangent }, radius);
  }
  const found = touchingCircle(corner, radius);
  return found === null ? "room" : { radius: found.radius, angle: found.angle, before: cutAt(found.before, true), after: cutAt(found.after, false) };
}

/** Between two lines the arc begins and ends as far from the corner as the radius and the angle say. */
function betweenLines(first: Side, second: Side, { angle, tangent }: { readonly angle: number; readonly tangent: number }, asked: number): Fillet | Refusal {
  const [shorter, longer] = [first, second].map(({ reach, most }) => reach * most).sort((a, b) => a - b);
  const most = shorter === undefined ? 0 : shorter / tangent;
  const radius = Math.min(asked, most);
  const away = asked >= most && shorter !== undefined ? shorter : radius * tangent;
  const cut = (side: Side): ReturnType<Side["at"]> => {
    const limit = side.reach * side.most;
    // Where all of it is used, or as good as all, the arc ends where the side does.
    return side.at(limit - away <= 1e-12 * limit ? side.most : away / side.reach);
  };
  const [before, after] = [cut(first), cut(second)];
  if (longer === undefined || before === null || after === null || !(radius > 0)) return "room";
  return { radius, angle, before: cutAt(before, true), after: cutAt(after, false) };
}

