import type { EditorState, Editor } from "../editor/editor.ts";
import { describe } from "../editor/curve/edits.ts";
import type { ModeParts } from "../editor/mode.ts";
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
 * Announcements at once. When it has been still for a moment: the drawing's summary, and aloud where what is chosen is
 * now, or else what has become of the drawing.
 */
export function mountLive(editor: Editor, live: HTMLElement, summary: HTMLElement, until: AbortSignal): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let known: ModeParts | undefined;
  const summarise = (): void => {
    const state = editor.state.value;
    const text = known?.summary?.(state) ?? (state.mode === "curve" ? summaryOf(state) : "");
    const before = summary.textContent;
    summary.textContent = text;
    const chosen = known === undefined ? chosenIn(state) : known.chosen?.(state) ?? "";
    // What can be done with it is there for who asks.
    const news = before === "" || before === text ? "" : text.split(" Brackets ")[0] ?? "";
    const said = chosen === live.textContent ? news : chosen || news;
    if (said !== "") live.textContent = said;
  };
  editor.notices.subscribe((notice) => {
    // Toasts are read out where they stand. The same once more is news.
    if (notice?.kind === "announce") live.textContent = notice.text;
  }, { until });
  editor.state.subscribe((state, before) => {
    const own = editor.modes.get(state.mode);
    if (own === known && state.curve === before.curve && state.selection === before.selection && state.surface === before.surface && state.fitRun.outcome === before.fitRun.outcome && state.traceRun === before.traceRun
      && state.mode === before.mode && state.engine === before.engine) return;
    known = own;
    if (state.engine.status !== "ready") return;
    clearTimeout(timer);
    // The first drawing is there as soon as it is shown.
    timer = setTimeout(summarise, summary.textContent === "" ? 0 : settleMs);
  }, { until });
  until.addEventListener("abort", () => clearTimeout(timer), { once: true });
}

/** What arrows would move. */
function chosenIn({ curve, mode, selection: { points, handle } }: EditorState): string {
  const [ref] = points;
  if (ref === undefined || mode !== "curve") return "";
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
