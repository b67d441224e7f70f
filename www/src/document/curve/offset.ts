import { noOffset, type ControlPoint, type Kind, type Offset, type Side } from "../document.ts";

/** Arithmetic on handles. A handle is an offset from its point. */

export function lengthOfOffset(offset: Offset): number {
  return Math.hypot(offset.dx, offset.dy);
}

export function scaled(offset: Offset, factor: number): Offset {
  return { dx: offset.dx * factor, dy: offset.dy * factor };
}

/** The opposite offset; keeps zero positive, so that documents compare equal after two turns. */
export function opposite(offset: Offset): Offset {
  return { dx: offset.dx === 0 ? 0 : -offset.dx, dy: offset.dy === 0 ? 0 : -offset.dy };
}

/** `offset` turned to point against `other`, with its own length. */
export function against(offset: Offset, other: Offset): Offset {
  const along = lengthOfOffset(other);
  return along === 0 ? offset : scaled(opposite(other), lengthOfOffset(offset) / along);
}

/** The point with one handle set and its partner following as the point's kind asks. */
export function withHandle(point: ControlPoint, side: Side, offset: Offset): ControlPoint {
  const partner = side === "out" ? point.in : point.out;
  const other = follow(point.kind, offset, partner);
  return side === "out" ? { ...point, out: offset, in: other } : { ...point, in: offset, out: other };
}

function follow(kind: Kind, moved: Offset, partner: Offset): Offset {
  switch (kind) {
    case "symmetric":
      return opposite(moved);
    case "smooth":
      // A handle of no length has no direction to give: the partner stays.
      return lengthOfOffset(moved) === 0 ? partner : against(partner, moved);
    case "cusp":
      return partner;
  }
}

/**
 * The point with its handles brought in line with a kind; the mean direction is kept. `automatic` serves points without
 * handles.
 */
export function withKind(point: ControlPoint, kind: Kind, automatic: { in: Offset; out: Offset }): ControlPoint {
  if (kind === "cusp") return { ...point, kind };
  const arriving = lengthOfOffset(point.in);
  const leaving = lengthOfOffset(point.out);
  if (arriving === 0 && leaving === 0) return { ...point, kind, in: automatic.in, out: automatic.out };
  const direction = meanDirection(point, arriving, leaving);
  // One retracted handle takes the other's length: a smooth point needs both to be seen and turned.
  const before = arriving === 0 ? leaving : arriving;
  const after = leaving === 0 ? arriving : leaving;
  if (kind === "symmetric") {
    const out = scaled(direction, (before + after) / 2);
    return { ...point, kind, out, in: opposite(out) };
  }
  return { ...point, kind, out: scaled(direction, after), in: opposite(scaled(direction, before)) };
}

/** The unit direction half-way between the leaving handle and the arriving one reversed. */
function meanDirection(point: ControlPoint, arriving: number, leaving: number): Offset {
  const forward = leaving === 0 ? noOffset : scaled(point.out, 1 / leaving);
  const backward = arriving === 0 ? noOffset : scaled(point.in, -1 / arriving);
  const sum = { dx: forward.dx + backward.dx, dy: forward.dy + backward.dy };
  const size = lengthOfOffset(sum);
  // Handles folded onto each other have no mean: turn a quarter, as a cusp smoothed by hand would.
  if (size < 1e-9) return { dx: -forward.dy, dy: forward.dx };
  return scaled(sum, 1 / size);
}

/** Whether the two handles lie on one line through the point, on opposite sides. */
export function areOpposite(point: ControlPoint, tolerance = 1e-6): boolean {
  const product = lengthOfOffset(point.in) * lengthOfOffset(point.out);
  if (product === 0) return false;
  const cross = point.in.dx * point.out.dy - point.in.dy * point.out.dx;
  const dot = point.in.dx * point.out.dx + point.in.dy * point.out.dy;
  return dot < 0 && Math.abs(cross) <= tolerance * product;
}

/** By how much the direction changes at a point, 0 … π radians; 0 where a handle has no length and so no direction. */
export function turnAt({ in: before, out: after }: Pick<ControlPoint, "in" | "out">): number {
  const cross = after.dx * before.dy - after.dy * before.dx;
  const dot = -(before.dx * after.dx + before.dy * after.dy);
  return Math.atan2(Math.abs(cross), dot);
}

/** The kind that a point's handles show. */
export function kindOf(point: Pick<ControlPoint, "in" | "out">): Kind {
  const probe: ControlPoint = { x: 0, y: 0, kind: "cusp", in: point.in, out: point.out };
  if (!areOpposite(probe)) return "cusp";
  const arriving = lengthOfOffset(point.in);
  const leaving = lengthOfOffset(point.out);
  return Math.abs(arriving - leaving) <= 1e-9 * (arriving + leaving) ? "symmetric" : "smooth";
}
