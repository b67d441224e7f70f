/**
 * Colours of JPEG pictures: brightness has a sample for each pixel, the two colour differences often only one for two
 * or four.
 */

/** How many pixels a sample stands for. */
export interface Sampling {
  readonly across: number;
  readonly down: number;
}

/**
 * Makes red, green and blue, in place, of brightness and two differences in three of each four bytes, where a sample of
 * the differences is repeated for the pixels that it stands for. Between samples they are interpolated, as other
 * programs do: repeated, colours have stairs of two pixels.
 */
export function colorsOf(data: Uint8Array, width: number, height: number, sampling: readonly Sampling[]): void {
  const [blueness, redness] = [1, 2].map((channel) => differences(data, width, height, channel, sampling[channel] ?? { across: 1, down: 1 }));
  const rounded = new Uint8ClampedArray(data.buffer, data.byteOffset, data.length);
  for (let row = 0, at = 0; row < height; row += 1) {
    const [blues, reds] = [blueness?.(row), redness?.(row)];
    for (let column = 0; column < width; column += 1, at += 4) {
      const brightness = data[at] ?? 0;
      const [blue, red] = [(blues?.[column] ?? 0) - 128, (reds?.[column] ?? 0) - 128];
      rounded[at] = brightness + 1.402 * red;
      rounded[at + 1] = brightness - 0.344136286 * blue - 0.714136286 * red;
      rounded[at + 2] = brightness + 1.772 * blue;
    }
  }
}

/** The samples of a channel, and from them its values in a row of pixels. */
function differences(data: Uint8Array, width: number, height: number, channel: number, { across, down }: Sampling): (row: number) => Float32Array {
  const [columns, rows] = [Math.ceil(width / across), Math.ceil(height / down)];
  const samples = new Uint8Array(columns * rows);
  for (let row = 0, i = 0; row < rows; row += 1) {
    const start = 4 * Math.ceil(row * down) * width + channel;
    for (let column = 0; column < columns; column += 1, i += 1) samples[i] = data[start + 4 * Math.ceil(column * across)] ?? 0;
  }
  const [beside, above] = [neighbours(width, across, columns), neighbours(height, down, rows)];
  const line = new Float32Array(columns);
  const values = new Float32Array(width);
  return (row) => {
    const [near, far] = [columns * (above.near[row] ?? 0), columns * (above.far[row] ?? 0)];
    for (let i = 0; i < columns; i += 1) line[i] = between(samples[near + i], samples[far + i]);
    for (let i = 0; i < width; i += 1) values[i] = between(line[beside.near[i] ?? 0], line[beside.far[i] ?? 0]);
    return values;
  };
}

/** Of two pixels that share a sample each is a quarter of the way to the next one from its middle. */
const between = (near = 0, far = 0): number => 0.75 * near + 0.25 * far;

/**
 * For each of so many pixels the sample that it belongs to, and the one on its other side: the same where there is
 * none, or none between.
 */
function neighbours(pixels: number, shared: number, samples: number): { readonly near: Int32Array; readonly far: Int32Array } {
  const near = Int32Array.from({ length: pixels }, (_, i) => Math.min(Math.floor(i / shared), samples - 1));
  if (shared !== 2) return { near, far: near };
  return { near, far: near.map((sample, i) => Math.max(0, Math.min(samples - 1, sample + (i % 2 === 0 ? -1 : 1)))) };
}
