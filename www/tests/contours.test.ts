import assert from "node:assert/strict";
import { test } from "node:test";
import { locate } from "../src/document/curve/contours.ts";
import { joined, reversedContour, startedAt, withClosed, withoutPoints } from "../src/document/curve/whole/rearranging.ts";
import { loweredContour } from "../src/document/curve/lowered.ts";
import { segmentCount, type Contour, type CurveDocument } from "../src/document/document.ts";
import { curveSample } from "../src/document/curve/samples.ts";
import { movePoints } from "../src/document/curve/commands.ts";
import { cubicsOf } from "../src/kernel/paths/paths.ts";
import { inserted, resampled } from "../src/kernel/curve/points/contours.ts";
import { refined } from "../src/kernel/curve/refining.ts";
import { samplePoints } from "../src/kernel/curve/samples.ts";
import { contoursOfPath, largestDistance } from "./harness.ts";

/** A few hundred units, a dozen roundings. */
const rounding = 2e-12;

function sample(id: string): { curve: CurveDocument; contour: Contour } {
  const curve = curveSample(id)?.curve;
  const contour = curve?.contours[0];
  assert.ok(curve !== undefined && contour !== undefined);
  return { curve, contour };
}

function reversedPoints(points: Float64Array, closed: boolean): Float64Array {
  const count = points.length / 2;
  return Float64Array.from(points, (_, k) => points[2 * ((closed ? count - (k >> 1) : count - 1 - (k >> 1)) % count) + (k & 1)] ?? 0);
}

test("a reversed contour is the same curve run the other way, and twice reversed the same contour", () => {
  for (const id of ["heart", "circle-8", "cycloid", "sine"]) {
    const { curve, contour } = sample(id);
    const back = reversedContour(contour);
    const points = samplePoints(curve, contour, 400);
    assert.ok(largestDistance(reversedPoints(points, contour.closed), samplePoints(curve, back, 400)) < rounding, id);
    assert.deepEqual(reversedContour(back), contour, id);
  }
});

test("a closed contour started elsewhere is the same curve", () => {
  const { curve, contour } = sample("circle-8");
  const finer = inserted(curve, contour, 2.3)?.contour;
  assert.ok(finer !== undefined);
  const [before, after] = [samplePoints(curve, finer, 800), samplePoints(curve, startedAt(finer, 2), 800)];
  const shift = 2 * 200;
  assert.ok(largestDistance(Float64Array.from(before, (_, k) => before[(k + shift) % before.length] ?? 0), after) < rounding);
});

test("closing adds one segment and opening takes it away, and the others keep their shape", () => {
  const { curve, contour } = sample("sine");
  const closed = withClosed(curve, contour, true);
  assert.equal(segmentCount(closed), segmentCount(contour) + 1);
  const open = withClosed(curve, closed, false);
  assert.equal(segmentCount(open), segmentCount(contour));
  assert.ok(largestDistance(samplePoints(curve, contour, 300), samplePoints(curve, open, 300)) < rounding);
});

test("taking points away leaves the runs between them", () => {
  const { curve, contour } = sample("circle-8");
  assert.deepEqual(withoutPoints(curve, contour, [6, 3]).map((part) => part.points.length), [4, 2]);
  assert.deepEqual(withoutPoints(curve, contour, [1, 3, 5, 7]).length, 0);
  const open = withClosed(curve, contour, false);
  assert.deepEqual(withoutPoints(curve, open, [0]).map((part) => part.points.length), [7]);
  assert.deepEqual(withoutPoints(curve, open, [4]).map((part) => part.points.length), [4, 3]);
});

test("an outline that ends where it began is closed, with one point in place of two", () => {
  const drawn = contoursOfPath("M10 10h80v40a20 20 0 0 1-20 20H40q-30 0-30-30V10", "trigonometric")[0];
  assert.ok(drawn !== undefined && !drawn.closed);
  const closed = joined(drawn);
  assert.equal(closed.closed, true);
  assert.equal(closed.points.length, drawn.points.length - 1);
  const curve: CurveDocument = { space: "trigonometric", omega: "auto", level: 0, contours: [] };
  const [open, round] = [samplePoints(curve, drawn, 601), samplePoints(curve, closed, 600)];
  assert.ok(largestDistance(open.slice(0, 1200), round) < 1e-12);
  const apart = contoursOfPath("M10 10h80v40z M0 0L5 5L9 0", "trigonometric");
  assert.equal(joined(apart[1] ?? drawn).closed, false);
});

test("refining leaves the curve where it is, for even and for uneven contours, and lowering undoes it to the last bit of the old points", () => {
  for (const id of ["circle-2", "circle-8", "heart", "cycloid", "sine", "glyph", "ellipse"]) {
    const { curve, contour } = sample(id);
    const fine = refined(curve, refined(curve, contour, 1), 2);
    assert.equal(fine.points.length, contour.closed ? 4 * contour.points.length : 4 * contour.points.length - 3, id);
    assert.ok(largestDistance(samplePoints(curve, contour, 601), samplePoints(curve, fine, 601)) < rounding, id);
    loweredContour(fine, 0).points.forEach((point, i) => {
      const old = contour.points[i];
      assert.ok(old !== undefined);
      assert.deepEqual([point.x, point.y], [old.x, old.y], id);
      assert.ok(Math.abs(point.out.dx - old.out.dx) + Math.abs(point.in.dy - old.in.dy) < rounding, id);
    });
  }
});

test("an open curve can be resampled again and again, though the sum of its lengths is rounded", () => {
  const { curve, contour } = sample("cycloid");
  const end = contour.points.at(-1);
  for (let count = 7; count <= 64; count += 1) {
    const last = resampled(curve, resampled(curve, contour, count), 11).points.at(-1);
    assert.ok(Math.hypot((last?.x ?? NaN) - (end?.x ?? NaN), (last?.y ?? NaN) - (end?.y ?? NaN)) < 1e-9, `by way of ${count} points`);
  }
});

test("a circle resampled to any number of points is still that circle", () => {
  const { curve, contour } = sample("circle-2");
  for (const count of [3, 5, 8, 64, 256]) {
    const points = samplePoints(curve, resampled(curve, contour, count), 999);
    for (let i = 0; i < points.length; i += 2) assert.ok(Math.abs(Math.hypot((points[i] ?? 0) - 400, (points[i + 1] ?? 0) - 300) - 160) < rounding);
  }
});

test("a parameter is found in its segment, and round the end of a closed contour", () => {
  const { curve, contour } = sample("circle-8");
  assert.deepEqual(locate(contour, 8.25), { segment: 0, x: 0.25 });
  assert.deepEqual(locate(contour, -0.5), { segment: 7, x: 0.5 });
  const finer = inserted(curve, contour, 0.37)?.contour;
  assert.ok(finer !== undefined);
  const found = locate(finer, 0.5);
  assert.equal(found.segment, 1);
  assert.ok(Math.abs(found.x - 0.13 / 0.63) < 1e-15);
});

test("a contour moved as a whole is drawn where its curve is, however often it was moved", () => {
  const { curve, contour } = sample("heart");
  const selection = { points: contour.points.map((_, index) => ({ contour: 0, index })), handle: null };
  let document = curve;
  cubicsOf(document, contour, 0.05);
  for (let i = 0; i < 50; i += 1) document = movePoints(selection, 0.1, -3.7).apply(document);
  const moved = document.contours[0];
  assert.ok(moved !== undefined);
  const [drawn, exact] = [cubicsOf(document, moved, 0.05), samplePoints(document, { ...moved }, 2)];
  assert.ok(Math.abs((drawn[0] ?? 0) - (exact[0] ?? 1)) < rounding && Math.abs((drawn[1] ?? 0) - (exact[1] ?? 1)) < rounding);
  // Another frequency is another curve: what is known of the old one no longer holds.
  const other = { ...document, omega: 0.2 };
  assert.ok(largestDistance(cubicsOf(other, moved, 0.05).slice(0, 8), drawn.slice(0, 8)) > 0.1);
});
