// Points along a closed outline, with noise: the same every time.

/** Numbers in [0, 1), the same every time. */
export function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 48271) >>> 0) % 2147483647;
    return state / 2147483647;
  };
}

export function normal(next) {
  return Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());
}

/**
 * A closed outline some 400 across with smooth lobes and four corners, `count` points along it, noise of deviation 1.
 */
export function outline(count) {
  const next = random(count);
  return Float64Array.from({ length: 2 * count }, (_, i) => {
    const angle = (2 * Math.PI * (i >> 1)) / count;
    const radius = 150 + 30 * Math.cos(3 * angle) + 18 * Math.abs(Math.sin(2 * angle)) + 6 * Math.sin(11 * angle);
    return 250 + radius * (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle)) + normal(next);
  });
}
