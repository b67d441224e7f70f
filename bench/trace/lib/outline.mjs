// Closed contours of Bézier segments, sampled densely: places, tangents, distances, turning, corners.

import { Places } from "./places.mjs";

const DEGREES = 180 / Math.PI;

function evaluate(p, t) {
  const u = 1 - t;
  const at = (i) => p[i];
  const each = (position, slope) => [position(0), position(1), slope(0), slope(1)];
  if (p.length === 4) return each((i) => u * at(i) + t * at(i + 2), (i) => at(i + 2) - at(i));
  if (p.length === 6) {
    return each((i) => u * u * at(i) + 2 * u * t * at(i + 2) + t * t * at(i + 4), (i) => 2 * u * (at(i + 2) - at(i)) + 2 * t * (at(i + 4) - at(i + 2)));
  }
  return each(
    (i) => u ** 3 * at(i) + 3 * u * u * t * at(i + 2) + 3 * u * t * t * at(i + 4) + t ** 3 * at(i + 6),
    (i) => 3 * u * u * (at(i + 2) - at(i)) + 6 * u * t * (at(i + 4) - at(i + 2)) + 3 * t * t * (at(i + 6) - at(i + 4)),
  );
}

/** The largest distance of a segment's control points from its first, by coordinate. */
function extent(p) {
  let most = 0;
  for (let i = 2; i < p.length; i++) most = Math.max(most, Math.abs(p[i] - p[i & 1]));
  return most;
}

/** The unit tangent at an end, whatever control points coincide. */
function endTangent(p, atEnd) {
  const least = extent(p) + 1e-12;
  const last = p.length - 2;
  for (let k = 2; k <= last; k += 2) {
    const [from, to] = atEnd ? [last - k, last] : [0, k];
    const [x, y] = [p[to] - p[from], p[to + 1] - p[from + 1]];
    const size = Math.hypot(x, y);
    if (size > 1e-6 * least && size > 1e-9) return [x / size, y / size];
  }
  return [1, 0];
}

/** Degrees from one direction to another. */
const turn = (ax, ay, bx, by) => Math.atan2(ax * by - ay * bx, ax * bx + ay * by) * DEGREES;

/** Without segments of no extent, and closed. */
export function cleaned(contours, least = 1e-3) {
  const out = [];
  for (const contour of contours) {
    const kept = contour.filter((p) => extent(p) > least);
    if (kept.length === 0) continue;
    const [first, last] = [kept[0], kept[kept.length - 1]];
    const [x, y] = [last[last.length - 2], last[last.length - 1]];
    if (Math.hypot(first[0] - x, first[1] - y) > least) kept.push([x, y, first[0], first[1]]);
    out.push(kept);
  }
  return out;
}

export class Outline {
  /** One sample for every `step` of a segment's control polygon, at least two. */
  constructor(contours, step) {
    this.places = [];
    this.tangents = [];
    this.weights = [];
    this.along = [];
    this.contour = [];
    /** Where each contour's samples start, and the end of the last. */
    this.starts = [0];
    this.lengths = [];
    this.joints = [];
    contours.forEach((contour, index) => this.#sample(contour, index, step));
    this.count = this.weights.length;
    this.places = Float64Array.from(this.places);
    this.tree = new Places(this.places, step > 0.2 ? 2 : 1);
    this.total = this.weights.reduce((sum, w) => sum + w, 0);
  }

  #sample(contour, index, step) {
    const ends = [];
    let reached = 0;
    for (const p of contour) {
      let polygon = 0;
      for (let i = 2; i < p.length; i += 2) polygon += Math.hypot(p[i] - p[i - 2], p[i + 1] - p[i - 1]);
      const n = Math.max(2, Math.ceil(polygon / step));
      ends.push(reached);
      for (let i = 0; i < n; i++) {
        let [x, y, dx, dy] = evaluate(p, (i + 0.5) / n);
        let speed = Math.hypot(dx, dy);
        if (speed < 1e-9) {
          speed = 1;
          [dx, dy] = [p[p.length - 2] - p[0], p[p.length - 1] - p[1]];
        }
        const size = Math.max(Math.hypot(dx, dy), 1e-12);
        this.places.push(x, y);
        this.tangents.push(dx / size, dy / size);
        this.weights.push(speed / n);
        this.along.push(reached + speed / n / 2);
        this.contour.push(index);
        reached += speed / n;
      }
    }
    contour.forEach((p, i) => {
      const [a, b] = [endTangent(contour[(i + contour.length - 1) % contour.length], true), endTangent(p, false)];
      this.joints.push({ contour: index, along: ends[i], x: p[0], y: p[1], turn: turn(...a, ...b) });
    });
    this.starts.push(this.weights.length);
    this.lengths.push(reached);
  }

  /** The sample before or after another of the same contour. */
  #beside(i, by) {
    const [start, end] = [this.starts[this.contour[i]], this.starts[this.contour[i] + 1]];
    return start + ((i - start + by + end - start) % (end - start));
  }

  /** The distance from a place to the chords at its nearest samples, and the nearest sample. */
  nearest(x, y) {
    const indices = [];
    this.tree.nearest(x, y, 3, indices);
    let best = Infinity;
    for (const i of indices) {
      best = Math.min(best, this.#chord(i, this.#beside(i, 1), x, y), this.#chord(this.#beside(i, -1), i, x, y));
    }
    return { distance: best, sample: indices[0] };
  }

  #chord(i, j, x, y) {
    const [ax, ay] = [this.places[2 * i], this.places[2 * i + 1]];
    const [dx, dy] = [this.places[2 * j] - ax, this.places[2 * j + 1] - ay];
    const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / Math.max(dx * dx + dy * dy, 1e-18)));
    return Math.hypot(x - ax - t * dx, y - ay - t * dy);
  }

  #tangentAt(contour, along) {
    const [start, end] = [this.starts[contour], this.starts[contour + 1]];
    const length = this.lengths[contour];
    const wanted = ((along % length) + length) % length;
    let [low, high] = [start, end];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.along[middle] < wanted) low = middle + 1;
      else high = middle;
    }
    const i = low >= end ? start : low;
    return [this.tangents[2 * i], this.tangents[2 * i + 1]];
  }

  /** Degrees by which a contour turns within ±reach of a place along it. */
  turning(contour, along, reach) {
    return turn(...this.#tangentAt(contour, along - reach), ...this.#tangentAt(contour, along + reach));
  }

  /** Joints at which the contour turns by more than `least` degrees within ±¼, one for each 0.6 along it. */
  corners(least) {
    const [reach, apart] = [0.25, 0.6];
    const out = [];
    this.lengths.forEach((length, contour) => {
      if (length < 4 * reach) return;
      const joints = this.joints.filter((j) => j.contour === contour);
      const turns = joints.map((j) => this.turning(contour, j.along, reach));
      const order = joints.map((_, i) => i).sort((a, b) => Math.abs(turns[b]) - Math.abs(turns[a]));
      const taken = [];
      for (const i of order) {
        if (Math.abs(turns[i]) < least) break;
        const { along, x, y } = joints[i];
        if (!taken.every((other) => round(along, other, length) > apart)) continue;
        taken.push(along);
        out.push({ x, y, turn: turns[i], contour, along });
      }
    });
    return out;
  }

  /** Places at which the outline turns by more than 30° within ±1.5: a raster cannot tell them from corners. */
  tight() {
    const out = [];
    for (let i = 0; i < this.count; i++) {
      const contour = this.contour[i];
      const reach = Math.min(1.5, this.lengths[contour] / 4);
      if (Math.abs(this.turning(contour, this.along[i], reach)) > 30) out.push(this.places[2 * i], this.places[2 * i + 1]);
    }
    return out;
  }

  /** Degrees of all turning, left and right alike. */
  totalTurning() {
    let total = 0;
    for (let i = 0; i < this.count; i++) {
      const j = this.#beside(i, 1);
      total += Math.abs(turn(this.tangents[2 * i], this.tangents[2 * i + 1], this.tangents[2 * j], this.tangents[2 * j + 1]));
    }
    return total;
  }
}

/** The distance along a closed contour. */
export const round = (a, b, length) => Math.min(Math.abs(a - b), length - Math.abs(a - b));
