/** From a picture to few curves: all at once, or in short tasks. */
import { ExplineError, type OwnBytes } from "./core.js";
import { Picture, type Step, initTrace } from "./trace/trace-engine.js";
import { type ImageLike, STAGES, type TraceOptions, type TraceOrder, type TraceStage, traceOrder } from "./trace/trace-options.js";
import { type Trace, readTrace } from "./trace/trace-result.js";
import { checkSignal, inOneGo, inTasks } from "./tasks/yielding.js";

export { fitProfile, looScore, metrics, quasiInterpolate } from "./trace/profile.js";
export type { ProfileFit, ProfileOptions, ProfileTube, QuasiInterpolantOptions } from "./trace/profile.js";
export { initTrace, initTraceSync } from "./trace/trace-engine.js";
export type { ImageLike, TraceOptions, TraceProgress, TraceStage } from "./trace/trace-options.js";
export type { Trace, TraceLayer, TraceMetrics, TraceSvgOptions, TracedContour } from "./trace/trace-result.js";

/** Work of one call into the engine, in microseconds or so. */
const BUDGET = 4000;

/** Steps of a trace; between two of them the caller may wait, stop or be told. */
function* steps(op: string, picture: Picture, { onProgress, pixels, filled }: TraceOrder): Generator<void, Trace> {
  const spent = new Map<TraceStage, number>();
  let before = performance.now();
  for (;;) {
    const step = stepOf(op, picture);
    const now = performance.now();
    const stage = STAGES[step.stage] ?? "pixels";
    spent.set(stage, (spent.get(stage) ?? 0) + now - before);
    onProgress?.({ stage, done: step.completed, total: step.total });
    if (step.done) return readTrace(picture.describe(op), pixels, spent, filled);
    yield;
    before = performance.now();
  }
}

/** One step; where the picture has too many contours or needs too much memory, what would help is said. */
function stepOf(op: string, picture: Picture): Step {
  try {
    return picture.step(op, BUDGET);
  } catch (error) {
    if (!(error instanceof ExplineError)) throw error;
    const { code, limit, max = 0, actual = 0 } = error;
    if (code === "E_MEMORY") {
      throw new ExplineError(code, op, `the image needs more memory than there is, for ${actual} bytes more; half its size needs less than half`, { actual });
    }
    if (limit !== "maxContours") throw error;
    const speckle = picture.offer(op);
    const help = speckle === undefined ? "" : `, and a speckle of ${Number(speckle.toPrecision(3))} would leave as many`;
    throw new ExplineError("E_LIMIT", op, `the image has ${actual} contours, like a photograph; maxContours is ${max}${help}`, {
      ...{ arg: "image", argument: "image", limit: "maxContours", max, actual },
      offer: { maxContours: actual, ...(speckle === undefined ? {} : { speckle }) },
    });
  }
}

/**
 * The outlines of a drawing, as few curves as explain its pixels.
 *
 * The threshold between ink and paper, the noise and the corners are found in the picture; where something is
 * transparent, that is paper. Corners stay corners, straight lines are lines, circles are circles, and the curves are
 * refined until they cover of every pixel what the picture says. The same picture gives the same bits everywhere.
 *
 * @throws {ExplineError} E_LIMIT with `limit` "maxContours", `actual` and `offer` for a photograph; "maxContourPoints"
 *   where contours cross more places between pixels than half as many as there are pixels, and 65,536 (noise,
 *   dithering: a `blur` helps); "maxPixels" above 40 megapixels. E_MEMORY where outlines are so many or so long that
 *   the 512 MiB of an engine do not do; half the size needs less than half. E_LENGTH of `data` that `width` and
 *   `height` do not explain.
 * @example
 * ```js
 * const fromMiddle = (i) => Math.hypot((i % 64) - 31.5, (i >> 6) - 31.5);
 * const shade = (i) => 255 * Math.min(1, Math.max(0, fromMiddle(i) - 19.5)); // a disc of radius 20
 * const data = Uint8Array.from({ length: 64 * 64 }, (_, i) => shade(i));
 * const image = { width: 64, height: 64, data }; // or an ImageData
 * const [{ curve, closed }] = traceImage(image).contours;
 * console.log(closed, curve.asEllipse(0.05).radii.map((radius) => radius.toFixed(1))); // → true [ '20.0', '20.0' ]
 * ```
 */
export function traceImage(image: ImageLike, options?: TraceOptions): Trace {
  const op = "traceImage";
  const order = traceOrder(op, image, options);
  checkSignal(op, order.signal);
  const picture = new Picture(op, order.pixels, order.record);
  try {
    return inOneGo(steps(op, picture, order));
  } finally {
    picture.close();
  }
}

/**
 * {@link traceImage} in short tasks on the caller's own thread: a page goes on painting and answering meanwhile. In a
 * worker it lets messages through, so that one of them can abort the signal. The picture is read in the first tasks,
 * and must be left alone until the answer is there.
 *
 * @throws {ExplineError} as traceImage does, by rejecting; E_CANCELLED when the signal was aborted, within a few
 *   milliseconds.
 */
export async function traceImageAsync(image: ImageLike, options?: TraceOptions): Promise<Trace> {
  const op = "traceImageAsync";
  const order = traceOrder(op, image, options);
  checkSignal(op, order.signal);
  await initTrace();
  checkSignal(op, order.signal);
  const picture = new Picture(op, order.pixels, order.record);
  try {
    return await inTasks(op, order.signal, steps(op, picture, order));
  } finally {
    picture.close();
  }
}

/**
 * A picture of dark ink on paper as if as much light fell on all of it: shades from 0, black, to 255, white, a byte
 * each. Undefined where the light is even already, or where most of the picture is not paper. {@link traceImage} does
 * this by itself, unless a threshold is given; here it is for showing what is traced.
 *
 * @throws {ExplineError} as traceImage does for its image.
 */
export function evenLight(image: ImageLike): { width: number; height: number; data: OwnBytes } | undefined {
  const op = "evenLight";
  const { pixels, record } = traceOrder(op, image, undefined);
  const picture = new Picture(op, pixels, record);
  try {
    const data = picture.inEvenLight(op);
    return data === undefined ? undefined : { width: pixels.width, height: pixels.height, data };
  } finally {
    picture.close();
  }
}
