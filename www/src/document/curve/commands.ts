import { automaticHandles, translated } from "./contours.ts";
import {
  nothingSelected, type Contour, type ControlPoint, type CurveDocument, type Kind, type Offset, type PointRef, type Selection, type Side,
  type Space,
} from "../document.ts";
import { withHandle, withKind } from "./offset.ts";
import { withStraightLines } from "./straight.ts";

/** A change of the curve document: its name for the history, and a pure function. */
export interface Command {
  /** Said in Undo's tooltip: "Move point", "Frequency". */
  readonly name: string;
  apply(curve: CurveDocument): CurveDocument;
  /** The selection after the change; absent: as it was, less what is gone. */
  readonly select?: Selection | ((after: CurveDocument) => Selection);
  /** Commands of the same run less than 600 ms apart become one entry (a run of nudges, of typed digits). */
  readonly run?: string;
}

/**
 * Changes the chosen points; contours without any of them stay the same objects, so that nothing of theirs is drawn
 * anew.
 */
export function withPoints(
  curve: CurveDocument, selection: Selection, change: (point: ControlPoint, ref: PointRef, contour: Contour) => ControlPoint,
): CurveDocument {
  const chosen = chosenIn(selection);
  const contours = curve.contours.map((contour, index) => {
    const indices = chosen.get(index);
    if (indices === undefined) return contour;
    // One point of very many is changed in a copy: going through all of them takes many times as long.
    const points = contour.points.slice();
    for (const i of indices) {
      const point = contour.points[i];
      if (point !== undefined) points[i] = change(point, { contour: index, index: i }, contour);
    }
    return { ...contour, points };
  });
  return { ...curve, contours };
}

/** Moves the chosen points; lines that they end stay lines. */
function withPlaces(curve: CurveDocument, selection: Selection, place: (point: ControlPoint) => ControlPoint): CurveDocument {
  const after = withPoints(curve, selection, place);
  const chosen = chosenIn(selection);
  const contours = after.contours.map((contour, c) => {
    const [before, indices] = [curve.contours[c], chosen.get(c)];
    return before === undefined || indices === undefined ? contour : withStraightLines(before, contour, indices);
  });
  return { ...after, contours };
}

/** The chosen points by their contours. */
function chosenIn({ points }: Selection): Map<number, number[]> {
  const chosen = new Map<number, number[]>();
  for (const { contour, index } of points) {
    const list = chosen.get(contour);
    if (list === undefined) chosen.set(contour, [index]);
    else list.push(index);
  }
  return chosen;
}

/** One point, chosen. */
export function only(point: PointRef): Selection {
  return { points: [point], handle: null };
}

export function replaceContour(curve: CurveDocument, index: number, ...by: readonly Contour[]): CurveDocument {
  return { ...curve, contours: curve.contours.flatMap((contour, i) => (i === index ? by : [contour])) };
}

export function movePoints(selection: Selection, dx: number, dy: number, run?: string): Command {
  return {
    name: selection.points.length === 1 ? "Move point" : "Move points",
    apply: (curve) => moved(curve, selection, dx, dy),
    ...(run === undefined ? {} : { run }),
  };
}

/** Contours of which every point is chosen move as a whole. */
function moved(curve: CurveDocument, selection: Selection, dx: number, dy: number): CurveDocument {
  const counts = new Map<number, number>();
  for (const { contour } of selection.points) counts.set(contour, (counts.get(contour) ?? 0) + 1);
  const isWhole = (c: number): boolean => counts.get(c) === curve.contours[c]?.points.length;
  const others = selection.points.every(({ contour }) => isWhole(contour))
    ? curve
    : withPlaces(curve, { points: selection.points.filter(({ contour }) => !isWhole(contour)), handle: null }, (point) => ({ ...point, x: point.x + dx, y: point.y + dy }));
  return { ...others, contours: others.contours.map((contour, c) => (counts.has(c) && isWhole(c) ? translated(contour, dx, dy) : contour)) };
}

export function placePoint(ref: PointRef, place: { x?: number; y?: number }, run?: string): Command {
  return {
    name: "Place point",
    apply: (curve) => withPlaces(curve, only(ref), (point) => ({ ...point, ...place })),
    ...(run === undefined ? {} : { run }),
  };
}

/** Sets a handle; `kind` breaks or re-links the point on the way. */
export function turnHandle(ref: PointRef, side: Side, offset: Offset, kind?: Kind, run?: string): Command {
  return {
    name: "Turn handle",
    apply: (curve) => withPoints(curve, only(ref), (point) => withHandle(kind === undefined ? point : { ...point, kind }, side, offset)),
    ...(run === undefined ? {} : { run }),
  };
}

export function setKinds(selection: Selection, kind: Kind): Command {
  return {
    name: kind === "cusp" ? "Make cusp" : `Make ${kind}`,
    apply: (curve) =>
      withPoints(curve, selection, (point, ref, contour) => (contour.family === "interpolating"
        ? point
        : withKind(point, kind, automaticHandles(curve, contour, ref.index)))),
  };
}

export function resetHandles(selection: Selection): Command {
  return {
    name: "Reset handles",
    apply: (curve) =>
      withPoints(curve, selection, (point, ref, contour) => ({ ...point, kind: "symmetric", ...automaticHandles(curve, contour, ref.index) })),
  };
}

/** A grid says what its roots are; elsewhere they are a frequency of the contour's own. */
function withoutOwnRoots({ roots, ...contour }: Contour): Contour {
  return contour.grid === undefined || roots === undefined ? contour : { ...contour, roots };
}

export function setSpace(space: Space): Command {
  return {
    name: "Space",
    apply: (curve) => ({ ...curve, space, contours: curve.contours.map(({ space: _own, ...contour }) => withoutOwnRoots(contour)) }),
  };
}

/** An empty drawing with the settings of another; what was true of its contours is gone with them. */
export function cleared({ space, omega }: CurveDocument): CurveDocument {
  return { space, omega, level: 0, contours: [] };
}

export function clearCurve(): Command {
  return {
    name: "Clear",
    apply: cleared,
    select: nothingSelected,
  };
}

export function replaceCurve(name: string, curve: CurveDocument): Command {
  return { name, apply: () => curve, select: nothingSelected };
}
