/** Shapes that are surfaces exactly. */
import { exactly, finite, integer } from "../core.js";
import { NAME, type SurfaceData, readSurface } from "./surface-data.js";
import { call } from "./surface-engine.js";

/** The surface of a shape of that number, with its lengths and how many units there are in u and v. @internal */
export function shape(
  name: string,
  which: number,
  lengths: readonly (readonly [arg: string, value: unknown, index?: number])[],
  segments: unknown,
  byDefault: readonly [number, number],
): SurfaceData {
  const op = `${NAME}.${name}`;
  const [a = 0, b = 0, c = 0] = lengths.map(([arg, value, index]) => finite(op, arg, value, index));
  let [m, n] = byDefault;
  if (segments !== undefined) {
    const given = exactly(op, "segments", segments, 2);
    [m, n] = [integer(op, "segments", given[0], 0, 0xffff, 0), integer(op, "segments", given[1], 0, 0xffff, 1)];
  }
  return readSurface(call(op, (kernel) => kernel.surface_shape(which, a, b, c, m, n)));
}

/** Three lengths of one argument. @internal */
export function three(name: string, arg: string, value: unknown): [string, unknown, number][] {
  const op = `${NAME}.${name}`;
  return Array.from(exactly(op, arg, value, 3), (number, i) => [arg, number, i]);
}
