import { lengthOf, type Contour, type ControlPoint, type CurveDocument, type Offset } from "../../document.ts";
import { arcAt, isLine, pointsOf, segmentsAt, step, type Place } from "./corners.ts";
import { kindOf, opposite, scaled } from "../offset.ts";
import { withPinnedOmega } from "../whole/rearranging.ts";

/** Arcs put in place of corners, and corners in place of arcs. */

/** Where a side of a corner is cut. */
export interface Cut {
  readonly at: Place;
  /** Which part of the side's segment lies before it, 0 … 1. */
  readonly part: number;
  /** The derivative of the segment there, by its part. */
  readonly tangent: Offset;
}

export interface Fillet {
  readonly radius: number;
  /** The angle of the arc, radians. */
  readonly angle: number;
  readonly before: Cut;
  readonly after: Cut;
}

export interface Rearranged {
  readonly contour: Contour;
  /** The first and the last point of each arc, or the corner twice; by the corner's point or the arc's segment. */
  readonly made: ReadonlyMap<number, readonly [number, number]>;
  /** Where the points are that stayed. */
  readonly stayed: ReadonlyMap<number, number>;
}

/** A contour that holds arcs exactly, and is the same curve. Null where hyperbolic curves are in the way. */
export function holdingArcs(curve: CurveDocument, contour: Contour): Contour | null {
  const space = contour.space ?? curve.space;
  const { omega = [], ...rest } = withPinnedOmega(curve, contour);
  if (space === "trigonometric") return { ...rest, omega };
  const asCubic = omega.map((own, segment) => (space === "polynomial" || isLine(contour, segment) ? 0 : own));
  // Only cubics belong to both spaces.
  return asCubic.every((own) => own === 0) ? { ...rest, omega: asCubic, space: "trigonometric" } : null;
}

/** Segments in their order, one with every point but the last of an open contour. */
class Rebuilding {
  readonly points: ControlPoint[] = [];
  readonly omega: number[] = [];
  readonly lengths: number[] = [];

  /** The point that came last gets the leaving handle of one at the same place. */
  merge(next: ControlPoint, isPlaced: boolean): void {
    const last = this.points.pop();
    const { x, y } = isPlaced || last === undefined ? next : last;
    const handles = { in: last?.in ?? next.in, out: next.out };
    this.points.push({ ...next, x, y, ...handles, kind: kindOf(handles) });
  }

  segment(omega: number, length: number): void {
    this.omega.push(omega);
    this.lengths.push(length);
  }

  contour({ lengths: _lengths, ...rest }: Contour): Contour {
    const even = this.lengths.every((length) => length === 1);
    return { ...rest, points: this.points, omega: this.omega, ...(even ? {} : { lengths: this.lengths }) };
  }
}

interface Kept {
  readonly out: Offset;
  readonly into: Offset;
  readonly omega: number;
  readonly length: number;
}

function line(from: Place, to: Place): { readonly out: Offset; readonly into: Offset } {
  const out = scaled(step(from, to), 1 / 3);
  return { out, into: opposite(out) };
}

/** Less of a side than this is nothing. */
const nothingLeft = 1e-9;

/** What is left of a segment between its cuts: undefined if it has none, null if nothing. */
function keptOf(contour: Contour, fillets: ReadonlyMap<number, Fillet>, segment: number): Kept | null | undefined {
  const ends = pointsOf(contour, segment);
  const [start, end] = [fillets.get(segment)?.after, fillets.get((segment + 1) % contour.points.length)?.before];
  if (ends === null || (start === undefined && end === undefined)) return undefined;
  const share = (end?.part ?? 1) - (start?.part ?? 0);
  if (share <= nothingLeft) return null;
  const whole = lengthOf(contour, segment);
  const length = whole * share;
  // Of a line nothing but its ends is seen: where no lengths are written down, none need be.
  if (isLine(contour, segment)) return { omega: 0, length: contour.lengths === undefined ? 1 : length, ...line(start?.at ?? ends[0], end?.at ?? ends[1]) };
  const out = start === undefined ? scaled(ends[0].out, share) : scaled(start.tangent, share / 3);
  const into = end === undefined ? scaled(ends[1].in, share) : opposite(scaled(end.tangent, share / 3));
  return { omega: contour.omega?.[segment] ?? 0, length, out, into };
}

function unit(offset: Offset): Offset {
  return scaled(offset, 1 / Math.hypot(offset.dx, offset.dy));
}

/** Without −0, which would not survive being written down. */
function clean({ dx, dy }: Offset): Offset {
  return { dx: dx + 0, dy: dy + 0 };
}

function joint({ x, y }: Place, into: Offset, out: Offset): ControlPoint {
  const handles = { in: clean(into), out: clean(out) };
  return { x: x + 0, y: y + 0, kind: kindOf(handles), ...handles };
}

/** A handle at a cut that has no segment left: what follows brings its own. */
const none: Offset = { dx: 0, dy: 0 };

/** The contour with arcs in place of the corners of these points. */
export function withFillets(contour: Contour, fillets: ReadonlyMap<number, Fillet>): Rearranged {
  const built = new Rebuilding();
  const made = new Map<number, readonly [number, number]>();
  const stayed = new Map<number, number>();
  let isGone = false;
  contour.points.forEach((point, index) => {
    const fillet = fillets.get(index);
    const [before, after] = segmentsAt(contour, index);
    const arriving = before === null ? undefined : keptOf(contour, fillets, before);
    const leaving = after === null ? undefined : keptOf(contour, fillets, after);
    const put = (fresh: ControlPoint): number => {
      if (isGone) built.merge(fresh, fillet === undefined);
      else built.points.push(fresh);
      isGone = false;
      return built.points.length - 1;
    };
    if (fillet === undefined) stayed.set(index, put(withHandles(point, arriving?.into, leaving?.out)));
    else {
      const [from, to] = [unit(fillet.before.tangent), unit(fillet.after.tangent)];
      const handle = (fillet.radius * fillet.angle) / 3;
      const first = put(joint(fillet.before.at, arriving?.into ?? none, scaled(from, handle)));
      const length = contour.lengths === undefined ? 1 : arcLength(contour, fillet, before, after);
      built.segment(fillet.angle / length, length);
      built.points.push(joint(fillet.after.at, opposite(scaled(to, handle)), leaving?.out ?? none));
      made.set(index, [first, built.points.length - 1]);
    }
    if (after === null) return;
    isGone = leaving === null;
    if (leaving !== null) built.segment(leaving?.omega ?? contour.omega?.[after] ?? 0, leaving?.length ?? lengthOf(contour, after));
  });
  if (isGone) joinRound(built, made, stayed, fillets.has(0));
  return { contour: built.contour(contour), made, stayed };
}

/** Nothing is left between the last point and the first: they are one. */
function joinRound(built: Rebuilding, made: Map<number, readonly [number, number]>, stayed: Map<number, number>, isCut: boolean): void {
  const last = built.points.length - 1;
  const first = built.points.shift();
  if (first === undefined) return;
  built.merge(first, !isCut);
  const merged = built.points.pop();
  if (merged !== undefined) built.points.unshift(merged);
  const moved = (index: number): number => (index === last ? 0 : index);
  for (const [key, [from, to]] of made) made.set(key, [moved(from), moved(to)]);
  for (const [key, index] of stayed) stayed.set(key, moved(index));
}

function withHandles(point: ControlPoint, into: Offset | undefined, out: Offset | undefined): ControlPoint {
  if (into === undefined && out === undefined) return point;
  const handles = { in: clean(into ?? point.in), out: clean(out ?? point.out) };
  return { ...point, ...handles, kind: point.kind === "cusp" ? "cusp" : kindOf(handles) };
}

/** As much of the parameter as the corner had that it stands for. */
function arcLength(contour: Contour, { before, after }: Fillet, arriving: number | null, leaving: number | null): number {
  const gone = (arriving === null ? 0 : (1 - before.part) * lengthOf(contour, arriving)) + (leaving === null ? 0 : after.part * lengthOf(contour, leaving));
  return gone > 0 ? gone : 1;
}

/** The contour with corners in place of these arcs, as `arcAt` finds them. */
export function sharpened(curve: CurveDocument, given: Contour, arcs: ReadonlySet<number>): Rearranged {
  const contour = withPinnedOmega(curve, given);
  const made = new Map<number, readonly [number, number]>();
  const stayed = new Map<number, number>();
  const nodes: { readonly point: ControlPoint; readonly segment: number | null; readonly isFresh: boolean }[] = [];
  contour.points.forEach((point, index) => {
    const [before, after] = segmentsAt(contour, index);
    // Where an arc began or ended its side goes straight on to the corner.
    const isPassed = [before, after].some((segment) => segment !== null && arcs.has(segment));
    if (!isPassed) {
      stayed.set(index, nodes.length);
      nodes.push({ point, segment: after, isFresh: false });
    }
    const arc = after !== null && arcs.has(after) ? arcAt(curve, contour, after) : null;
    if (after === null || arc === null) return;
    made.set(after, [nodes.length, nodes.length]);
    const [, next] = segmentsAt(contour, (index + 1) % contour.points.length);
    nodes.push({ point: { ...arc.corner, kind: "cusp", in: none, out: none }, segment: next, isFresh: true });
  });
  const built = new Rebuilding();
  nodes.forEach(({ point, segment, isFresh }, i) => {
    const [previous, next] = [nodes[(i + nodes.length - 1) % nodes.length], nodes[(i + 1) % nodes.length]];
    const into = previous !== undefined && (isFresh || previous.isFresh) ? line(previous.point, point).into : undefined;
    const out = next !== undefined && (isFresh || next.isFresh) ? line(point, next.point).out : undefined;
    built.points.push(withHandles(point, into, out));
    if (!contour.closed && i === nodes.length - 1) return;
    const length = segment === null ? 1 : lengthOf(contour, segment);
    built.segment(out === undefined && segment !== null ? contour.omega?.[segment] ?? 0 : 0, length);
  });
  return { contour: built.contour(contour), made, stayed };
}
