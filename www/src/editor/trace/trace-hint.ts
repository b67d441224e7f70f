import { isEmptyTrace } from "../../document/trace/trace.ts";
import type { LeftOut } from "../../kernel/trace/job.ts";
import { cornersIn, pointCount } from "../../kernel/trace/outcome.ts";
import type { EditorState } from "../editor.ts";
import { describePoint, shownOf } from "./trace-edits.ts";

/** What the next press would do in Trace. */
export function traceHint(state: EditorState): string {
  const { traceView, traceRun, trace, hint } = state;
  if (traceView.over !== null) return `${describePoint(state, traceView.over)}: ${state.touch ? "double-tap" : "double-click"} to toggle the corner`;
  if (isEmptyTrace(trace)) return "";
  if (traceRun.behind) return behindText;
  if (hint !== "") return hint;
  if (traceView.view === "edges" && traceRun.picture !== null) {
    // Between colours there is no threshold.
    return trace.settings.mode !== "brightness" || trace.settings.colors > 0 ? "Bright means a strong edge." : `Anything darker than ${Math.round(traceRun.picture.threshold)} of 255 counts as ink.`;
  }
  return traceRun.outcome === null
    ? ""
    : state.touch ? "Double-tap a point to switch between corner and smooth." : `Double-click a point to switch between corner and smooth.${traceRun.picture === null ? "" : " Hold O to see only the picture."}`;
}

/** Of outlines whose settings have changed since, as the trace with them was cancelled. */
export const behindText = "These outlines are of the settings before. Trace makes them anew.";

/** "12 shapes or holes smaller than 16 px² were left out." */
export function leftOutText({ count, below }: LeftOut): string {
  return count === 1 ? `A shape or hole smaller than ${below} px² was left out.` : `${count} shapes or holes smaller than ${below} px² were left out.`;
}

/** The picture in words, for those who do not see it. */
export function traceSummary(state: EditorState): string {
  const { trace, traceRun } = state;
  const shown = shownOf(state);
  if (isEmptyTrace(trace)) return "No picture yet. Choose a file, paste one, or open a sample.";
  if (shown === null) return traceRun.since === null ? "The picture has no outlines." : "Tracing.";
  const { drawing, max } = shown;
  const { picture } = traceRun;
  const holes = shown.holes.filter((hole) => hole).length;
  const left = shown.leftOut === undefined ? "" : ` ${leftOutText(shown.leftOut)}`;
  const error = max === null ? "" : ` No place is farther than ${max.toPrecision(2)} pixels from the edge in the picture.`;
  return `${picture?.name ?? trace.kept?.name ?? "The picture"}: ${counted(drawing.contours.length, "outline")}, ${holes} of them holes, ${counted(pointCount(drawing), "point")}, ${counted(cornersIn(drawing).length, "corner")}.${error}${left}${traceRun.behind ? ` ${behindText}` : ""} Brackets step through the points, C toggles a corner.`;
}

function counted(count: number, what: string): string {
  return `${count} ${what}${count === 1 ? "" : "s"}`;
}
