import assert from "node:assert/strict";
import { before, test } from "node:test";
import init, { initTrace, traceImage, type Trace, type TraceOptions } from "expline/slim";
import { turnAt } from "../src/document/curve/offset.ts";
import { withFoundCorners } from "../src/document/trace/corners.ts";
import { contoursOfPath } from "../src/kernel/curve/points/contours.ts";
import { measured } from "../src/kernel/trace/measured.ts";
import { cornersIn, outcomeOf, type TraceOutcome } from "../src/kernel/trace/outcome.ts";
import { coverage } from "../src/kernel/trace/raster.ts";

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
  return { trace, outcome: outcomeOf(await measured(trace, [1, 1], { ink, columns, rows }, corner), undefined) };
}

const nearest = ([x, y]: Pair, among: readonly { readonly x: number; readonly y: number }[]): number => Math.min(...among.map((each) => Math.hypot(each.x - x, each.y - y)));

test("every corner that the tracer finds in overlapping shapes is one in the count and for whoever edits the outline", async () => {
  const { trace, outcome: { drawing } } = await traced(picture([[0, box(50, 50, 120, 200)], [119, box(170, 90, 120, 160)], [68, circle(290, 120, 60)]]));
  const found = trace.contours.flatMap(({ cusps }) => cusps.map(([x = 0, y = 0]): Pair => [x, y]));
  const corners = cornersIn(drawing);
  const points = drawing.contours.flatMap((contour) => contour.points);
  // This picture's curve passes beside one of them; if none did, nothing would be tested.
  const beside = Math.max(...found.map((place) => nearest(place, points)));
  assert.ok(found.length >= 6 && beside > 1e-3 && beside < 0.5, `${found.length} corners, ${beside} px beside`);
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
