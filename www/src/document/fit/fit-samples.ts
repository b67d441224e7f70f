/**
 * Samples for Fit: outlines by formulas, with noise of a fixed seed on top, so that the truth is known. Each comes with
 * its own good settings.
 */
import { fitDefaults, type FitDocument, type Pair } from "./fit.ts";
import { coastline } from "./fit-coast.ts";
import { signature } from "./fit-signature.ts";

export interface FitSample {
  readonly id: string;
  readonly title: string;
  /** One sentence: what to try. */
  readonly note: string;
  readonly settings: Omit<FitDocument, "data">;
  /** The strokes as they would be without noise. */
  readonly truth: () => readonly (readonly Pair[])[];
}

const center: Pair = [400, 300];

/** Numbers from 0 to 1 that look random and are always the same. */
function randomFrom(seed: number): () => number {
  let state = (seed + 1) * 0x9e3779b9;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

/** Two normal numbers at once, by Box and Muller. */
function normalPair(random: () => number): Pair {
  const radius = Math.sqrt(-2 * Math.log(1 - random()));
  const angle = 2 * Math.PI * random();
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
}

/** The sample's points with noise of a standard deviation in each coordinate, as data and the beginnings of strokes. */
export function samplePoints({ truth }: FitSample, noise: number, seed: number): Pick<FitDocument, "data" | "starts"> {
  const random = randomFrom(seed);
  const data: Pair[] = [];
  const starts: number[] = [];
  for (const stroke of truth()) {
    if (data.length > 0) starts.push(data.length);
    for (const [x, y] of stroke) {
      const [dx, dy] = normalPair(random);
      data.push([rounded(x + noise * dx), rounded(y + noise * dy)]);
    }
  }
  return { data, starts };
}

/** A thousandth of a pixel: what is shared and saved stays short. */
const rounded = (value: number): number => Math.round(value * 1000) / 1000 + 0;

/** Points evenly along a closed polygon. */
function alongPolygon(corners: readonly Pair[], count: number): Pair[] {
  const sides = corners.map((corner, i) => {
    const next = corners[(i + 1) % corners.length] ?? corner;
    return { corner, dx: next[0] - corner[0], dy: next[1] - corner[1], length: Math.hypot(next[0] - corner[0], next[1] - corner[1]) };
  });
  const total = sides.reduce((sum, { length }) => sum + length, 0);
  return Array.from({ length: count }, (_, i) => {
    let left = (total * i) / count;
    for (const { corner, dx, dy, length } of sides) {
      if (left <= length) return [corner[0] + (dx * left) / length, corner[1] + (dy * left) / length];
      left -= length;
    }
    return corners[0] ?? center;
  });
}

/** The corners of a star, first tip up. */
function starCorners([x, y]: Pair, tips: number, outer: number, inner: number): Pair[] {
  return Array.from({ length: 2 * tips }, (_, i) => {
    const angle = (Math.PI * i) / tips - Math.PI / 2;
    const radius = i % 2 === 0 ? outer : inner;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

function circle(radius: number, count: number): Pair[] {
  return Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)];
  });
}

/** A rectangle whose corners are quarter circles: evenly along straight sides and arcs. */
function roundedRectangle(halfWidth: number, halfHeight: number, radius: number, count: number): Pair[] {
  const [straightX, straightY, arc] = [2 * (halfWidth - radius), 2 * (halfHeight - radius), (Math.PI / 2) * radius];
  const pieces = [straightX, arc, straightY, arc, straightX, arc, straightY, arc];
  const total = pieces.reduce((sum, length) => sum + length, 0);
  // Side by side, clockwise on the screen: where each begins, and which way it runs.
  const [left, right, top, bottom] = [-halfWidth + radius, halfWidth - radius, -halfHeight + radius, halfHeight - radius];
  const sides: readonly (readonly [number, number, number, number])[] = [
    [left, -halfHeight, 1, 0],
    [halfWidth, top, 0, 1],
    [right, halfHeight, -1, 0],
    [-halfWidth, bottom, 0, -1],
  ];
  const centers: readonly Pair[] = [[right, top], [right, bottom], [left, bottom], [left, top]];
  return Array.from({ length: count }, (_, i) => {
    let rest = (total * i) / count;
    let piece = 0;
    while (piece < 7 && rest > (pieces[piece] ?? 0)) {
      rest -= pieces[piece] ?? 0;
      piece += 1;
    }
    const side = piece >> 1;
    const [sx = 0, sy = 0, dx = 0, dy = 0] = sides[side] ?? [];
    if (piece % 2 === 0) return [center[0] + sx + dx * rest, center[1] + sy + dy * rest];
    const [cx, cy] = centers[side] ?? center;
    const angle = -Math.PI / 2 + (side * Math.PI) / 2 + rest / radius;
    return [center[0] + cx + radius * Math.cos(angle), center[1] + cy + radius * Math.sin(angle)];
  });
}

function sine(count: number): Pair[] {
  return Array.from({ length: count }, (_, i) => {
    const x = 120 + (560 * i) / (count - 1);
    return [x, 300 + 110 * Math.sin((2 * Math.PI * (x - 120)) / 280)];
  });
}

function sample(id: string, title: string, note: string, settings: Partial<FitDocument>, truth: FitSample["truth"]): FitSample {
  return { id, title, note, settings: { ...fitDefaults, sample: id, ...settings }, truth };
}

export const fitSamples: readonly FitSample[] = [
  sample("fit-star", "Noisy star", "Drag Smoothing: knots disappear, and corners last longest.", { noise: 1.5, seed: 5, closing: "closed" },
    () => [alongPolygon(starCorners(center, 5, 180, 75), 300)]),
  sample("fit-circle", "Noisy circle", "Two hundred points become a few smooth knots.", { noise: 2, seed: 2, closing: "closed", model: "cubic" },
    () => [circle(160, 200)]),
  sample("fit-roundrect", "Rounded rectangle", "Straight sides and round corners together: a job for the hybrid model.", {
    noise: 1,
    seed: 3,
    closing: "closed",
    smoothing: 20,
  },
    () => [roundedRectangle(220, 140, 60, 360)]),
  sample("fit-sine", "Noisy sine", "An open curve with free ends.", { noise: 3, seed: 4, closing: "open", model: "cubic" }, () => [sine(240)]),
  sample("fit-signature", "Signature", "Nine hundred handwritten points become a few dozen knots.", { noise: 0.5, seed: 6, closing: "open", smoothing: 18 },
    () => signature()),
  sample("fit-coast", "Coastline", "Four thousand points. The chart shows where detail ends.", { noise: 0, seed: 7, closing: "closed", smoothing: 45 },
    () => [coastline(4000)]),
];

export function fitSample(id: string): FitSample | undefined {
  return fitSamples.find((each) => each.id === id);
}
