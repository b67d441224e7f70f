// Time on whole sheets: sixteen shapes side by side, in four rows.

import { drawn } from "./unseen.mjs";

const ACROSS = 4;

/** The first sixteen shapes of a set on a square of so many pixels. */
export function sheet(shapes, side) {
  const tile = side / ACROSS;
  const pixels = new Uint8Array(side * side);
  shapes.slice(0, ACROSS * ACROSS).forEach((shape, i) => {
    const picture = drawn(shape, tile);
    const corner = Math.floor(i / ACROSS) * tile * side + (i % ACROSS) * tile;
    for (let row = 0; row < tile; row++) pixels.set(picture.pixels.subarray(row * tile, (row + 1) * tile), corner + row * side);
  });
  return { width: side, height: side, pixels };
}

/** Milliseconds of each contestant, which take turns: least and median over the rounds. */
export async function timed(picture, contestants, rounds) {
  const samples = contestants.map(() => []);
  for (let round = 0; round < rounds; round++) {
    for (const [i, [, trace]] of contestants.entries()) samples[i].push((await trace(picture, 1)).ms);
  }
  return contestants.map(([name], i) => {
    const sorted = samples[i].sort((a, b) => a - b);
    return { name, least: sorted[0], median: sorted[sorted.length >> 1] };
  });
}
