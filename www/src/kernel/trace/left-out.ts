import { ExplineError } from "expline/slim";
import type { tracePixels, Trace, TraceOptions } from "./engine.ts";
import type { LeftOut } from "./job.ts";
import type { Pixels } from "./picture.ts";

/** What a trace left out as specks, where it may be small letters, dots and holes rather than dust. */

/** Square pixels of what the tracer takes for dust wherever nobody says otherwise. */
const dust = 2;
/**
 * From each place to the nearest other it is less than this part of what it would be by chance: .4 and less in lines of
 * letters, dashes and dots, .65 and more in grain and dust.
 */
const together = 0.5;

export interface Asked {
  readonly trace: typeof tracePixels;
  readonly pixels: Pixels;
  /** As the trace was asked for: `speckle` in the pixels that were looked at, `maxContours` as of a photograph. */
  readonly options: TraceOptions & { readonly speckle: number; readonly maxContours: number };
  /** With a lower speckle there are too many pieces of ink. */
  readonly least: number;
}

/**
 * Nothing where nothing was left out, where it was grain and dust, or where with it there would be too many contours.
 * There are more specks than shapes in grain, and they lie where chance put them; the letters of a line below a mark
 * may be more than the mark's contours, but they lie beside one another. Counting takes a hundredth of a trace or so.
 */
export async function leftOut({ contours }: Trace, asked: Asked): Promise<LeftOut | null> {
  const { pixels: { width, height, columns, rows }, options: { speckle, maxContours, source, colors } } = asked;
  // What is left of edges is mostly grain, and lines are kept however short they are.
  if (colors === undefined && source !== "brightness") return null;
  const perPixel = (width * height) / (columns * rows);
  // Whole pixels of the picture, as the slider has them.
  const whole = (least: number): number => Math.ceil(least * perPixel);
  let keeping = whole(Math.max(dust, asked.least));
  if (keeping >= speckle * perPixel) return null;
  let { count, offer } = await counted(asked, keeping / perPixel, maxContours);
  if (count > maxContours) {
    keeping = whole(offer);
    if (keeping >= speckle * perPixel) return null;
    ({ count, offer } = await counted(asked, keeping / perPixel, maxContours));
  }
  const left = count - (await counted(asked, speckle, maxContours)).count;
  if (left <= 0 || count > maxContours) return null;
  const isMeant = left <= contours.length || await areTogether(asked, keeping / perPixel);
  return isMeant ? { count: left, below: Math.round(speckle * perPixel), keeping } : null;
}

interface Counted {
  readonly count: number;
  /** Where that is more than `most`: the speckle from which on it is not; infinite where the tracer knows of none. */
  readonly offer: number;
}

/** How many contours there are. The tracer says so when it refuses, long before it has traced them. */
async function counted({ trace, pixels, options }: Asked, speckle: number, most: number): Promise<Counted> {
  const count = await refused(trace, pixels, { ...options, speckle, maxContours: 1 });
  const isOver = (count?.actual ?? 0) > most;
  const over = isOver ? await refused(trace, pixels, { ...options, speckle, maxContours: most }) : null;
  return { count: count?.actual ?? 1, offer: over?.offer?.["speckle"] ?? Infinity };
}

/** The refusal of a picture with too many contours; null where it has no more. */
async function refused(trace: Asked["trace"], pixels: Pixels, options: TraceOptions): Promise<ExplineError | null> {
  const enough = new AbortController();
  const { signal } = options;
  const stop = (): void => enough.abort();
  signal?.addEventListener("abort", stop, { once: true });
  try {
    // Contours are counted before their corners are looked for.
    await trace(pixels, { ...options, signal: enough.signal, onProgress: ({ stage }) => stage === "corners" && stop() });
    return null;
  } catch (error) {
    if (!(error instanceof ExplineError)) throw error;
    if (error.limit === "maxContours") return error;
    if (error.code === "E_CANCELLED" && signal?.aborted !== true) return null;
    throw error;
  } finally {
    signal?.removeEventListener("abort", stop);
  }
}

/**
 * Whether what is smaller than the speckle lies nearer together than chance would have put it (Clark and Evans, 1954).
 */
async function areTogether({ trace, pixels, options }: Asked, speckle: number): Promise<boolean> {
  const found = await trace(pixels, { ...options, speckle, refine: false });
  const places = found.contours.flatMap(({ curve }) => (Math.abs(curve.area()) < options.speckle ? [[curve.points[0] ?? 0, curve.points[1] ?? 0] as const] : []));
  const nearest = places.map(([x, y], i) => places.reduce((best, [a, b], j) => (i === j ? best : Math.min(best, Math.hypot(a - x, b - y))), Infinity));
  const mean = nearest.reduce((sum, distance) => sum + distance, 0) / nearest.length;
  const byChance = Math.sqrt((pixels.columns * pixels.rows) / places.length) / 2;
  return mean < together * byChance;
}
