import assert from "node:assert/strict";
import { before, test } from "node:test";
import init, { initTrace, traceImage, traceImageAsync, type TraceOptions } from "expline/slim";
import type { tracePixels } from "../src/kernel/trace/engine.ts";
import { leftOut } from "../src/kernel/trace/left-out.ts";
import type { LeftOut } from "../src/kernel/trace/job.ts";
import { coverage } from "../src/kernel/trace/raster.ts";

// Of what a trace leaves out as specks, only what somebody has drawn is told.
before(() => Promise.all([init(), initTrace()]));

type Box = readonly [x: number, y: number, width: number, height: number];

const [columns, rows] = [500, 400];
const mark: readonly Box[] = [[60, 60, 120, 120], [220, 60, 60, 120], [320, 60, 100, 40]];
/** Letters of a small line, so to speak: 9 square pixels each, five pixels from one to the next. */
const line = (count: number): Box[] => Array.from({ length: count }, (_, i) => [80 + 5 * (i % 60), 250 + 9 * Math.floor(i / 60), 3, 3]);

/** The same numbers every time, from 0 to 1. */
function dice(): () => number {
  let state = 1;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

/** Specks of so many square pixels, anywhere below the mark. */
function dust(count: number, side: number): Box[] {
  const roll = dice();
  return Array.from({ length: count }, () => [Math.floor(roll() * (columns - 8)) + 3, 190 + Math.floor(roll() * 200), side, side]);
}

function drawn(boxes: readonly Box[]): Uint8Array<ArrayBuffer> {
  const ink = coverage(boxes.map(([x, y, w, h]) => Float64Array.of(x, y, x + w, y, x + w, y + h, x, y + h)), columns, rows, 1);
  return Uint8Array.from(ink, (share) => 255 * (1 - share));
}

const trace: typeof tracePixels = ({ data, ...size }, options) => traceImageAsync({ data, width: size.columns, height: size.rows }, options);

async function told(data: Uint8Array<ArrayBuffer>, { speckle = 16, maxContours = 1500, enlarged = 1, ...more }: TraceOptions & { readonly enlarged?: number } = {}): Promise<LeftOut | null> {
  const options = { source: "brightness" as const, ...more, maxContours, speckle: speckle / enlarged ** 2 };
  const pixels = { width: columns * enlarged, height: rows * enlarged, columns, rows, data };
  return leftOut(traceImage({ data, width: columns, height: rows }, options), { trace, pixels, options, least: 0 });
}

/** Red, green, blue and opacity of the same shades. */
const inColor = (shades: Uint8Array): Uint8Array<ArrayBuffer> => Uint8Array.from({ length: 4 * shades.length }, (_, i) => (i % 4 === 3 ? 255 : shades[i >> 2] ?? 0));

test("letters below a mark that are smaller than the speckle are counted, and what is offered keeps them all", async () => {
  for (const count of [1, 3, 58, 150]) {
    const data = drawn([...mark, ...line(count)]);
    const left = await told(data);
    assert.deepEqual(left, { count, below: 16, keeping: 2 }, `${count} letters`);
    assert.equal(traceImage({ data, width: columns, height: rows }, { speckle: 2 }).contours.length, mark.length + count);
    assert.equal(await told(data, { speckle: 2 }), null, "with that nothing is left out");
  }
});

test("the holes of letters count as well", async () => {
  const data = drawn([...mark, ...line(12)]).map((shade) => 255 - shade);
  assert.equal((await told(data, { invert: false }))?.count, 12);
});

test("colour by colour it is the same", async () => {
  assert.deepEqual(await told(inColor(drawn([...mark, ...line(40)])), { colors: 4, source: undefined }), { count: 40, below: 16, keeping: 2 });
});

test("nothing is said of dust and grain: there is more of it than of shapes, and it lies anywhere", async () => {
  for (const [count, side] of [[40, 2], [600, 2], [4000, 1], [300, 3]] as const) {
    assert.equal(await told(drawn([...mark, ...dust(count, side)])), null, `${count} specks of ${side} pixels`);
  }
  const roll = dice();
  const grain = (): number => 150 * (roll() + roll() + roll() + roll() - 2);
  const grainy = drawn(mark).map((shade) => Math.min(255, Math.max(0, shade * 0.8 + 25 + grain())));
  assert.equal(await told(grainy), null);
});

test("nothing is said where nothing is left out, and nothing is offered that would make a photograph of the drawing", async () => {
  assert.equal(await told(drawn(mark)), null);
  assert.equal(await told(drawn([...mark, ...line(40)]), { maxContours: 20 }), null);
});

test("areas are those of the picture, however much smaller it was looked at", async () => {
  const data = drawn([...mark, ...line(40)]);
  assert.deepEqual(await told(data, { enlarged: 4, speckle: 256 }), { count: 40, below: 256, keeping: 32 });
  assert.equal(await told(data, { enlarged: 4, speckle: 16 }), null, "a pixel that was looked at is no smaller than that");
});

test("where the page is done with a trace the count ends, too", async () => {
  const data = drawn([...mark, ...line(40)]);
  await assert.rejects(told(data, { signal: AbortSignal.abort() }), { code: "E_CANCELLED" });
});
