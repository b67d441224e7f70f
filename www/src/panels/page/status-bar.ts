import type { CurveDocument, Mode } from "../../document/document.ts";
import { h, setAttribute } from "../controls/dom.ts";
import { isMeasuredElsewhere } from "../../kernel/curve/measuring/measure.ts";
import { curveMetrics } from "../curve/curve-metrics.ts";
import type { Metric, ModeMetrics } from "../mode/metric.ts";
import { inNextFrame, type Shell } from "../shell.ts";

const slowEveryMs = 120;
/** Of a frame, for measuring what is very large. */
const shareOfFrameMs = 8;
const mostMeasuredLive = 200;
/** What is measured as a whole is so only when it has been still. */
const restMs = 300;

/**
 * What is there, what is true about it, what it costs. Every number can be copied by a press and carries itself in
 * `data-value`.
 */
export function mountStatusBar(shell: Shell): { readonly metrics: HTMLElement; put(mode: Mode, metrics: ModeMetrics): void } {
  const { editor, regions, io, toasts, until } = shell;
  const make = (metric: Metric): { metric: Metric; element: HTMLButtonElement } => {
    const element = h("button", { class: "metric", type: "button", testid: metric.testid, title: `${metric.about}. Click to copy.` });
    element.addEventListener("click", () => {
      const value = element.dataset["value"] ?? "";
      void io.copyText(value).then((done) => toasts.say(done ? `Copied ${value}` : `The number is ${value}`));
    });
    return { metric, element };
  };
  const frame = { testid: "m-ms", about: "Time to compute and draw the last frame", read: () => frameTime(shell.frame.times) };
  const element = h("div", { class: "metrics" });
  // What does not fit is reached with any wheel.
  element.addEventListener("wheel", ({ deltaY }) => element.scrollBy(deltaY, 0), { passive: true });
  regions.status.append(element);

  const modes = new Map<Mode, ModeMetrics>([["curve", curveMetrics]]);
  let shownMode: Mode | null = null;
  let all: ReturnType<typeof make>[] = [];
  let cost: ReturnType<typeof make> | undefined;
  const build = (mode: Mode): void => {
    shownMode = mode;
    const [first, second, third] = modes.get(mode) ?? [[], [], []];
    const groups = [first, second, [...third, frame]].map((metrics) => metrics.map(make));
    all = groups.flat();
    cost = all.at(-1);
    element.replaceChildren(
      ...groups.map((group, i) => h("div", { class: `metric-group${i === 1 ? " truth" : ""}`, role: "group", "aria-label": ["Drawing", "Accuracy", "Cost"][i] ?? "" },
        ...group.map((entry) => entry.element),
      )),
    );
  };
  let lastSlow = 0;
  let pending: ReturnType<typeof setTimeout> | null = null;
  let resting: ReturnType<typeof setTimeout> | undefined;
  let rested: CurveDocument | null = null;
  const update = (): void => {
    const state = editor.state.value;
    element.hidden = !modes.has(state.mode);
    if (element.hidden) return;
    if (shownMode !== state.mode) build(state.mode);
    // Of a very large drawing they wait for the end of the drag.
    const isMoving = rested !== state.curve && state.curve.contours.some(isMeasuredElsewhere);
    const waits = isMoving || (state.drag !== null && state.curve.contours.length > mostMeasuredLive);
    clearTimeout(resting);
    if (isMoving) resting = setTimeout(() => { rested = state.curve; soon.request(); }, restMs);
    const slowToo = !waits && performance.now() - lastSlow >= slowEveryMs;
    // The very first frame has no time of its own yet.
    if (shell.frame.times.length === 0) setTimeout(soon.request);
    const start = performance.now();
    const prepared = slowToo && all.every(({ metric }) => metric.prepare?.(state, () => performance.now() - start > shareOfFrameMs) !== false);
    if (slowToo && !prepared) soon.request();
    else if (slowToo) lastSlow = performance.now();
    else if (!isMoving) pending ??= setTimeout(() => { pending = null; soon.request(); }, slowEveryMs);
    for (const { metric, element: shown } of all) if (metric.slow !== true || slowToo) show(shown, metric.slow === true && !prepared ? null : metric.read(state));
  };
  const soon = inNextFrame(shell.frame, () => editor.state.value.engine.status === "ready" && update());
  // A view that is turned or moved changes no number of the drawing, but each of its frames costs something.
  shell.frame.add("paint", () => cost !== undefined && show(cost.element, cost.metric.read(editor.state.value)));
  editor.state.subscribe((state, before) => {
    if (state.curve !== before.curve || state.surface !== before.surface || state.fit !== before.fit || state.fitRun !== before.fitRun
      || state.traceRun !== before.traceRun || state.solid.tessellation !== before.solid.tessellation
      || state.trace !== before.trace || state.settings !== before.settings || state.mode !== before.mode || state.engine !== before.engine) soon.request();
  }, { until });
  build("curve");
  soon.request();
  return {
    metrics: element,
    put(mode, metrics) {
      modes.set(mode, metrics);
      shownMode = null;
      soon.request();
    },
  };
}

function frameTime(times: readonly number[]): ReturnType<Metric["read"]> {
  const value = times.at(-1);
  return value === undefined ? null : { value, strong: value < 0.1 ? "<0.1" : value.toFixed(1), rest: "ms" };
}

function show(element: HTMLElement, reading: ReturnType<Metric["read"]>): void {
  element.hidden = reading === null;
  if (reading === null) {
    setAttribute(element, "data-value", null);
    return;
  }
  setAttribute(element, "data-value", String(reading.value));
  const text = [reading.lead, reading.strong, reading.rest].filter((part) => part !== undefined).join(" ");
  if (element.textContent === text) return;
  const spaced = (part: string | undefined, after: string): string => (part === undefined ? "" : after === "" ? ` ${part}` : `${part} `);
  element.replaceChildren(spaced(reading.lead, " "), h("b", {}, reading.strong), spaced(reading.rest, ""));
}
