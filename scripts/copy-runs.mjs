// Runs of bytes that another wasm's streams have too, copied from there.
//
// A wasm that is loaded beside the core has much of the core's code: what every curve and every number is made of. What
// comes out is
//
//   how many bytes the runs take
//   runs: how many own bytes are next, how much further than after them the other's place is (twice that, or one less
//   than twice how far back), and how many bytes are copied from there
//   the own bytes
//
// with all numbers as LEB128.

import { leb } from "./wasm-functions.mjs";

/** Runs are looked for by so many bytes. */
const LOOKED_FOR = 6;
/**
 * A run that goes on where the last one ended, with as many own bytes between as the other has, costs less than one
 * from elsewhere.
 */
const SHORTEST_NEXT = 8;

/** Where the other has each few bytes. */
function placesIn(other) {
  const places = new Map();
  for (let at = 0; at + LOOKED_FOR <= other.length; at++) {
    const key = other.toString("latin1", at, at + LOOKED_FOR);
    const list = places.get(key);
    if (list === undefined) places.set(key, [at]);
    else list.push(at);
  }
  return places;
}

function lengthOf(bytes, at, other, place) {
  let length = 0;
  while (at + length < bytes.length && place + length < other.length && bytes[at + length] === other[place + length]) length += 1;
  return length;
}

/** The bytes with runs of the other of at least so many bytes copied. */
export function withRuns(given, from, shortest) {
  const [bytes, other] = [Buffer.from(given), Buffer.from(from)];
  const places = placesIn(other);
  const runs = [];
  const own = [];
  let [at, next, since] = [0, 0, 0];
  const add = (place, length) => {
    const step = place - next;
    runs.push(...leb(since), ...leb(step < 0 ? -2 * step - 1 : 2 * step), ...leb(length));
    next = place + length;
    at += length;
    since = 0;
  };
  while (at < bytes.length) {
    const straight = lengthOf(bytes, at, other, next);
    let [best, longest] = [0, 0];
    for (const place of places.get(bytes.toString("latin1", at, at + LOOKED_FOR)) ?? []) {
      const length = lengthOf(bytes, at, other, place);
      if (length > longest) [best, longest] = [place, length];
    }
    if (straight >= SHORTEST_NEXT && longest < straight + shortest) add(next, straight);
    else if (longest >= shortest) add(best, longest);
    else {
      own.push(bytes[at]);
      at += 1;
      next += 1;
      since += 1;
    }
  }
  // Nothing of the other, from a place that it has.
  if (since > 0) add(0, 0);
  return Uint8Array.from([...leb(runs.length), ...runs, ...own]);
}
