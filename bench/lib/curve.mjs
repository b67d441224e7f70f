// The curve that everything is measured on: closed, 16 cubics in a box of 512, uniform Catmull–Rom through 16 points.
// Bézier, cardinal and Hermite libraries can all hold exactly this curve, so that results can be checked.

export const SEGMENTS = 16;
/** The frequency of the same points' curve whose segments are no cubics. */
export const EXPONENTIAL_OMEGA = Math.PI / 2;

/** A small generator of numbers in [0, 1), the same everywhere. */
export function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** The 16 points: around the middle of the box, at uneven distances. */
export const points = (() => {
  const next = random(7);
  const out = new Float64Array(2 * SEGMENTS);
  for (let i = 0; i < SEGMENTS; i++) {
    const angle = (2 * Math.PI * (i + 0.3 * next())) / SEGMENTS;
    const radius = 110 + 140 * next();
    out[2 * i] = 256 + radius * Math.cos(angle);
    out[2 * i + 1] = 256 + radius * Math.sin(angle);
  }
  return out;
})();

/** dr/dt at the points, one unit of t per segment. */
export const tangents = Float64Array.from(points, (_, k) => {
  const n = points.length;
  return (points[(k + 2) % n] - points[(k - 2 + n) % n]) / 2;
});

/** The same curve as cubic Béziers, 8 numbers each. */
export const cubics = (() => {
  const out = new Float64Array(8 * SEGMENTS);
  for (let i = 0; i < SEGMENTS; i++) {
    const j = (i + 1) % SEGMENTS;
    for (let k = 0; k < 2; k++) {
      const [p, q] = [points[2 * i + k], points[2 * j + k]];
      out[8 * i + k] = p;
      out[8 * i + 2 + k] = p + tangents[2 * i + k] / 3;
      out[8 * i + 4 + k] = q - tangents[2 * j + k] / 3;
      out[8 * i + 6 + k] = q;
    }
  }
  return out;
})();

/** Power form: a, b, c, d with a + b t + c t² + d t³, per segment for x, then for y. */
const powers = (() => {
  const out = new Float64Array(8 * SEGMENTS);
  for (let i = 0; i < SEGMENTS; i++) {
    for (let k = 0; k < 2; k++) {
      const [p0, p1, p2, p3] = [0, 2, 4, 6].map((m) => cubics[8 * i + m + k]);
      out.set([p0, 3 * (p1 - p0), 3 * (p0 - 2 * p1 + p2), p3 - 3 * p2 + 3 * p1 - p0], 8 * i + 4 * k);
    }
  }
  return out;
})();

/** Coordinate k (0 for x, 1 for y) at t in [0, 16). */
export function coordinate(t, k) {
  const i = Math.min(SEGMENTS - 1, Math.floor(t));
  const x = t - i;
  const o = 8 * i + 4 * k;
  return powers[o] + x * (powers[o + 1] + x * (powers[o + 2] + x * powers[o + 3]));
}

/** The derivative of a coordinate. */
export function slope(t, k) {
  const i = Math.min(SEGMENTS - 1, Math.floor(t));
  const x = t - i;
  const o = 8 * i + 4 * k;
  return powers[o + 1] + x * (2 * powers[o + 2] + x * 3 * powers[o + 3]);
}

const NODES = [-0.906179845938664, -0.5384693101056831, 0, 0.5384693101056831, 0.906179845938664];
const WEIGHTS = [0.23692688505618908, 0.47862867049936647, 128 / 225, 0.47862867049936647, 0.23692688505618908];
/** Pieces of a segment in the true length: Gauss–Legendre of five points is exact to rounding on each. */
const PIECES = 200;

/** The length from a to b, which are in the same piece or at ends of pieces. */
export function lengthBetween(a, b) {
  const count = Math.max(1, Math.round((b - a) * PIECES));
  const half = (b - a) / count / 2;
  let total = 0;
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < 5; k++) {
      const t = a + half * (2 * i + 1 + NODES[k]);
      total += half * WEIGHTS[k] * Math.hypot(slope(t, 0), slope(t, 1));
    }
  }
  return total;
}

/** `count` points at equal distances along the curve, by bisection on the true length. */
export function evenPlaces(count) {
  const ends = new Float64Array(SEGMENTS * PIECES + 1);
  for (let i = 0; i < ends.length - 1; i++) ends[i + 1] = ends[i] + lengthBetween(i / PIECES, (i + 1) / PIECES);
  const out = new Float64Array(2 * count);
  let piece = 0;
  for (let i = 0; i < count; i++) {
    const wanted = (ends[ends.length - 1] * i) / count;
    while (ends[piece + 1] <= wanted) piece += 1;
    const start = piece / PIECES;
    let [low, high] = [start, (piece + 1) / PIECES];
    for (let step = 0; step < 50; step++) {
      const middle = (low + high) / 2;
      if (ends[piece] + lengthBetween(start, middle) < wanted) low = middle;
      else high = middle;
    }
    out.set([coordinate(low, 0), coordinate(low, 1)], 2 * i);
  }
  return out;
}

/** 10 000 places around and on the curve to ask the nearest point for. */
export const queries = (() => {
  const next = random(11);
  return Float64Array.from({ length: 20_000 }, () => 512 * next());
})();

/** The path text of the parse and print rows: 1000 cubics of three decimals, absolute. */
export const pathText = (() => {
  const next = random(13);
  const number = () => (512 * next()).toFixed(3);
  const segments = Array.from({ length: 1000 }, () => `C${[0, 1, 2].map(() => `${number()},${number()}`).join(" ")}`);
  return `M${number()},${number()} ${segments.join(" ")} Z`;
})();

/**
 * The distance from the first `count` queries to the curve by brute force: every low place of a dense sampling,
 * refined.
 */
export function trueDistances(count) {
  const n = SEGMENTS * 64;
  const xs = Float64Array.from({ length: n }, (_, i) => coordinate(i / 64, 0));
  const ys = Float64Array.from({ length: n }, (_, i) => coordinate(i / 64, 1));
  const coarse = new Float64Array(n);
  return Float64Array.from({ length: count }, (_, q) => {
    const [x, y] = [queries[2 * q], queries[2 * q + 1]];
    const squared = (u) => {
      const t = ((u + n) % n) / 64;
      return (coordinate(t, 0) - x) ** 2 + (coordinate(t, 1) - y) ** 2;
    };
    let least = Number.POSITIVE_INFINITY;
    for (let i = 0; i < n; i++) {
      coarse[i] = (xs[i] - x) ** 2 + (ys[i] - y) ** 2;
      least = Math.min(least, coarse[i]);
    }
    let best = least;
    for (let i = 0; i < n; i++) {
      const isLow = coarse[i] <= coarse[(i + 1) % n] && coarse[i] <= coarse[(i + n - 1) % n];
      // Neighbouring samples are at most 4 apart here, so a place farther off than that cannot win.
      if (isLow && Math.sqrt(coarse[i]) <= Math.sqrt(least) + 4) best = Math.min(best, goldenSection(squared, i - 1, i + 1));
    }
    return Math.sqrt(best);
  });
}

function goldenSection(f, from, to) {
  const ratio = (Math.sqrt(5) - 1) / 2;
  let [a, b] = [from, to];
  let [c, d] = [b - ratio * (b - a), a + ratio * (b - a)];
  let [fc, fd] = [f(c), f(d)];
  while (b - a > 1e-7) {
    if (fc < fd) {
      [b, d, fd] = [d, c, fc];
      c = b - ratio * (b - a);
      fc = f(c);
    } else {
      [a, c, fc] = [c, d, fd];
      d = a + ratio * (b - a);
      fd = f(d);
    }
  }
  return Math.min(fc, fd);
}
