import type { Offset } from "../../../document/document.ts";
import { cross, dot, mostTurn, step, type Place } from "../../../document/curve/corners/corners.ts";
import type { Side, SidePlace } from "./sides.ts";

/**
 * Circles that touch both sides of a corner from inside.
 *
 * The circle that touches the first side at p, with unit normal n, and passes through q has the radius |q − p|² / (2
 * n·(q − p)). The least of these over the second side is the one circle that touches both; it is a minimum of
 * continuous functions of p, and so continuous in p. Its radius is 0 at the corner: between the corner and a p whose
 * circle is too large there is one whose circle has the radius that is asked for, and bisection finds it.
 */

export interface Touching {
  readonly radius: number;
  /** The angle of the arc between the two places. */
  readonly angle: number;
  readonly before: SidePlace;
  readonly after: SidePlace;
}

export interface Corner {
  readonly before: Side;
  readonly after: Side;
  /** 1 where the contour turns from x to y, −1 where it turns the other way. */
  readonly turn: 1 | -1;
}

/** A circle comes this near to a side that it touches, as part of its radius. */
const touch = 1e-9;
/** Places of the first side that are looked at, denser towards the corner. */
const places = 64;
/** Halvings of an interval until its ends are neighbours among numbers. */
const halvings = 60;
/** Circles through ever nearer places; each step at least halves what is too much near the end. */
const mostSteps = 80;

function placeOf({ before }: Corner, k: number): number {
  return k === places ? before.most : before.most * (k / places) ** 3;
}

function inwards({ direction: { dx, dy } }: SidePlace, turn: number): Offset {
  return { dx: 0 - turn * dy, dy: turn * dx };
}

function centreOf(place: SidePlace, turn: number, radius: number): Place {
  const normal = inwards(place, turn);
  return { x: place.x + radius * normal.dx, y: place.y + radius * normal.dy };
}

/** The radius of the largest circle that touches a side at a place and has nothing of the other side in it. */
function largestAt(place: SidePlace, other: Side, turn: number, most: number): number {
  const normal = inwards(place, turn);
  let radius = most;
  for (let i = 0; i < mostSteps; i += 1) {
    const found = other.nearest(place.x + radius * normal.dx, place.y + radius * normal.dy);
    if (found.distance >= radius * (1 - 1e-14)) return radius;
    const chord = step(place, found);
    const next = dot(chord, chord) / (2 * dot(normal, chord));
    if (!(next < radius)) return radius;
    radius = next;
  }
  return radius;
}

/** The circle of a radius that touches one side at a place, if it touches the other as well, and both from inside. */
function touchingAt({ before, after, turn }: Corner, own: "before" | "after", place: SidePlace, radius: number): Touching | null {
  const [side, other] = own === "before" ? [before, after] : [after, before];
  const centre = centreOf(place, turn, radius);
  const found = other.nearest(centre.x, centre.y);
  const across = found.part > 0 && found.part <= other.most * (1 + 1e-12) ? other.at(Math.min(found.part, other.most)) : null;
  if (across === null || Math.abs(found.distance - radius) > touch * radius) return null;
  const normal = inwards(across, turn);
  const isTouched = Math.hypot(across.x + radius * normal.dx - centre.x, across.y + radius * normal.dy - centre.y) <= 1e-6 * radius;
  // A circle that is bent less than its own side would cut into it.
  const isFree = side.nearest(centre.x, centre.y).distance >= radius * (1 - touch);
  const [first, second] = own === "before" ? [place, across] : [across, place];
  const angle = Math.atan2(turn * cross(first.direction, second.direction), dot(first.direction, second.direction));
  return isTouched && isFree && angle > 0 && angle <= mostTurn ? { radius, angle, before: first, after: second } : null;
}

/** The engine looks at no place farther away than 1e9, and the drawing ends at a tenth of that. */
const farthest = 5e8;

/** Between lines that turn by a degree, the least that is a corner, the largest radius is 115 times their length. */
function mostOf({ before, after }: Corner): number {
  return Math.min(farthest, 120 * (before.reach + after.reach));
}

interface Looked {
  readonly part: number;
  readonly radius: number;
  readonly found: Touching | null;
}

function look(corner: Corner, part: number): Looked {
  const { before, after, turn } = corner;
  const place = before.at(part);
  const most = mostOf(corner);
  const radius = place === null ? 0 : largestAt(place, after, turn, most);
  return { part, radius, found: place === null || radius >= most ? null : touchingAt(corner, "before", place, radius) };
}

/** The circle at the end of the second side, which uses all of it. */
function atEndOfSecond(corner: Corner): Looked | null {
  const { before, after, turn } = corner;
  const place = after.at(after.most);
  const most = mostOf(corner);
  const radius = place === null ? 0 : largestAt(place, before, turn, most);
  const found = place === null || radius >= most ? null : touchingAt(corner, "after", place, radius);
  return found === null ? null : { part: found.before.part, radius, found };
}

/** Between a place with a circle and one without, the farthest with one. */
function border(corner: Corner, good: Looked, bad: number): Looked {
  let [last, beyond] = [good, bad];
  for (let i = 0; i < halvings; i += 1) {
    const next = look(corner, (last.part + beyond) / 2);
    if (next.found === null) beyond = next.part;
    else last = next;
  }
  return last;
}

/** Circles from the corner outwards, as far as they touch both sides. */
function circles(corner: Corner): Looked[] {
  const all: Looked[] = [];
  for (let k = 1; k <= places; k += 1) {
    const next = look(corner, placeOf(corner, k));
    const last = all.at(-1);
    if (next.found !== null) all.push(next);
    else if (last !== undefined) {
      const end = atEndOfSecond(corner);
      return [...all, end !== null && end.part > last.part && end.part < next.part ? end : border(corner, last, next.part)];
    }
  }
  return all;
}

/** Whether the circle of a radius that touches the first side at a part of it has nothing of the second side in it. */
function isFreeAt({ before, after, turn }: Corner, part: number, radius: number): boolean {
  const place = before.at(part);
  if (place === null) return false;
  const centre = centreOf(place, turn, radius);
  return after.nearest(centre.x, centre.y).distance >= radius;
}

/** The circle of a radius, where it is too large at one place of the first side and not at another. */
function between(corner: Corner, radius: number, small: number, large: number): Touching | null {
  let [near, far] = [small, large];
  for (let i = 0; i < halvings; i += 1) {
    const part = (near + far) / 2;
    if (isFreeAt(corner, part, radius)) far = part;
    else near = part;
  }
  const place = corner.before.at(far);
  return place === null ? null : touchingAt(corner, "before", place, radius);
}

/** The first circle of a radius from the corner outwards; null where that one does not touch as it should. */
function firstOf(corner: Corner, radius: number): Touching | null {
  let last = 0;
  for (let k = 1; k <= places; k += 1) {
    const part = placeOf(corner, k);
    if (isFreeAt(corner, part, radius)) return between(corner, radius, last, part);
    last = part;
  }
  return null;
}

/**
 * The circle of this radius that touches both sides, or the largest one if there is none as large: `Infinity` asks for
 * that. Null where no circle fits into the corner.
 */
export function touchingCircle(corner: Corner, radius: number): Touching | null {
  const first = radius < mostOf(corner) ? firstOf(corner, radius) : null;
  if (first !== null) return first;
  const all = circles(corner);
  const [largest] = [...all].sort((a, b) => b.radius - a.radius);
  if (largest === undefined || radius >= largest.radius * (1 - touch)) return largest?.found ?? null;
  const index = all.findIndex((each) => each.radius >= radius);
  return between(corner, radius, all[index - 1]?.part ?? 0, all[index]?.part ?? 0);
}
