import assert from "node:assert/strict";
import { before, test } from "node:test";
import init, { initTrace, traceImage, type Trace, type TraceOptions } from "expline/slim";
import { turnAt } from "../src/document/curve/offset.ts";
import { withFoundCorners } from "../src/document/trace/corners.ts";
import { samplePoints } from "../src/kernel/curve/samples.ts";
import { measured } from "../src/kernel/trace/measured.ts";
import { cornersIn, outcomeOf, shownOutcome, type TraceOutcome } from "../src/kernel/trace/outcome.ts";
import { distanceToBorder } from "../src/kernel/trace/pixels/shades.ts";
import { coverage } from "../src/kernel/trace/raster.ts";
import { contoursOfPath } from "./harness.ts";

// What becomes of a picture with the tracer of the library itself.
before(() => Promise.all([init(), initTrace()]));

type Pair = readonly [number, number];

const [columns, rows] = [400, 300];

/** Shapes one on the other on white paper, each with its shade. */
function picture(shapes: readonly (readonly [shade: number, outline: readonly Pair[]])[]): Uint8Array<ArrayBuffer> {
  const shades = new Float64Array(columns * rows).fill(255);
  for (const [shade, outline] of shapes) {
    coverage([Float64Array.from(outline.flat())], columns, rows, 1).forEach((share, i) => (shades[i] = (shades[i] ?? 0) * (1 - share) + shade * share));
  }
  return Uint8Array.from(shades, Math.round);
}

const box = (x: number, y: number, width: number, height: number): Pair[] => [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
const circle = (x: number, y: number, r: number): Pair[] => Array.from({ length: 400 }, (_, i) => [x + r * Math.cos(i * Math.PI / 200), y + r * Math.sin(i * Math.PI / 200)] as const);

const corner = Math.PI / 4;

interface Seen {
  readonly trace: Trace;
  readonly outcome: TraceOutcome;
}

async function traced(data: Uint8Array<ArrayBuffer>, options: TraceOptions = {}): Promise<Seen> {
  const trace = traceImage({ data, width: columns, height: rows }, { speckle: 16, corner, ...options });
  const ink = data.map((shade) => (shade < 128 ? 1 : 0));
  return { trace, outcome: outcomeOf(await measured(trace, [1, 1], { ink, columns, rows, border: { shades: { values: data, columns, rows }, threshold: 127.5 } }, corner), undefined) };
}

const nearest = ([x, y]: Pair, among: readonly { readonly x: number; readonly y: number }[]): number => Math.min(...among.map((each) => Math.hypot(each.x - x, each.y - y)));

test("every corner that the tracer finds in overlapping shapes is one in the count and for whoever edits the outline", async () => {
  const { trace, outcome: { drawing } } = await traced(picture([[0, box(50, 50, 120, 200)], [119, box(170, 90, 120, 160)], [68, circle(290, 120, 60)]]));
  const found = trace.contours.flatMap(({ cusps }) => cusps.map(([x = 0, y = 0]): Pair => [x, y]));
  const corners = cornersIn(drawing);
  const points = drawing.contours.flatMap((contour) => contour.points);
  // Also of this picture, where an arc ends in one of them, the tracer's corners are points of its curve; they were up
  // to .06 pixels beside.
  const beside = Math.max(...found.map((place) => nearest(place, points)));
  assert.ok(found.length >= 6 && beside < 1e-9, `${found.length} corners, ${beside} px beside`);
  for (const place of found) assert.equal(nearest(place, corners), nearest(place, points), `${place.join(", ")} is no corner`);
  assert.equal(corners.length, found.length);
  for (const point of points) assert.ok(point.kind === "cusp" || turnAt(point) < corner, `${point.x}, ${point.y} turns and is called ${point.kind}`);
});

test("a corner that the tracer found is the point nearest to its place, and a turn that was asked for stays one, found or not", () => {
  const [square] = contoursOfPath("M10 10L110 10L110 110L10 110Z", "trigonometric");
  assert.ok(square !== undefined);
  const kinds = (places: readonly Pair[], least: number): string => withFoundCorners(square, places, { within: 0.5, least }).points.map(({ kind }) => kind === "cusp" ? "c" : "s").join("");
  assert.equal(kinds([[110.1, 9.9], [10, 110]], Math.PI), "scsc", "an eighth of a pixel away is found, and what turns less than was asked is smooth");
  assert.equal(kinds([[111, 10]], Math.PI), "ssss", "a pixel away is another place");
  assert.equal(kinds([], corner), "cccc");
});

test("how far corners go beyond the ink is what pixels cut off them: much of a needle, little of a square, and nothing is said of a disc", async () => {
  const beyond = async (outline: readonly Pair[]): Promise<number> => (await traced(picture([[0, outline]]))).outcome.beyond ?? NaN;
  // A tip of 20° is a pixel wide, and so half ink, at 1 / (2 tan 10°) = 2.8 px from its end.
  const needle = await beyond([[50, 150], [50 + 280, 150 - 280 * Math.tan(Math.PI / 18)], [50 + 280, 150 + 280 * Math.tan(Math.PI / 18)]]);
  assert.ok(needle > 1.5 && needle < 4, `${needle} px`);
  assert.ok(await beyond(box(100, 100, 100, 100)) < 0.75);
  assert.equal(await beyond(circle(200, 150, 100)), 0);
  assert.ok(await beyond(box(0, 0, 100, 100)) < 0.75, "ink that ends with the picture has its border there");
});

test("the distance to the border of ink is that to the nearest of all", () => {
  const data = picture([[0, circle(200, 150, 60)], [0, box(300, 20, 41, 33)]]);
  const ink = data.map((shade) => (shade < 128 ? 1 : 0));
  for (const [x, y] of [[200.5, 150.5], [10, 10], [262.3, 151.1], [320, 36], [350, 200]] as const) {
    const toBox = Math.max(300 - x, x - 341, 20 - y, y - 53) <= 0 ? Math.min(x - 300, 341 - x, y - 20, 53 - y) : Math.hypot(Math.max(300 - x, 0, x - 341), Math.max(20 - y, 0, y - 53));
    const known = Math.min(Math.abs(Math.hypot(x - 200, y - 150) - 60), toBox);
    const found = distanceToBorder({ values: data, columns, rows }, ink, 127.5, x, y);
    // Borders are known where they pass between two pixels: half a pixel beside that, along a straight one.
    assert.ok(Math.abs(found - known) < 0.5, `${x}, ${y}: ${found}, not ${known}`);
  }
});

test("what is shared with the ink is counted by the areas that are drawn, of a stroke between two outlines by its own", async () => {
  const ring = picture([[0, circle(200, 150, 100)], [255, circle(200, 150, 80)]]);
  for (const source of ["brightness", "edges"] as const) {
    const { outcome } = await traced(ring, { source });
    assert.equal(outcome.drawing.contours.length, 2, source);
    assert.ok((outcome.iou ?? 0) > 0.97, `${source}: ${outcome.iou}`);
  }
});

/** The outlines as places. */
const placesOn = ({ drawing }: TraceOutcome): Pair[] => drawing.contours.flatMap((contour) => {
  const places = samplePoints(drawing, contour, 2000);
  return Array.from({ length: places.length / 2 }, (_, i): Pair => [places[2 * i] ?? 0, places[2 * i + 1] ?? 0]);
});

test("a smooth point that is made a corner frees its handles and moves nothing: every number stays true", async () => {
  const { outcome } = await traced(picture([[0, circle(200, 150, 100)]]));
  const point = outcome.drawing.contours[0]?.points[0];
  assert.ok(point !== undefined && point.kind !== "cusp");
  const shown = shownOutcome(outcome, [{ x: point.x, y: point.y, kind: "cusp" }]);
  assert.deepEqual(cornersIn(shown.drawing).map(({ index }) => index), [0]);
  assert.deepEqual(placesOn(shown), placesOn(outcome));
  assert.deepEqual({ ...shown, drawing: null }, { ...outcome, drawing: null });
});

for (const [what, tip] of [["sharp", 250], ["flat", 160]] as const) {
  test(`the outline of a ${what} star stays within a pixel and a half of its ink when all of its corners are smoothed`, async () => {
    const star = Array.from({ length: 10 }, (_, i): Pair => [200 + (i % 2 === 0 ? tip / 2 : 50) * Math.cos(Math.PI * i / 5), 150 + (i % 2 === 0 ? tip / 2 : 50) * Math.sin(Math.PI * i / 5)]);
    const { outcome } = await traced(picture([[0, star]]));
    const corners = cornersIn(outcome.drawing);
    assert.ok(corners.length >= 5);
    const shown = shownOutcome(outcome, corners.map(({ x, y }) => ({ x, y, kind: "smooth" })));
    assert.equal(cornersIn(shown.drawing).length, 0);
    for (const { contour, index } of corners) {
      const point = shown.drawing.contours[contour]?.points[index];
      assert.ok(point !== undefined && turnAt(point) < 1e-9 && Math.hypot(point.out.dx, point.out.dy) > 0.5, JSON.stringify(point));
    }
    const side = (i: number): Pair => star[i % 10] ?? [0, 0];
    const away = Math.max(...placesOn(shown).map((place) => Math.min(...star.map((_, i) => toSide(place, side(i), side(i + 1))))));
    assert.ok(away < 1.5, `${away} px`);
  });
}

function toSide([x, y]: Pair, [ax, ay]: Pair, [bx, by]: Pair): number {
  const [ux, uy] = [bx - ax, by - ay];
  const t = Math.max(0, Math.min(1, ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy)));
  return Math.hypot(x - ax - t * ux, y - ay - t * uy);
}

test("a corner between two long arcs is smoothed without leaving them by more than a thirtieth of their length", async () => {
  // A lens: two arcs of 120° that meet at 120°.
  const r = 150;
  const arc = (middle: number, from: number): Pair[] => Array.from({ length: 200 }, (_, i) => [200 + r * Math.cos(from + i * Math.PI / 300), middle + r * Math.sin(from + i * Math.PI / 300)] as const);
  const lens = [...arc(225, (7 * Math.PI) / 6), ...arc(75, Math.PI / 6)];
  const { outcome } = await traced(picture([[0, lens]]));
  const corners = cornersIn(outcome.drawing);
  assert.equal(corners.length, 2);
  const shown = shownOutcome(outcome, corners.slice(1).map(({ x, y }) => ({ x, y, kind: "smooth" })));
  const away = Math.max(...placesOn(shown).map(([x, y]) => Math.min(...lens.map(([a, b]) => Math.hypot(a - x, b - y)))));
  assert.ok(away < (r * 2 * Math.PI) / 3 / 30, `${away} px`);
});
