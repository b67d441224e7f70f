import type { ControlPoint, Offset, Selection } from "../document.ts";
import { withPoints, type Command } from "./commands.ts";

/** Maps that take straight lines to straight lines. Every family of curves follows its points under them exactly. */

interface Place {
  readonly x: number;
  readonly y: number;
}

/** A place goes to centre + (a·Δx + c·Δy, b·Δx + d·Δy): the centre stays to the last bit. */
export interface Affine {
  readonly centre: Place;
  readonly a: number;
  readonly b: number;
  readonly c: number;
  readonly d: number;
}

export function stretching(centre: Place, across: number, down: number): Affine {
  return { centre, a: across, b: 0, c: 0, d: down };
}

/** Cosine and sine of quarter turns: those of an angle in radians are not quite whole. */
const quarters: readonly (readonly [number, number])[] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

/** Clockwise on the screen, where y points down. */
export function turning(centre: Place, degrees: number): Affine {
  const angle = (degrees * Math.PI) / 180;
  const whole = degrees - 360 * Math.floor(degrees / 360);
  const [cos, sin] = quarters[whole / 90] ?? [Math.cos(angle), Math.sin(angle)];
  return { centre, a: cos, b: sin, c: -sin, d: cos };
}

function mappedPlace(map: Affine, { x, y }: Place): Place {
  const { dx, dy } = mappedOffset(map, { dx: x - map.centre.x, dy: y - map.centre.y });
  return { x: map.centre.x + dx, y: map.centre.y + dy };
}

/**
 * A step, of which only the linear part counts; zero stays positive, so that documents compare equal after two flips.
 */
function mappedOffset({ a, b, c, d }: Affine, { dx, dy }: Offset): Offset {
  return { dx: a * dx + c * dy + 0, dy: b * dx + d * dy + 0 };
}

/**
 * Points go where the map takes them, with their handles: of contours that are chosen as a whole the curve goes there
 * too, exactly.
 */
export function transformPoints(name: string, selection: Selection, map: Affine, run?: string): Command {
  const mapped = (point: ControlPoint): ControlPoint => ({
    ...point,
    ...mappedPlace(map, point),
    in: mappedOffset(map, point.in),
    out: mappedOffset(map, point.out),
    ...(point.moved === undefined ? {} : { moved: mappedOffset(map, point.moved) }),
  });
  return { name, apply: (curve) => withPoints(curve, selection, mapped), ...(run === undefined ? {} : { run }) };
}
