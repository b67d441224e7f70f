import { arcAt, cross, directionsAt, pointsOf, segmentsAt, step, type Place } from "../../../document/curve/corners/corners.ts";
import type { Contour, CurveDocument, Offset } from "../../../document/document.ts";
import { unitOf } from "../../../kernel/unit.ts";
import { toScreen, type ScreenPoint } from "../../pointer/camera.ts";
import type { EditorState } from "../../editor.ts";
import { chosenCorners, type ChosenCorners } from "./chosen.ts";

/** Grips of the chosen corners: each is where the centre of its arc is, and in it while the corner is sharp. */

interface Wedge {
  readonly corner: Place;
  /** From the corner between its sides, of length 1. */
  readonly inwards: Offset;
  /** The sine of half the angle between the sides: the radius of an arc by how far its centre is from the corner. */
  readonly sine: number;
  /** How far it is along the shorter side. */
  readonly room: number;
  readonly radius: number;
  /** The handles of a sharp corner. */
  readonly handles: readonly Offset[];
}

export interface CornerGrip extends Wedge {
  readonly screen: ScreenPoint;
  /** The step of radii that suits the drawing. */
  readonly unit: number;
}

/** Of more corners each has no grip: they would be in each other's way. */
const mostGrips = 32;
/** From a grip to its corner and to its sides, CSS pixels: points and curves are pressed there. */
const fromCorner = { mouse: 24, touch: 44 } as const;
const fromSides = { mouse: 9, touch: 20 } as const;
const fromHandles = { mouse: 17, touch: 34 } as const;

function normalised({ dx, dy }: Offset): Offset {
  const length = Math.hypot(dx, dy);
  return { dx: dx / length, dy: dy / length };
}

function wedge(corner: Place, before: Offset, after: Offset, radius: number, handles: readonly Offset[] = []): Wedge[] {
  const [one, other] = [normalised(before), normalised(after)];
  const inwards = normalised({ dx: one.dx + other.dx, dy: one.dy + other.dy });
  const sine = Math.abs(cross(one, inwards));
  const room = Math.min(Math.hypot(before.dx, before.dy), Math.hypot(after.dx, after.dy));
  return Number.isFinite(inwards.dx) && sine > 0.01 ? [{ corner, inwards, sine, radius, room, handles }] : [];
}

function wedgeAt(contour: Contour, index: number, radius: number): Wedge[] {
  const point = contour.points[index];
  const directions = directionsAt(contour, index);
  const [before, after] = segmentsAt(contour, index).map((segment) => (segment === null ? null : pointsOf(contour, segment)));
  if (point === undefined || directions === null || !before || !after) return [];
  const along = (direction: Offset, other: Place): Offset => {
    const [{ dx, dy }, chord] = [normalised(direction), step(point, other)];
    const length = Math.hypot(chord.dx, chord.dy);
    return { dx: dx * length, dy: dy * length };
  };
  return wedge(point, along(directions.in, before[0]), along(directions.out, after[1]), radius, radius === 0 ? [point.in, point.out] : []);
}

function wedgesOf(curve: CurveDocument, { contour, sharp, arcs, rounding }: ChosenCorners): Wedge[] {
  const shape = curve.contours[contour];
  if (shape === undefined) return [];
  if (rounding !== null) return rounding.corners.flatMap((index, i) => wedgeAt(rounding.base, index, rounding.radii[i] ?? 0));
  const round = [...arcs].flatMap(([segment, radius]) => {
    const [arc, ends] = [arcAt(curve, shape, segment), pointsOf(shape, segment)];
    return arc === null || ends === null ? [] : wedge(arc.corner, step(arc.corner, ends[0]), step(arc.corner, ends[1]), radius);
  });
  return [...sharp.flatMap((index) => wedgeAt(shape, index, 0)), ...round];
}

/** Beyond a handle that would be pressed in its place: in sharp corners handles are close to the middle. */
function besideHandle(away: number, handle: Offset, inwards: Offset, clear: number): number {
  const along = handle.dx * inwards.dx + handle.dy * inwards.dy;
  return Math.hypot(away - along, cross(handle, inwards)) < clear ? along + clear : away;
}

export function cornerGrips(state: EditorState): CornerGrip[] {
  if (state.tool !== "select" || state.selection.points.length > 4 * mostGrips) return [];
  const all = chosenCorners(state).flatMap((each) => wedgesOf(state.curve, each));
  if (all.length > mostGrips) return [];
  const [{ zoom }, unit] = [state.view, unitOf(state.curve)];
  const reach = state.touch ? "touch" : "mouse";
  return all.flatMap((each) => {
    const { corner, inwards, sine, room, radius, handles } = each;
    const least = Math.max(fromCorner[reach], fromSides[reach] / sine) / zoom;
    if (radius === 0 && room < least) return [];
    const away = handles.reduce((now, handle) => besideHandle(now, handle, inwards, fromHandles[reach] / zoom), Math.max(least, radius / sine));
    return [{ ...each, unit, screen: toScreen(state.view, state.stage, { x: corner.x + away * inwards.dx, y: corner.y + away * inwards.dy }) }];
  });
}

/** Which grip is within reach of a place. */
export function cornerGripAt(state: EditorState, at: ScreenPoint, reach: number): CornerGrip | null {
  const away = ({ screen }: CornerGrip): number => Math.hypot(screen.x - at.x, screen.y - at.y);
  const [nearest] = cornerGrips(state).sort((a, b) => away(a) - away(b));
  return nearest !== undefined && away(nearest) <= reach ? nearest : null;
}
