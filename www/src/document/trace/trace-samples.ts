/** Pictures that are drawn by code: what they show is known exactly, so that what is found in them can be judged. */

import type { TraceSettings } from "./trace.ts";

type Place = readonly [number, number];

/**
 * A closed outline as a polygon so fine that its corners cannot be seen: x and y in turn. Holes run the other way
 * round.
 */
export type Outline = Float64Array;

/** Red, green and blue, 0 … 255. */
export type Color = readonly [number, number, number];

export interface ColoredShape {
  readonly color: Color;
  readonly outlines: readonly Outline[];
}

export interface TraceSample {
  readonly id: string;
  readonly title: string;
  /** What it shows, in a sentence. */
  readonly note: string;
  readonly width: number;
  readonly height: number;
  readonly settings: Partial<TraceSettings>;
  /** In pixels of the picture. */
  outlines(): readonly Outline[];
  /** Shapes in colours, each over the ones before, on a ground of the first; absent: the outlines in black on white. */
  readonly colored?: { readonly ground: Color; shapes(): readonly ColoredShape[] };
  /** Uneven paper and grain; absent: white paper, black ink, exact coverage. */
  readonly rough?: { readonly grain: number; readonly shade: number };
}

/** Sides of a polygon that stands for a circle: within 2e-4 pixels of one of radius 200. */
const sides = 2400;

function around(count: number, at: (turn: number) => Place): Outline {
  const outline = new Float64Array(2 * count);
  for (let i = 0; i < count; i += 1) outline.set(at(i / count), 2 * i);
  return outline;
}

const circle = (x: number, y: number, radius: number, count = sides): Outline =>
  around(count, (turn) => [x + radius * Math.cos(2 * Math.PI * turn), y + radius * Math.sin(2 * Math.PI * turn)]);

const polygon = (...places: readonly Place[]): Outline => Float64Array.from(places.flat());

/** The same outline, run through backwards. */
function reversed(outline: Outline): Outline {
  return outline.map((_, i) => outline[outline.length - 2 - i + 2 * (i % 2)] ?? 0);
}

/** A star with its first tip up, turned by an angle. */
function star(x: number, y: number, outer: number, inner: number, tips = 5, angle = 0): Outline {
  return around(2 * tips, (turn) => {
    const radius = Math.round(turn * 2 * tips) % 2 === 0 ? outer : inner;
    const at = 2 * Math.PI * turn - Math.PI / 2 + angle;
    return [x + radius * Math.cos(at), y + radius * Math.sin(at)];
  });
}

/** A square with round corners: straight sides and quarter circles. */
function roundSquare(x: number, y: number, half: number, radius: number, angle: number, count = 240): Outline {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const quarter = count / 4;
  return around(count, (turn) => {
    const step = Math.round(turn * count);
    const side = Math.floor(step / quarter);
    const at = (Math.PI / 2) * (side + (step % quarter) / (quarter - 1));
    const [signX, signY] = [side === 0 || side === 3 ? 1 : -1, side < 2 ? 1 : -1];
    const [dx, dy] = [signX * (half - radius) + radius * Math.cos(at), signY * (half - radius) + radius * Math.sin(at)];
    return [x + dx * cos - dy * sin, y + dx * sin + dy * cos];
  });
}

/** A ring, a dot in it, and a bolt with sharp corners. */
function logo(size: number): readonly Outline[] {
  const s = size / 512;
  const bolt: readonly Place[] = [[282, 118], [188, 276], [248, 276], [224, 394], [326, 226], [262, 226]];
  return [
    circle(256 * s, 256 * s, 216 * s),
    reversed(circle(256 * s, 256 * s, 168 * s)),
    polygon(...bolt.map(([x, y]): Place => [x * s, y * s])),
    circle(352 * s, 318 * s, 22 * s),
  ];
}

/** Points of a cubic from one place to another, its end left out. */
function cubic(from: Place, a: Place, b: Place, to: Place, count = 400): Place[] {
  return Array.from({ length: count }, (_, i): Place => {
    const t = i / count;
    const [u, v] = [1 - t, t];
    const mix = (k: 0 | 1): number => u * u * u * from[k] + 3 * u * u * v * a[k] + 3 * u * v * v * b[k] + v * v * v * to[k];
    return [mix(0), mix(1)];
  });
}

/** A leaf between two cusps, with its vein cut out, and a stem. */
function leaf(): readonly Outline[] {
  const [tip, base]: [Place, Place] = [[420, 80], [150, 350]];
  const blade = [...cubic(tip, [452, 260], [330, 396], base), ...cubic(base, [92, 188], [236, 52], tip)];
  const vein = [...cubic([360, 146], [300, 190], [244, 236], [188, 312], 200), ...cubic([188, 312], [236, 226], [292, 180], [360, 146], 200)];
  const stem = [
    ...cubic([152, 362], [122, 386], [98, 416], [78, 460], 200),
    ...cubic([78, 460], [96, 466], [96, 466], [98, 466], 40),
    ...cubic([98, 466], [118, 424], [138, 396], [164, 370], 200),
  ];
  return [polygon(...blade), reversed(polygon(...vein)), polygon(...stem)].map(withPositiveArea).map((outline, i) => (i === 1 ? reversed(outline) : outline));
}

function withPositiveArea(outline: Outline): Outline {
  let area = 0;
  for (let i = 0; i < outline.length; i += 2) {
    const j = (i + 2) % outline.length;
    area += (outline[i] ?? 0) * (outline[j + 1] ?? 0) - (outline[j] ?? 0) * (outline[i + 1] ?? 0);
  }
  return area < 0 ? reversed(outline) : outline;
}

/** A line drawn by hand: its breadth swells and its way trembles. */
function stroke(way: readonly Place[], breadth: number, seed: number): Outline {
  const left: Place[] = [];
  const right: Place[] = [];
  way.forEach(([x, y], i) => {
    const [before, after] = [way[Math.max(0, i - 1)] ?? [x, y], way[Math.min(way.length - 1, i + 1)] ?? [x, y]];
    const size = Math.hypot(after[0] - before[0], after[1] - before[1]) || 1;
    const [nx, ny] = [-(after[1] - before[1]) / size, (after[0] - before[0]) / size];
    const t = i / (way.length - 1);
    const half = (breadth / 2) * (0.45 + 0.55 * Math.sin(Math.PI * t) ** 0.5) * (1 + 0.12 * Math.sin(9 * t + seed));
    const tremble = 0.8 * Math.sin(23 * t + 2 * seed) + 0.5 * Math.sin(41 * t + seed);
    left.push([x + nx * (tremble + half), y + ny * (tremble + half)]);
    right.push([x + nx * (tremble - half), y + ny * (tremble - half)]);
  });
  return withPositiveArea(polygon(...left, ...right.reverse()));
}

/** A cup, its handle and its steam. */
function sketch(): readonly Outline[] {
  const whole = (...parts: readonly Place[][]): Place[] => parts.flat();
  return [
    stroke(whole(cubic([150, 190], [150, 300], [176, 352], [236, 356], 90), cubic([236, 356], [300, 358], [330, 300], [334, 186], 90)), 8, 1),
    stroke(whole(cubic([142, 188], [190, 168], [300, 166], [344, 184], 90), cubic([344, 184], [300, 206], [190, 208], [146, 192], 90)), 6, 2),
    stroke(whole(cubic([330, 216], [400, 200], [404, 290], [318, 296], 90)), 7, 3),
    stroke(whole(cubic([206, 150], [184, 120], [232, 104], [206, 66], 90)), 5, 4),
    stroke(whole(cubic([262, 146], [240, 116], [288, 100], [262, 58], 90)), 5, 5),
    stroke(whole(cubic([112, 384], [200, 396], [320, 392], [404, 378], 90)), 5, 6),
  ];
}

/** A beach in seven colours: sky, sun, hills, sea, sand, and a boat with its sail. */
function postcard(): readonly ColoredShape[] {
  const hill = (from: Place, a: Place, b: Place, to: Place): Outline => polygon(...cubic(from, a, b, to), to, [to[0], 330], [from[0], 330]);
  const sand = polygon(...cubic([0, 452], [150, 372], [330, 470], [512, 404]), [512, 404], [512, 520], [0, 520]);
  return [
    { color: [255, 183, 77], outlines: [circle(352, 150, 64)] },
    { color: [46, 125, 90], outlines: [hill([-20, 330], [90, 170], [190, 170], [330, 330])] },
    { color: [27, 94, 80], outlines: [hill([180, 330], [290, 200], [420, 230], [560, 330])] },
    { color: [25, 84, 140], outlines: [polygon([-2, 310], [514, 310], [514, 514], [-2, 514])] },
    { color: [240, 214, 166], outlines: [sand] },
    { color: [255, 255, 255], outlines: [polygon(...cubic([236, 196], [296, 250], [304, 300], [300, 342]), [300, 342], [236, 342])] },
    { color: [176, 42, 48], outlines: [polygon(
      [160, 350],
      [332, 350],
      ...cubic([332, 350], [320, 388], [300, 396], [276, 396], 120),
      ...cubic([216, 396], [190, 396], [172, 380], [160, 350], 120),
    )] },
  ];
}

/** A ribbon along a way: a line of one breadth. */
function line(breadth: number, ...way: readonly Place[]): Outline {
  const sides = (sign: 1 | -1): Place[] => way.map(([x, y], i): Place => {
    const [before, after] = [way[Math.max(0, i - 1)] ?? [x, y], way[Math.min(way.length - 1, i + 1)] ?? [x, y]];
    const size = Math.hypot(after[0] - before[0], after[1] - before[1]) || 1;
    const half = (sign * breadth) / 2;
    return [x - ((after[1] - before[1]) / size) * half, y + ((after[0] - before[0]) / size) * half];
  });
  return withPositiveArea(polygon(...sides(1), ...sides(-1).reverse()));
}

/** A balloon, drawn with one pen. */
function balloon(): readonly Outline[] {
  const pen = 9;
  const ring = (x: number, y: number, radius: number): Outline[] => [circle(x, y, radius + pen / 2), reversed(circle(x, y, radius - pen / 2))];
  return [
    ...ring(256, 196, 140),
    line(pen, ...cubic([256, 56], [166, 120], [166, 272], [256, 336], 200), [256, 336]),
    line(pen, ...cubic([256, 56], [346, 120], [346, 272], [256, 336], 200), [256, 336]),
    line(pen, [210, 360], [222, 432]), line(pen, [302, 360], [290, 432]),
    line(pen, [214, 436], [298, 436]), line(pen, [218, 436], [224, 480]), line(pen, [294, 436], [288, 480]), line(pen, [222, 480], [290, 480]),
    line(pen, ...cubic([40, 430], [70, 400], [100, 400], [130, 430], 120), [130, 430]),
    line(pen, ...cubic([380, 452], [410, 422], [440, 422], [470, 452], 120), [470, 452]),
  ];
}

const grid = 24;

/** Rows of small shapes in waves of size: 576 of them, a third with a hole. */
function many(): readonly Outline[] {
  const step = 2048 / grid;
  const shapes: Outline[] = [];
  for (let row = 0; row < grid; row += 1) {
    for (let column = 0; column < grid; column += 1) {
      const [x, y] = [(column + 0.5) * step, (row + 0.5) * step];
      const wave = Math.sin(0.55 * column + 0.3 * row) + Math.cos(0.4 * row - 0.2 * column);
      const radius = step * (0.28 + 0.07 * wave);
      const angle = 0.11 * (3 * column + 5 * row);
      switch ((column + 2 * row) % 3) {
        case 0:
          shapes.push(circle(x, y, radius, 240), reversed(circle(x, y, 0.55 * radius, 240)));
          break;
        case 1:
          shapes.push(star(x, y, 1.15 * radius, 0.5 * radius, 5, angle));
          break;
        default:
          shapes.push(roundSquare(x, y, 0.9 * radius, 0.35 * radius, angle));
      }
    }
  }
  return shapes;
}

/** What a name that is none gives way to. */
export const firstTraceSample: TraceSample = {
  id: "trace-logo",
  title: "Logo",
  note: "Rings stay circles, the bolt keeps its corners.",
  width: 512,
  height: 512,
  settings: {},
  outlines: () => logo(512),
};

export const traceSamples: readonly TraceSample[] = [
  firstTraceSample,
  {
    id: "trace-star",
    title: "Star",
    note: "Ten corners, ten straight sides, nothing else.",
    width: 512,
    height: 512,
    settings: {},
    outlines: () => [star(256, 256, 200, 80)],
  },
  {
    id: "trace-disc",
    title: "Disc",
    note: "A circle of radius 160, traced as an exact arc rather than a polygon.",
    width: 512,
    height: 512,
    settings: {},
    outlines: () => [circle(256, 256, 160)],
  },
  { id: "trace-leaf", title: "Leaf", note: "Two cusps, a vein and a stem.", width: 512, height: 512, settings: {}, outlines: leaf },
  {
    id: "trace-small",
    title: "Small logo",
    note: "The same logo at 48 pixels: the grey edge pixels carry the detail.",
    width: 48,
    height: 48,
    settings: { speckle: 2 },
    outlines: () => logo(48),
  },
  {
    id: "trace-sketch",
    title: "Sketch",
    note: "Pencil on uneven, grainy paper.",
    width: 512,
    height: 440,
    settings: { detail: 55, speckle: 60 },
    outlines: sketch,
    rough: { grain: 9, shade: 52 },
  },
  {
    id: "trace-postcard",
    title: "Postcard",
    note: "Flat colours as stacked layers without gaps.",
    width: 512,
    height: 512,
    settings: { colors: 10 },
    outlines: () => postcard().flatMap(({ outlines }) => outlines),
    colored: { ground: [144, 205, 232], shapes: postcard },
  },
  {
    id: "trace-lines",
    title: "Balloon",
    note: "Lines of even width come back as strokes.",
    width: 512,
    height: 512,
    settings: { mode: "lines" },
    outlines: balloon,
  },
  {
    id: "trace-big",
    title: "Sheet",
    note: "576 shapes in 2048 × 2048 pixels. Watch the progress, or cancel it.",
    width: 2048,
    height: 2048,
    settings: {},
    outlines: many,
  },
];

export function traceSample(id: string): TraceSample | undefined {
  return traceSamples.find((sample) => sample.id === id);
}
