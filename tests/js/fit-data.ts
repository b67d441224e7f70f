// Points for fits, the same every time.

/** Numbers in [0, 1). */
export function random(seed: number): () => number {
  let state = seed + 1;
  return () => {
    state = (Math.imul(state, 48271) >>> 0) % 2147483647 || 1;
    return state / 2147483647;
  };
}

/** About normal, by the sum of twelve. */
function normal(next: () => number): number {
  let sum = -6;
  for (let i = 0; i < 12; i += 1) sum += next();
  return sum;
}

/** `count` points round the unit circle, with noise of deviation `sigma` in each coordinate. */
export function noisyCircle(count: number, sigma: number, seed: number): Float64Array {
  const next = random(seed);
  return Float64Array.from({ length: 2 * count }, (_, i) => {
    const angle = (2 * Math.PI * (i >> 1)) / count;
    return (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle)) + sigma * normal(next);
  });
}

/** `count` points on the line from (0, 0) to (1, 2). */
export function collinear(count: number): Float64Array {
  return Float64Array.from({ length: 2 * count }, (_, i) => ((i >> 1) / (count - 1)) * (1 + (i % 2)));
}

/** A star of so many tips, `per` points on each side. */
export function star(tips: number, per: number): Float64Array {
  const corner = (k: number): [number, number] => {
    const [angle, radius] = [(Math.PI * k) / tips, k % 2 === 0 ? 2 : 1];
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  };
  const list: number[] = [];
  for (let k = 0; k < 2 * tips; k += 1) {
    const [[x0, y0], [x1, y1]] = [corner(k), corner(k + 1)];
    for (let i = 0; i < per; i += 1) list.push(x0 + (i / per) * (x1 - x0), y0 + (i / per) * (y1 - y0));
  }
  return Float64Array.from(list);
}
