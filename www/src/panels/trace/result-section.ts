import { hasPicture } from "../../document/trace/trace.ts";
import type { EditorState } from "../../editor/editor.ts";
import { leftOutOf, shownOf } from "../../editor/trace/trace-edits.ts";
import { behindText, leftOutText } from "../../editor/trace/trace-hint.ts";
import { cornersIn, pointCount, type TraceOutcome } from "../../kernel/trace/outcome.ts";
import { h, setText } from "../controls/dom.ts";
import { formatBytes, formatCount, formatDeviation } from "../controls/format.ts";
import { legendRow } from "../controls/legend.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";
import { progressText } from "./trace-progress.ts";

/** What was found, how near it is to the picture, what it costs, and where to go with it. */

export function resultSection(shell: Shell): Section {
  const { editor } = shell;
  const action = (label: string, id: string, title: string, more = ""): HTMLButtonElement =>
    h("button", { class: `button ${more}`.trim(), type: "button", testid: id, title, click: () => editor.actions.run(id) }, h("span", {}, label));
  const run = action("Trace", "trace-run", "Trace the picture again.");
  const cancel = action("Cancel", "trace-cancel", "Stop and keep the previous outlines.");
  const state = h("span", { class: "trace-state num", "aria-hidden": "true" });
  const corners = legendRow("cusp", "Cusps", "Go to the next sharp corner", () => editor.actions.run("trace-next-corner"));
  const smooth = legendRow("point", "Smooth", "Go to the next point", () => editor.actions.run("trace-next"));
  const list = h("dl", { class: "trace-numbers num" });
  const edit = action("Edit in Curve", "trace-edit", "Copy the outlines to Curve, ready to edit.", "primary");
  const fit = action("Smooth in Fit", "trace-smooth-in-fit", "Copy points along the outlines to Fit.");
  const save = h("button", {
    class: "button",
    type: "button",
    testid: "trace-export",
    title: "Export the outlines as SVG, path, JSON or PNG.",
    click: () => editor.actions.run("export"),
  }, h("span", {}, "Export"));
  const behind = h("p", { class: "field-note", testid: "trace-behind" }, behindText);
  const keep = action("Keep them", "trace-keep-small", "Trace again with a speckle that keeps them (S).");
  const left = h("p", { class: "field-note", testid: "trace-left-out" });
  const offer = h("div", { class: "trace-left-out" }, left, keep);
  let printed: TraceOutcome | null = null;
  return {
    element: h("section", { class: "section", "aria-label": "Result" },
      h("div", { class: "field-row" }, run, cancel, state), behind,
      h("div", { class: "legend" }, corners.row, smooth.row), list, offer,
      h("div", { class: "field-row trace-actions" }, edit, fit, save)),
    update(now) {
      const { trace, traceRun, traceProgress: progress } = now;
      const { since } = traceRun;
      behind.hidden = !traceRun.behind;
      run.disabled = !hasPicture(trace);
      cancel.hidden = since === null;
      setText(state, since === null || progress === null ? "" : progressText(progress));
      const shown = shownOf(now);
      for (const button of [edit, fit, save]) button.disabled = shown === null;
      const sharp = shown === null ? 0 : cornersIn(shown.drawing).length;
      corners.show(sharp);
      const small = leftOutOf(now);
      offer.hidden = small === null;
      if (small !== null) setText(left, leftOutText(small));
      smooth.show(shown === null ? 0 : pointCount(shown.drawing) - sharp);
      if (shown === printed) return;
      printed = shown;
      list.replaceChildren(...(shown === null ? [] : rowsOf(shown, now)));
    },
  };
}

/** Every corner is cut off by a part of a pixel; only of more is anything to be seen. */
const worthSaying = 1;

function rowsOf(shown: TraceOutcome, { trace, traceRun }: EditorState): HTMLElement[] {
  const row = (label: string, testid: string, text: string): HTMLElement => h("div", {}, h("dt", {}, label), h("dd", { testid }, text));
  const { holes, segments, sizes, rms, max, beyond, iou, stages } = shown;
  const rows: HTMLElement[] = [];
  const inner = holes.filter((hole) => hole).length;
  rows.push(row("Contours", "trace-contours", inner === 0 ? String(holes.length) : `${holes.length}, ${formatCount(inner, "hole")}`));
  if (segments !== null) {
    const { lines, arcs, curves } = segments;
    const kinds = ([[lines, "line"], [arcs, "exact arc"], [curves, "curve"]] as const).flatMap(([count, kind]) => (count === 0 ? [] : [formatCount(count, kind)]));
    rows.push(h("div", {}, h("dt", {}, "Segments"), h("dd", { testid: "trace-segments" }, ...unbroken(kinds.length === 0 ? ["none"] : kinds))));
  }
  if (rms !== null && max !== null) rows.push(row("To the edge", "trace-error", `rms ${formatDeviation(rms)}, max ${formatDeviation(max)} px`));
  // Only the tracer knows the edge, and it has not seen what was smoothed by hand.
  else if (typeof traceRun.outcome?.max === "number") rows.push(row("To the edge", "trace-unmeasured", "unknown, edited by hand"));
  if (beyond !== null && beyond > worthSaying) {
    const tips = row("Corners past it", "trace-beyond", `up to ${formatDeviation(beyond)} px`);
    tips.title = "Pixels blunt sharp corners; the outline continues to where the sides meet.";
    rows.push(tips);
  }
  if (iou !== null) rows.push(row("Overlap with ink", "trace-iou", `${(100 * iou).toFixed(2)} %`));
  if (sizes !== null) {
    rows.push(row("Path", "trace-bytes", `${formatBytes(sizes.raw)}, ${formatBytes(sizes.gzip)} gzip`));
    rows.push(row("As a polygon", "trace-polygon-bytes", `${formatBytes(sizes.polygonRaw)}, ${formatBytes(sizes.polygonGzip)} gzip`));
  }
  if (trace.corners.length > 0) rows.push(row("By hand", "trace-by-hand", formatCount(trace.corners.length, "corner")));
  // The row itself begins with the whole.
  const times = Object.entries(stages).filter(([stage, ms]) => ms >= 0.5 && stage !== "total").map(([stage, ms]) => `${stage} ${ms < 10 ? ms.toFixed(1) : Math.round(ms)}`);
  if (times.length > 0) {
    rows.push(h("div", { class: "trace-times" }, h("dt", {}, `${Math.round(traceRun.lastMs)} ms`), h("dd", { testid: "trace-stages" }, ...unbroken(times))));
  }
  return rows;
}

/** A list whose lines break between its items and nowhere else. */
function unbroken(items: readonly string[]): (HTMLElement | string)[] {
  return items.flatMap((item, i) => [h("span", { class: "unbroken" }, i + 1 < items.length ? `${item},` : item), " "]);
}
