import { HermiteCurve, parsePath } from "expline/slim";
import { joined } from "../../document/curve/whole/rearranging.ts";
import type { Contour, Space } from "../../document/document.ts";
import { Problem } from "../../document/problem.ts";
import { contourFrom } from "../curve/points/contours.ts";
import { errorCode } from "../engine.ts";
import { closedByLine, joinedNearly, nearIn } from "./closing.ts";

/** Drawings from outside as contours: exact where they are lines, cubics, quadratics or arcs. */

export interface ImportedPath {
  readonly contours: readonly Contour[];
  /** Where the text stopped making sense; what stood before it is in `contours`. */
  readonly broken: Problem | null;
}

/** As in SVG's `matrix(a b c d e f)`. */
export type Matrix = readonly [number, number, number, number, number, number];

/** What subpaths that do not say that they are closed are: lines, areas, or not known to be either. */
export type Drawn = "lines" | "areas" | "either";

/** The subpaths of a `d`, moved by an SVG matrix. @throws Problem when there is nothing to read at all. */
export function importPath(d: string, space: Space, matrix: Matrix | null = null, drawn: Drawn = "either"): ImportedPath {
  let broken: Problem | null = null;
  try {
    const curves = parsePath(d, { onWarning: (warning) => { broken = stops(d, warning.index); } });
    const moved = matrix === null ? curves : curves.map((curve) => curve.transform(matrix));
    return { contours: closed(moved.map((curve) => joined(contourFrom(curve, space))), drawn).map(withSmoothJoints), broken };
  } catch (error) {
    throw asProblem(error, d);
  }
}

function closed(contours: readonly Contour[], drawn: Drawn): readonly Contour[] {
  if (drawn === "lines" || contours.every((contour) => contour.closed)) return contours;
  const near = nearIn(contours);
  const met = contours.map((contour) => joinedNearly(contour, near));
  return drawn === "areas" ? met.map(closedByLine) : met;
}

/** The box around the outlines of a `d`; null where they cannot be read, or there are none. */
export function boundsOfPath(d: string): { left: number; top: number; right: number; bottom: number } | null {
  try {
    const boxes = parsePath(d, { onWarning: () => undefined }).map((curve) => curve.bounds());
    if (boxes.length === 0) return null;
    const least = (of: "minX" | "minY"): number => boxes.reduce((least, box) => Math.min(least, box[of]), Infinity);
    const most = (of: "maxX" | "maxY"): number => boxes.reduce((most, box) => Math.max(most, box[of]), -Infinity);
    return { left: least("minX"), top: least("minY"), right: most("maxX"), bottom: most("maxY") };
  } catch {
    // Whoever reads it for its shapes hears why.
    return null;
  }
}

/** The length of the outlines of a `d`, all together; null where they cannot be read. */
export function lengthOfPath(d: string): number | null {
  try {
    return parsePath(d, { onWarning: () => undefined }).reduce((sum, curve) => sum + curve.length(), 0);
  } catch {
    return null;
  }
}

/** Files are written with few decimals: what was drawn smooth comes in with a kink of a fraction of a degree. */
const kinkDegrees = 2;

/** Joints that were meant smooth are called smooth, so that their handles turn together. Nothing is moved. */
function withSmoothJoints(contour: Contour): Contour {
  const least = Math.cos((kinkDegrees * Math.PI) / 180);
  const points = contour.points.map((point) => {
    const { in: before, out: after } = point;
    const product = Math.hypot(before.dx, before.dy) * Math.hypot(after.dx, after.dy);
    const straight = product > 0 && -(before.dx * after.dx + before.dy * after.dy) >= least * product;
    return point.kind === "cusp" && straight ? { ...point, kind: "smooth" as const } : point;
  });
  return { ...contour, points };
}

function stops(d: string, offset: number): Problem {
  // Counted from 1, as people count characters; the excerpt starts at the one that is wrong.
  return new Problem("d-broken", { at: offset + 1, excerpt: d.slice(offset, offset + 12) });
}

function asProblem(error: unknown, d: string): unknown {
  switch (errorCode(error)) {
    case "E_PARSE_SVG":
      return stops(d, error instanceof Error && "index" in error && typeof error.index === "number" ? error.index : 0);
    case "E_RANGE":
    case "E_NOT_FINITE":
      return new Problem("d-range");
    case "E_LIMIT":
      return new Problem("d-big");
    default:
      return error;
  }
}

/** A smooth open or closed curve through points, as smooth as its end conditions allow. */
export function importPoints(points: readonly (readonly [number, number])[], closed: boolean, space: Space): Contour {
  return contourFrom(HermiteCurve.through(Float64Array.from(points.flat()), { closed }), space);
}
