// Pictures for traces, the same every time.

import type { ImageLike } from "expline";

import { random } from "./fit-data.ts";

/** A picture of four bytes a pixel that can be changed. */
export interface Drawn extends ImageLike {
  readonly data: Uint8ClampedArray;
}

/** Every pixel from its place: a shade, or red, green, blue and opacity. */
export function painted(width: number, height: number, paint: (x: number, y: number) => number | readonly [number, number, number, number]): Drawn {
  const data = new Uint8ClampedArray(4 * width * height);
  for (let y = 0, at = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1, at += 4) {
      const color = paint(x, y);
      data.set(typeof color === "number" ? [color, color, color, 255] : color, at);
    }
  }
  return { data, width, height };
}

/** What of a pixel lies inside a circle, nearly. */
export function inCircle(x: number, y: number, cx: number, cy: number, radius: number): number {
  return Math.min(1, Math.max(0, radius + 0.5 - Math.hypot(x + 0.5 - cx, y + 0.5 - cy)));
}

/** A black ring on white. */
export function ring(size: number): Drawn {
  const [middle, outer, inner] = [size / 2, size * 0.4, size * 0.2];
  return painted(size, size, (x, y) => 255 * (1 - inCircle(x, y, middle, middle, outer) + inCircle(x, y, middle, middle, inner)));
}

/** Discs on a grid, each of another size: `count` contours. */
export function discs(size: number, count: number): Drawn {
  const columns = Math.ceil(Math.sqrt(count));
  const step = size / columns;
  return painted(size, size, (x, y) => {
    const [column, row] = [Math.floor(x / step), Math.floor(y / step)];
    const i = row * columns + column;
    return i >= count ? 255 : 255 * (1 - inCircle(x, y, (column + 0.5) * step, (row + 0.5) * step, step * (0.2 + (0.2 * (i % 7)) / 7)));
  });
}

/** Every pixel another colour. */
export function photoNoise(width: number, height: number, seed: number): Drawn {
  const next = random(seed);
  return painted(width, height, () => [256 * next(), 256 * next(), 256 * next(), 255]);
}

/** Black pixels here and there. */
export function salt(width: number, height: number, share: number, seed: number): Drawn {
  const next = random(seed);
  return painted(width, height, () => (next() < share ? 0 : 255));
}

/** Stripes of four pixels along the longer side. */
export function stripes(width: number, height: number): Drawn {
  return painted(width, height, (x, y) => ((width > height ? x : y) % 8 < 4 ? 0 : 255));
}

/** One colour. */
export function filled(width: number, height: number, color: readonly [number, number, number, number]): Drawn {
  return painted(width, height, () => color);
}
