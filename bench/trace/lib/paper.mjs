// The times that Raffo and Biasotti print for their method (Mathematics 9(23):3084, Table 4), beside ours for profiles
// of as many edge points.

/** Figure, tubes, edge points, seconds. */
const PRINTED = [
  ["6, daffodil", 13, 583, 0.386935],
  ["7, mushroom", 11, 901, 0.700913],
  ["8, left eyebrow", 5, 363, 0.530476],
  ["8, right eyebrow", 4, 375, 0.539895],
  ["8, letter M", 10, 721, 0.75875],
  ["8, oval", 7, 649, 0.833938],
  ["8, moustache", 9, 930, 1.038803],
  ["9, cherry", 30, 3758, 6.910031],
  ["10, head", 24, 878, 1.541078],
  ["11, first", 4, 134, 0.211553],
  ["11, fifth", 10, 215, 0.252587],
  ["12, body", 41, 726, 2.786343],
  ["12, aorta", 5, 422, 0.426888],
];

/** The share of the printed time that may be taken. */
const SHARE = 0.1;

/** The pixels that a closed wave of some size runs through, in order. */
function ring(size) {
  const pixels = [];
  for (let i = 0; i < 40 * size; i++) {
    const angle = (2 * Math.PI * i) / (40 * size);
    const r = size * (1 + 0.22 * Math.sin(3 * angle) + 0.12 * Math.sin(7 * angle + 1) + 0.04 * Math.sin(13 * angle));
    const [x, y] = [Math.floor(r * Math.cos(angle)) + 0.5, Math.floor(r * Math.sin(angle)) + 0.5];
    const last = pixels.at(-1);
    if (last?.[0] !== x || last[1] !== y) pixels.push([x, y]);
  }
  return pixels;
}

/** The smallest ring of at least so many pixels. */
function ringOf(count) {
  let size = 4;
  while (ring(size).length < count) size += 0.25;
  return ring(size);
}

/** Rows { name, points, printed, published, improved }, times in milliseconds, the least of some runs. */
export function paperTimes(fitProfile) {
  return PRINTED.map(([name, , count, seconds]) => {
    const points = ringOf(count);
    const least = (method) => {
      let best = Infinity;
      for (let run = 0; run < 5; run++) {
        const start = performance.now();
        fitProfile(points, { method });
        best = Math.min(best, performance.now() - start);
      }
      return best;
    };
    return { name, points: points.length, printed: 1000 * seconds, published: least("mean"), improved: least("local") };
  });
}

/** Whether a row is as fast as asked. */
export const fastEnough = ({ printed, published, improved }) => Math.max(published, improved) <= SHARE * printed;
