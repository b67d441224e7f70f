/**
 * The samples: drawn by formulas with fixed seeds, so that there is no licence to track and, where a sample sets out
 * to be a known shape, the truth is known too. Circle samples put point k at the angle 360°·k/M from 3 o'clock,
 * clockwise on the screen (y points down).
 */
import type { Contour, ControlPoint, CurveDocument, Kind, Space } from "../document.ts";

/** The shape that a sample is exactly, for measuring the distance of the drawing from it. */
export type SampleTruth =
  | { readonly shape: "ellipse"; readonly center: readonly [number, number]; readonly radii: readonly [number, number]; readonly rotation: number };

export interface CurveSample {
  readonly id: string;
  readonly title: string;
  /** One sentence: what to try. */
  readonly note: string;
  readonly curve: CurveDocument;
  /** Overlays that are part of the lesson, beyond the ordinary ones. */
  readonly overlays: readonly ("bezier" | "comb" | "polygon")[];
  readonly truth?: SampleTruth;
}

type Pair = readonly [number, number];

const center: Pair = [400, 300];

function knot(x: number, y: number, kind: Kind, arriving: Pair, leaving: Pair): ControlPoint {
  // + 0: a formula's −0 would not survive being written down.
  return { x: x + 0, y: y + 0, kind, in: { dx: arriving[0] + 0, dy: arriving[1] + 0 }, out: { dx: leaving[0] + 0, dy: leaving[1] + 0 } };
}

/** A point whose two handles are opposite: `tangent` is dr/dt, and handles are drawn at a third of it. */
function symmetric(at: Pair, tangent: Pair): ControlPoint {
  const [dx, dy] = [tangent[0] / 3, tangent[1] / 3];
  return knot(at[0], at[1], "symmetric", [-dx, -dy], [dx, dy]);
}

function document(sample: string, space: Space, omega: number | "auto", contours: readonly Contour[]): CurveDocument {
  return { space, omega, level: 0, contours, sample };
}

function contour(points: readonly ControlPoint[], closed = true): Contour {
  return { family: "hermite", closed, points, support: 1 };
}

/** `count` points of r(θ) at `from + k·step`; a closed curve's frequency is then `step`. */
function along(count: number, from: number, step: number, at: (angle: number) => Pair, slope: (angle: number) => Pair): ControlPoint[] {
  return Array.from({ length: count }, (_, k) => {
    const angle = from + k * step;
    const [dx, dy] = slope(angle);
    return symmetric(at(angle), [dx * step, dy * step]);
  });
}

function ellipsePoints(count: number, radii: Pair, rotation: number): ControlPoint[] {
  const [cos, sin] = [Math.cos(rotation), Math.sin(rotation)];
  const turn = (x: number, y: number): Pair => [x * cos - y * sin, x * sin + y * cos];
  return along(
    count,
    0,
    (2 * Math.PI) / count,
    (angle) => {
      const [x, y] = turn(radii[0] * Math.cos(angle), radii[1] * Math.sin(angle));
      return [center[0] + x, center[1] + y];
    },
    (angle) => turn(-radii[0] * Math.sin(angle), radii[1] * Math.cos(angle)),
  );
}

function ellipseSample(id: string, title: string, note: string, count: number, radii: Pair, rotation: number): CurveSample {
  return {
    id,
    title,
    note,
    curve: document(id, "trigonometric", "auto", [contour(ellipsePoints(count, radii, rotation))]),
    overlays: ["bezier"],
    truth: { shape: "ellipse", center, radii, rotation },
  };
}

/** Two arches of a rolling circle. The tangent vanishes where they meet, which is the cusp, and it is exact. */
function cycloid(): CurveSample {
  const radius = 48;
  const points = along(
    9,
    0,
    Math.PI / 2,
    (angle) => [center[0] + radius * (angle - 2 * Math.PI - Math.sin(angle)), 348 - radius * (1 - Math.cos(angle))],
    (angle) => [radius * (1 - Math.cos(angle)), -radius * Math.sin(angle)],
  ).map((point, k) => {
    if (k % 4 !== 0) return point;
    // 1 − cos of a multiple of 2π is 0; the rounding of the formula must not leave a stray handle.
    return knot(point.x, 348, "cusp", [0, 0], [0, 0]);
  });
  return {
    id: "cycloid",
    title: "Cycloid",
    note: "Two arches traced by a rolling circle, exact right into the cusp between them.",
    curve: document("cycloid", "trigonometric", Math.PI / 2, [contour(points, false)]),
    overlays: [],
  };
}

function sine(): CurveSample {
  const [stretch, height] = [48, 110];
  const points = along(
    9,
    0,
    Math.PI / 2,
    (angle) => [center[0] + stretch * (angle - 2 * Math.PI), center[1] - height * Math.sin(angle)],
    (angle) => [stretch, -height * Math.cos(angle)],
  );
  return {
    id: "sine",
    title: "Sine",
    note: "Two periods of an exact sine wave. Move a point and only its two segments change.",
    curve: document("sine", "trigonometric", Math.PI / 2, [contour(points, false)]),
    overlays: [],
  };
}

function hyperbola(): CurveSample {
  const [a, b, step] = [130, 90, 0.8];
  const points = along(
    5,
    -2 * step,
    step,
    (u) => [160 + a * Math.cosh(u), center[1] + b * Math.sinh(u)],
    (u) => [a * Math.sinh(u), b * Math.cosh(u)],
  );
  return {
    id: "hyperbola",
    title: "Hyperbola",
    note: "One exact branch, in hyperbolic space. Switch to trigonometric to see what changes.",
    curve: document("hyperbola", "hyperbolic", step, [contour(points, false)]),
    overlays: [],
  };
}

function heart(): CurveSample {
  const points = [
    knot(400, 226, "cusp", [-10, -38], [10, -38]),
    knot(476, 160, "symmetric", [-34, 0], [34, 0]),
    knot(544, 236, "smooth", [0, -32], [0, 50]),
    knot(400, 448, "cusp", [58, -64], [-58, -64]),
    knot(256, 236, "smooth", [0, 50], [0, -32]),
    knot(324, 160, "symmetric", [-34, 0], [34, 0]),
  ];
  return {
    id: "heart",
    title: "Heart",
    note: "Two cusps. Double-press a point to switch it between cusp and smooth.",
    curve: document("heart", "trigonometric", "auto", [contour(points)]),
    overlays: [],
  };
}

/** One straight side or quarter arc of an outline: where it ends, and for an arc the tangents' directions. */
type Side = { readonly to: Pair } | { readonly to: Pair; readonly arc: readonly [Pair, Pair] };

/** An outline of straight sides and quarter arcs, each segment with the frequency that makes it exact. */
function outline(start: Pair, sides: readonly Side[]): Contour {
  const handles = sides.map((side, k) => {
    const from = k === 0 ? start : (sides[k - 1]?.to ?? start);
    const chord: Pair = [(side.to[0] - from[0]) / 3, (side.to[1] - from[1]) / 3];
    if (!("arc" in side)) return { leaving: chord, arriving: chord, omega: 0 };
    const third = (direction: Pair): Pair => [(direction[0] * Math.PI) / 6, (direction[1] * Math.PI) / 6];
    return { leaving: third(side.arc[0]), arriving: third(side.arc[1]), omega: Math.PI / 2 };
  });
  const points = sides.map((_, k) => {
    const at = k === 0 ? start : (sides[k - 1]?.to ?? start);
    const before = handles.at(k - 1)?.arriving ?? [0, 0];
    const after = handles[k]?.leaving ?? [0, 0];
    const straight = Math.abs(before[0] * after[1] - before[1] * after[0]) < 1e-9 && before[0] * after[0] + before[1] * after[1] > 0;
    const equal = before[0] === after[0] && before[1] === after[1];
    return knot(at[0], at[1], straight ? (equal ? "symmetric" : "smooth") : "cusp", [-before[0], -before[1]], after);
  });
  return { ...contour(points), omega: handles.map((handle) => handle.omega) };
}

function glyph(): CurveSample {
  const outer = outline([280, 140], [
    { to: [424, 140] },
    { to: [516, 232], arc: [[92, 0], [0, 92]] },
    { to: [424, 324], arc: [[0, 92], [-92, 0]] },
    { to: [528, 460] },
    { to: [448, 460] },
    { to: [344, 324] },
    { to: [344, 460] },
    { to: [280, 460] },
    { to: [280, 140] },
  ]);
  const counter = outline([344, 196], [
    { to: [344, 268] },
    { to: [424, 268] },
    { to: [460, 232], arc: [[36, 0], [0, -36]] },
    { to: [424, 196], arc: [[0, -36], [-36, 0]] },
    { to: [344, 196] },
  ]);
  return {
    id: "glyph",
    title: "Letter R",
    note: "Straight sides and exact quarter circles in one outline. The comb shows where curvature jumps.",
    curve: document("glyph", "trigonometric", "auto", [outer, counter]),
    overlays: ["comb"],
  };
}

/** `count` points of r(θ) that the curve goes through, without tangents. */
function through(count: number, radius: (angle: number) => number): Contour {
  const points = Array.from({ length: count }, (_, k) => {
    const angle = (2 * Math.PI * k) / count;
    return knot(center[0] + radius(angle) * Math.cos(angle), center[1] + radius(angle) * Math.sin(angle), "smooth", [0, 0], [0, 0]);
  });
  return { family: "interpolating", closed: true, points, support: 2 };
}

function blob16(): CurveSample {
  const radius = (angle: number): number => 158 + 26 * Math.cos(3 * angle + 0.6) + 18 * Math.sin(2 * angle) + 9 * Math.cos(5 * angle);
  return {
    id: "blob-16",
    title: "Blob, 16 points",
    note: "Every point lies on the curve. Drag one: only the highlighted two segments on each side change.",
    curve: document("blob-16", "trigonometric", "auto", [through(16, radius)]),
    overlays: [],
  };
}

function net64(): CurveSample {
  return {
    id: "net-64",
    title: "Net, 64 points",
    note: "Sixty-four points on the curve. Drag any of them and watch the frame time below.",
    curve: document("net-64", "trigonometric", "auto", [through(64, (angle) => 190 + 34 * Math.sin(6 * angle))]),
    overlays: ["comb"],
  };
}

/** In the order of the menu; the first one is where a new visitor lands. */
export const curveSamples: readonly CurveSample[] = [
  ellipseSample("circle-2", "Circle, 2 points", "A perfect circle from two points. Drag a point: still an exact ellipse. Turn a handle: a teardrop.", 2, [160, 160], 0),
  ellipseSample("ellipse", "Ellipse", "An exact rotated ellipse from four points. It stays smooth as you drag.", 4, [220, 120], -Math.PI / 7),
  ellipseSample("circle-8", "Circle, 8 points", "Insert or delete a point: the circle barely changes.", 8, [160, 160], 0),
  cycloid(),
  sine(),
  hyperbola(),
  heart(),
  blob16(),
  glyph(),
  net64(),
];

export const landingSample = "circle-2";

export function curveSample(id: string): CurveSample | undefined {
  return curveSamples.find((sample) => sample.id === id);
}
