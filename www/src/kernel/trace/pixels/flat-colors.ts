import type { Pixels } from "../picture.ts";

/** Whether a picture is drawn in flat colours, of which ink on paper would show only some. */

/** Neighbours this near in every channel are of one colour; compression leaves as much between them. */
const near = 14;
/** Colours this far apart, squared, in red, green and blue, are two. */
const apart = 36 ** 2;
/** And this near they are one, as it was drawn; of gradients most lies between. */
const same = 18 ** 2;
/** Part of what is flat that is as near as that to one of the colours. */
const leastTrue = 0.85;
/** Part of what is flat that a colour has at least. */
const leastShare = 0.003;
/** Part of the picture that is flat at least; photographs have less. */
const leastFlat = 0.8;
/** Between the strongest and the weakest channel of what is not gray. */
const leastChroma = 48;
const mostColors = 16;
/** What is transparent. */
const opaque = 250;

type Color = readonly [red: number, green: number, blue: number];

interface Found {
  readonly color: Color;
  /** Pixels of this colour, and pixels that are like it. */
  own: number;
  like: number;
}

const squared = (a: Color, b: Color): number => (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2;

/** True of drawings in several colours; not of grays, a single ink on paper, photographs and gradients. */
export function hasFlatColors(pixels: Pixels): boolean {
  if (pixels.data.length === pixels.columns * pixels.rows) return false;
  const { bins, flat, clear, all } = flatPixels(pixels);
  if (flat < leastFlat * all) return false;
  const colors = colorsOf(bins).filter(({ like }) => like >= leastShare * flat);
  const count = colors.length + (clear >= leastShare * all ? 1 : 0);
  const exact = colors.reduce((sum, { own }) => sum + own, 0);
  const isColored = colors.some(({ color }) => Math.max(...color) - Math.min(...color) >= leastChroma);
  return isColored && count >= 3 && count <= mostColors && exact >= leastTrue * flat;
}

/** The most frequent colours, and those that are none of them. */
function colorsOf(bins: ReadonlyMap<number, number>): readonly Found[] {
  const found: Found[] = [];
  for (const [bin, count] of [...bins].sort(([, a], [, b]) => b - a)) {
    const color: Color = [(bin >> 10) * 8 + 4, ((bin >> 5) & 31) * 8 + 4, (bin & 31) * 8 + 4];
    const known = found.find((each) => squared(each.color, color) < apart);
    if (known === undefined) found.push({ color, own: count, like: count });
    else {
      known.like += count;
      if (squared(known.color, color) < same) known.own += count;
    }
  }
  return found;
}

interface FlatPixels {
  /** Pixels that are like their neighbours to the right and below, by colour, five bits a channel. */
  readonly bins: ReadonlyMap<number, number>;
  readonly flat: number;
  /** Pixels with nothing in them. */
  readonly clear: number;
  /** Pixels with a colour that covers what is behind. */
  readonly all: number;
}

function flatPixels({ columns, rows, data }: Pixels): FlatPixels {
  const bins = new Map<number, number>();
  let [flat, clear, all] = [0, 0, 0];
  const differs = (i: number, j: number): boolean => [0, 1, 2].some((k) => Math.abs((data[i + k] ?? 0) - (data[j + k] ?? 0)) > near) || (data[j + 3] ?? 0) < opaque;
  for (let y = 0; y + 1 < rows; y += 1) {
    for (let x = 0; x + 1 < columns; x += 1) {
      const i = 4 * (y * columns + x);
      if (data[i + 3] === 0) clear += 1;
      if ((data[i + 3] ?? 0) < opaque) continue;
      all += 1;
      if (differs(i, i + 4) || differs(i, i + 4 * columns)) continue;
      flat += 1;
      const bin = ((data[i] ?? 0) >> 3 << 10) | ((data[i + 1] ?? 0) >> 3 << 5) | ((data[i + 2] ?? 0) >> 3);
      bins.set(bin, (bins.get(bin) ?? 0) + 1);
    }
  }
  return { bins, flat, clear, all };
}
