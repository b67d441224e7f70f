// Coverage of pixels by filled outlines, exactly: each edge adds the area to its right, as signed numbers.

/** How far a chord may be from its curve, in pixels of the raster. */
const FLAT = 0.002;

/** Where a Bézier segment is at t, as [x, y]. */
export function pointAt(p, t) {
  const u = 1 - t;
  if (p.length === 4) return [u * p[0] + t * p[2], u * p[1] + t * p[3]];
  if (p.length === 6) return [0, 1].map((i) => u * u * p[i] + 2 * u * t * p[i + 2] + t * t * p[i + 4]);
  return [0, 1].map((i) => u * u * u * p[i] + 3 * u * u * t * p[i + 2] + 3 * u * t * t * p[i + 4] + t * t * t * p[i + 6]);
}

/** Into how many chords a segment is cut. */
function chords(p, scale) {
  let most = 0;
  for (let i = 0; i + 5 < p.length; i += 2) {
    most = Math.max(most, Math.hypot(p[i] - 2 * p[i + 2] + p[i + 4], p[i + 1] - 2 * p[i + 3] + p[i + 5]));
  }
  const degree = p.length / 2 - 1;
  return Math.max(1, Math.ceil(Math.sqrt((degree * (degree - 1) * most * scale) / (8 * FLAT))));
}

export class Raster {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    // One column more, into which falls what lies to the right.
    this.sums = new Float64Array((width + 2) * height);
  }

  /** Adds contours of segments [x0, y0, …]; coordinates are multiplied by the scale. */
  add(contours, scale = 1) {
    for (const contour of contours) {
      for (const p of contour) {
        const n = chords(p, scale);
        let [x, y] = [p[0] * scale, p[1] * scale];
        for (let i = 1; i <= n; i++) {
          const [a, b] = i === n ? [p[p.length - 2], p[p.length - 1]] : pointAt(p, i / n);
          this.#edge(x, y, a * scale, b * scale);
          [x, y] = [a * scale, b * scale];
        }
      }
    }
    return this;
  }

  #edge(x0, y0, x1, y1) {
    if (y0 === y1) return;
    if (y0 > y1) return this.#descend(x1, y1, x0, y0, -1);
    return this.#descend(x0, y0, x1, y1, 1);
  }

  #descend(x0, y0, x1, y1, sign) {
    const slope = (x1 - x0) / (y1 - y0);
    const last = Math.min(this.height, Math.ceil(y1));
    for (let row = Math.max(0, Math.floor(y0)); row < last; row++) {
      const [top, bottom] = [Math.max(y0, row), Math.min(y1, row + 1)];
      if (bottom <= top) continue;
      const [a, b] = [x0 + (top - y0) * slope, x0 + (bottom - y0) * slope];
      this.#strip(row, Math.min(a, b), Math.max(a, b), sign * (bottom - top));
    }
  }

  /** An edge within one row, from column a to b, that is `drop` high. */
  #strip(row, a, b, drop) {
    const [base, width] = [row * (this.width + 2), this.width];
    const [left, right] = [Math.min(Math.max(a, 0), width), Math.min(Math.max(b, 0), width)];
    const first = Math.floor(left);
    if (right <= first + 1 || b - a < 1e-12) {
      const inside = first + 1 - 0.5 * (left + right);
      this.sums[base + first] += drop * inside;
      this.sums[base + first + 1] += drop * (1 - inside);
      return;
    }
    const share = drop / (b - a);
    // The parts beyond both sides are upright there.
    if (a < 0) this.sums[base] += share * (left - a);
    for (let column = first; column < right; column++) {
      const [from, to] = [Math.max(left, column), Math.min(right, column + 1)];
      const piece = share * (to - from);
      const inside = column + 1 - 0.5 * (from + to);
      this.sums[base + column] += piece * inside;
      this.sums[base + column + 1] += piece * (1 - inside);
    }
  }

  /** The share of every pixel that is covered. */
  coverage(rule = "nonzero") {
    const covered = new Float32Array(this.width * this.height);
    for (let row = 0; row < this.height; row++) {
      let sum = 0;
      for (let column = 0; column < this.width; column++) {
        sum += this.sums[row * (this.width + 2) + column];
        const turns = Math.abs(sum);
        covered[row * this.width + column] = rule === "evenodd" ? Math.abs(turns - 2 * Math.round(turns / 2)) : Math.min(1, turns);
      }
    }
    return covered;
  }
}
