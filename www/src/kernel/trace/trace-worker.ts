/** The worker that traces: one picture at a time, the newest request first. */
import init, { ExplineError } from "expline/slim";
import wasmUrl from "expline/expline_bg.wasm?url";
import { shadesInEvenLight, startTraceEngine, tracePixels, type TraceOptions } from "./engine.ts";
import { traceStages, type TraceAnswer, type TraceHow, type TraceRequest, type TraceStage } from "./job.ts";
import { leftOut } from "./left-out.ts";
import { measured } from "./measured.ts";
import { hasFlatColors } from "./pixels/flat-colors.ts";
import { imageOf } from "./raster.ts";
import { PictureError, pixelsOf, sizeOf, type Pixels } from "./picture.ts";
import { blurred, foundThreshold, inkOf, pieceAreas, shadesOf, steepness, type Shades } from "./pixels/shades.ts";

const ready = Promise.all([init({ wasmUrl }), startTraceEngine()]);

/** The picture that was looked at last: a slider asks for the same one again and again. */
let last: Looked | null = null;

interface Looked {
  readonly key: string;
  readonly size: number;
  readonly invert: boolean;
  readonly pixels: Pixels;
  readonly shades: Shades;
  /** The shades as if the light on the paper were even. */
  readonly even: Shades;
  readonly colored: boolean;
}

/** Ends whatever is under way. */
let under = new AbortController();
/** Requests are worked off one after the other; a new one ends the one before. */
let queue: Promise<void> = Promise.resolve();

const answer = (message: TraceAnswer, transfer: Transferable[] = []): void => postMessage(message, { transfer });

/** The part of the whole that each stage begins with. */
const begins: Readonly<Record<TraceStage, number>> = {
  decoding: 0,
  edges: 0.05,
  contours: 0.15,
  corners: 0.25,
  splines: 0.35,
  refinement: 0.55,
  layers: 0.15,
  measuring: 0.96,
};

/** Progress that never goes back, however stages come. */
function progressOf(id: number): (stage: string, done: number, total: number) => void {
  let most = 0;
  return (name, done, total) => {
    const stage = traceStages.find((each) => each === name) ?? "decoding";
    const end = Math.min(...Object.values(begins).filter((begin) => begin > begins[stage]), 1);
    const share = total > 0 ? Math.min(1, done / total) : 0;
    // Colour by colour, the other stages have no part of their own.
    const value = begins[stage] + share * ((stage === "layers" ? begins.measuring : end) - begins[stage]);
    most = Math.max(most, value);
    answer({ kind: "progress", id, stage, value: most, done, total });
  };
}

async function looked(request: Extract<TraceRequest, { kind: "trace" }>): Promise<Looked> {
  const { picture, how } = request;
  if (last !== null && last.key === picture.key && last.size === how.size && last.invert === how.invert) return last;
  const pixels = last !== null && last.key === picture.key && last.size === how.size ? last.pixels : await pixelsOf(picture, how.size);
  const shades = shadesOf(pixels, how.invert);
  const values = shadesInEvenLight(pixels);
  return (last = { key: picture.key, size: how.size, invert: how.invert, pixels, shades, even: values === null ? shades : { ...shades, values }, colored: hasFlatColors(pixels) });
}

/** A breath in which a request that has come meanwhile is heard; true when one has ended this job. */
async function ended(signal: AbortSignal): Promise<boolean> {
  await new Promise((resolve) => setTimeout(resolve));
  return signal.aborted;
}

async function trace(request: Extract<TraceRequest, { kind: "trace" }>, signal: AbortSignal): Promise<void> {
  const { id, how } = request;
  const start = performance.now();
  const report = progressOf(id);
  report("decoding", 0, 1);
  const picture = await looked(request);
  const { pixels, shades, even } = picture;
  report("decoding", 1, 1);
  if (await ended(signal)) return answer({ kind: "stopped", id });
  // The tracer does the same: a threshold that is given is meant for the shades as they are.
  const invert = how.invert || shades.lightOnNothing === true;
  const seen = how.threshold === "auto" && !invert && how.source !== "edges" ? even : shades;
  const soft = how.blur === "auto" ? seen : blurred(seen, how.blur);
  const threshold = how.threshold === "auto" ? foundThreshold(soft) : how.threshold;
  const ink = inkOf(soft, threshold, invert);
  const byShade = how.source === "brightness" && how.colors === 0;
  await show(id, picture, byShade ? ink.map((on) => 255 * (1 - on)) : steepness(soft), threshold);
  if (await ended(signal)) return answer({ kind: "stopped", id });
  const scale = [pixels.width / pixels.columns, pixels.height / pixels.rows] as const;
  const least = how.speckle / (scale[0] * scale[1]);
  const areas = byShade ? pieceAreas(ink, pixels.columns, pixels.rows) : [];
  if (tooMany(request, areas, pixels, least)) return;
  const asked = { ...options(how, least), signal };
  const found = await tracePixels(pixels, { ...asked, onProgress: ({ stage, done, total }) => report(stage, done, total) });
  report("measuring", 0, 1);
  const border = byShade ? { border: { shades: soft, threshold } } : {};
  const result = await measured(found, scale, { ink, columns: pixels.columns, rows: pixels.rows, ...border }, how.corner);
  const left = await leftOut(found, { trace: tracePixels, pixels, options: asked, least: overMost(areas, how) });
  if (signal.aborted) return answer({ kind: "stopped", id });
  answer({ kind: "traced", id, result: left === null ? result : { ...result, leftOut: left }, ms: performance.now() - start });
}

function options(how: TraceHow, speckle: number): TraceOptions & { speckle: number; maxContours: number } {
  const ink = { source: how.source, invert: how.invert, ...(how.threshold === "auto" ? {} : { threshold: how.threshold }) };
  return {
    speckle, corner: how.corner, tolerance: how.tolerance,
    ...(how.blur === "auto" ? {} : { blur: how.blur }),
    ...(how.colors === 0 ? ink : { colors: how.colors }),
    maxContours: how.mostContours,
  };
}

/** Says that this is a photograph, and from which speckle on it would not be. */
function tooMany({ id, how }: Extract<TraceRequest, { kind: "trace" }>, areas: ArrayLike<number>, { columns, rows, width, height }: Pixels, least: number): boolean {
  const count = Array.from(areas).filter((area) => area >= least).length;
  if (count <= how.mostContours) return false;
  answer({ kind: "photo", id, count, speckle: Math.ceil(overMost(areas, how) * ((width * height) / (columns * rows))) });
  return true;
}

/**
 * The area, in pixels that were looked at, from which on there are no more pieces than contours of a drawing; 0 where
 * there are no more of any.
 */
function overMost(areas: ArrayLike<number>, { mostContours }: TraceHow): number {
  const area = areas[mostContours];
  return area === undefined ? 0 : area + 1;
}

/**
 * The speckle in square pixels of the picture from which on so many contours would be left; 0 where the tracer knows of
 * none.
 */
async function offered({ offer }: ExplineError, request: Extract<TraceRequest, { kind: "trace" }>): Promise<number> {
  const { pixels: { width, height, columns, rows } } = await looked(request);
  return Math.ceil((offer?.["speckle"] ?? 0) * (width / columns) * (height / rows));
}

async function show(id: number, { pixels, colored }: Looked, edges: Uint8Array, threshold: number): Promise<void> {
  const { width, height, columns, rows, data } = pixels;
  const [source, seen] = await Promise.all([bitmapOf(data, columns, rows), bitmapOf(edges, columns, rows)]);
  answer({ kind: "picture", id, width, height, analysed: [columns, rows], source, edges: seen, threshold, colored }, [source, seen]);
}

/** One byte per pixel, or four, as a picture. */
function bitmapOf(data: Uint8Array | Uint8ClampedArray, columns: number, rows: number): Promise<ImageBitmap> {
  return createImageBitmap(imageOf({ width: columns, height: rows, data }));
}

async function probe({ id, picture }: Extract<TraceRequest, { kind: "probe" }>): Promise<void> {
  const [width, height] = await sizeOf(picture);
  answer({ kind: "probed", id, width, height });
}

async function work(request: TraceRequest, signal: AbortSignal): Promise<void> {
  if (request.kind === "stop") return;
  const { id } = request;
  if (signal.aborted) return answer({ kind: "stopped", id });
  try {
    await ready;
    await (request.kind === "probe" ? probe(request) : trace(request, signal));
  } catch (error) {
    if (error instanceof ExplineError && error.code === "E_CANCELLED") return answer({ kind: "stopped", id });
    const code = error instanceof ExplineError || error instanceof PictureError ? error.code : "";
    if (error instanceof ExplineError && error.limit === "maxContours" && request.kind === "trace") answer({
      kind: "photo",
      id,
      count: error.actual ?? 0,
      speckle: await offered(error, request),
    });
    else answer({ kind: "failed", id, code, message: String(error) });
  }
}

onmessage = (event: MessageEvent<TraceRequest>) => {
  // Looking whether something is a picture disturbs nobody.
  if (event.data.kind === "probe") return void work(event.data, new AbortController().signal);
  under.abort();
  under = new AbortController();
  const { signal } = under;
  queue = queue.then(() => work(event.data, signal));
};
