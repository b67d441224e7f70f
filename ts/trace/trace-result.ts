/** What a trace gives, read from what the engine leaves. */
import { type HermiteCurve, integer, options as checkOptions, pathsOf, tolerance as checkTolerance } from "../core.js";
import { Sections } from "../tasks/sections.js";
import type { TraceStage } from "./trace-options.js";

/** How far a curve is from the sub-pixel contour that it follows, in pixels. */
export interface TraceMetrics {
  /** Root of the mean square distance of the contour's points. */
  rmse: number;
  /** Their mean distance. */
  mae: number;
  /** Their largest distance. */
  max: number;
  /**
   * The largest distance between both, in both directions: more than `max` where a sharp corner stands beyond its
   * contour, which pixels cut off.
   */
  hausdorff: number;
  /** The share of the pixels on both that are next to each other: 1 is best. */
  jaccard: number;
}

/** One contour of a picture. */
export interface TracedContour {
  /** In pixels: (0, 0) is the outer corner of the first one, its centre is at (0.5, 0.5), y goes down. */
  curve: HermiteCurve;
  /** A stroke's centre line, or an edge that ends, is not; it is drawn as a line and not filled. */
  closed: boolean;
  /**
   * Whether it bounds a hole. Ink is run around one way and holes the other, so that both rules of filling give the
   * same.
   */
  hole: boolean;
  /** Its corners. */
  cusps: [number, number][];
  /** How far it is from the contour in the picture. */
  metrics: TraceMetrics;
  /** Which of the trace's layers it belongs to: 0 where there is only ink. */
  layer: number;
}

/** One colour of a picture. */
export interface TraceLayer {
  /** "#rrggbb"; of what is translucent, that on white. */
  color: string;
}

/** How {@link Trace.toSvg} writes. */
export interface TraceSvgOptions {
  /**
   * Largest distance in pixels, above 0, between the curves and what the text draws, with decimals enough for it.
   * Default 0.02, and .007 for two decimals.
   */
  tolerance?: number | undefined;
  /**
   * Digits behind the point, up to 17. Default: as many as the tolerance needs that is asked for, else 2. They cost
   * half a unit of the last one in x and in y besides the tolerance: 2 draw up to .0071 pixels farther off, 1 up to
   * .071 and 0 up to .71.
   */
  decimals?: number | undefined;
}

/**
 * The curves of a picture. `postMessage` takes neither curves nor functions: of the contours send
 * `{ ...contour, curve: contour.curve.toJSON() }`, which `fromJSON` reads.
 */
export interface Trace {
  /** Of the picture, in pixels. */
  width: number;
  /** Of the picture, in pixels. */
  height: number;
  /** All contours, those of a lower layer first. */
  contours: TracedContour[];
  /** The colours, the lowest layer first; none without `colors`. */
  layers: TraceLayer[];
  /**
   * The picture as an SVG document, with as few bytes as it can be said in.
   *
   * @throws {ExplineError} E_RANGE of a `tolerance` that is not above 0, and of `decimals` outside 0 to 17.
   */
  toSvg(options?: TraceSvgOptions): string;
  /** How long each stage took, and `total`. */
  milliseconds: Record<string, number>;
}

/** Reads a trace from what the engine says of it. @internal */
export function readTrace(numbers: Float64Array, { width, height }: { width: number; height: number }, spent: ReadonlyMap<TraceStage, number>, filled: boolean): Trace {
  const sections = new Sections(numbers);
  const layers = sections.records(3, (color): TraceLayer => ({ color: hex(color) }));
  const contours: TracedContour[] = [];
  while (sections.more) {
    const curve = sections.curve();
    const [closed = 0, hole = 0, rmse = 0, mae = 0, max = 0, hausdorff = 0, jaccard = 0, layer = 0] = sections.next();
    const cusps = sections.places();
    contours.push({ curve, closed: closed === 1, hole: hole === 1, cusps, metrics: { rmse, mae, max, hausdorff, jaccard }, layer });
  }
  const milliseconds = Object.fromEntries(spent);
  milliseconds["total"] = [...spent.values()].reduce((sum, time) => sum + time, 0);
  // What is written is what was found, whatever becomes of the lists.
  const paths = pathsToWrite(contours, layers, filled);
  return { width, height, contours, layers, toSvg: (options) => written(width, height, paths, options), milliseconds };
}

const hex = (color: Float64Array): string => `#${Array.from(color, (channel) => channel.toString(16).padStart(2, "0")).join("")}`;

/** One element of the document: outlines are filled, lines drawn. */
interface Path {
  readonly attributes: string;
  readonly curves: readonly HermiteCurve[];
}

function pathsToWrite(contours: readonly TracedContour[], layers: readonly TraceLayer[], filled: boolean): Path[] {
  const curvesOf = (layer: number, area: boolean): HermiteCurve[] =>
    contours.filter((contour) => contour.layer === layer && (filled && contour.closed) === area).map(({ curve }) => curve);
  const colors = layers.length === 0 ? [""] : layers.map(({ color }) => (color === "#000000" ? "" : ` fill="${short(color)}"`));
  const paths = colors.map((attributes, i) => ({ attributes, curves: curvesOf(i, true) }));
  paths.push({ attributes: ' fill="none" stroke="#000"', curves: curvesOf(0, false) });
  return paths.filter(({ curves }) => curves.length > 0);
}

/** #f00 for #ff0000. */
const short = (color: string): string => color.replace(/^#(.)\1(.)\2(.)\3$/u, "#$1$2$3");

function written(width: number, height: number, paths: readonly Path[], options: unknown): string {
  const op = "toSvg";
  const { tolerance, decimals } = checkOptions(op, options, ["tolerance", "decimals"]);
  const within = checkTolerance(op, tolerance === undefined ? 0.02 : tolerance);
  // The engine takes as many as a tolerance needs that is asked for.
  const digits = decimals === undefined && tolerance !== undefined ? -1 : integer(op, "decimals", decimals === undefined ? 2 : decimals, 0, 17);
  const body = paths.map(({ attributes, curves }) => `<path${attributes} d="${pathsOf(op, curves, within, digits)}"/>`).join("");
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}">${body}</svg>`;
}
