// Pictures that were scaled up by repeating pixels.

import assert from "node:assert/strict";
import { test } from "node:test";

import { type Trace, type TraceOptions, traceImage, traceImageAsync } from "expline";

import { type Drawn, inCircle, painted } from "./trace-data.ts";

const SIDE = 64;

/** A disc that covers a part of another one, each with its own colour, on white. */
function discs(): Drawn {
  const picture = painted(SIDE, SIDE, () => 255);
  for (const [x, y, radius, color] of [[26.3, 30.2, 17.4, [200, 16, 46]], [41.8, 36.7, 13.1, [0, 48, 135]]] as const) {
    for (let i = 0; i < SIDE * SIDE; i += 1) {
      const share = inCircle(i % SIDE, Math.floor(i / SIDE), x, y, radius);
      color.forEach((channel, k) => (picture.data[4 * i + k] = Math.round((1 - share) * picture.data[4 * i + k]! + share * channel)));
    }
  }
  return picture;
}

/** Every pixel so many times in a row and in a column, on the average. */
function enlarged({ width, height, data }: Drawn, times: number): Drawn {
  const each = data.length / (width * height);
  const [columns, rows] = [times * width, times * height];
  const large = new Uint8ClampedArray(each * columns * rows);
  for (let i = 0; i < columns * rows; i += 1) {
    const nearest = (at: number): number => Math.floor((at + 0.5) / times);
    const from = each * (nearest(Math.floor(i / columns)) * width + nearest(i % columns));
    large.set(data.subarray(from, from + each), each * i);
  }
  return { width: columns, height: rows, data: large };
}

/** Points of all contours, in pixels that are so many times as large. */
const points = ({ contours }: Trace, times: number): number[] => contours.flatMap(({ curve }) => Array.from(curve.points, (v) => v / times));

test("an enlarged drawing has the outlines and the layers of the drawing, so many times as large", async () => {
  const drawing = discs();
  const shades = { ...drawing, data: drawing.data.filter((_, i) => i % 4 === 0) };
  for (const options of [{}, { colors: 4 }, { colors: ["#ffffff", "#c8102e", "#003087"] }] satisfies TraceOptions[]) {
    for (const picture of [drawing, shades]) {
      const small = traceImage(picture, options);
      const large = traceImage(enlarged(picture, 4), options);
      assert.deepEqual([large.width, large.height, large.layers], [4 * SIDE, 4 * SIDE, small.layers]);
      assert.deepEqual(points(large, 4), points(small, 1), JSON.stringify(options));
      const inTasks = await traceImageAsync(enlarged(picture, 4), options);
      assert.equal(inTasks.toSvg(), large.toSvg());
    }
  }
});

test("a drawing on a scaled display has the outlines and the layers of the drawing, as many times as large", async () => {
  const drawing = discs();
  const shades = { ...drawing, data: drawing.data.filter((_, i) => i % 4 === 0) };
  for (const times of [1.25, 1.5, 1.75]) {
    for (const options of [{}, { colors: 4 }] satisfies TraceOptions[]) {
      for (const picture of [drawing, shades]) {
        const small = points(traceImage(picture, options), 1);
        const large = traceImage(enlarged(picture, times), options);
        const found = points(large, times);
        assert.equal(found.length, small.length);
        // Multiplied and divided again, numbers are the same up to their last bits.
        assert.ok(found.every((v, i) => Math.abs(v - small[i]!) < 1e-12 * SIDE), `${times} times, ${JSON.stringify(options)}`);
        assert.equal((await traceImageAsync(enlarged(picture, times), options)).toSvg(), large.toSvg());
      }
    }
  }
});

test("so many contours are refused that a speckle which is offered helps", () => {
  const dots = painted(SIDE, SIDE, (x, y) => 255 * (1 - [0, 1, 2, 3].reduce((sum, k) => sum + inCircle(x, y, 9.3 + 14.7 * k, 8.7 + 13.9 * k, 2 + k), 0)));
  const picture = enlarged(dots, 3);
  assert.throws(
    () => traceImage(picture, { maxContours: 2 }),
    (error: { offer?: { speckle?: number } }) => {
      assert.equal(traceImage(picture, { maxContours: 2, speckle: error.offer?.speckle }).contours.length, 2);
      return true;
    },
  );
});
