import type { Pair } from "./fit.ts";

/** The outline of an island: an oval with bays, then each stretch broken again and again, half as much every time. */

const center: Pair = [400, 300];
const coarse = 32;

/** A generator of its own: the island must not move when other samples change. */
function shaken(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) | 0;
    return (state >>> 0) / 2147483648 - 1;
  };
}

export function coastline(count: number): Pair[] {
  const random = shaken(20261);
  let points: Pair[] = Array.from({ length: coarse }, (_, i) => {
    const angle = (2 * Math.PI * i) / coarse;
    const reach = 1 + 0.2 * Math.sin(2 * angle + 0.7) + 0.14 * Math.sin(3 * angle + 2.1) + 0.1 * Math.sin(5 * angle) + 0.05 * random();
    return [center[0] + 235 * reach * Math.cos(angle), center[1] + 165 * reach * Math.sin(angle)];
  });
  for (let rough = 0.17; points.length < count / 2; rough *= 0.86) points = broken(points, rough, random);
  return evenly(points, count);
}

/** Every side gets a point beside its middle. */
function broken(points: readonly Pair[], rough: number, random: () => number): Pair[] {
  return points.flatMap(([x, y], i) => {
    const [nextX, nextY] = points[(i + 1) % points.length] ?? [x, y];
    const by = rough * random();
    return [[x, y] as const, [(x + nextX) / 2 - by * (nextY - y), (y + nextY) / 2 + by * (nextX - x)] as const];
  });
}

/** The closed polygon at `count` places, evenly along it. */
function evenly(points: readonly Pair[], count: number): Pair[] {
  const lengths = points.map(([x, y], i) => {
    const [nextX, nextY] = points[(i + 1) % points.length] ?? [x, y];
    return Math.hypot(nextX - x, nextY - y);
  });
  const total = lengths.reduce((sum, length) => sum + length, 0);
  const list: Pair[] = [];
  let side = 0;
  let before = 0;
  for (let i = 0; i < count; i += 1) {
    const at = (total * i) / count;
    while (side < points.length - 1 && before + (lengths[side] ?? 0) < at) {
      before += lengths[side] ?? 0;
      side += 1;
    }
    const [x, y] = points[side] ?? center;
    const [nextX, nextY] = points[(side + 1) % points.length] ?? center;
    const part = (at - before) / Math.max(1e-12, lengths[side] ?? 1);
    list.push([x + part * (nextX - x), y + part * (nextY - y)]);
  }
  return list;
}
