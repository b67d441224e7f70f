import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { HermiteCurve } from "expline/slim";
import { movePoints } from "../src/document/curve/commands.ts";
import type { Contour, ControlPoint, CurveDocument } from "../src/document/document.ts";
import { initialState } from "../src/editor/initial-state.ts";
import { curveOf, hermiteOf } from "../src/kernel/curve/curve-cache.ts";
import { bezierGhost } from "../src/kernel/curve/overlays/bezier-ghost.ts";
import { healed } from "../src/kernel/curve/points/contours.ts";
import { boundsOf } from "../src/kernel/curve/samples.ts";
import { weightsOf } from "../src/kernel/curve/weights.ts";
import { drawBelow, drawKnots } from "../src/render/layers/analysis.ts";
import { drawData, drawHeat } from "../src/render/fit/fit-layers.ts";
import type { FitOutcome } from "../src/kernel/fit/outcome.ts";
import { documentPaths } from "../src/render/outlines.ts";
import type { Palette } from "../src/render/palette.ts";
import type { Scene } from "../src/render/scene.ts";
import { longContour } from "./harness.ts";

/** What explains a curve, and edits of it, where there are very many points: the same, of less work. */

const drawn = { paths: 0, lines: 0, rings: 0 };

/** Counts what is drawn. */
class Path {
  lines = 0;
  moveTo(): void {}
  closePath(): void {}
  arc(): void {}
  lineTo(): void { this.lines += 1; }
  bezierCurveTo(): void { this.lines += 1; }
  addPath(path: Path): void { this.lines += path.lines; }
}

const context = new Proxy({}, {
  get: (_, name) => (path?: unknown): void => {
    if (name === "strokeRect") drawn.rings += 1;
    if (!(path instanceof Path)) return;
    drawn.paths += 1;
    drawn.lines += path.lines;
  },
  set: () => true,
}) as CanvasRenderingContext2D;

const real = Reflect.get(globalThis, "Path2D") as unknown;
before(() => { Reflect.set(globalThis, "Path2D", Path); });
after(() => { Reflect.set(globalThis, "Path2D", real); });

const drawing = (contour: Contour): CurveDocument => ({ space: "trigonometric", omega: "auto", level: 0, contours: [contour] });
const many = longContour(20_000);

/** What is drawn of an overlay in a window of 1000 × 800. */
function workOf(curve: CurveDocument, overlay: "comb" | "subdivision" | "knots", zoom: number, at: { x: number; y: number }): typeof drawn {
  const state = initialState;
  const overlays = { ...state.settings.overlays, comb: false, subdivision: false, polygon: false, knots: false, [overlay]: true };
  const scene: Scene = {
    context, palette: {} as Palette, ratio: 1, origin: curve, focused: false,
    state: {
      ...state, curve, view: { ...at, zoom }, stage: { left: 0, top: 0, width: 1000, height: 800 },
      settings: { ...state.settings, overlays, subdivisionSteps: overlay === "subdivision" ? 3 : 0 },
    },
  };
  Object.assign(drawn, { paths: 0, lines: 0, rings: 0 });
  drawBelow(scene);
  drawKnots(scene);
  return { ...drawn };
}

test("overlays of very many points have no more than can be told apart, and nothing of what is out of sight", () => {
  const curve = drawing(many);
  // The contour is 2,800 units long: that many pixels at a zoom of 1, and 64 times as many at 64.
  for (const [overlay, whole] of [["comb", 3 * 2800], ["subdivision", 4 * 2800]] as const) {
    assert.ok(workOf(curve, overlay, 1, { x: 400, y: 300 }).lines <= whole, `${overlay}: ${drawn.lines} lines`);
    const { x, y } = many.points[300] as ControlPoint;
    const near = workOf(curve, overlay, 64, { x, y });
    assert.ok(near.paths >= 2, `${overlay}: ${near.paths} paths in sight`);
    // A part has 512 segments with four teeth and a stretch of envelope to each, or eight sides in each of the steps;
    // three parts may be near.
    assert.ok(near.lines <= 3 * 512 * 32, `${overlay}: ${near.lines} lines`);
    assert.equal(workOf(curve, overlay, 1, { x: 1e6, y: 1e6 }).paths, 0, overlay);
  }
  // A ring of 14 pixels in each cell of 14 that the curve goes through: it goes through fewer than two to each cell's
  // side of its length.
  const { rings } = workOf(curve, "knots", 1, { x: 400, y: 300 });
  assert.ok(rings > 50 && rings <= 2 * 2800 / 14, `${rings} rings`);
});

test("of few points every tooth and every knot is drawn", () => {
  const few = drawing(longContour(40));
  // 1024 teeth shared among 40 segments are 25 each; the envelope has one stretch fewer.
  assert.equal(workOf(few, "comb", 1, { x: 400, y: 300 }).lines, 40 * (25 + 24));
  assert.equal(workOf(few, "knots", 1, { x: 400, y: 300 }).rings, 40);
});

/** The library's own removal, on the whole curve. */
function removedAsWhole(curve: CurveDocument, contour: Contour, index: number): { places: Float64Array; deviation: number } {
  const { curve: result, maxError } = (hermiteOf(curve, contour) as HermiteCurve).remove(index);
  return { places: result.sample(5003), deviation: maxError };
}

test("a point taken out of a long contour, looking at its two segments only, leaves the curve that taking it out of the whole leaves", () => {
  const uneven = { ...longContour(300), lengths: Array.from({ length: 300 }, (_, i) => 1 + (i % 3) / 2) };
  const { closed: _closed, ...open } = longContour(300);
  const own = { ...longContour(300), omega: Array.from({ length: 300 }, (_, i) => 0.01 * (i % 7)) };
  for (const contour of [many, uneven, own, { ...open, closed: false }]) {
    const curve = drawing(contour);
    for (const index of [0, 1, 17, contour.points.length - 1]) {
      const whole = removedAsWhole(curve, contour, index);
      const result = healed(curve, contour, index);
      assert.ok(result !== null);
      // Both solve the same small system; the frequency of "auto" is divided in another order.
      assert.ok(Math.abs(result.deviation - whole.deviation) <= 1e-9 * whole.deviation + 1e-12, `${index}: ${result.deviation}, ${whole.deviation}`);
      const places = curveOf(drawing(result.contour), result.contour)?.sample(5003) ?? new Float64Array(0);
      assert.equal(places.length, whole.places.length);
      const worst = places.reduce((most, value, i) => Math.max(most, Math.abs(value - (whole.places[i] ?? NaN))), 0);
      assert.ok(worst <= 1e-9, `${index}: ${worst}`);
    }
  }
});

test("taking one point of very many away reads the handles of those beside it alone", () => {
  const read = new Set<number>();
  const points = many.points.map((point, i) => Object.defineProperty({ ...point }, "in", { enumerable: true, get: () => (read.add(i), point.in) }));
  const contour = { ...many, points };
  assert.ok(healed(drawing(contour), contour, 777) !== null);
  assert.ok(read.size <= 5, `${read.size} points`);
});

test("what was moved as a whole has the box and the Bézier's error of what it is", () => {
  const curve = drawing(many);
  const all = { points: many.points.map((_, index) => ({ contour: 0, index })), handle: null };
  const moved = movePoints(all, 31, -7).apply(curve);
  const contour = moved.contours[0] as Contour;
  const afresh: Contour = structuredClone(contour);
  const [box, exact] = [boundsOf(moved, contour), boundsOf(drawing(afresh), afresh)];
  for (const side of ["minX", "minY", "maxX", "maxY"] as const) assert.ok(Math.abs((box?.[side] ?? NaN) - (exact?.[side] ?? NaN)) <= 1e-12 * 700, side);
  // Distances of 1e-5 between coordinates of hundreds: rounding is 1e-13.
  assert.ok(Math.abs((bezierGhost(moved, contour)?.distance ?? NaN) - (bezierGhost(drawing(afresh), afresh)?.distance ?? NaN)) <= 1e-12);
});

test("the weights of a point of very many are those of the same point among few", () => {
  const contour = { ...longContour(3000), omega: Array.from({ length: 3000 }, () => 0.3) };
  const { points } = contour;
  const index = 1200;
  // Ten segments on either side, as a contour that is short enough to be looked at whole.
  const short: Contour = { family: "hermite", closed: false, support: 1, points: points.slice(index - 10, index + 11), omega: Array.from({ length: 20 }, () => 0.3) };
  const [near, whole] = [weightsOf(drawing(contour), { contour: 0, index }), weightsOf(drawing(short), { contour: 0, index: 10 })];
  assert.ok(near !== null && whole !== null && !near.closed);
  /** The weight at the place nearest to this one. */
  const at = (weights: typeof near, x: number, y: number): number => {
    let [best, least] = [NaN, Infinity];
    for (let k = 0; k < weights.point.length; k += 1) {
      const distance = Math.hypot((weights.places[2 * k] ?? NaN) - x, (weights.places[2 * k + 1] ?? NaN) - y);
      if (distance < least) [best, least] = [weights.point[k] ?? NaN, distance];
    }
    return best;
  };
  for (let i = -3; i <= 3; i += 1) {
    const { x, y } = points[index + i] as ControlPoint;
    const expected = i === 0 ? 1 : 0;
    // Places stand 48 or so to a segment, and a weight grows by at most 2 over a segment.
    for (const weights of [near, whole]) assert.ok(Math.abs(at(weights, x, y) - expected) <= 2 / 48, `${i}: ${at(weights, x, y)}`);
  }
  assert.ok(near.places.length <= 2 * 5 * 48, `${near.places.length / 2} places`);
});

/** Noise that comes back the same. */
const noise = (i: number): number => ((i * 7919) % 1009) / 1009 - 0.5;

/** What is drawn of so many noisy points of a circle of radius 200, and of how far they are from it. */
function workOfFit(count: number): { readonly line: number; readonly heat: number } {
  const angle = (i: number): number => (2 * Math.PI * i) / count;
  const data = Array.from({ length: count }, (_, i): [number, number] => [400 + (200 + 4 * noise(i)) * Math.cos(angle(i)), 300 + (200 + 4 * noise(i)) * Math.sin(angle(i))]);
  const state = initialState;
  const scene = {
    context, palette: { heat: ["a", "b", "c", "d", "e"] } as unknown as Palette, ratio: 1, origin: state.curve, focused: false,
    state: { ...state, view: { x: 400, y: 300, zoom: 1 }, stage: { left: 0, top: 0, width: 1000, height: 800 }, fit: { ...state.fit, data, starts: [] } },
  };
  const lines = (draw: () => void): number => {
    drawn.lines = 0;
    draw();
    return drawn.lines;
  };
  const curve = { closed: true, evaluate: (t: Float64Array) => Float64Array.from([...t].flatMap((i) => [400 + 200 * Math.cos(angle(i)), 300 + 200 * Math.sin(angle(i))])) };
  const stroke = { curve, parts: [], points: Float64Array.from(data.flat()), parameters: Float64Array.from(data, (_, i) => i) };
  const outcome = { strokes: [stroke], max: 2 } as unknown as FitOutcome;
  return { line: lines(() => drawData(scene, 1)), heat: lines(() => drawHeat(scene, outcome)) };
}

test("of very many points of Fit the way and the errors are drawn to the pixel, of few each step", () => {
  const [few, many] = [workOfFit(1500), workOfFit(60_000)];
  assert.deepEqual(few, { line: 1499, heat: 1500 });
  // The points lie in a ring 4 wide and 400 π long: so many cells of a pixel, and half as many again along its two
  // rims.
  assert.ok(many.line <= 6 * 400 * Math.PI, `${many.line}`);
  // A chord of a circle of 1,257 pixels, every one two thirds of a pixel long.
  assert.ok(many.heat <= 2001, `${many.heat}`);
});

test("very many contours are stroked in paths of few, which are all of them once", () => {
  const curve: CurveDocument = { ...drawing(longContour(9)), contours: Array.from({ length: 70 }, () => longContour(9)) };
  const scene: Scene = {
    context, palette: {} as Palette, ratio: 1, origin: curve, focused: false,
    state: { ...initialState, curve, view: { x: 400, y: 300, zoom: 1 }, stage: { left: 0, top: 0, width: 1000, height: 800 } },
  };
  const outlines = documentPaths(scene, curve);
  const linesOf = (path: Path2D): number => (path as unknown as Path).lines;
  assert.equal(outlines.lines.length, 3);
  assert.equal(outlines.lines.reduce((sum, path) => sum + linesOf(path), 0), linesOf(outlines.all));
  assert.ok(outlines.lines.every((path) => linesOf(path) <= linesOf(outlines.all) / 2));
  assert.equal(outlines.closed, outlines.all);
  assert.equal(documentPaths(scene, curve), outlines, "made once");
});

test("a contour of very many points without tangents is drawn in as many lines as can be told apart, and in its own pieces from near", () => {
  const curve = drawing({ family: "interpolating", closed: true, support: 2, points: longContour(5000).points });
  const linesAt = (zoom: number): number => {
    const scene: Scene = {
      context, palette: {} as Palette, ratio: 1, origin: curve, focused: false,
      state: { ...initialState, curve, view: { x: 400, y: 300, zoom }, stage: { left: 0, top: 0, width: 1000, height: 800 } },
    };
    return documentPaths(scene, curve).lines.reduce((sum, line) => sum + (line as unknown as Path).lines, 0);
  };
  // A twentieth of a pixel beside a circle of 250 pixels is passed by a chord of 10, so some 160 would do for a plain
  // one; its 11 waves take more.
  assert.ok(linesAt(1) < 1000, `${linesAt(1)} lines`);
  // Five pixels from point to point: pieces of a curve, one or more for each.
  assert.ok(linesAt(16) >= 5000, `${linesAt(16)} pieces`);
});
