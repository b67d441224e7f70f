import { strokesOf, type FitDocument } from "../../document/fit/fit.ts";
import { unitIn } from "../../document/unit.ts";
import type { EditorState } from "../../editor/editor.ts";
import { boxOf } from "../../editor/fit/fit-edits.ts";
import { bytesOfData, bytesOfFit, type FitOutcome } from "../../kernel/fit/outcome.ts";
import { formatBytes, formatDeviation } from "../controls/format.ts";
import type { Metric, ModeMetrics } from "../mode/metric.ts";

/** Fit's numbers; nothing is printed that is not there. */

type Reading = ReturnType<Metric["read"]>;

const of = (read: (outcome: FitOutcome, state: EditorState) => Reading) => (state: EditorState): Reading =>
  state.fitRun.outcome === null ? null : read(state.fitRun.outcome, state);

/** What was measured has units of its own, which nobody has said. */
export function unitName({ up }: FitDocument): string {
  return up === true ? "" : " px";
}

const inPixels = (fit: FitDocument): { readonly rest?: string } => (fit.up === true ? {} : { rest: "px" });

export const fitMetrics: ModeMetrics = [
  [
    {
      testid: "m-points",
      about: "Points being fitted",
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
      about: "Root mean square distance between points and curve",
      read: of(({ rms }, { fit }) => ({ value: rms, lead: "rms", strong: formatDeviation(rms), ...inPixels(fit) })),
    },
    {
      testid: "m-max",
      about: "No point is farther from the curve than this",
      read: of(({ max }, { fit }) => ({ value: max, lead: "max", strong: formatDeviation(max), ...inPixels(fit) })),
    },
    {
      testid: "m-gap",
      about: "Certified relative distance from the optimum",
      // Of points that are met to rounding nothing is left that could be certified.
      read: of(({ gap, smoothing, rms, diagonal }) => (smoothing === null || rms < 1e-9 * diagonal ? null : { value: gap, lead: "gap", strong: formatDeviation(gap) })),
    },
    {
      testid: "m-lambda",
      about: "λ of the fit, one per part",
      read: of(({ lambda }) => (lambda.length === 0 ? null : { value: lambda[0] ?? 0, lead: "λ", strong: lambda.map((value) => value.toPrecision(2)).join(", ") })),
    },
  ],
  [
    {
      testid: "m-bytes", about: "Size as path data: the points as a polyline, then the curve",
      read: of((outcome, { fit }) => {
        const unit = unitIn(boxOf(fit.data));
        const value = bytesOfFit(outcome, unit);
        return { value, lead: `${formatBytes(bytesOfData(fit.data, strokesOf(fit), unit))} →`, strong: formatBytes(value) };
      }),
      slow: true,
    },
    { testid: "m-solve", about: "Time the last fit took", read: of((_, { fitRun }) => ({ value: fitRun.lastMs, lead: "fit", strong: fitRun.lastMs < 10
      ? fitRun.lastMs.toFixed(1)
      : String(Math.round(fitRun.lastMs)), rest: "ms" })) },
  ],
];
