// Taking turns: every round measures each contestant once for a while, so that a noisy machine disturbs all alike.

/** One sample lasts about this long. */
const SAMPLE_MS = 30;

/** How often an action has to run for a sample of the wanted length; it is warm afterwards. */
async function calibrate(measure) {
  let times = 1;
  for (;;) {
    const ms = await measure(times);
    if (ms >= SAMPLE_MS / 2) return Math.max(1, Math.round((times * SAMPLE_MS) / ms));
    times = Math.ceil(times * Math.min(50, Math.max(2, SAMPLE_MS / Math.max(ms, 0.01))));
  }
}

/** An action of this process as a measure: milliseconds for so many runs. */
export function here(action) {
  return (times) => {
    const start = performance.now();
    for (let i = 0; i < times; i++) action();
    return performance.now() - start;
  };
}

/**
 * Measures contestants `{ name, measure, units }` in turns and gives back, for each, nanoseconds per unit: least and
 * median over the rounds.
 */
export async function race(contestants, rounds) {
  const entries = [];
  for (const c of contestants) entries.push({ ...c, times: await calibrate(c.measure), samples: [] });
  for (let round = 0; round < rounds; round++) {
    for (const c of entries) c.samples.push(((await c.measure(c.times)) * 1e6) / (c.times * c.units));
  }
  return entries.map(({ samples, ...c }) => {
    samples.sort((a, b) => a - b);
    return { ...c, least: samples[0], median: samples[samples.length >> 1] };
  });
}
