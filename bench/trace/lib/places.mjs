// The nearest of many places, from a grid of cells.

export class Places {
  /** Coordinates x, y, x, y, … */
  constructor(xy, cell = 2) {
    this.xy = xy;
    this.count = xy.length / 2;
    this.cell = cell;
    let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let i = 0; i < xy.length; i += 2) {
      left = Math.min(left, xy[i]);
      right = Math.max(right, xy[i]);
      top = Math.min(top, xy[i + 1]);
      bottom = Math.max(bottom, xy[i + 1]);
    }
    [this.left, this.top] = [left, top];
    this.columns = this.count > 0 ? Math.floor((right - left) / cell) + 1 : 0;
    this.rows = this.count > 0 ? Math.floor((bottom - top) / cell) + 1 : 0;
    this.starts = new Int32Array(this.columns * this.rows + 1);
    for (let i = 0; i < this.count; i++) this.starts[this.#cellOf(i) + 1]++;
    for (let i = 1; i < this.starts.length; i++) this.starts[i] += this.starts[i - 1];
    this.order = new Int32Array(this.count);
    const next = this.starts.slice();
    for (let i = 0; i < this.count; i++) this.order[next[this.#cellOf(i)]++] = i;
  }

  #cellOf(i) {
    const column = Math.floor((this.xy[2 * i] - this.left) / this.cell);
    const row = Math.floor((this.xy[2 * i + 1] - this.top) / this.cell);
    return row * this.columns + column;
  }

  /**
   * The `k` nearest, near ones first: writes their indices, and gives the distance to the first; Infinity where there
   * is none.
   */
  nearest(x, y, k, indices) {
    const found = [];
    const limit = Math.min(k, this.count);
    const [column, row] = [Math.floor((x - this.left) / this.cell), Math.floor((y - this.top) / this.cell)];
    // Rings before this one are empty.
    const first = Math.max(0, -column, column - this.columns + 1, -row, row - this.rows + 1);
    for (let ring = first; limit > 0; ring++) {
      // Whatever lies in this ring is farther than this.
      const far = (ring - 1) * this.cell;
      if (found.length === limit && ring > 0 && far > 0 && found[limit - 1].square <= far * far) break;
      this.#ring(column, row, ring, (i) => keep(found, limit, i, (this.xy[2 * i] - x) ** 2 + (this.xy[2 * i + 1] - y) ** 2));
    }
    for (let i = 0; i < found.length; i++) indices[i] = found[i].index;
    return found.length > 0 ? Math.sqrt(found[0].square) : Infinity;
  }

  /** The distance to the nearest place. */
  distance(x, y) {
    return this.nearest(x, y, 1, []);
  }

  #ring(column, row, ring, visit) {
    const bottom = Math.min(this.rows - 1, row + ring);
    for (let r = Math.max(0, row - ring); r <= bottom; r++) {
      const step = Math.abs(r - row) === ring || ring === 0 ? 1 : 2 * ring;
      for (let c = column - ring; c <= column + ring; c += step) {
        if (c < 0 || c >= this.columns) continue;
        const cell = r * this.columns + c;
        for (let i = this.starts[cell]; i < this.starts[cell + 1]; i++) visit(this.order[i]);
      }
    }
  }
}

function keep(found, limit, index, square) {
  if (found.length === limit && found[limit - 1].square <= square) return;
  let at = found.length;
  while (at > 0 && found[at - 1].square > square) at--;
  found.splice(at, 0, { index, square });
  if (found.length > limit) found.pop();
}
