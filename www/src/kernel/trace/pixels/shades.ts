import type { Pixels } from "../picture.ts";

/** Shades of a picture, what is ink of them, and how many pieces there are: what is shown before anything is traced. */

export interface Shades {
  readonly columns: number;
  readonly rows: number;
  /** 0 black … 255 white. */
  readonly values: Uint8Array<ArrayBuffer>;
  /** Whether all that is there is light, on a transparent ground: then that is the ink, as the tracer takes it. */
  readonly lightOnNothing?: boolean;
}

/**
 * The luma of Rec. 709; where something is transparent, that is paper: black where all is light, or is and light ink is
 * asked for, else white.
 */
export function shadesOf({ columns, rows, data }: Pixels, invert = false): Shades {
  const count = columns * rows;
  if (data.length === count) return { columns, rows, values: data instanceof Uint8Array ? data : new Uint8Array(data.buffer) };
  const luma = (i: number): number => (54 * (data[i] ?? 0) + 183 * (data[i + 1] ?? 0) + 19 * (data[i + 2] ?? 0)) / 256;
  let [light, opaque, dark] = [0, 0, 0];
  for (let i = 0; i < data.length; i += 4) {
    const [shade, alpha] = [luma(i), data[i + 3] ?? 0];
    light += shade * alpha;
    opaque += alpha;
    if (shade < 127.5) dark += alpha;
  }
  const isLight = light > opaque * 127.5;
  const lightOnNothing = isLight && 10 * (255 * count - opaque) >= 255 * count && 50 * dark <= opaque;
  const paper = lightOnNothing || (isLight && invert) ? 0 : 255;
  const values = new Uint8Array(count);
  for (let i = 0; i < count; i += 1) {
    const alpha = (data[4 * i + 3] ?? 0) / 255;
    values[i] = luma(4 * i) * alpha + paper * (1 - alpha) + 0.5;
  }
  return { columns, rows, values, lightOnNothing };
}

/** Blurred by three boxes in a row, which is as good as a bell for looking at. */
export function blurred(shades: Shades, sigma: number): Shades {
  const half = Math.round((Math.sqrt(4 * sigma * sigma + 1) - 1) / 2);
  if (half < 1) return shades;
  let values = shades.values;
  for (let pass = 0; pass < 3; pass += 1) {
    values = boxed(values, shades.columns, shades.rows, half, 1);
    values = boxed(values, shades.rows, shades.columns, half, shades.columns);
  }
  return { ...shades, values };
}

/** Means over 2·half + 1 pixels along lines whose pixels are `step` apart. */
function boxed(from: Uint8Array, length: number, lines: number, half: number, step: number): Uint8Array<ArrayBuffer> {
  const to = new Uint8Array(from.length);
  const across = step === 1 ? length : 1;
  const width = 2 * half + 1;
  for (let line = 0; line < lines; line += 1) {
    const start = line * across;
    const at = (i: number): number => from[start + step * Math.min(length - 1, Math.max(0, i))] ?? 0;
    let sum = 0;
    for (let i = -half; i <= half; i += 1) sum += at(i);
    for (let i = 0; i < length; i += 1) {
      to[start + step * i] = sum / width + 0.5;
      sum += at(i + half + 1) - at(i - half);
    }
  }
  return to;
}

/** Half-way between the middle shades of ink and paper, which Otsu's threshold parts. */
export function foundThreshold({ values }: Shades): number {
  const bins = new Float64Array(256);
  for (const value of values) bins[value] = (bins[value] ?? 0) + 1;
  const total = values.length;
  const sum = bins.reduce((all, n, shade) => all + n * shade, 0);
  let [best, bestAt, below, belowSum] = [-1, 127, 0, 0];
  for (let shade = 0; shade < 255; shade += 1) {
    below += bins[shade] ?? 0;
    belowSum += shade * (bins[shade] ?? 0);
    if (below === 0 || below === total) continue;
    const apart = below * (total - below) * (belowSum / below - (sum - belowSum) / (total - below)) ** 2;
    if (apart > best) [best, bestAt] = [apart, shade];
  }
  return (median(bins, 0, bestAt) + median(bins, bestAt + 1, 255)) / 2;
}

function median(bins: Float64Array, from: number, to: number): number {
  let half = 0;
  for (let shade = from; shade <= to; shade += 1) half += (bins[shade] ?? 0) / 2;
  let below = 0;
  for (let shade = from; shade <= to; shade += 1) {
    below += bins[shade] ?? 0;
    if (below >= half && below > 0) return shade;
  }
  return (from + to) / 2;
}

/** 1 where there is ink. */
export function inkOf({ values }: Shades, threshold: number, invert: boolean): Uint8Array<ArrayBuffer> {
  const ink = new Uint8Array(values.length);
  for (let i = 0; i < values.length; i += 1) ink[i] = (values[i] ?? 0) < threshold !== invert ? 1 : 0;
  return ink;
}

/**
 * How far a place is from the nearest border between ink and paper, in pixels: between two pixels, where their shades
 * pass the threshold; where ink ends with the picture, there. Infinite where there is no border at all.
 */
export function distanceToBorder(shades: Shades, ink: Uint8Array, threshold: number, x: number, y: number): number {
  const { columns, rows } = shades;
  const [column, row] = [Math.floor(x), Math.floor(y)];
  let best = Infinity;
  // Ring by ring of pixels: the borders of ring r, and of all around it, are at least r − 1.5 away.
  const far = Math.max(column, columns - column, row, rows - row);
  for (let r = 0; r <= far && best > r - 1.5; r += 1) {
    for (let down = -r; down <= r; down += 1) {
      const step = Math.abs(down) === r ? 1 : Math.max(1, 2 * r);
      for (let right = -r; right <= r; right += step) best = Math.min(best, toOwnBorders(shades, ink, threshold, column + right, row + down, x, y));
    }
  }
  return best;
}

const sides = [[1, 0], [-1, 0], [0, 1], [0, -1]] as const;

/** The distance of a place from the borders of a pixel of ink with its neighbours. */
function toOwnBorders({ columns, rows, values }: Shades, ink: Uint8Array, threshold: number, column: number, row: number, x: number, y: number): number {
  const isIn = (i: number, j: number): boolean => i >= 0 && j >= 0 && i < columns && j < rows;
  if (!isIn(column, row) || ink[row * columns + column] !== 1) return Infinity;
  const own = values[row * columns + column] ?? 0;
  let best = Infinity;
  for (const [right, down] of sides) {
    const [i, j] = [column + right, row + down];
    const other = isIn(i, j) ? j * columns + i : -1;
    if (ink[other] === 1) continue;
    const share = other < 0 ? 0.5 : (threshold - own) / ((values[other] ?? 0) - own);
    best = Math.min(best, Math.hypot(column + 0.5 + right * share - x, row + 0.5 + down * share - y));
  }
  return best;
}

/** How steep the shades are at each pixel, 0 … 255. */
export function steepness({ values, columns, rows }: Shades): Uint8Array<ArrayBuffer> {
  const steep = new Uint8Array(values.length);
  for (let y = 0; y < rows; y += 1) {
    const [up, down] = [Math.max(0, y - 1) * columns, Math.min(rows - 1, y + 1) * columns];
    for (let x = 0; x < columns; x += 1) {
      const [left, right] = [Math.max(0, x - 1), Math.min(columns - 1, x + 1)];
      const at = (i: number): number => values[i] ?? 0;
      const row = y * columns;
      const dx = at(up + right) + 2 * at(row + right) + at(down + right) - at(up + left) - 2 * at(row + left) - at(down + left);
      const dy = at(down + left) + 2 * at(down + x) + at(down + right) - at(up + left) - 2 * at(up + x) - at(up + right);
      steep[row + x] = Math.min(255, Math.hypot(dx, dy) / 4);
    }
  }
  return steep;
}

/**
 * Areas in pixels of the pieces of ink and of the pieces of paper, in falling order. Every piece has an outline of its
 * own but for the paper around, so that their number tells a drawing from a photograph.
 */
export function pieceAreas(ink: Uint8Array, columns: number, rows: number): Uint32Array {
  // Runs of equal pixels, joined to those of the row above: one number per run, not one per pixel.
  const parent: number[] = [];
  const area: number[] = [];
  const find = (piece: number): number => {
    let root = piece;
    while ((parent[root] ?? root) !== root) root = parent[root] ?? root;
    for (let at = piece; at !== root;) {
      const next = parent[at] ?? root;
      parent[at] = root;
      at = next;
    }
    return root;
  };
  let above: { end: number; piece: number; value: number }[] = [];
  for (let y = 0; y < rows; y += 1) {
    const row: typeof above = [];
    let over = 0;
    let x = 0;
    while (x < columns) {
      const value = ink[y * columns + x] ?? 0;
      let end = x + 1;
      while (end < columns && ink[y * columns + end] === value) end += 1;
      let piece = -1;
      while (over < above.length && (above[over]?.end ?? 0) <= x) over += 1;
      for (let i = over, start = x; i < above.length && start < end; i += 1) {
        const run = above[i];
        if (run === undefined) break;
        if (run.value === value) {
          const root = find(run.piece);
          if (piece === -1) piece = root;
          else if (piece !== root) {
            parent[root] = piece;
            area[piece] = (area[piece] ?? 0) + (area[root] ?? 0);
          }
        }
        start = run.end;
      }
      if (piece === -1) {
        piece = parent.length;
        parent.push(piece);
        area.push(0);
      }
      area[piece] = (area[piece] ?? 0) + end - x;
      row.push({ end, piece, value });
      x = end;
    }
    above = row;
  }
  const roots = area.filter((_, piece) => parent[piece] === piece);
  return Uint32Array.from(roots).sort().reverse();
}
