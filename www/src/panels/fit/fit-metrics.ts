import { strokesOf } from "../../document/fit/fit.ts";
import type { EditorState } from "../../editor/editor.ts";
import { bytesOfData, bytesOfFit, type FitOutcome } from "../../kernel/fit/outcome.ts";
import { formatBytes, formatDeviation } from "../controls/format.ts";
import type { Metric, ModeMetrics } from "../mode/metric.ts";

/** Fit's numbers; nothing is printed that is not there. */

type Reading = ReturnType<Metric["read"]>;

const of = (read: (outcome: FitOutcome, state: EditorState) => Reading) => (state: EditorState): Reading =>
  state.fitRun.outcome === null ? null : read(state.fitRun.outcome, state);

export const fitMetrics: ModeMetrics = [
  [
    {
      testid: "m-points",
      about: "Points that are fitted",
      read: ({ fit }) => ({ value: fit.data.length, strong: String(fit.data.length), rest: fit.data.length === 1 ? "point" : "points" }),
    },
    {
      testid: "m-knots",
      about: "Knots: places where the curve changes",
      read: of(({ knots }) => ({ value: knots.length, strong: String(knots.length), rest: knots.length === 1 ? "knot" : "knots" })),
    },
  ],
  [
    {
      testid: "m-rms",
      about: "Root of the mean square of the distances between points and curve",
      read: of(({ rms }) => ({ value: rms, lead: "rms", strong: formatDeviation(rms), rest: "px" })),
    },
    {
      testid: "m-max",
      about: "No point is farther from the curve than this",
      read: of(({ max }) => ({ value: max, lead: "max", strong: formatDeviation(max), rest: "px" })),
    },
    {
      testid: "m-gap",
      about: "Certified distance from the optimum, relative",
      // Of points that are met to rounding nothing is left that could be certified.
      read: of(({ gap, smoothing, rms, diagonal }) => (smoothing === null || rms < 1e-9 * diagonal ? null : { value: gap, lead: "gap", strong: formatDeviation(gap) })),
    },
    {
      testid: "m-lambda",
      about: "λ of the fit, one for each part",
      read: of(({ lambda }) => (lambda.length === 0 ? null : { value: lambda[0] ?? 0, lead: "λ", strong: lambda.map((value) => value.toPrecision(2)).join(", ") })),
    },
  ],
  [
    {
      testid: "m-bytes", about: "Size as path text: the points as a polyline, and the curve",
      read: of((outcome, { fit }) => {
        const value = bytesOfFit(outcome);
        return { value, lead: `${formatBytes(bytesOfData(fit.data, strokesOf(fit)))} →`, strong: formatBytes(value) };
      }),
      slow: true,
    },
    { testid: "m-solve", about: "Time that the last fit took in its worker", read: of((_, { fitRun }) => ({ value: fitRun.lastMs, lead: "fit", strong: fitRun.lastMs < 10
      ? fitRun.lastMs.toFixed(1)
      : String(Math.round(fitRun.lastMs)), rest: "ms" })) },
  ],
];
