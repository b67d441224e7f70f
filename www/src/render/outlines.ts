import { partSegments, partsOf } from "../document/curve/parts.ts";
import type { Contour, CurveDocument } from "../document/document.ts";
import { boundsOf, type Bounds } from "../kernel/curve/samples.ts";
import { cubicsOf } from "../kernel/paths/paths.ts";
import { polylineOf } from "../kernel/paths/polylines.ts";
import { addCubics, addVertices, contourPath, overlap, pathOfPoints, sightOf, toleranceOf, type Scene } from "./scene.ts";

/** All contours of a drawing in one path. Of long contours it has what is in sight, and as fine as can be seen. */
export interface Outlines {
  readonly all: Path2D;
  readonly closed: Path2D;
}

/**
 * Contours in a path of `lines`: browsers stroke a thousand contours in a hundred paths in six tenths of the time that
 * one path of them takes.
 */
const contoursInLine = 30;

export interface DrawnOutlines extends Outlines {
  /** What `all` is, in several paths, for lines through which nothing shows. */
  readonly lines: readonly Path2D[];
}

interface Kept extends DrawnOutlines {
  readonly tolerance: number;
  /** Outside of this box long contours are not where they are drawn; null where there is none. */
  readonly within: Bounds | null;
}

const wholes = new WeakMap<CurveDocument, Kept>();

/**
 * The contours of a drawing together: one of thousands is stroked and filled in a few calls, and panning makes nothing
 * new.
 */
export function documentPaths(scene: Scene, document: CurveDocument): DrawnOutlines {
  const [tolerance, sight] = [toleranceOf(scene), sightOf(scene)];
  const known = wholes.get(document);
  if (known !== undefined && known.tolerance === tolerance && (known.within === null || encloses(known.within, sight))) return known;
  const isLong = document.contours.some((contour) => partsOf(document, contour).length > 1);
  const within = isLong ? grown(sight) : null;
  const paths = document.contours.map((contour) => (within === null ? partPath(scene, document, contour) : pathWithin(scene, document, contour, within)));
  const fresh: Kept = Object.assign(outlinesOf(paths, document), { tolerance, within });
  wholes.set(document, fresh);
  return fresh;
}

/** Each is put together when it is first asked for. */
function outlinesOf(paths: readonly Path2D[], { contours }: CurveDocument): DrawnOutlines {
  const all = once(() => joined(paths));
  const closed = once(() => (contours.every((contour) => contour.closed) ? all() : joined(paths.filter((_, i) => contours[i]?.closed === true))));
  const lines = once(() => Array.from({ length: Math.ceil(paths.length / contoursInLine) }, (_, i) => joined(paths.slice(contoursInLine * i, contoursInLine * (i + 1)))));
  return {
    get all() {
      return all();
    },
    get closed() {
      return closed();
    },
    get lines() {
      return lines();
    },
  };
}

function once<T>(make: () => T): () => T {
  let made: { readonly value: T } | undefined;
  return () => (made ??= { value: make() }).value;
}

function joined(paths: readonly Path2D[]): Path2D {
  const path = new Path2D();
  for (const each of paths) path.addPath(each);
  return path;
}

/** So much more than what is in sight on every side, so that panning makes a new path only now and then. */
const beyond = 0.5;

function grown({ minX, minY, maxX, maxY }: Bounds): Bounds {
  const [width, height] = [beyond * (maxX - minX), beyond * (maxY - minY)];
  return { minX: minX - width, minY: minY - height, maxX: maxX + width, maxY: maxY + height };
}

function encloses(outer: Bounds, inner: Bounds): boolean {
  return inner.minX >= outer.minX && inner.minY >= outer.minY && inner.maxX <= outer.maxX && inner.maxY <= outer.maxY;
}

/** Whether a contour or a part may be in sight; else all of it lies beyond one and the same side. */
export function isSeen(document: CurveDocument, part: Contour, sight: Bounds): boolean {
  const box = boundsOf(document, part);
  return box !== null && overlap(box, sight);
}

/**
 * A part beyond one side of what is in sight is a straight line: it lies beyond that side, too, so that neither line
 * nor filled area differ in sight.
 */
function pathWithin(scene: Scene, document: CurveDocument, contour: Contour, within: Bounds): Path2D {
  const parts = partsOf(document, contour);
  if (parts.length === 1) return partPath(scene, document, contour);
  const path = new Path2D();
  const tolerance = toleranceOf(scene);
  const [first] = contour.points;
  if (first !== undefined) path.moveTo(first.x, first.y);
  for (const part of parts) {
    const end = part.points.at(-1);
    if (!isSeen(document, part, within)) {
      if (end !== undefined) path.lineTo(end.x, end.y);
    } else if (isDense(scene, part)) addVertices(path, polylineOf(document, part, tolerance));
    else addCubics(path, cubicsOf(document, part, tolerance));
  }
  if (contour.closed) path.closePath();
  return path;
}

/** A contour, or a part of one, by itself. */
export function partPath(scene: Scene, document: CurveDocument, part: Contour): Path2D {
  if (!isDense(scene, part)) return contourPath(scene, document, part);
  return pathOfPoints(polylineOf(document, part, toleranceOf(scene)), part.closed);
}

/** CSS pixels between points, up to which a polyline has fewer vertices than there are segments. */
const dense = 1.5;
const steps = new WeakMap<Contour, number>();

/** Whether the segments of a part are too short to be seen one by one. */
export function isDense({ state }: Scene, part: Contour): boolean {
  return part.points.length >= partSegments / 2 && stepOf(part) * state.view.zoom < dense;
}

/** From one point to the next, on average. */
export function stepOf(part: Contour): number {
  const { points } = part;
  const step = steps.get(part)
    ?? points.reduce((sum, { x, y }, i) => sum + Math.hypot(x - (points[i - 1]?.x ?? x), y - (points[i - 1]?.y ?? y)), 0) / points.length;
  steps.set(part, step);
  return step;
}
