import type { Contour } from "../contour.ts";

/** What Trace works on: a picture, how it is to be followed, and what was decided by hand. */

/**
 * What is followed: the border between dark and light, the places of steepest change, or the middle of thin strokes.
 */
export type TraceSource = "brightness" | "edges" | "lines";

export interface TraceSettings {
  /** 0 (every pixel) … 100 (smooth) */
  readonly detail: number;
  /** Degrees of turning from which a corner is kept, 0 … 180. */
  readonly corner: number;
  /** Square pixels that a contour must enclose. */
  readonly speckle: number;
  readonly mode: TraceSource;
  /** A shade from 0 (black) to 255 (white). */
  readonly threshold: number | "auto";
  /** Standard deviation in pixels. */
  readonly blur: number | "auto";
  /** Light shapes on dark ground. */
  readonly invert: boolean;
  /** Flat colours that are looked for at most, 2 … 16; 0: ink on paper. */
  readonly colors: number;
  /** Pixels of the longer side that are looked at. */
  readonly size: WorkSize;
}

export const workSizes = [512, 1024, 2048] as const;
export type WorkSize = (typeof workSizes)[number];

export const traceLimits = { detail: 100, corner: 180, speckle: 1000, threshold: 255, blur: 5, colors: 16 } as const;

export const traceDefaults: TraceSettings = {
  detail: 35, corner: 45, speckle: 16, mode: "brightness", threshold: "auto", blur: "auto", invert: false, colors: 0, size: 1024,
};

/** A picture of somebody's own. Its pixels are in this page's memory alone, under `key`. */
export interface OwnPicture {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  readonly key: string;
}

/** A corner that was made smooth by hand, or a smooth point that was made a corner; in pixels of the picture. */
export interface CornerChoice {
  readonly x: number;
  readonly y: number;
  readonly kind: "smooth" | "cusp";
}

/** Outlines that came with a file or a link, without their picture. */
export interface KeptTrace {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  readonly contours: readonly Contour[];
}

export interface TraceDocument {
  /** A picture that is drawn by code. */
  readonly sample?: string;
  readonly picture?: OwnPicture;
  readonly kept?: KeptTrace;
  readonly settings: TraceSettings;
  readonly corners: readonly CornerChoice[];
  /** Somebody has seen that this is a photograph and wants it traced all the same. */
  readonly anyway?: boolean;
}

export const emptyTrace: TraceDocument = { settings: traceDefaults, corners: [] };

/** What an entry of Trace's history brings back. */
export interface TraceMoment {
  readonly trace: TraceDocument;
}

/** The document with another picture: what was decided about the old one's corners is no concern of the new one. */
export function withPicture({ settings }: TraceDocument, picture: Pick<TraceDocument, "sample" | "picture" | "kept">): TraceDocument {
  return { ...picture, settings, corners: [] };
}

export function isEmptyTrace({ sample, picture, kept }: TraceDocument): boolean {
  return sample === undefined && picture === undefined && kept === undefined;
}

/** Whether there are pixels to trace. Outlines that came back without their picture have none. */
export function hasPicture({ sample, picture }: TraceDocument): boolean {
  return sample !== undefined || picture !== undefined;
}

/** Choices this near each other, in pixels, are about one corner. */
const samePlace = 3;

/** The choice among these that is about a place. */
export function choiceAt(corners: readonly CornerChoice[], x: number, y: number): CornerChoice | undefined {
  return corners.find((corner) => Math.hypot(corner.x - x, corner.y - y) <= samePlace);
}

/** One more choice; taking back an earlier one leaves neither. */
export function withChoice(corners: readonly CornerChoice[], choice: CornerChoice): readonly CornerChoice[] {
  const before = choiceAt(corners, choice.x, choice.y);
  if (before === undefined) return [...corners, choice];
  const rest = corners.filter((corner) => corner !== before);
  return before.kind === choice.kind ? corners : rest;
}

/**
 * The largest deviation in pixels that a position of the Detail slider stands for: the tracer's own default at 35,
 * and twice that every 14 steps.
 */
export function toleranceOf(detail: number): number {
  return defaultTolerance * 2 ** ((detail - traceDefaults.detail) / 14);
}

export const defaultTolerance = 0.22;
