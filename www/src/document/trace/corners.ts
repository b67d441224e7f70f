import { lengthOfOffset, scaled, turnAt, withKind } from "../curve/offset.ts";
import type { Contour, ControlPoint, Offset } from "../document.ts";
import { choiceAt, type CornerChoice } from "./trace.ts";

/**
 * Which points of a traced outline are corners: for the tracer to say, though it names places, not points; and for
 * whoever knows better.
 */

export interface CornerSearch {
  /** How far from a corner that was found its point may be. */
  readonly within: number;
  /** Radians of turning from which on a point is a corner, found or not. */
  readonly least: number;
}

/**
 * The outline with its corners named. Each corner that was found is the point nearest to it. Another point is smooth,
 * though its handles differ by a rounding error: unless they turn as much as a corner was asked to.
 */
export function withFoundCorners(contour: Contour, corners: readonly (readonly [number, number])[], { within, least }: CornerSearch): Contour {
  const found = new Set(corners.map(([x, y]) => nearestPoint(contour.points, x, y, within)));
  const points = contour.points.map((point, i) => {
    const isCorner = found.has(i) || (point.kind === "cusp" && turnAt(point) >= least);
    if (isCorner === (point.kind === "cusp")) return point;
    return { ...point, kind: isCorner ? "cusp" as const : "smooth" as const };
  });
  return { ...contour, points };
}

/** −1: none is near. */
function nearestPoint(points: readonly ControlPoint[], x: number, y: number, within: number): number {
  let [best, least] = [-1, within];
  points.forEach((point, i) => {
    const distance = Math.hypot(point.x - x, point.y - y);
    if (distance <= least) [best, least] = [i, distance];
  });
  return best;
}

/** The outline with what was decided about its corners by hand; the same object where nothing was. */
export function withDecided(contour: Contour, choices: readonly CornerChoice[]): Contour {
  const points = contour.points.map((point, i) => {
    const choice = choiceAt(choices, point.x, point.y);
    if (choice === undefined || (choice.kind === "cusp") === (point.kind === "cusp")) return point;
    // A corner's handles are free, and stand where they stood: the outline stays until one is dragged.
    return choice.kind === "cusp" ? { ...point, kind: "cusp" as const } : smoothed(contour, i, point);
  });
  return points.every((point, i) => point === contour.points[i]) ? contour : { ...contour, points };
}

/**
 * As far as smoothing may take an outline off straight sides, in pixels: enough for a joint that can be seen and
 * turned.
 */
const offSides = 1;
/** The share of a handle's movement that the curve follows, where it follows most. */
const followed = 4 / 9;

/**
 * A corner with both handles on the line half-way between, each as long as keeps its side where it is, and no longer
 * than it was.
 */
function smoothed(contour: Contour, i: number, point: ControlPoint): ControlPoint {
  const [before, after] = [neighbour(contour, i, -1), neighbour(contour, i, 1)];
  const own = {
    ...point,
    in: handleTo(point, point.in, before),
    out: handleTo(point, point.out, after),
  };
  const turned = withKind(own, "smooth", own);
  return {
    ...turned,
    in: nearSide(turned.in, own.in, point, before, before?.out),
    out: nearSide(turned.out, own.out, point, after, after?.in),
  };
}

function neighbour({ points, closed }: Contour, i: number, by: number): ControlPoint | null {
  if (!closed && points[i + by] === undefined) return null;
  return points[(i + by + points.length) % points.length] ?? null;
}

/** A handle without length goes for its neighbour, as that side does. */
function handleTo(point: ControlPoint, handle: Offset, other: ControlPoint | null): Offset {
  if (other === null || lengthOfOffset(handle) > 0) return handle;
  return { dx: (other.x - point.x) / 3, dy: (other.y - point.y) / 3 };
}

/**
 * The turned handle, as long as leaves the side in place where it follows most, a third of the way from here: moving
 * the handle's end by Δ moves that place by Δ · 4/9, and only what is across the side there can be seen. Beside a line
 * that length is 0, which would be a corner still: it is then what takes the side `offSides` away.
 */
function nearSide(turned: Offset, old: Offset, point: ControlPoint, other: ControlPoint | null, facing: Offset | undefined): Offset {
  const [length, size] = [lengthOfOffset(old), lengthOfOffset(turned)];
  if (other === null || facing === undefined || length === 0 || size === 0) return turned;
  const unit = scaled(turned, 1 / size);
  const chord = { dx: other.x - point.x, dy: other.y - point.y };
  // Where a cubic is headed a third of the way, which this handle has no part in.
  const along = { dx: 4 * chord.dx + 3 * facing.dx, dy: 4 * chord.dy + 3 * facing.dy };
  if (lengthOfOffset(along) === 0) return turned;
  const across = (offset: Offset): number => (along.dx * offset.dy - along.dy * offset.dx) / lengthOfOffset(along);
  const short = Math.min(length, offSides / (followed * Math.abs(across(unit))));
  const still = across(old) / across(unit);
  return scaled(unit, Math.min(length, Math.max(short, Number.isFinite(still) ? still : 0)));
}
