import type { EditorState } from "../../editor/editor.ts";
import { measureCurve, measureUntil } from "../../kernel/curve/measuring/measure.ts";
import { formatBytes, formatCount, formatMeasure, formatRatio } from "../controls/format.ts";
import type { Metric, ModeMetrics } from "../mode/metric.ts";

/** Curve's numbers. */

const count = (testid: string, about: string, one: string, read: (state: EditorState) => number, many = `${one}s`): Metric => ({
  testid,
  about,
  read(state) {
    const value = read(state);
    return { value, strong: String(value), rest: formatCount(value, one, many).replace(/^\d+ /u, "") };
  },
});

const present: readonly Metric[] = [
  count("m-points", "Control points", "point", ({ curve }) => measureCurve(curve).points),
  count("m-contours", "Contours", "contour", ({ curve }) => measureCurve(curve).contours),
  count("m-cusps", "Cusps: points where the direction changes sharply", "cusp", ({ curve }) => measureCurve(curve).cusps),
];

const truth: readonly Metric[] = [
  {
    testid: "m-error",
    about: "Largest distance from the exact ellipse, relative to its radius, over 512 samples",
    read({ curve }) {
      const value = measureCurve(curve).modelError;
      return value === undefined ? null : { value, lead: "ellipse error", strong: formatRatio(value) };
    },
  },
  {
    testid: "m-bezier",
    about: "The same error for the Bézier curve drawn behind it",
    read({ curve, settings }) {
      const value = settings.overlays.bezier ? measureCurve(curve).bezierError : undefined;
      return value === undefined ? null : { value, lead: "Bézier", strong: formatRatio(value) };
    },
  },
  {
    testid: "m-length",
    about: "Total length of all contours, to 1e-9 of the drawing's size",
    read({ curve }) {
      return curve.contours.length === 0 ? null : { value: measureCurve(curve).length, lead: "length", strong: formatMeasure(measureCurve(curve).length) };
    },
    slow: true,
    prepare: ({ curve }, spent) => measureUntil(curve, spent),
  },
  {
    testid: "m-area",
    about: "Area of all closed contours; those that run the other way round are holes",
    read({ curve }) {
      const { closed, area: signed } = measureCurve(curve);
      // Whichever way round a file has its outlines.
      const area = Math.abs(signed);
      return closed === 0 ? null : { value: area, lead: "area", strong: formatMeasure(area) };
    },
    slow: true,
  },
];

const cost: readonly Metric[] = [
  {
    testid: "m-bytes",
    about: "Size of the path data at tolerance 0.02 with 3 decimals",
    read({ curve }) {
      const { bytes, isLong } = measureCurve(curve);
      return { value: bytes, lead: isLong ? "d ≈" : "d", strong: formatBytes(bytes) };
    },
    slow: true,
  },
];

export const curveMetrics: ModeMetrics = [present, truth, cost];
