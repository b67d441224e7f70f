import type { Pair } from "./fit.ts";

/**
 * A word as somebody would sign it: "spline" in one go, then the dot of the i. Places that the pen passes, drawn
 * through smoothly, slower in the bends, as a hand is.
 */

/** In units of the letters' height; y points down, the line is at 0. */
const word: readonly Pair[] = [
  // s
  [-0.35, 0.02], [0.05, -0.28], [0.34, -0.98], [0.3, -0.72], [0.52, -0.36], [0.42, -0.04], [0.12, -0.03], [0.3, -0.1],
  // p
  [0.78, -0.42], [0.98, -0.92], [0.94, -0.4], [0.8, 0.62], [0.72, 1.02], [0.84, 0.4],
  [1.02, -0.6], [1.26, -0.95], [1.5, -0.72], [1.44, -0.24], [1.14, -0.02], [1.3, 0.02],
  // l
  [1.78, -0.3], [2.2, -1.2], [2.24, -1.82], [2.06, -1.86], [1.94, -1.1], [1.94, -0.3], [2.12, 0.0], [2.4, -0.18],
  // i
  [2.66, -0.62], [2.76, -0.94], [2.68, -0.4], [2.78, -0.02], [3.0, -0.12],
  // n
  [3.22, -0.56], [3.32, -0.92], [3.3, -0.42], [3.24, -0.02], [3.36, -0.5], [3.62, -0.94], [3.86, -0.84], [3.84, -0.36], [3.92, 0.0], [4.16, -0.14],
  // e, and the stroke that ends it all
  [4.54, -0.5], [4.72, -0.8], [4.54, -0.98], [4.32, -0.66], [4.36, -0.2], [4.66, 0.0], [5.04, -0.2], [5.5, -0.62], [6.1, -0.66], [5.5, -0.3], [4.2, 0.34], [2.9, 0.5],
];

const dot: readonly Pair[] = [[2.86, -1.26], [2.9, -1.37], [3.0, -1.46]];

const [left, line, height] = [140, 330, 92];

export function signature(): Pair[][] {
  return [through(word, 888), through(dot, 12)].map((stroke) => stroke.map(([x, y]) => [left + height * x, line + height * y * 0.95]));
}

/**
 * `count` points on the centripetal curve of Catmull and Rom through the places: at even steps of its parameter, so
 * dense in bends.
 */
function through(places: readonly Pair[], count: number): Pair[] {
  const at = (i: number): Pair => places[Math.min(places.length - 1, Math.max(0, i))] ?? [0, 0];
  const knots = [0];
  for (let i = 1; i < places.length; i += 1) knots.push((knots[i - 1] ?? 0) + Math.sqrt(distance(at(i - 1), at(i))));
  const end = knots.at(-1) ?? 1;
  let span = 0;
  return Array.from({ length: count }, (_, k) => {
    const t = (end * k) / (count - 1);
    while (span < places.length - 2 && t > (knots[span + 1] ?? end)) span += 1;
    return onSpan([at(span - 1), at(span), at(span + 1), at(span + 2)], [knots[span] ?? 0, knots[span + 1] ?? end], t);
  });
}

function distance(a: Pair, b: Pair): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** The pyramid of Barry and Goldman; at the ends a place stands for its missing neighbour. */
function onSpan(places: readonly [Pair, Pair, Pair, Pair], [t1, t2]: readonly [number, number], t: number): Pair {
  const [p0, p1, p2, p3] = places;
  const t0 = t1 - Math.max(0.2, Math.sqrt(distance(p0, p1)));
  const t3 = t2 + Math.max(0.2, Math.sqrt(distance(p2, p3)));
  const mix = (a: Pair, b: Pair, from: number, to: number): Pair => {
    const part = (t - from) / (to - from);
    return [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
  };
  const [a1, a2, a3] = [mix(p0, p1, t0, t1), mix(p1, p2, t1, t2), mix(p2, p3, t2, t3)];
  return mix(mix(a1, a2, t0, t2), mix(a2, a3, t1, t3), t1, t2);
}
