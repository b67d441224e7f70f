import { isSelected, pointAt, type ControlPoint, type CurveDocument, type Offset, type PointRef, type Selection } from "../../document/document.ts";
import { against, lengthOfOffset } from "../../document/curve/offset.ts";
import type { PagePoint } from "./camera.ts";
import { unitOf } from "../../kernel/unit.ts";
import type { EditorState, Guide } from "../editor.ts";

/** Where a drag is drawn to, and the line that says so. */

export interface Snapped<T> {
  readonly value: T;
  readonly guides: readonly Guide[];
  /** In words, for the hint line; null when nothing was near. */
  readonly to: string | null;
  /** The point that it went onto. */
  readonly onto?: PointRef;
}

const reachPx = 6;

interface Candidate {
  readonly place: PagePoint;
  readonly name: string;
  readonly ref: PointRef;
}

/**
 * What is nearest by each of the three measures: onto the place, in a column with it, level with it. Of two as near,
 * the later.
 */
function nearestOthers(curve: CurveDocument, moving: Selection, at: PagePoint, reach: number): Record<"onto" | "column" | "row", Candidate | null> {
  const found: { onto: PointRef | null; column: PointRef | null; row: PointRef | null } = { onto: null, column: null, row: null };
  let [onto, column, row] = [reach, reach, reach];
  curve.contours.forEach(({ points }, contour) => points.forEach(({ x, y }, index) => {
    const [across, down] = [Math.abs(x - at.x), Math.abs(y - at.y)];
    // Of very many points nearly all are near in no way.
    if (across > column && down > row && (across > onto || down > onto)) return;
    const ref = { contour, index };
    if (isSelected(moving, ref)) return;
    const distance = Math.hypot(x - at.x, y - at.y);
    if (distance <= onto) [found.onto, onto] = [ref, distance];
    if (across <= column) [found.column, column] = [ref, across];
    if (down <= row) [found.row, row] = [ref, down];
  }));
  const candidate = (ref: PointRef | null): Candidate | null => {
    const point = ref === null ? undefined : pointAt(curve, ref);
    return ref === null || point === undefined ? null : { place: { x: point.x, y: point.y }, name: `point ${ref.index + 1}`, ref };
  };
  return { onto: candidate(found.onto), column: candidate(found.column), row: candidate(found.row) };
}

/** Where the grid is seen, its step in document units; else null. */
export function gridOf({ curve, settings: { overlays, gridStep } }: Pick<EditorState, "curve" | "settings">): number | null {
  return overlays.grid ? gridStep * unitOf(curve) : null;
}

/** A point near another goes onto it; else in line with others, each way by itself; else onto the grid. */
export function snapPlace(curve: CurveDocument, moving: Selection, at: PagePoint, zoom: number, grid: number | null): Snapped<PagePoint> {
  const reach = reachPx / zoom;
  const { onto, column, row } = nearestOthers(curve, moving, at, reach);
  if (onto !== null) return { value: onto.place, guides: [], to: `on ${onto.name}`, onto: onto.ref };
  if (column !== null || row !== null) {
    const value = { x: column?.place.x ?? at.x, y: row?.place.y ?? at.y };
    const guides = [column, row].flatMap((found) => (found === null ? [] : [{ from: found.place, to: value }]));
    const names = [column === null ? "" : `in a column with ${column.name}`, row === null ? "" : `level with ${row.name}`].filter((text) => text !== "");
    return { value, guides, to: names.join(", ") };
  }
  if (grid === null) return { value: at, guides: [], to: null };
  return { value: { x: Math.round(at.x / grid) * grid, y: Math.round(at.y / grid) * grid }, guides: [], to: "on the grid" };
}

/** A handle near its point goes in; near its partner's line, straight; near an axis, level or upright. */
export function snapHandle(point: ControlPoint, offset: Offset, partner: Offset | null, zoom: number): Snapped<Offset> {
  const reach = reachPx / zoom;
  const size = lengthOfOffset(offset);
  if (size <= reach) return { value: { dx: 0, dy: 0 }, guides: [], to: "into the point" };
  if (partner !== null && lengthOfOffset(partner) > reach) {
    const straight = against(offset, partner);
    if (Math.hypot(straight.dx - offset.dx, straight.dy - offset.dy) <= reach) {
      return { value: straight, guides: [line(point, partner, straight)], to: "straight with the other handle" };
    }
  }
  if (Math.abs(offset.dy) <= reach) return axis(point, { dx: offset.dx, dy: 0 }, "horizontal");
  if (Math.abs(offset.dx) <= reach) return axis(point, { dx: 0, dy: offset.dy }, "vertical");
  return { value: offset, guides: [], to: null };
}

function axis(point: ControlPoint, value: Offset, to: string): Snapped<Offset> {
  return { value, guides: [line(point, { dx: -value.dx, dy: -value.dy }, value)], to };
}

function line(point: ControlPoint, from: Offset, to: Offset): Guide {
  return { from: { x: point.x + from.dx, y: point.y + from.dy }, to: { x: point.x + to.dx, y: point.y + to.dy } };
}

/** A step held to the nearest of the eight compass directions. */
export function constrained(dx: number, dy: number): { dx: number; dy: number } {
  const eighth = Math.round(Math.atan2(dy, dx) / (Math.PI / 4));
  if (eighth % 4 === 0) return { dx, dy: 0 };
  if (eighth % 2 === 0) return { dx: 0, dy };
  const size = (Math.abs(dx) + Math.abs(dy)) / 2;
  return { dx: Math.sign(dx) * size, dy: Math.sign(dy) * size };
}

const twelfth = Math.PI / 12;

/** A handle turned to the nearest multiple of 15°, as long as it was. */
export function turnedBySteps(offset: Offset): Offset {
  const size = lengthOfOffset(offset);
  const angle = Math.round(Math.atan2(offset.dy, offset.dx) / twelfth) * twelfth;
  const clean = (value: number): number => (Math.abs(value) < 1e-12 * size ? 0 : value);
  return { dx: clean(size * Math.cos(angle)), dy: clean(size * Math.sin(angle)) };
}
