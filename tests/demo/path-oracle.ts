/**
 * Path data evaluated by the text of the SVG standard alone: every command, arcs by their centre parametrisation. It
 * shares no code with the library and no code with the browser, whose own arc lengths are off by 1.4e-4.
 */
import type { Pair } from "./page.ts";

export interface Subpath {
  readonly closed: boolean;
  readonly points: Pair[];
}

/** Points per piece: a half turn of radius 160 is then within 3e-4 of its chords. */
const [perLine, perCurve, perArc] = [24, 200, 800];
const arity: Readonly<Record<string, number>> = { M: 2, L: 2, H: 1, V: 1, C: 6, S: 4, Q: 4, T: 2, A: 7, Z: 0 };

interface Command {
  readonly letter: string;
  readonly values: number[];
}

/** What a smooth command after this one reflects. */
type Control = { readonly kind: "C" | "Q"; readonly at: Pair } | null;

/** The commands of a `d`, one per set of numbers. */
export function commandsOf(d: string): Command[] {
  const commands: Command[] = [];
  for (const [, letter = "", rest = ""] of d.matchAll(/([a-z])([^a-df-z]*)/gi)) {
    const count = arity[letter.toUpperCase()] ?? 0;
    const numbers = letter.toUpperCase() === "A" ? arcNumbers(rest) : (rest.match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi) ?? []).map(Number);
    if (count === 0) commands.push({ letter, values: [] });
    for (let i = 0; count > 0 && i < numbers.length; i += count) {
      const following = i === 0 ? letter : letter === "M" ? "L" : letter === "m" ? "l" : letter;
      commands.push({ letter: following, values: numbers.slice(i, i + count) });
    }
  }
  return commands;
}

/** The two flags of an arc are single digits that may stand without separators. */
function arcNumbers(text: string): number[] {
  const number = "([-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:e[-+]?\\d+)?)[\\s,]*";
  const arc = new RegExp(`${number.repeat(3)}([01])[\\s,]*([01])[\\s,]*${number.repeat(2)}`, "gi");
  return [...text.matchAll(arc)].flatMap((match) => match.slice(1, 8).map(Number));
}

/** Dense points of every subpath. */
export function evaluatePath(d: string): Subpath[] {
  const subpaths: { closed: boolean; points: Pair[] }[] = [];
  let at: Pair = [0, 0];
  let start: Pair = [0, 0];
  let lastControl: Control = null;
  const line = (): Pair[] => {
    const last = subpaths.at(-1);
    if (last === undefined || last.closed) {
      subpaths.push({ closed: false, points: [at] });
      return subpaths.at(-1)?.points ?? [];
    }
    return last.points;
  };
  const draw = (of: (t: number) => Pair, count = perLine): void => {
    const points = line();
    for (let i = 1; i <= count; i += 1) points.push(of(i / count));
  };
  for (const { letter, values } of commandsOf(d)) {
    const from = at;
    const relative = letter === letter.toLowerCase();
    const [ox, oy] = relative ? from : [0, 0];
    const pair = (i: number): Pair => [ox + (values[i] ?? 0), oy + (values[i + 1] ?? 0)];
    let control: Control = null;
    switch (letter.toUpperCase()) {
      case "M":
        at = start = pair(0);
        subpaths.push({ closed: false, points: [at] });
        break;
      case "Z": {
        const last = subpaths.at(-1);
        if (last !== undefined) {
          at = start;
          if (from[0] !== at[0] || from[1] !== at[1]) draw((t) => mix(from, start, t));
          last.closed = true;
        }
        break;
      }
      case "H":
        at = [ox + (values[0] ?? 0), from[1]];
        draw((t) => mix(from, at, t));
        break;
      case "V":
        at = [from[0], oy + (values[0] ?? 0)];
        draw((t) => mix(from, at, t));
        break;
      case "L":
        at = pair(0);
        draw((t) => mix(from, at, t));
        break;
      case "C":
      case "S": {
        const smooth = letter.toUpperCase() === "S";
        const first: Pair = smooth ? reflected(from, lastControl, "C") : pair(0);
        const second = pair(smooth ? 0 : 2);
        at = pair(smooth ? 2 : 4);
        control = { kind: "C", at: second };
        draw((t) => bezier([from, first, second, at], t), perCurve);
        break;
      }
      case "Q":
      case "T": {
        const smooth = letter.toUpperCase() === "T";
        const middle: Pair = smooth ? reflected(from, lastControl, "Q") : pair(0);
        at = pair(smooth ? 0 : 2);
        control = { kind: "Q", at: middle };
        draw((t) => bezier([from, middle, at], t), perCurve);
        break;
      }
      case "A": {
        at = pair(5);
        const arc = arcOf(from, values, at);
        draw((t) => arc(t), perArc);
        break;
      }
    }
    lastControl = control;
  }
  return subpaths;
}

function mix(a: Pair, b: Pair, t: number): Pair {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
}

/** De Casteljau. */
function bezier(points: readonly Pair[], t: number): Pair {
  const [first, second] = points;
  if (first === undefined) return [0, 0];
  if (second === undefined) return first;
  return bezier(points.slice(1).map((point, i) => mix(points[i] ?? first, point, t)), t);
}

function reflected(at: Pair, last: { kind: string; at: Pair } | null, kind: string): Pair {
  return last?.kind === kind ? [2 * at[0] - last.at[0], 2 * at[1] - last.at[1]] : at;
}

/** The standard's appendix on elliptical arcs: from end points to centre and angles. */
function arcOf(from: Pair, values: readonly number[], to: Pair): (t: number) => Pair {
  const [givenRx = 0, givenRy = 0, degrees = 0, large = 0, sweep = 0] = values;
  let [rx, ry] = [Math.abs(givenRx), Math.abs(givenRy)];
  if (rx === 0 || ry === 0) return (t) => mix(from, to, t);
  const angle = (degrees * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const [hx, hy] = [(from[0] - to[0]) / 2, (from[1] - to[1]) / 2];
  const [x, y] = [cos * hx + sin * hy, -sin * hx + cos * hy];
  const excess = (x / rx) ** 2 + (y / ry) ** 2;
  if (excess > 1) [rx, ry] = [rx * Math.sqrt(excess), ry * Math.sqrt(excess)];
  const below = (rx * y) ** 2 + (ry * x) ** 2;
  const factor = (large === sweep ? -1 : 1) * Math.sqrt(Math.max(0, (rx * ry) ** 2 - below) / below);
  const [u, v] = [(factor * rx * y) / ry, (-factor * ry * x) / rx];
  const centre: Pair = [cos * u - sin * v + (from[0] + to[0]) / 2, sin * u + cos * v + (from[1] + to[1]) / 2];
  const begin = Math.atan2((y - v) / ry, (x - u) / rx);
  let turn = Math.atan2((-y - v) / ry, (-x - u) / rx) - begin;
  if (sweep === 1 && turn < 0) turn += 2 * Math.PI;
  if (sweep === 0 && turn > 0) turn -= 2 * Math.PI;
  return (t) => {
    const [a, b] = [rx * Math.cos(begin + turn * t), ry * Math.sin(begin + turn * t)];
    return [centre[0] + cos * a - sin * b, centre[1] + sin * a + cos * b];
  };
}

/** The largest distance from the points of one curve to the polygon through another. */
export function farthest(from: readonly Pair[], to: readonly Pair[], closed: boolean): number {
  const distance = distanceFinder(to, closed);
  return Math.max(...from.map(distance));
}

export function bothWays(a: readonly Pair[], b: readonly Pair[], closed: boolean): number {
  return Math.max(farthest(a, b, closed), farthest(b, a, closed));
}

function toSide([x, y]: Pair, [ax, ay]: Pair, [bx, by]: Pair): number {
  const [ux, uy] = [bx - ax, by - ay];
  const size = ux * ux + uy * uy;
  const t = size === 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * ux + (y - ay) * uy) / size));
  return Math.hypot(x - ax - t * ux, y - ay - t * uy);
}

/** Sides in order of x; from a place outwards until x alone, less the longest side, is farther than the best. */
function distanceFinder(vertices: readonly Pair[], closed: boolean): (point: Pair) => number {
  const count = closed ? vertices.length : vertices.length - 1;
  const sides = Array.from({ length: count }, (_, i) => ({ a: vertices[i] ?? [0, 0], b: vertices[(i + 1) % vertices.length] ?? [0, 0] })) as { a: Pair; b: Pair }[];
  sides.sort((s, t) => s.a[0] - t.a[0]);
  const longest = Math.max(...sides.map(({ a, b }) => Math.abs(a[0] - b[0])));
  return (point) => {
    let [low, high] = [0, sides.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((sides[middle]?.a[0] ?? 0) < point[0]) low = middle + 1;
      else high = middle;
    }
    let best = Infinity;
    const look = (at: number): boolean => {
      const side = sides[at];
      if (side === undefined || Math.abs(side.a[0] - point[0]) > best + longest) return false;
      best = Math.min(best, toSide(point, side.a, side.b));
      return true;
    };
    let [left, right, goLeft, goRight] = [low - 1, low, true, true];
    while (goLeft || goRight) {
      if (goLeft) goLeft = look(left--);
      if (goRight) goRight = look(right++);
    }
    return best;
  };
}
