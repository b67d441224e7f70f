import type { Color, ColoredShape, Outline, TraceSample } from "../../document/trace/trace-samples.ts";

/** Pictures from outlines, with the exact area that they cover of every pixel. */

export interface DrawnPicture {
  readonly width: number;
  readonly height: number;
  /** Row by row, a byte per pixel, 0 black … 255 white; or four: red, green, blue and opacity. */
  readonly data: Uint8Array<ArrayBuffer>;
}

/**
 * Share of every pixel that lies inside, 0 … 1: of any outline, or of an odd number of them. Each edge leaves in a
 * pixel the area between itself and the pixel's right side; summed along a row that is the area inside.
 */
export function coverage(outlines: readonly Outline[], width: number, height: number, scale: number, rule: CanvasFillRule = "nonzero"): Float32Array {
  const inside = rule === "nonzero" ? (around: number): number => Math.min(1, around) : (around: number): number => Math.abs(around - 2 * Math.round(around / 2));
  const sums = new Float32Array(width * height + 1);
  for (const outline of outlines) {
    for (let i = 0; i + 1 < outline.length; i += 2) {
      const j = i + 2 < outline.length ? i + 2 : 0;
      addEdge(sums, width, height, (outline[i] ?? 0) * scale, (outline[i + 1] ?? 0) * scale, (outline[j] ?? 0) * scale, (outline[j + 1] ?? 0) * scale);
    }
  }
  for (let y = 0; y < height; y += 1) {
    let sum = 0;
    for (let i = y * width; i < (y + 1) * width; i += 1) {
      sum += sums[i] ?? 0;
      sums[i] = inside(Math.abs(sum));
    }
  }
  return sums.subarray(0, width * height);
}

function addEdge(sums: Float32Array, width: number, height: number, x0: number, y0: number, x1: number, y1: number): void {
  if (y0 === y1) return;
  const sign = y0 < y1 ? 1 : -1;
  const [topX, topY, endX, endY] = y0 < y1 ? [x0, y0, x1, y1] : [x1, y1, x0, y0];
  const slope = (endX - topX) / (endY - topY);
  const last = Math.min(height, Math.ceil(endY));
  for (let y = Math.max(0, Math.floor(topY)); y < last; y += 1) {
    const [from, to] = [Math.max(y, topY), Math.min(y + 1, endY)];
    if (to > from) addInRow(sums, y * width, width, sign * (to - from), topX + (from - topY) * slope, topX + (to - topY) * slope);
  }
}

/** The part of an edge in one row of pixels: `high` is its height there, signed. */
function addInRow(sums: Float32Array, start: number, width: number, high: number, xa: number, xb: number): void {
  const [left, right] = xa < xb ? [xa, xb] : [xb, xa];
  const [a, b] = [Math.min(width, Math.max(0, left)), Math.min(width, Math.max(0, right))];
  const first = Math.min(width - 1, Math.floor(a));
  const last = Math.min(width - 1, Math.max(first, Math.ceil(b) - 1));
  const put = (column: number, value: number): void => {
    if (column < width) sums[start + column] = (sums[start + column] ?? 0) + value;
  };
  if (first === last || b - a < 1e-9) {
    // Within one pixel: the mean distance from the edge to the pixel's right side.
    const inside = first + 1 - (a + b) / 2;
    put(first, high * inside);
    put(first + 1, high * (1 - inside));
    return;
  }
  const perPixel = high / (b - a);
  // How much of the row is inside is the sum of what stands in it so far: each pixel gets what its neighbour lacks.
  let [above, told] = [0, 0];
  for (let column = first; column <= last; column += 1) {
    const [from, to] = [Math.max(a, column), Math.min(b, column + 1)];
    const share = perPixel * (to - from);
    const area = above + share * (column + 1 - (from + to) / 2);
    put(column, area - told);
    [above, told] = [above + share, area];
  }
  put(last + 1, high - told);
}

/** Mixes the bits of a number: noise that is the same everywhere and every time. */
function noiseAt(i: number): number {
  let bits = Math.imul(i ^ 0x9e3779b9, 0x85ebca6b);
  bits = Math.imul(bits ^ (bits >>> 13), 0xc2b2ae35);
  return ((bits ^ (bits >>> 16)) >>> 0) / 2 ** 32;
}

/** A sample with its longer side at most so many pixels, never larger than it is. */
export function drawSample(sample: TraceSample, most: number): DrawnPicture {
  const scale = Math.min(1, most / Math.max(sample.width, sample.height));
  const [width, height] = [Math.max(1, Math.round(sample.width * scale)), Math.max(1, Math.round(sample.height * scale))];
  const { colored } = sample;
  if (colored !== undefined) return { width, height, data: painted(colored.ground, colored.shapes(), width, height, scale) };
  const ink = coverage(sample.outlines(), width, height, scale);
  const gray = new Uint8Array(width * height);
  const { grain = 0, shade = 0 } = sample.rough ?? {};
  for (let i = 0; i < gray.length; i += 1) {
    const across = (i % width) / width + Math.floor(i / width) / width;
    // Four throws of the dice are as good as the bell curve.
    const dice = grain === 0 ? 0 : noiseAt(4 * i) + noiseAt(4 * i + 1) + noiseAt(4 * i + 2) + noiseAt(4 * i + 3) - 2;
    const paper = 255 - (shade * across) / 2 - (grain > 0 ? 6 : 0);
    const dark = sample.rough === undefined ? 0 : 62;
    gray[i] = Math.round(Math.min(255, Math.max(0, paper + ((ink[i] ?? 0) * (dark - paper)) + 1.7 * grain * dice)));
  }
  return { width, height, data: gray };
}

/** Shape over shape, each by its share of every pixel. */
function painted(ground: Color, shapes: readonly ColoredShape[], width: number, height: number, scale: number): Uint8Array<ArrayBuffer> {
  const seen = new Float32Array(3 * width * height);
  for (let i = 0; i < seen.length; i += 1) seen[i] = ground[(i % 3) as 0 | 1 | 2];
  for (const { color, outlines } of shapes) {
    coverage(outlines, width, height, scale).forEach((share, i) => {
      if (share > 0) color.forEach((channel, k) => (seen[3 * i + k] = (seen[3 * i + k] ?? 0) * (1 - share) + channel * share));
    });
  }
  const data = new Uint8Array(4 * width * height).fill(255);
  seen.forEach((value, i) => (data[4 * Math.floor(i / 3) + (i % 3)] = Math.round(value)));
  return data;
}

/** A drawn picture as a canvas takes it. */
export function imageOf({ width, height, data }: Pick<DrawnPicture, "width" | "height"> & { readonly data: Uint8Array | Uint8ClampedArray }): ImageData {
  const image = new ImageData(width, height);
  if (data.length === image.data.length) image.data.set(data);
  else data.forEach((shade, i) => image.data.set([shade, shade, shade, 255], 4 * i));
  return image;
}
