/** What passes between the page and the worker that traces: plain data and pictures. */
import type { Contour } from "../../document/document.ts";
import type { TraceSource } from "../../document/trace/trace.ts";

/** Where pixels come from. Pictures of one key are one picture. */
export type PictureSource =
  | { readonly kind: "sample"; readonly key: string; readonly id: string }
  | { readonly kind: "file"; readonly key: string; readonly content: Blob };

/** How a picture is traced. Lengths are in pixels of the picture. */
export interface TraceHow {
  /** The longer side of what is looked at. */
  readonly size: number;
  readonly source: TraceSource;
  readonly threshold: number | "auto";
  readonly blur: number | "auto";
  readonly invert: boolean;
  /** Flat colours at most; 0: ink on paper. */
  readonly colors: number;
  /** Square pixels. */
  readonly speckle: number;
  /** Radians of turning. */
  readonly corner: number;
  readonly tolerance: number;
  /** More contours than this are a photograph's. */
  readonly mostContours: number;
}

export type TraceRequest =
  /** Decode only: is it a picture, and how large? */
  | { readonly kind: "probe"; readonly id: number; readonly picture: PictureSource }
  | { readonly kind: "trace"; readonly id: number; readonly picture: PictureSource; readonly how: TraceHow }
  | { readonly kind: "stop" };

export const traceStages = ["decoding", "edges", "contours", "corners", "splines", "refinement", "layers", "measuring"] as const;
export type TraceStage = (typeof traceStages)[number];

export interface Metrics {
  readonly rmse: number;
  readonly mae: number;
  readonly max: number;
  readonly hausdorff: number;
  readonly jaccard: number;
}

/** One outline, in pixels of the picture. */
export interface TracedOutline {
  readonly contour: Contour;
  readonly hole: boolean;
  /** Which of the colours it bounds. */
  readonly layer: number;
  /** Length of the outline. */
  readonly length: number;
  readonly metrics: Metrics;
  /** Cubics, eight numbers each, nearer to the curve than can be seen. */
  readonly cubics: Float64Array;
}

export interface TraceSizes {
  readonly raw: number;
  readonly gzip: number;
  /** The same outlines as polygons within a tenth of a pixel. */
  readonly polygonRaw: number;
  readonly polygonGzip: number;
}

/** Contours that were smaller than the speckle, where they may be missed. Areas are in square pixels of the picture. */
export interface LeftOut {
  readonly count: number;
  /** The speckle that they were smaller than, */
  readonly below: number;
  /** and the one that keeps them. */
  readonly keeping: number;
}

export interface TraceResult {
  readonly outlines: readonly TracedOutline[];
  /** The colours, "#rrggbb", the lowest layer first; none where there is only ink. */
  readonly colors: readonly string[];
  /** Segments by kind. */
  readonly segments: { readonly lines: number; readonly arcs: number; readonly curves: number };
  /**
   * Area that closed outlines and thresholded picture have in common, by the area of either; null where lines end
   * openly and where there are colours.
   */
  readonly iou: number | null;
  /**
   * The largest distance of a corner from the border of the ink, in pixels; null where edges, lines or colours were
   * followed.
   */
  readonly beyond: number | null;
  readonly sizes: TraceSizes;
  readonly leftOut?: LeftOut;
  /** Milliseconds by stage. */
  readonly stages: Readonly<Record<string, number>>;
}

export type TraceAnswer =
  | { readonly kind: "probed"; readonly id: number; readonly width: number; readonly height: number }
  | {
    readonly kind: "progress"; readonly id: number; readonly stage: TraceStage; readonly done: number; readonly total: number;
    /** Of the whole job, 0 … 1. */
    readonly value: number;
  }
  /** What is looked at, and what is ink of it, as soon as it is known. */
  | {
      readonly kind: "picture"; readonly id: number; readonly width: number; readonly height: number;
      readonly analysed: readonly [number, number]; readonly source: ImageBitmap; readonly edges: ImageBitmap;
      /** The shade between ink and paper. */ readonly threshold: number;
      /** Whether it is drawn in several flat colours. */ readonly colored: boolean;
    }
  | { readonly kind: "traced"; readonly id: number; readonly result: TraceResult; readonly ms: number }
  | { readonly kind: "photo"; readonly id: number; readonly count: number; /** Square pixels. */ readonly speckle: number }
  | { readonly kind: "stopped"; readonly id: number }
  | { readonly kind: "failed"; readonly id: number; readonly code: string; readonly message: string };
