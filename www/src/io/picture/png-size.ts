import { sheetOf, type Artboard, type Box } from "../../document/artboard.ts";
import type { PaintedPath } from "../../document/paint-layers.ts";
import { reachOf, type Line } from "../../document/painted.ts";

/** Browsers refuse or blank canvases beyond these. */
const mostSide = 16_384;
const mostPixels = 16_777_216;
const margin = 16;
/**
 * An icon of 24 units would be a thumbnail, and its lines as thick as itself: it is drawn as if it were as large as
 * this.
 */
const leastSize = 256;

/**
 * Of a larger one, in units that programs count by the thousand, browsers draw no picture: it is drawn as if it were as
 * small as this, a margin included.
 */
const mostSize = Math.sqrt(mostPixels) - 2 * margin;

/** Of a drawing that is neither. */
export const lineWidth = 2;

/** Times as large as it is that a drawing is drawn in a file: 1 but for small ones, and for huge ones. */
export function enlargement(box: Box): number {
  const size = Math.max(box.maxX - box.minX, box.maxY - box.minY);
  return size > 0 ? Math.min(Math.max(1, leastSize / size), mostSize / size) : 1;
}

/** In pixels. */
export interface PngSize {
  readonly width: number;
  readonly height: number;
}

/** What is drawn, and on what. */
export interface Subject {
  readonly box: Box | null;
  readonly artboard?: Artboard;
  /** Areas of ink, holes left out, in place of lines. */
  readonly filled?: boolean;
  /** In place of the one path, the lowest first. */
  readonly layers?: readonly PaintedPath[];
}

/** How far lines reach out of the outlines that they run along; areas are no larger than theirs. */
export function roomFor({ artboard, filled = false, layers = [] }: Subject, thin: number): number {
  const paths: readonly Omit<PaintedPath, "d">[] = layers.length > 0 ? layers : [{ isLine: !filled }];
  // What an artboard cuts off a line of the drawing's own, it always did.
  const reach = (line: Line): number => (artboard === undefined ? reachOf(line) : 0);
  return paths.reduce((most, { isLine, line }) => Math.max(most, line !== undefined ? reach(line) : isLine === true ? thin : 0), 0);
}

function grown({ minX, minY, maxX, maxY }: Box, by: number): Box {
  return { minX: minX - by, minY: minY - by, maxX: maxX + by, maxY: maxY + by };
}

/** What of the plane a file shows, and how many times as large as it is. */
export interface Sheet {
  readonly frame: Box;
  readonly enlarged: number;
}

/** The artboard, with room for the drawing's line where that reaches out of it; null without one. */
export function sheetIn(subject: Subject): Sheet | null {
  const { box, artboard } = subject;
  if (artboard === undefined) return null;
  const enlarged = enlargement(sheetOf(artboard, box));
  const frame = sheetOf(artboard, box === null ? box : grown(box, roomFor(subject, lineWidth / enlarged)));
  return { frame, enlarged };
}

/** What a picture shows: the artboard, or the drawing and a margin. */
export function pictureOf(subject: Subject): Sheet | null {
  const sheet = sheetIn(subject);
  if (sheet !== null || subject.box === null) return sheet;
  const enlarged = enlargement(subject.box);
  return { frame: grown(subject.box, Math.max(margin / enlarged, roomFor(subject, 0))), enlarged };
}

/** The size in pixels that a picture of the drawing would have, or null when it is larger than browsers can draw. */
export function pngSize(subject: Subject, scale: number): PngSize | null {
  const picture = pictureOf(subject);
  if (picture === null) return null;
  const { frame, enlarged } = picture;
  // A whole number that came out a rounding larger is that number.
  const pixels = (length: number): number => Math.max(1, Math.ceil(scale * enlarged * length - 1e-6));
  const [width, height] = [pixels(frame.maxX - frame.minX), pixels(frame.maxY - frame.minY)];
  return width <= mostSide && height <= mostSide && width * height <= mostPixels ? { width, height } : null;
}
