import type { EditorState } from "../../editor/editor.ts";
import { shownOf } from "../../editor/trace/trace-edits.ts";
import { cornersIn, pointCount, type TraceOutcome } from "../../kernel/trace/outcome.ts";
import { formatBytes, formatDeviation } from "../controls/format.ts";
import type { Metric, ModeMetrics } from "../mode/metric.ts";

/** Trace's numbers; nothing is printed that is not there. */

type Reading = ReturnType<Metric["read"]>;

const of = (read: (shown: TraceOutcome, state: EditorState) => Reading) => (state: EditorState): Reading => {
  const shown = shownOf(state);
  return shown === null ? null : read(shown, state);
};

const counted = (value: number, one: string): Reading => ({ value, strong: String(value), rest: value === 1 ? one : `${one}s` });

export const traceMetrics: ModeMetrics = [
  [
    { testid: "m-contours", about: "Outlines, including holes", read: of(({ holes }) => counted(holes.length, "contour")) },
    { testid: "m-cusps", about: "Sharp corners", read: of(({ drawing }) => counted(cornersIn(drawing).length, "cusp")) },
    { testid: "m-points", about: "Control points", read: of(({ drawing }) => counted(pointCount(drawing), "point")) },
  ],
  [
    {
      testid: "m-rms",
      about: "Root mean square distance between the outlines and the sub-pixel edge",
      read: of(({ rms }) => (rms === null ? null : { value: rms, lead: "rms", strong: formatDeviation(rms), rest: "px" })),
    },
    {
      testid: "m-max",
      about: "Largest distance from the sub-pixel edge to the outlines",
      read: of(({ max }) => (max === null ? null : { value: max, lead: "max", strong: formatDeviation(max), rest: "px" })),
    },
    {
      testid: "m-iou",
      about: "Overlap of outlines and thresholded picture: shared area over total area",
      read: of(({ iou }) => (iou === null ? null : { value: iou, lead: "IoU", strong: iou.toFixed(4) })),
    },
  ],
  [
    {
      testid: "m-bytes",
      about: "Size as path data: as polygons within 0.1 pixels, then as curves",
      read: of(({ sizes }) => (sizes === null ? null : { value: sizes.raw, lead: `${formatBytes(sizes.polygonRaw)} →`, strong: formatBytes(sizes.raw) })),
    },
    { testid: "m-solve", about: "Time the last trace took", read: of((_, { traceRun }) => (traceRun.lastMs === 0
      ? null
      : { value: traceRun.lastMs, lead: "trace", strong: traceRun.lastMs < 10 ? traceRun.lastMs.toFixed(1) : String(Math.round(traceRun.lastMs)), rest: "ms" })) },
  ],
];
