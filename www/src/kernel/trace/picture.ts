import { traceSample } from "../../document/trace/trace-samples.ts";
import type { PictureSource } from "./job.ts";
import { drawSample } from "./raster.ts";

/** Pixels of a picture, at the size at which it is looked at. Runs in a worker. */

export interface Pixels {
  /** Of the picture itself. */
  readonly width: number;
  readonly height: number;
  /** What is looked at: never larger than the picture. */
  readonly columns: number;
  readonly rows: number;
  /** One byte per pixel, or four. */
  readonly data: Uint8Array<ArrayBuffer> | Uint8ClampedArray<ArrayBuffer>;
}

/** What went wrong with a picture, by the codes of the page's catalogue. */
export class PictureError extends Error {
  override readonly name = "PictureError";
  constructor(readonly code: "E_IMAGE" | "E_BLANK" | "E_SAMPLE") {
    super(code);
  }
}

/** The decoded picture of a file; samples are drawn for the size that is asked for. */
async function decode(content: Blob): Promise<ImageBitmap> {
  try {
    return await createImageBitmap(content);
  } catch {
    throw new PictureError("E_IMAGE");
  }
}

export async function sizeOf(source: PictureSource): Promise<readonly [number, number]> {
  if (source.kind === "sample") {
    const sample = traceSample(source.id);
    if (sample === undefined) throw new PictureError("E_SAMPLE");
    return [sample.width, sample.height];
  }
  const bitmap = await decode(source.content);
  const size = [bitmap.width, bitmap.height] as const;
  bitmap.close();
  return size;
}

export async function pixelsOf(source: PictureSource, most: number): Promise<Pixels> {
  if (source.kind === "sample") {
    const sample = traceSample(source.id);
    if (sample === undefined) throw new PictureError("E_SAMPLE");
    const { width, height, data } = drawSample(sample, most);
    return { width: sample.width, height: sample.height, columns: width, rows: height, data };
  }
  const bitmap = await decode(source.content);
  try {
    return read(bitmap, most);
  } finally {
    bitmap.close();
  }
}

function read(bitmap: ImageBitmap, most: number): Pixels {
  const { width, height } = bitmap;
  const scale = Math.min(1, most / Math.max(width, height));
  const [columns, rows] = [Math.max(1, Math.round(width * scale)), Math.max(1, Math.round(height * scale))];
  const context = new OffscreenCanvas(columns, rows).getContext("2d", { willReadFrequently: true });
  if (context === null) throw new PictureError("E_BLANK");
  context.imageSmoothingQuality = "high";
  context.drawImage(bitmap, 0, 0, columns, rows);
  const { data } = context.getImageData(0, 0, columns, rows);
  // Some systems give back nothing at all, and say nothing, beyond an area of their own.
  if (columns * rows > silentArea && !data.some((byte) => byte !== 0)) throw new PictureError("E_BLANK");
  return { width, height, columns, rows, data };
}

/** Below this every browser gives the pixels that were drawn. */
const silentArea = 1_000_000;
