// Drawings on paper in uneven light.

import assert from "node:assert/strict";
import { test } from "node:test";

import { ExplineError, type HermiteCurve, evenLight, traceImage, traceImageAsync } from "expline";

import { random } from "./fit-data.ts";
import { type Drawn, inCircle, painted, ring } from "./trace-data.ts";

const SIDE = 200;
/** How much light falls on a place, from 0 to 1. */
type Light = (x: number, y: number) => number;
const fromTheLeft: Light = (x) => 0.95 - (0.6 * x) / SIDE;

/** A ring of two thin circles, a tenth of the paper's shade, with a little noise as a camera has. */
function sheet(light: Light, noise = 0): Drawn {
  const ink = (x: number, y: number): number => inCircle(x, y, 110.4, 96.7, 62) - inCircle(x, y, 110.4, 96.7, 57);
  return painted(SIDE, SIDE, (x, y) => 255 * light(x, y) * (1 - 0.9 * ink(x, y)) + noise * Math.sin(12.9898 * x + 78.233 * y + x * y));
}

test("a circle drawn in uneven light is a circle, at once and in tasks", async () => {
  for (const [light, noise] of [[fromTheLeft, 0], [fromTheLeft, 2], [(x, y) => 1 - 0.7 * ((x / SIDE - 0.5) ** 2 + (y / SIDE - 0.6) ** 2), 0]] as const satisfies readonly (readonly [Light, number])[]) {
    const picture = sheet(light, noise);
    const { contours } = traceImage(picture);
    assert.equal(contours.length, 2);
    contours.forEach(({ curve }, i) => {
      const { center, radii } = (curve as HermiteCurve).asEllipse(0.05) ?? { center: [NaN, NaN], radii: [NaN, NaN] };
      // Beyond the quantisation of the dark side, the test's own coverage of a pixel is good to a twentieth.
      assert.ok(Math.hypot(center[0] - 110.4, center[1] - 96.7) < 0.1, `${center.join(", ")}`);
      assert.ok(Math.abs(radii[0] - [62, 57][i]!) < 0.15, `${radii.join(", ")}`);
    });
    assert.equal((await traceImageAsync(picture)).toSvg(), traceImage(picture).toSvg());
  }
});

test("evenLight gives the shades that are traced, and nothing where the light is even or a picture is no paper", () => {
  const even = evenLight(sheet(fromTheLeft));
  assert.ok(even);
  assert.deepEqual([even.width, even.height, even.data.length], [SIDE, SIDE, SIDE * SIDE]);
  // As light as the lightest part of the sheet, all over; a byte of the dark side is nearly three of the light one.
  const paper = even.data[0]!;
  assert.ok(paper > 0.9 * 255, `${paper}`);
  const before = sheet(() => paper / 255).data;
  const worst = even.data.reduce((most, shade, i) => Math.max(most, Math.abs(shade - before[4 * i]!)), 0);
  assert.ok(worst <= 4, `off by ${worst} of 255`);
  assert.equal(evenLight(ring(SIDE)), undefined);
  assert.equal(evenLight(painted(SIDE, SIDE, (x, y) => 128 + 100 * Math.sin(x / 9) * Math.cos(y / 11))), undefined);
  assert.equal(evenLight({ width: 1, height: 1, data: Uint8Array.of(7) }), undefined);
  const { data } = sheet(fromTheLeft);
  const gray = Uint8Array.from({ length: SIDE * SIDE }, (_, i) => data[4 * i] ?? 0);
  assert.deepEqual(evenLight({ width: SIDE, height: SIDE, data: gray })?.data, even.data, "one byte for each pixel or four");
  assert.deepEqual(evenLight(even), undefined, "once is enough");
});

test("evenLight refuses what is no picture, by name", () => {
  for (const [image, argument] of [[undefined, "image"], [{ width: 2, height: 2, data: new Uint8Array(3) }, "data"]] as const) {
    assert.throws(() => evenLight(image as never), (error) => error instanceof ExplineError && error.argument === argument);
  }
});

test("a threshold that is given is meant for the shades as they are", () => {
  const dark = traceImage(sheet(fromTheLeft), { threshold: 128 });
  assert.ok(dark.contours.some(({ curve }) => curve.bounds().maxX > SIDE - 1), "the dark side counts as ink");
});

/** Two circles and a band of other colours on a board, with a little noise as a camera has. */
function pens(light: Light): Drawn {
  const next = random(3);
  const noise = (): number => 4 * (next() + next() + next() - 1.5);
  return painted(320, 240, (x, y) => {
    const fell = light((x * SIDE) / 320, (y * SIDE) / 240);
    const [red, green] = [inCircle(x, y, 100.3, 90.7, 60) - inCircle(x, y, 100.3, 90.7, 52), inCircle(x, y, 230.2, 80.4, 40)];
    const blue = Math.abs(y + 0.5 - 190) < 8 && x > 30 && x < 290 ? 1 : 0;
    const shade = ([board, r, g, b]: readonly [number, number, number, number]): number =>
      fell * (board + red * (r - board) + green * (g - board) + blue * (b - board)) + noise();
    return [shade([236, 200, 30, 40]), shade([238, 40, 150, 60]), shade([240, 40, 70, 190]), 255];
  });
}

test("pens on a board in uneven light are a layer each, as in even light, at once and in tasks", async () => {
  const even = traceImage(pens(() => 1), { colors: 5 });
  for (const light of [fromTheLeft, (x: number, y: number) => Math.exp(-1.1 * ((x / SIDE - 0.3) ** 2 + (y / SIDE - 0.3) ** 2))]) {
    const picture = pens(light);
    const drawing = traceImage(picture, { colors: 5 });
    assert.equal(drawing.layers?.length, 4, "a board and three pens");
    assert.equal(drawing.contours.length, even.contours.length, "without the light there were hundreds");
    assert.equal((await traceImageAsync(picture, { colors: 5 })).toSvg(), drawing.toSvg());
  }
});
