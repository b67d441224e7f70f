import { HermiteCurve } from "expline/slim";
import { contourFrom } from "../curve/points/contours.ts";
import { withFoundCorners } from "../../document/trace/corners.ts";
import type { Trace } from "./engine.ts";
import type { TracedOutline, TraceResult, TraceSizes } from "./job.ts";
import { coverage } from "./raster.ts";
import { segmentsIn } from "./segments.ts";
import { distanceToBorder, type Shades } from "./pixels/shades.ts";

/** What a trace came to: outlines in pixels of the picture, and the numbers that are printed about them. */

/** Half a thousandth of a pixel cannot be seen at the largest zoom. */
const drawnWithin = 2e-3;
/** Of the path text: the defaults of Export. */
const printed = { tolerance: 0.02, decimals: 3 } as const;
const polygonWithin = 0.1;
/**
 * The tracer finds a corner where its sides meet, and the curve is fitted after that: it passes within an eighth of a
 * pixel or so.
 */
const cornerWithin = 0.5;

type Found = Trace["contours"][number];

/** The ink that was looked at. */
export interface Thresholded {
  readonly ink: Uint8Array;
  readonly columns: number;
  readonly rows: number;
  /** What parted it from the paper, where outlines are its border. */
  readonly border?: { readonly shades: Shades; readonly threshold: number };
}

/** `corner`: radians of turning from which on a corner was asked for. */
export async function measured(trace: Trace, scale: readonly [number, number], seen: Thresholded, corner: number): Promise<TraceResult> {
  const start = performance.now();
  const curves = trace.contours.map((found) => inPicture(found, scale));
  const texts = curves.map((curve) => curve.toPathD(printed).d);
  const outlines = trace.contours.map((found, i) => outlineOf(found, curves[i], scale, corner));
  const segments = segmentsIn(outlines.map(({ contour }) => contour));
  const polygons = curves.map((curve) => polygonText(curve.flatten(polygonWithin)));
  const sizes = await sizesOf(texts.join(""), polygons.join(""));
  const colors = trace.layers.map(({ color }) => color);
  const iou = colors.length === 0 && outlines.every(({ contour }) => contour.closed) ? overlap(outlines, scale, seen) : null;
  return { outlines, colors, segments, iou, beyond: beyondBorder(trace, scale, seen), sizes, stages: { ...trace.milliseconds, measuring: performance.now() - start } };
}

function inPicture({ curve }: Found, [x, y]: readonly [number, number]): HermiteCurve {
  if (!(curve instanceof HermiteCurve)) throw new TypeError("a traced outline is a Hermite curve");
  return x === 1 && y === 1 ? curve : curve.transform([x, 0, 0, y, 0, 0]);
}

function outlineOf(found: Found, curve: HermiteCurve | undefined, scale: readonly [number, number], corner: number): TracedOutline {
  if (curve === undefined) throw new TypeError("every outline has a curve");
  const larger = Math.max(...scale);
  const { rmse, mae, max, hausdorff, jaccard } = found.metrics;
  const corners = found.cusps.map(([x, y]) => [x * scale[0], y * scale[1]] as const);
  return {
    contour: withFoundCorners(contourFrom(curve, "trigonometric"), corners, { within: cornerWithin * larger, least: corner }),
    hole: found.hole,
    layer: found.layer,
    length: curve.length(),
    metrics: { rmse: rmse * larger, mae: mae * larger, max: max * larger, hausdorff: hausdorff * larger, jaccard },
    cubics: curve.toCubics(drawnWithin).path,
  };
}

/** How far the farthest corner is from the ink's border; null where it was not a border that was followed. */
function beyondBorder(trace: Trace, scale: readonly [number, number], { ink, border }: Thresholded): number | null {
  if (border === undefined) return null;
  const distances = trace.contours.flatMap(({ cusps }) => cusps.map(([x, y]) => distanceToBorder(border.shades, ink, border.threshold, x, y)));
  return distances.filter(Number.isFinite).reduce((most, distance) => Math.max(most, distance), 0) * Math.max(...scale);
}

function polygonText(vertices: Float64Array): string {
  let text = "";
  for (let i = 0; i + 1 < vertices.length; i += 2) text += `${i === 0 ? "M" : "L"}${short(vertices[i] ?? 0)} ${short(vertices[i + 1] ?? 0)}`;
  return `${text}Z`;
}

const short = (value: number): string => String(Number(value.toFixed(printed.decimals)));

async function sizesOf(text: string, polygon: string): Promise<TraceSizes> {
  const [gzip, polygonGzip] = await Promise.all([gzipped(text), gzipped(polygon)]);
  return { raw: text.length, gzip, polygonRaw: polygon.length, polygonGzip };
}

async function gzipped(text: string): Promise<number> {
  const packed = new Response(new Blob([text]).stream().pipeThrough(new CompressionStream("gzip")));
  return (await packed.arrayBuffer()).byteLength;
}

/**
 * Pixels inside of the outlines against pixels of ink. Outlines of edges turn the same way on both sides of a stroke:
 * as they are drawn and saved, so here every other one is paper.
 */
function overlap(outlines: readonly TracedOutline[], [x, y]: readonly [number, number], { ink, columns, rows }: Thresholded): number {
  const inside = coverage(outlines.map(({ cubics }) => flattened(cubics, x, y)), columns, rows, 1, "evenodd");
  let [both, either] = [0, 0];
  for (let i = 0; i < ink.length; i += 1) {
    const [a, b] = [(inside[i] ?? 0) >= 0.5, ink[i] === 1];
    if (a && b) both += 1;
    if (a || b) either += 1;
  }
  return either === 0 ? 1 : both / either;
}

/** Sixteen chords for each cubic, in pixels that were looked at. */
function flattened(cubics: Float64Array, scaleX: number, scaleY: number): Float64Array {
  const chords = 16;
  const places = new Float64Array((cubics.length / 8) * chords * 2);
  for (let c = 0; c < cubics.length / 8; c += 1) {
    for (let step = 0; step < chords; step += 1) {
      const [v, u] = [step / chords, 1 - step / chords];
      const mix = (k: number): number => {
        const at = (i: number): number => cubics[8 * c + 2 * i + k] ?? 0;
        return u * u * u * at(0) + 3 * u * u * v * at(1) + 3 * u * v * v * at(2) + v * v * v * at(3);
      };
      places.set([mix(0) / scaleX, mix(1) / scaleY], 2 * (c * chords + step));
    }
  }
  return places;
}
