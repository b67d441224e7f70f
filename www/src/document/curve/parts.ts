import { lengthOf, omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument, type Space } from "../document.ts";
import { translatedAs, translationOf, type Translation } from "./contours.ts";
import { opposite } from "./offset.ts";

/**
 * Long contours in parts: open contours of some hundred segments each, which are the same objects as long as nothing of
 * theirs is another. What is known of a part stays while the others are edited, and what is out of sight is not looked
 * at.
 */

/**
 * Segments of a part. Fewer would be more to look through for each picture, more would be more to compute for each
 * edit.
 */
export const partSegments = 512;

interface Known {
  readonly space: Space;
  readonly omega: number | "auto";
  readonly parts: readonly Contour[];
}

const known = new WeakMap<Contour, Known>();
/** The last part that began with a point: an edited contour has most of its points in common with the one before. */
const begunWith = new WeakMap<ControlPoint, Contour>();

/**
 * A contour in parts, one behind the other; itself where it is short, or where its segments depend on more than their
 * two points.
 */
export function partsOf(curve: CurveDocument, contour: Contour): readonly Contour[] {
  const segments = segmentCount(contour);
  if (contour.family !== "hermite" || segments <= 2 * partSegments) return [contour];
  const last = known.get(contour);
  if (last !== undefined && last.space === curve.space && last.omega === curve.omega) return last.parts;
  const moved = translationOf(contour);
  const parts = moved === undefined ? divided(curve, contour, segments) : movedParts(curve, contour, moved);
  known.set(contour, { space: curve.space, omega: curve.omega, parts });
  return parts;
}

/** What was a part before is one again, wherever it begins by now: a point more or less changes no part but its own. */
function divided(curve: CurveDocument, contour: Contour, segments: number): Contour[] {
  const parts: Contour[] = [];
  for (let from = 0; from < segments; ) {
    const part = partBegunAt(curve, contour, from) ?? freshPart(curve, contour, from, endOfFresh(curve, contour, from, segments));
    parts.push(part);
    from += part.points.length - 1;
  }
  return parts;
}

function partBegunAt(curve: CurveDocument, contour: Contour, from: number): Contour | undefined {
  const first = contour.points[from];
  const part = first === undefined ? undefined : begunWith.get(first);
  return part !== undefined && isPart(part, curve, contour, from) ? part : undefined;
}

function endOfFresh(curve: CurveDocument, contour: Contour, from: number, segments: number): number {
  const farthest = Math.min(segments, from + 1.5 * partSegments);
  for (let to = from + 1; to < farthest; to += 1) if (partBegunAt(curve, contour, to) !== undefined) return to;
  return farthest === segments ? segments : from + partSegments;
}

function freshPart(curve: CurveDocument, contour: Contour, from: number, to: number): Contour {
  const part = cut(curve, contour, from, to);
  const [first] = part.points;
  if (first !== undefined) begunWith.set(first, part);
  return part;
}

function cut(curve: CurveDocument, contour: Contour, from: number, to: number): Contour {
  const each = (of: (segment: number) => number): number[] => Array.from({ length: to - from }, (_, i) => of(from + i));
  return {
    family: "hermite",
    closed: false,
    points: to < contour.points.length ? contour.points.slice(from, to + 1) : [...contour.points.slice(from, to), ...contour.points.slice(0, 1)],
    space: contour.space ?? curve.space,
    omega: each((segment) => omegaOf(curve, contour, segment)),
    ...(contour.lengths === undefined ? {} : { lengths: each((segment) => lengthOf(contour, segment)) }),
  };
}

/** A contour that was moved as a whole has the parts of the old one, moved along. */
function movedParts(curve: CurveDocument, contour: Contour, moved: Translation): Contour[] {
  let from = 0;
  return partsOf(curve, moved.from).map((old) => {
    const start = from;
    from += old.points.length - 1;
    return translatedAs(cut(curve, contour, start, from), { ...moved, from: old });
  });
}

/** Whether a part is what these segments of a contour would be as one. */
function isPart(part: Contour, curve: CurveDocument, contour: Contour, from: number): boolean {
  const { points } = contour;
  const segments = part.points.length - 1;
  if (from + segments > segmentCount(contour) || part.space !== (contour.space ?? curve.space)) return false;
  for (let i = 0; i <= segments; i += 1) if (part.points[i] !== points[(from + i) % points.length]) return false;
  for (let i = 0; i < segments; i += 1) {
    if (part.omega?.[i] !== omegaOf(curve, contour, from + i) || lengthOf(part, i) !== lengthOf(contour, from + i)) return false;
  }
  return true;
}

/** The part that a segment of a contour is in, and which segment of the part it is. */
export function partAt(curve: CurveDocument, contour: Contour, segment: number): { readonly part: Contour; readonly segment: number } {
  let left = segment;
  for (const part of partsOf(curve, contour)) {
    const count = segmentCount(part);
    if (left < count) return { part, segment: left };
    left -= count;
  }
  return { part: contour, segment };
}

/** An open contour closed by a straight line. */
export function closedByChord(part: Contour): Contour {
  const { points, omega = [], lengths } = part;
  const [first, last] = [points[0], points.at(-1)];
  if (first === undefined || last === undefined) return part;
  const third = { dx: (first.x - last.x) / 3, dy: (first.y - last.y) / 3 };
  return {
    ...part,
    closed: true,
    points: [{ ...first, in: opposite(third) }, ...points.slice(1, -1), { ...last, out: third }],
    omega: [...omega, 0],
    ...(lengths === undefined ? {} : { lengths: [...lengths, 1] }),
  };
}
