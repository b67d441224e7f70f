/** What can be asked of a trace, checked and written down as the engine reads it. */
import { type Signal, count, flag, inRange, integer, lengthOfArray, options as checkOptions, overLimit, tagOf, word, wrong, wrongLength } from "../core.js";
import type { Pixels } from "./trace-engine.js";
import { type Watch, watch } from "../tasks/yielding.js";

/**
 * What a trace is doing: reading pixels, finding edges, following contours, looking for corners, fitting splines,
 * refining them; with `colors` all of that for one layer after the other.
 */
export type TraceStage = "pixels" | "edges" | "contours" | "corners" | "splines" | "refinement" | "layers";

/** The stages in the engine's order; the first is the face's own. @internal */
export const STAGES: readonly TraceStage[] = ["pixels", "edges", "contours", "corners", "splines", "refinement", "layers"];

/** How far a trace has come. */
export interface TraceProgress {
  /** Stages come in their order, and some more than once where there are colours. */
  stage: TraceStage;
  /** How much of the stage is done, of `total`. */
  done: number;
  /** All of the stage, in a unit of its own. */
  total: number;
}

/** A picture: an `ImageData`, or anything with the same three fields. */
export interface ImageLike {
  /**
   * Red, green, blue and opacity of every pixel, or one shade from 0, black, to 255, white: which of both, the length
   * says.
   */
  readonly data: Uint8ClampedArray | Uint8Array;
  /** Pixels in a row, 1 to 16,384. */
  readonly width: number;
  /** Rows, 1 to 16,384; 40 million pixels at most. */
  readonly height: number;
}

/** What {@link traceImage} can be told. */
export interface TraceOptions {
  /**
   * What is followed: the outlines of ink, the default; edges, where the shade changes fastest; or the centre lines of
   * thin strokes.
   */
  source?: "brightness" | "edges" | "lines" | undefined;
  /** Shade between ink and paper, 0 … 255. Default "auto": found in the picture. */
  threshold?: number | "auto" | undefined;
  /** Standard deviation in pixels of a blur before all else, 0 … 10. Default: found, as much as the noise needs. */
  blur?: number | undefined;
  /** Light ink on dark paper. Default false; a light drawing on a transparent ground is ink without being asked for. */
  invert?: boolean | undefined;
  /**
   * Contours that enclose fewer square pixels are left out, and edges shorter than the outline of a square of so many:
   * 0 to 1e9. Default 2; of ink in thin strokes without noise, as small letters have, smaller dots are kept as well,
   * down to what is hardly above the threshold.
   */
  speckle?: number | undefined;
  /** The least turning of a corner, in radians, 0.05 … π: π knows no corners. Default 0.49, 28°. */
  corner?: number | undefined;
  /**
   * How far the first curve of a contour may be from its points in pixels, about: pieces are fitted to points half a
   * pixel apart, and the ends of a piece, corners and pieces of two pixels may be farther. A refined curve begins
   * within .18 and goes where the picture says; above the default joints may leave more in proportion. In noise twice
   * as much is allowed. What was reached is `metrics.max`. 0.01 to 1000; default 0.22. Where a drawing was scaled up by
   * repeating pixels, this counts in those pixels.
   */
  tolerance?: number | undefined;
  /**
   * A picture of a few flat colours: how many at most, 2 … 64, are looked for, or which they are, 1 to 64 as "#rrggbb"
   * or "#rgb". Each becomes a layer, and layers lie on one another without gaps. They are opaque: what is translucent,
   * and the same all around, has the colour that it has on white. Where they are looked for and light falls unevenly,
   * they are as where most light falls; colours that are given are meant as they are. Default: ink on paper, which
   * `source`, `threshold` and `invert` are about: beside `colors` they are E_RANGE.
   */
  colors?: number | readonly string[] | undefined;
  /** Which fit follows a contour: the sparsest spline, the default, or the weighted quasi-interpolant. */
  model?: "sparse" | "wqisa" | undefined;
  /** Whether curves are refined until they cover of every pixel what the picture says. Default true. */
  refine?: boolean | undefined;
  /**
   * More contours than this is taken for a photograph: E_LIMIT with `actual`, how many there are. Default 1500, at most
   * 200,000.
   */
  maxContours?: number | undefined;
  /** Ends the work: E_CANCELLED. A synchronous trace looks at it once, before it begins. */
  signal?: Signal | undefined;
  /** Told how far the work is. What it throws ends the trace and reaches the caller as it is. */
  onProgress?: ((progress: TraceProgress) => void) | undefined;
}

const MAX_SIDE = 16_384;
const MAX_PIXELS = 40_000_000;
const MAX_CONTOURS = 200_000;
const MAX_AREA = 1e9;
/** What turns less is what pixels make of a straight line. @internal */
export const LEAST_CORNER = 0.05;
const MAX_COLORS = 64;

const SOURCES = ["brightness", "edges", "lines"] as const;
const MODELS = ["sparse", "wqisa"] as const;
const NAMES = [
  ...["source", "threshold", "blur", "invert", "speckle", "corner", "tolerance", "model", "refine", "maxContours", "colors"] as const,
  ...["signal", "onProgress"] as const,
] as const;

/** A trace as the engine is told of it. @internal */
export interface TraceOrder extends Watch<TraceProgress> {
  readonly pixels: Pixels;
  /** Options in a fixed order. */
  readonly record: Float64Array;
  /** Whether outlines are followed, which enclose ink; edges and centre lines enclose none, closed or not. */
  readonly filled: boolean;
}

/** All checks of a trace's arguments that need no arithmetic. @internal */
export function traceOrder(op: string, image: unknown, options: unknown): TraceOrder {
  const pixels = pixelsOf(op, image);
  const own = checkOptions(op, options, NAMES);
  const { source, threshold, blur, invert, speckle, corner, tolerance, model, refine, maxContours } = own;
  const optional = (name: string, value: unknown, least: number, most: number): number =>
    value === undefined ? -1 : inRange(op, name, value, least, most);
  const [mostColors, palette] = colorsOf(op, own.colors);
  const record = Float64Array.of(
    pixels.width,
    pixels.height,
    pixels.channels,
    source === undefined ? 0 : SOURCES.indexOf(word(op, "source", source, SOURCES)),
    model === undefined ? 0 : MODELS.indexOf(word(op, "model", model, MODELS)),
    optional("threshold", threshold === "auto" ? undefined : threshold, 0, 255),
    optional("blur", blur, 0, 10),
    flag(op, "invert", invert, false) ? 1 : 0,
    optional("speckle", speckle, 0, MAX_AREA),
    optional("corner", corner, LEAST_CORNER, Math.PI),
    optional("tolerance", tolerance, 0.01, 1000),
    flag(op, "refine", refine, true) ? 1 : 0,
    maxContours === undefined ? -1 : count(op, "maxContours", maxContours, 1, "maxContours", MAX_CONTOURS),
    mostColors,
    palette.length / 3,
    ...palette,
  );
  if (own.colors !== undefined) checkInk(op, own);
  return { pixels, record, filled: source === undefined || source === "brightness", ...watch(op, own) };
}

/**
 * What tells ink from paper has no say where each colour is a layer of its own: to take it in silence would promise
 * more than is done.
 */
function checkInk(op: string, { source, threshold, invert }: { readonly [N in "source" | "threshold" | "invert"]?: unknown }): void {
  const idle = [["source", source, "brightness"], ["threshold", threshold, "auto"], ["invert", invert, false]] as const;
  for (const [name, value, only] of idle) {
    if (value !== undefined && value !== only) throw wrong("E_RANGE", op, name, value, `${JSON.stringify(only)} beside colors`);
  }
}

/** How many colours are looked for, and those that are given, three numbers each. */
function colorsOf(op: string, value: unknown): [number, number[]] {
  if (value === undefined) return [0, []];
  if (!Array.isArray(value)) {
    if (typeof value !== "number") throw wrong("E_TYPE", op, "colors", value, "a number, or a list of colours");
    return [integer(op, "colors", value, 2, MAX_COLORS), []];
  }
  const list = value as readonly unknown[];
  if (list.length < 1 || list.length > MAX_COLORS) throw wrongLength(op, "colors", list.length, `1 to ${MAX_COLORS}`);
  const palette = Array.from(list, (color, i) => {
    if (typeof color !== "string") throw wrong("E_TYPE", op, "colors", color, 'text like "#cc0000"', i);
    const digits = /^#(?:[0-9a-f]{3}|[0-9a-f]{6})$/iu.test(color) ? color.slice(1) : undefined;
    if (digits === undefined) throw wrong("E_RANGE", op, "colors", color, '"#rgb" or "#rrggbb"', i);
    const wide = digits.length === 3 ? digits.replace(/./gu, "$&$&") : digits;
    return [0, 2, 4].map((at) => Number.parseInt(wide.slice(at, at + 2), 16));
  });
  return [0, palette.flat()];
}

/** Whether it really holds bytes. */
function isBytes(value: unknown): value is Uint8Array | Uint8ClampedArray {
  return /^Uint8(?:Clamped)?Array$/.test(String(tagOf(value)));
}

function pixelsOf(op: string, image: unknown): Pixels {
  if (typeof image !== "object" || image === null) throw wrong("E_TYPE", op, "image", image, "an image with data, width and height");
  const { data, width: columns, height: rows } = image as { data?: unknown; width?: unknown; height?: unknown };
  const width = integer(op, "width", columns, 1, MAX_SIDE);
  const height = integer(op, "height", rows, 1, MAX_SIDE);
  if (width * height > MAX_PIXELS) throw overLimit(op, "image", "maxPixels", MAX_PIXELS, width * height);
  if (!isBytes(data)) throw wrong("E_TYPE", op, "data", data, "Uint8ClampedArray | Uint8Array");
  const length = lengthOfArray(op, "data", data);
  const channels = length / (width * height);
  if (channels !== 4 && channels !== 1) throw wrongLength(op, "data", length, `${4 * width * height}, four bytes a pixel, or ${width * height}, one`);
  // Seen through an array of our own: a subclass may have another idea of what parts of it are.
  return { data: new Uint8Array(data.buffer, data.byteOffset, length), width, height, channels };
}
