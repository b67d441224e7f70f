// Traces that are written, stopped, watched, repeated, and coloured.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { test } from "node:test";

import { ExplineError, HermiteCurve, type ImageLike, type Trace, type TraceProgress, parsePath, traceImage, traceImageAsync } from "expline";

import { discs, filled, inCircle, painted, photoNoise, ring } from "./trace-data.ts";

const RING = ring(96);

/** Every bit of a trace. */
function bits({ contours }: Trace): string {
  return createHash("sha256").update(JSON.stringify(contours)).digest("hex");
}

/** The path data of a document. */
function dataOf(svg: string): string[] {
  return [...svg.matchAll(/ d="([^"]*)"/g)].map(([, d]) => d ?? "");
}

test("a ring is two circles, and its hole is one", () => {
  const { contours, width, height, layers, milliseconds } = traceImage(RING);
  assert.deepEqual([width, height, layers], [96, 96, []]);
  assert.deepEqual(contours.map(({ hole, closed, cusps, layer }) => [hole, closed, cusps.length, layer]), [[false, true, 0, 0], [true, true, 0, 0]]);
  contours.forEach(({ curve, metrics }, i) => {
    const ellipse = (curve as HermiteCurve).asEllipse(1e-6);
    assert.ok(ellipse !== undefined, "a circle to the last bit");
    assert.ok(Math.hypot(ellipse.center[0] - 48, ellipse.center[1] - 48) < 0.02);
    assert.ok(Math.abs(ellipse.radii[0] - [38.4, 19.2][i]!) < 0.05, `${ellipse.radii[0]}`);
    assert.ok(metrics.mae <= metrics.rmse && metrics.rmse <= metrics.max && metrics.max <= metrics.hausdorff && metrics.hausdorff < 0.2);
    assert.ok(metrics.jaccard > 0.99);
  });
  const [ink = 0, hole = 0] = contours.map(({ curve }) => curve.area());
  assert.ok(ink > 0 && hole < 0, "both rules of filling give the same");
  const { total = 0, ...stages } = milliseconds;
  assert.ok(Object.values(stages).every((time) => time >= 0));
  assert.ok(Math.abs(Object.values(stages).reduce((sum, time) => sum + time, 0) - total) < 1e-6);
});

test("toSvg is one path, relative where that is shorter, and draws what was found", () => {
  const picture = discs(120, 9);
  const trace = traceImage(picture);
  const svg = trace.toSvg();
  assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg" viewBox="0 0 120 120"><path d="M[^"]+"\/><\/svg>$/);
  const [d = ""] = dataOf(svg);
  assert.match(d, /[Zz]m/, "contours begin where the one before has ended");
  const read = parsePath(d);
  assert.equal(read.length, trace.contours.length);
  read.forEach((curve, i) => {
    const wanted = trace.contours[i]!.curve;
    for (const t of [0, 0.3, 0.7]) {
      const [x = 0, y = 0] = curve.evaluate(t * curve.domain[1]);
      assert.ok(wanted.nearest(x, y).distance <= 0.03, `contour ${i}`);
    }
    assert.ok(Math.abs(curve.area() - wanted.area()) < 1);
  });
  const separate = trace.contours.map(({ curve }) => curve.toPathD({ decimals: 2 }).d).join("");
  assert.ok(d.length < separate.length, `${d.length} and ${separate.length} characters`);
});

test("toSvg keeps the tolerance that it is asked for, with as many decimals as that needs", () => {
  const trace = traceImage(discs(64, 4));
  for (const tolerance of [0.1, 1e-3, 1e-6]) {
    const read = parsePath(dataOf(trace.toSvg({ tolerance }))[0] ?? "");
    read.forEach((curve, i) => {
      const { minX, minY, maxX, maxY } = trace.contours[i]!.curve.bounds();
      const own = curve.bounds();
      const off = Math.max(...[own.minX - minX, own.minY - minY, own.maxX - maxX, own.maxY - maxY].map(Math.abs));
      // Bounds move no farther than the curve.
      assert.ok(off <= tolerance, `${off} of ${tolerance}`);
    });
  }
});

test("toSvg rounds as it is asked to", () => {
  const trace = traceImage(discs(64, 4));
  const [whole = ""] = dataOf(trace.toSvg({ decimals: 0, tolerance: 1 }));
  assert.doesNotMatch(whole, /\./);
  const [exact = ""] = dataOf(trace.toSvg({ decimals: 17 }));
  const read = parsePath(exact);
  read.forEach((curve, i) => assert.ok(Math.abs(curve.area() - trace.contours[i]!.curve.area()) < 1e-6));
  assert.throws(() => trace.toSvg({ decimals: 18 }), { code: "E_RANGE", arg: "decimals" });
  assert.throws(() => trace.toSvg({ tolerance: 0 }), { code: "E_RANGE", arg: "tolerance" });
  assert.throws(() => trace.toSvg({ digits: 2 } as never), { code: "E_TYPE", arg: "digits" });
});

test("nothing but paper is an empty document", () => {
  const trace = traceImage(filled(20, 10, [255, 255, 255, 255]));
  assert.deepEqual(trace.contours, []);
  assert.equal(trace.toSvg(), '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10"></svg>');
});

test("one byte a pixel or four, any kind of array of bytes: the same trace", () => {
  const gray = Uint8Array.from({ length: 96 * 96 }, (_, i) => RING.data[4 * i] ?? 0);
  const before = bits(traceImage(RING));
  // The luma of equal channels is off by rounding at most, which 8 bits do not see.
  assert.equal(bits(traceImage({ ...RING, data: gray })), before);
  assert.equal(bits(traceImage({ ...RING, data: new Uint8ClampedArray(gray) })), before);
  assert.equal(bits(traceImage({ ...RING, data: Buffer.from(RING.data) })), before);
  const shared = new Uint8Array(new SharedArrayBuffer(RING.data.length));
  shared.set(RING.data);
  assert.equal(bits(traceImage({ ...RING, data: shared })), before, "shared memory");
  const amid = new Uint8Array(RING.data.length + 16);
  amid.set(RING.data, 7);
  assert.equal(bits(traceImage({ ...RING, data: amid.subarray(7, -9) })), before, "a part of another array");
  class Frames extends Uint8Array {
    static get [Symbol.species](): Uint16ArrayConstructor {
      return Uint16Array;
    }
    override subarray(): Uint8Array<ArrayBuffer> {
      return new Uint8Array(this.length);
    }
  }
  assert.equal(bits(traceImage({ ...RING, data: Frames.from(RING.data) })), before, "a subclass that has other parts");
  class Frame {
    get data(): Uint8ClampedArray {
      return RING.data;
    }
    get width(): number {
      return 96;
    }
    get height(): number {
      return 96;
    }
  }
  assert.equal(bits(traceImage(new Frame())), before, "getters of a class, as an ImageData has them");
});

test("the same picture gives the same bits: again, in short tasks, after a cancelled trace, in another process, from the slim entry", async () => {
  const before = bits(traceImage(RING));
  await assert.rejects(traceImageAsync(RING, { signal: AbortSignal.abort("enough") }), (error) => error instanceof ExplineError && error.code === "E_CANCELLED" && error.cause === "enough");
  assert.equal(bits(traceImage(RING)), before);
  assert.equal(bits(await traceImageAsync(RING)), before);
  const code = `
    import { createHash } from "node:crypto";
    import init, { ExplineError, initTrace, traceImage, traceImageAsync } from "expline/slim";
    const image = { width: 96, height: 96, data: new Uint8Array(Buffer.from(${JSON.stringify(Buffer.from(RING.data).toString("base64"))}, "base64")) };
    await init();
    let code;
    try { traceImage(image); } catch (error) { code = error.code; }
    const { contours } = await traceImageAsync(image);
    console.log(code, createHash("sha256").update(JSON.stringify(contours)).digest("hex"));
  `;
  const said = execFileSync(process.execPath, ["--input-type=module", "-e", code], { encoding: "utf8" }).trim();
  assert.equal(said, `E_NOT_READY ${before}`);
});

test("progress names the stages in their order, and never goes back", async () => {
  const seen: TraceProgress[] = [];
  let turns = 0;
  const timer = setInterval(() => (turns += 1), 1);
  // Long enough for many tasks on any machine.
  await traceImageAsync(discs(600, 400), { onProgress: (progress) => seen.push(progress) });
  clearInterval(timer);
  const order = ["pixels", "edges", "contours", "corners", "splines", "refinement"];
  seen.forEach(({ stage, done, total }, i) => {
    const before = seen[i - 1];
    assert.ok(done >= 0 && done <= total, `${done} of ${total}`);
    if (before === undefined) return;
    assert.ok(order.indexOf(stage) >= order.indexOf(before.stage));
    if (stage === before.stage) assert.ok(done >= before.done);
  });
  assert.equal(seen[0]?.stage, "pixels");
  assert.equal(seen.at(-1)?.stage, "refinement");
  assert.ok(turns > 0, "timers had their turn");
});

test("an abort ends the trace at its next step, and what a callback throws reaches the caller as it is", async () => {
  const stop = new AbortController();
  const stages: string[] = [];
  const cancelled = traceImageAsync(discs(300, 100), {
    signal: stop.signal,
    onProgress: ({ stage }) => {
      stages.push(stage);
      if (stage === "splines" && !stop.signal.aborted) stop.abort();
    },
  });
  await assert.rejects(cancelled, { name: "ExplineError", code: "E_CANCELLED" });
  assert.equal(stages.includes("refinement"), false, "the abort came before");
  const own = new TypeError("mine");
  const onProgress = (): never => {
    throw own;
  };
  assert.throws(() => traceImage(RING, { onProgress }), (error) => error === own);
  await assert.rejects(traceImageAsync(RING, { onProgress }), (error) => error === own);
  assert.equal(traceImage(RING).contours.length, 2);
});

test("TR-027: bytes that are taken away while they are read are missed with a name", async () => {
  type Resizable = ArrayBuffer & { resize(bytes: number): void };
  const transfer = (buffer: Resizable): void => void structuredClone(buffer, { transfer: [buffer] });
  const shrink = (buffer: Resizable): void => buffer.resize(100);
  for (const take of [transfer, shrink]) {
    const buffer = Reflect.construct(ArrayBuffer, [96 * 96, { maxByteLength: 96 * 96 }]) as Resizable;
    const data = new Uint8Array(buffer);
    // Nothing is read before the next turn: the engine may have to be compiled.
    const work = traceImageAsync({ data, width: 96, height: 96 });
    take(buffer);
    await assert.rejects(work, (error: ExplineError) => {
      assert.ok(error instanceof ExplineError && !error.fatal, String(error));
      assert.ok(error.arg === "data" && (error.code === "E_DETACHED" || error.code === "E_LENGTH"), error.message);
      return true;
    });
  }
  assert.equal(traceImage(RING).contours.length, 2);
});

test("traces side by side do not know of one another", async () => {
  const pictures = [RING, discs(100, 9), discs(80, 4)];
  const alone = pictures.map((picture) => bits(traceImage(picture)));
  const together = await Promise.all(pictures.map((picture) => traceImageAsync(picture)));
  assert.deepEqual(together.map(bits), alone);
});

test("a photograph is refused with the count, and with what would help", () => {
  const picture = photoNoise(200, 200, 3);
  const options = { maxContours: 40, blur: 0, speckle: 0, refine: false };
  let offered: Readonly<Record<string, number>> = {};
  assert.throws(
    () => traceImage(picture, options),
    (error) => {
      assert.ok(error instanceof ExplineError);
      assert.deepEqual([error.code, error.arg, error.limit, error.max], ["E_LIMIT", "image", "maxContours", 40]);
      assert.ok((error.actual ?? 0) > 40, `${error.actual}`);
      assert.match(error.message, /like a photograph/);
      offered = error.offer ?? {};
      return true;
    },
  );
  const { speckle = 0, maxContours = 0 } = offered;
  assert.ok(speckle > 0 && maxContours > 40);
  assert.ok(traceImage(picture, { ...options, speckle }).contours.length <= 40);
  assert.equal(traceImage(picture, { ...options, maxContours }).contours.length, maxContours);
});

test("a thin stroke comes back as its middle, which is drawn and not filled", () => {
  const stroke = painted(80, 40, (x, y) => 255 * (1 - Math.max(0, Math.min(1, 2 - Math.abs(y + 0.5 - 20.3))) * (x >= 10 && x < 70 ? 1 : 0)));
  const trace = traceImage(stroke, { source: "lines" });
  assert.deepEqual(trace.contours.map(({ closed }) => closed), [false]);
  const { minX, minY, maxX, maxY } = trace.contours[0]!.curve.bounds();
  assert.ok(minX > 8 && minX < 13 && maxX > 67 && maxX < 72, `${minX} to ${maxX}`);
  assert.ok(Math.abs(minY - 20.3) < 0.3 && Math.abs(maxY - 20.3) < 0.3, `${minY} to ${maxY}`);
  assert.match(trace.toSvg(), /<path fill="none" stroke="#000" d="M[^Zz"]+"\/><\/svg>$/);
});

test("closed centre lines and edges are drawn, too, and outlines are filled", () => {
  for (const source of ["lines", "edges"] as const) {
    const trace = traceImage(RING, { source });
    assert.ok(trace.contours.length > 0 && trace.contours.every(({ closed }) => closed), source);
    assert.equal(trace.toSvg().match(/<path [^>]*>/g)?.length, 1, source);
    assert.match(trace.toSvg(), /<path fill="none" stroke="#000" d="M[^"]+Z"\/><\/svg>$/i, source);
  }
  assert.match(traceImage(RING).toSvg(), /<path d="M[^"]+Z"\/><\/svg>$/i);
});

test("every source goes with every model", () => {
  for (const source of ["brightness", "edges", "lines"] as const) {
    for (const model of ["sparse", "wqisa"] as const) {
      const { contours } = traceImage(RING, { source, model });
      assert.ok(contours.length > 0, `${source}, ${model}`);
      for (const { curve } of contours) {
        const [x = 0, y = 0] = curve.evaluate(0.5 * curve.domain[1]);
        const radius = Math.hypot(x - 48, y - 48);
        // The outer circle, the inner one, or the line between them.
        assert.ok([38.4, 19.2, 28.8].some((wanted) => Math.abs(radius - wanted) < 1), `${source}, ${model}: ${radius}`);
      }
    }
  }
});

const RED = [200, 16, 46] as const;
const BLUE = [0, 48, 135] as const;

/** A red disc on a blue one on white. */
const TARGET: ImageLike = painted(80, 80, (x, y) => {
  const [blue, red] = [inCircle(x, y, 40, 40, 32), inCircle(x, y, 44, 40, 15)];
  const channels = [0, 1, 2].map((k) => 255 * (1 - blue) + (BLUE[k] ?? 0) * (blue - red) + (RED[k] ?? 0) * red);
  return [channels[0] ?? 0, channels[1] ?? 0, channels[2] ?? 0, 255];
});

test("flat colours are found, and lie on one another", () => {
  const trace = traceImage(TARGET, { colors: 8 });
  assert.deepEqual(trace.layers, [{ color: "#003087" }, { color: "#ffffff" }, { color: "#c8102e" }].sort((a, b) => order(trace, a.color) - order(trace, b.color)));
  assert.equal(trace.layers.length, 3);
  assert.equal(trace.layers.at(-1)?.color, "#c8102e", "the smallest on top");
  const red = trace.contours.filter(({ layer }) => trace.layers[layer]?.color === "#c8102e");
  assert.equal(red.length, 1);
  const ellipse = (red[0]?.curve as HermiteCurve).asEllipse(1e-6);
  assert.ok(ellipse !== undefined && Math.abs(ellipse.radii[0] - 15) < 0.1, JSON.stringify(ellipse));
  const svg = trace.toSvg();
  assert.equal(dataOf(svg).length, 3);
  assert.match(svg, /<path fill="#fff" d="M/);
  assert.match(svg, /<path fill="#c8102e" d="M[^"]+"\/><\/svg>$/);
  assert.ok((trace.milliseconds["layers"] ?? -1) >= 0);
});

/** Where a colour is in the list; the test above names them, whatever their order. */
function order({ layers }: Trace, color: string): number {
  return layers.findIndex((layer) => layer.color === color);
}

test("a palette that is given is the one that is used, in one pass and in short tasks", async () => {
  const options = { colors: ["#c8102e", "#FFF", "#003087", "#00ff00"] };
  const trace = traceImage(TARGET, options);
  assert.equal(trace.layers.length, 3, "nothing is green");
  assert.equal(bits(await traceImageAsync(TARGET, options)), bits(trace));
  assert.equal(bits(traceImage(TARGET, { colors: 5 })), bits(trace), "the colours are those that are found");
});

test("gray pictures have layers too, and transparent ones no background", () => {
  const gray = { ...RING, data: Uint8Array.from({ length: 96 * 96 }, (_, i) => RING.data[4 * i] ?? 0) };
  assert.equal(bits(traceImage(gray, { colors: 2 })), bits(traceImage(RING, { colors: 2 })));
  const floating = painted(40, 40, (x, y) => [...RED, 255 * inCircle(x, y, 20, 20, 12)]);
  const trace = traceImage(floating, { colors: 4 });
  assert.deepEqual(trace.layers, [{ color: "#c8102e" }]);
  assert.equal(trace.contours.length, 1);
  assert.deepEqual(traceImage(filled(9, 9, [0, 0, 0, 0]), { colors: 4 }).contours, []);
});
