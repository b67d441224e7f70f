// Large pictures, and how much of the engine's memory they take.

import assert from "node:assert/strict";
import { test } from "node:test";

import { ExplineError, type ImageLike, traceImage } from "expline";

import { random } from "./fit-data.ts";
import { bytesOfEngines } from "./memories.ts";
import { type Drawn, painted, photoNoise } from "./trace-data.ts";

const WIDTH = 6000;
const HEIGHT = 4000;

/** A picture out of a tile, side by side and below one another; of 24 megapixels, if nothing else is asked for. */
function tiled(tile: Drawn, width = WIDTH, height = HEIGHT): ImageLike {
  const data = new Uint8ClampedArray(4 * width * height);
  const side = 4 * tile.width;
  for (let y = 0; y < height; y += 1) {
    const row = tile.data.subarray(side * (y % tile.height), side * (y % tile.height) + side);
    for (let at = 0; at < 4 * width; at += side) data.set(row, 4 * width * y + at);
  }
  return { data, width, height };
}

// The smallest first: memory that an engine has had stays its own.
test("four megapixels of two shades, full of outlines, take at most six bytes of the engine's memory a pixel", (t) => {
  const side = 2048;
  const gear = painted(256, 256, (x, y) => {
    const [right, down] = [x - 127.5, y - 127.5];
    return Math.hypot(right, down) < 96 + 8 * Math.sin(12 * Math.atan2(down, right) + 0.4) ? 0 : 255;
  });
  const { contours } = traceImage(tiled(gear, side, side));
  const each = bytesOfEngines() / (side * side);
  t.diagnostic(`${each.toFixed(2)} bytes a pixel`);
  assert.equal(contours.length, 64);
  // A wave of 8 adds half its square to that of the radius, in the mean.
  const area = Math.PI * (96 * 96 + 32);
  for (const { curve } of contours) assert.ok(Math.abs(curve.area() / area - 1) < 3e-3, `${curve.area()} of ${area}`);
  assert.ok(each <= 6, `${each}`);
});

test("four megapixels of a noisy drawing take at most six bytes of the engine's memory a pixel", (t) => {
  const side = 2048;
  const next = random(7);
  const disc = painted(256, 256, (x, y) => {
    const shade = 255 * Math.min(1, Math.max(0, Math.hypot(x - 127.5, y - 127.5) - 95.5));
    return shade + 20 * Math.sqrt(3) * (next() + next() + next() + next() - 2);
  });
  const { contours } = traceImage(tiled(disc, side, side));
  const each = bytesOfEngines() / (side * side);
  t.diagnostic(`${each.toFixed(2)} bytes a pixel`);
  assert.equal(contours.length, 64);
  // Noise of 20 in each of 600 pixels around an edge: its mean is known to .003 of a pixel, and an area to .01 with
  // what follows it.
  for (const { curve } of contours) assert.ok(Math.abs(curve.area() / (Math.PI * 96 ** 2) - 1) < 1e-3, `${curve.area()}`);
  assert.ok(each <= 6, `${each}`);
});

test("24 megapixels of drawing take at most six bytes of the engine's memory a pixel", (t) => {
  const tile = painted(500, 500, (x, y) => 255 * Math.min(1, Math.max(0, Math.hypot(x - 249.5, y - 249.5) - 179.8)));
  const { contours } = traceImage(tiled(tile));
  const each = bytesOfEngines() / (WIDTH * HEIGHT);
  t.diagnostic(`${each.toFixed(2)} bytes a pixel`);
  assert.equal(contours.length, 96);
  // A disc of shades that fall over one pixel from 179.8 on has its edge at 180.3.
  for (const { curve } of contours) {
    const { minX, minY, maxX, maxY } = curve.bounds();
    for (const radius of [(maxX - minX) / 2, (maxY - minY) / 2]) assert.ok(Math.abs(radius - 180.3) < 0.05, `${radius}`);
  }
  assert.ok(each <= 6, `${each}`);
});

/**
 * Rings in one another, dark and light, so many pixels wide each; edges of exact coverage, but for what bends inside a
 * pixel.
 */
function rings(side: number, width: number, spiral: number): ImageLike {
  const data = new Uint8ClampedArray(side * side);
  const half = side / 2;
  for (let at = 0; at < data.length; at += 1) {
    const [x, y] = [(at % side) + 0.5 - half, Math.floor(at / side) + 0.5 - half];
    const radius = Math.hypot(x, y);
    const from = (radius + (spiral * Math.atan2(y, x)) / Math.PI) % (2 * width);
    const inside = from < width ? Math.min(from, width - from) : -Math.min(from - width, 2 * width - from);
    data[at] = radius < half ? 255 - 255 * Math.min(1, Math.max(0, inside + 0.5)) : 255;
  }
  return { data, width: side, height: side };
}

test("sixteen megapixels of 800 rings, which are outlines all over, are traced", (t) => {
  const side = 4000;
  const { contours } = traceImage(rings(side, 2.5, 0));
  t.diagnostic(`${(bytesOfEngines() / side ** 2).toFixed(2)} bytes a pixel`);
  // The innermost ring is a disc, and every radius of 2.5 k up to 2000 is an edge.
  assert.equal(contours.length, 799);
  for (const [k, { curve }] of [...contours].sort((a, b) => Math.abs(a.curve.area()) - Math.abs(b.curve.area())).entries()) {
    const radius = Math.sqrt(Math.abs(curve.area()) / Math.PI);
    assert.ok(Math.abs(radius - 2.5 * (k + 1)) < 0.05, `${radius} instead of ${2.5 * (k + 1)}`);
  }
});

test("a picture for which there is no memory is refused with what helps, and the engine lives on", () => {
  assert.throws(
    () => traceImage(rings(6300, 2.6, 2.6)),
    (error) => error instanceof ExplineError && error.code === "E_MEMORY" && (error.actual ?? 0) > 0 && /half its size/.test(error.message),
  );
  assert.equal(traceImage(rings(100, 10, 0)).contours.length, 5);
});

test("a photograph of 24 megapixels is refused with its count, within the 512 MiB that an engine may have", (t) => {
  const photograph = tiled(photoNoise(600, 500, 1));
  assert.throws(
    () => traceImage(photograph),
    (error) => error instanceof ExplineError && error.code === "E_LIMIT" && error.limit === "maxContours" && (error.actual ?? 0) > 1500,
  );
  t.diagnostic(`${(bytesOfEngines() / (WIDTH * HEIGHT)).toFixed(2)} bytes a pixel`);
  assert.ok(bytesOfEngines() <= 512 * 2 ** 20);
});
