// What `remove` promises, on real logos: no other handles bring the segment that heals the gap much nearer to the old
// shape. The others are tried here, as cubics of the test's own.

import assert from "node:assert/strict";
import { test } from "node:test";

import { parsePath, type HermiteCurve } from "expline";
import * as simpleIcons from "simple-icons";

type Point = readonly [number, number];

/** One logo in so many, and of each the first contour that has a point to spare. */
const STRIDE = 27;
/** Places at which shapes are compared, and chords of the one they are compared with. */
const [PLACES, CHORDS] = [40, 160];
/**
 * Handles below a thirtieth of the length are as good as none, and shapes that turn by so much more than the old one
 * make a loop.
 */
const [LEAST_HANDLE, LOOP] = [1 / 30, 0.9];
/**
 * Eighth powers of 48 distances are made small, not the largest of them, which is so many times the least at most;
 * hairpins apart.
 */
const AT_MOST = 48 ** (1 / 8);
/** Of a drawing of 24 units: where both are this near, a ratio says nothing. */
const NOTHING = 1e-4;

const pairs = (numbers: ArrayLike<number>): Point[] =>
  Array.from({ length: numbers.length / 2 }, (_, k) => [numbers[2 * k] ?? NaN, numbers[2 * k + 1] ?? NaN]);

function toChords([x, y]: Point, way: readonly Point[]): number {
  let nearest = Infinity;
  for (let k = 1; k < way.length; k += 1) {
    const [[ax, ay], [bx, by]] = [way[k - 1] as Point, way[k] as Point];
    const [dx, dy] = [bx - ax, by - ay];
    const share = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
    nearest = Math.min(nearest, Math.hypot(x - ax - share * dx, y - ay - share * dy));
  }
  return nearest;
}

/** The larger of both directed distances. */
function apart(one: readonly Point[], other: readonly Point[]): number {
  const directed = (from: readonly Point[], to: readonly Point[]): number =>
    from.reduce((most, point, k) => (k % (CHORDS / PLACES) === 0 ? Math.max(most, toChords(point, to)) : most), 0);
  return Math.max(directed(one, other), directed(other, one));
}

function turning(way: readonly Point[]): number {
  let [sum, last] = [0, NaN];
  for (let k = 1; k < way.length; k += 1) {
    const [[ax, ay], [bx, by]] = [way[k - 1] as Point, way[k] as Point];
    if (ax === bx && ay === by) continue;
    const angle = Math.atan2(by - ay, bx - ax);
    if (!Number.isNaN(last)) sum += Math.abs(Math.atan2(Math.sin(angle - last), Math.cos(angle - last)));
    last = angle;
  }
  return sum;
}

/** Points of a cubic that leaves `from` along `out` and arrives at `to` along `into`, with handles of these lengths. */
function cubic(from: Point, to: Point, out: Point, into: Point, a: number, b: number): Point[] {
  const corners = [from, [from[0] + a * out[0], from[1] + a * out[1]], [to[0] - b * into[0], to[1] - b * into[1]], to] as const;
  return Array.from({ length: CHORDS + 1 }, (_, k) => {
    const [x, y] = [k / CHORDS, 1 - k / CHORDS];
    const weights = [y * y * y, 3 * x * y * y, 3 * x * x * y, x * x * x];
    const sum = (axis: 0 | 1): number => corners.reduce((total, corner, i) => total + corner[axis] * (weights[i] ?? 0), 0);
    return [sum(0), sum(1)];
  });
}

/** How near any handles bring it: a lattice of their lengths, and on from the best. */
function least(old: readonly Point[], shape: (a: number, b: number) => Point[], size: number): number {
  const turned = turning(old);
  const cost = ([a, b]: Point): number => {
    const handles = [Math.exp(a) / 3, Math.exp(b) / 3] as const;
    if (Math.min(...handles) < LEAST_HANDLE) return Infinity;
    const way = shape(handles[0] * size, handles[1] * size);
    return turning(way) > turned + LOOP ? Infinity : apart(old, way);
  };
  let [best, at] = [Infinity, [0, 0] as Point];
  const look = (place: Point): boolean => {
    const there = cost(place);
    if (there >= best) return false;
    [best, at] = [there, place];
    return true;
  };
  for (let k = 0; k < 81; k += 1) look([(k % 9) * 0.5 - 2.3, Math.floor(k / 9) * 0.5 - 2.3]);
  for (let step = 0.25; step > 0.01;) {
    const from = at;
    const around = Array.from({ length: 8 }, (_, k): Point => [from[0] + step * Math.cos((k * Math.PI) / 4), from[1] + step * Math.sin((k * Math.PI) / 4)]);
    if (!around.some(look)) step /= 2;
  }
  return best;
}

/**
 * The two segments around point `i`, as points; how far they are from the segment that heals them; and how far it could
 * be.
 */
function compared(curve: HermiteCurve, i: number): [healed: number, least: number] | null {
  const { curve: healed } = curve.remove(i);
  const lengths = curve.lengths;
  const start = lengths.subarray(0, i - 1).reduce((sum, length) => sum + length, 0);
  const end = start + (lengths[i - 1] ?? NaN) + (lengths[i] ?? NaN);
  const places = Float64Array.from({ length: CHORDS + 1 }, (_, k) => start + ((end - start) * k) / CHORDS);
  const [old, made] = [pairs(curve.evaluate(places)), pairs(healed.evaluate(places))];
  const size = old.reduce((sum, [x, y], k) => (k === 0 ? 0 : sum + Math.hypot(x - (old[k - 1]?.[0] ?? x), y - (old[k - 1]?.[1] ?? y))), 0);
  const directions = [pairs(healed.tangents)[i - 1], pairs(healed.tangentsIn)[i]].map((v) => [v?.[0] ?? 0, v?.[1] ?? 0, Math.hypot(v?.[0] ?? 0, v?.[1] ?? 0)] as const);
  if (directions.some(([, , length]) => length === 0)) return null;
  const [out, into] = directions.map(([x, y, length]): Point => [x / length, y / length]) as [Point, Point];
  const mine = apart(old, made);
  if (mine < NOTHING) return null;
  const [from, to] = [old[0] as Point, old[CHORDS] as Point];
  return [mine, Math.min(mine, least(old, (a, b) => cubic(from, to, out, into, a, b), size))];
}

test("of points removed from real logos nine in ten end within 1.15 times the least distance that any handles reach", (t) => {
  const ratios: number[] = [];
  const icons = Object.values(simpleIcons).filter(({ path }) => typeof path === "string");
  for (let k = 0; k < icons.length; k += STRIDE) {
    const curve = parsePath(icons[k]?.path ?? "").find(({ points, omega }) => points.length >= 8 && omega.every((each) => each === 0));
    const both = curve === undefined ? null : compared(curve, 1 + (k % (curve.points.length / 2 - 2)));
    if (both !== null) ratios.push(both[0] / both[1]);
  }
  ratios.sort((a, b) => a - b);
  const share = (limit: number): number => ratios.filter((ratio) => ratio <= limit).length / ratios.length;
  const said = [1.02, 1.15, AT_MOST].map((limit) => `${(100 * share(limit)).toFixed(0)} % within ${limit.toFixed(2)}`).join(", ");
  t.diagnostic(`${ratios.length} points: ${said}; the farthest ${ratios.at(-1)?.toFixed(2)} times`);
  assert.ok(ratios.length > 80, "enough points have something to heal");
  assert.ok(share(1.15) >= 0.92, said);
  assert.ok(share(AT_MOST) >= 0.97, said);
});
