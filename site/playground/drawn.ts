/** What is drawn of a value: curves, surfaces, fits, traces, path data, SVG, points, and lists of these. */
import type { Drawn } from "./messages.ts";

/** More than this nobody sees, and a page does not bear it. */
const MOST = 2000;
const MOST_NUMBERS = 100_000;
/** Lines of a surface in each direction. */
const WIRES = 24;
const STEPS = 96;

const has = <K extends string>(value: object, name: K): value is Record<K, unknown> => name in value;
const isFunction = (value: unknown): value is (...all: never[]) => unknown => typeof value === "function";

/** A surface from the front and above, as lines. */
function wires(surface: { domain: { u: readonly [number, number]; v: readonly [number, number] }; evaluate(u: number[], v: number[]): Float64Array }): Drawn {
  const { u, v } = surface.domain;
  const at = ([from, to]: readonly [number, number], part: number): number => from + (to - from) * part;
  const parts = Array.from({ length: STEPS + 1 }, (_, i) => i / STEPS);
  let d = "";
  const add = (points: Float64Array): void => {
    for (let i = 0; i < points.length; i += 3) {
      const [x = 0, y = 0, z = 0] = points.subarray(i, i + 3);
      d += `${i === 0 ? "M" : "L"}${(0.8 * x - 0.6 * y).toFixed(3)} ${(0.27 * x + 0.36 * y - 0.89 * z).toFixed(3)}`;
    }
  };
  for (let i = 0; i <= WIRES; i += 1) {
    add(surface.evaluate(parts.map((part) => at(u, part)), parts.map(() => at(v, i / WIRES))));
    add(surface.evaluate(parts.map(() => at(u, i / WIRES)), parts.map((part) => at(v, part))));
  }
  return { kind: "path", d, isWire: true };
}

function ofObject(value: object): Drawn[] {
  if (ArrayBuffer.isView(value) && !(value instanceof DataView)) return [{ kind: "dots", points: Array.from(value as Float64Array).slice(0, MOST_NUMBERS) }];
  if (Array.isArray(value)) {
    const isPlaces = value.length > 0 && value.every((each) => typeof each === "number" || (Array.isArray(each) && each.length === 2 && each.every((part) => typeof part === "number")));
    return isPlaces ? [{ kind: "dots", points: (value.flat() as number[]).slice(0, MOST_NUMBERS) }] : value.slice(0, MOST).flatMap(drawnOf);
  }
  if (has(value, "toPathD") && isFunction(value.toPathD)) return [{ kind: "path", d: (value as { toPathD(): { d: string } }).toPathD().d }];
  if (has(value, "toSvg") && isFunction(value.toSvg)) return [{ kind: "svg", text: (value as { toSvg(): string }).toSvg() }];
  if (has(value, "mesh") && has(value, "domain")) return [wires(value as unknown as Parameters<typeof wires>[0])];
  if (has(value, "curve")) {
    const knots = has(value, "knots") && Array.isArray(value.knots) ? value.knots : [];
    return [...drawnOf(value.curve), ...(knots.length > 0 ? [{ kind: "dots", points: knots.flatMap(({ x, y }: { x: number; y: number }) => [x, y]), areKnots: true } as const] : [])];
  }
  if (has(value, "d")) return drawnOf(value.d);
  return [];
}

export function drawnOf(value: unknown): Drawn[] {
  if (typeof value === "string") return /^\s*</.test(value) ? [{ kind: "svg", text: value }] : /^\s*[Mm]/.test(value) ? [{ kind: "path", d: value }] : [];
  return typeof value === "object" && value !== null ? ofObject(value).slice(0, MOST) : [];
}
