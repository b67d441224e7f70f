import type { EditorState, Editor } from "../editor/editor.ts";
import { describe } from "../editor/curve/edits.ts";
import { hintFor } from "../editor/hint.ts";
import { measureCurve } from "../kernel/curve/measuring/measure.ts";

/** The small DOM parts of the stage: the hint line, and what screen readers hear. */

/** What the stage is called, which is up to the mode. */
export function mountLabel(editor: Editor, surface: HTMLElement, until: AbortSignal): void {
  const plane = surface.ariaLabel ?? "";
  editor.state.subscribe(({ mode }) => {
    const label = editor.modes.get(mode)?.label ?? plane;
    if (surface.ariaLabel !== label) surface.ariaLabel = label;
  }, { until, now: true });
}

export function mountHint(editor: Editor, element: HTMLElement, until: AbortSignal): void {
  editor.state.subscribe(
    (state) => {
      const text = editor.modes.get(state.mode)?.hint?.(state) ?? hintFor(state);
      if (element.textContent !== text) element.textContent = text;
      element.hidden = text === "";
    },
    { until, now: true },
  );
}

const settleMs = 700;

/**
 * Announcements at once; the drawing's summary, and where what is chosen is now, when it has been still for a moment.
 */
export function mountLive(editor: Editor, live: HTMLElement, summary: HTMLElement, until: AbortSignal): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const summarise = (): void => {
    const state = editor.state.value;
    summary.textContent = editor.modes.get(state.mode)?.summary?.(state) ?? summaryOf(state);
    const chosen = state.mode === "curve" ? chosenIn(state) : "";
    if (chosen !== "") live.textContent = chosen;
  };
  editor.notices.subscribe((notice) => {
    // Toasts are read out where they stand.
    if (notice?.kind === "announce") live.textContent = notice.text;
  }, { until });
  editor.state.subscribe((state, before) => {
    if (state.curve === before.curve && state.selection === before.selection && state.surface === before.surface && state.fitRun === before.fitRun && state.traceRun === before.traceRun
      && state.mode === before.mode && state.engine === before.engine) return;
    if (state.engine.status !== "ready") return;
    clearTimeout(timer);
    // The first drawing is there as soon as it is shown.
    timer = setTimeout(summarise, summary.textContent === "" ? 0 : settleMs);
  }, { until });
  until.addEventListener("abort", () => clearTimeout(timer), { once: true });
}

/** What arrows would move. */
function chosenIn({ curve, selection: { points, handle } }: EditorState): string {
  const [ref] = points;
  if (ref === undefined) return "";
  return points.length > 1 ? `${points.length} points selected` : describe(curve, ref, handle?.side);
}

function counted(count: number, one: string, many: string): string {
  return `${count} ${count === 1 ? one : many}`;
}

function summaryOf(state: EditorState): string {
  const { contours, closed, points, cusps } = measureCurve(state.curve);
  if (contours === 0) return "An empty drawing. Use the pen or open a sample to begin.";
  const kind = contours === 1 ? (closed === 1 ? "Closed curve" : "Open curve") : `${contours} contours, ${closed} closed`;
  return `${kind}, ${counted(points, "point", "points")}, ${counted(cusps, "cusp", "cusps")}. Brackets step through the points, arrows move the selected one.`;
}
