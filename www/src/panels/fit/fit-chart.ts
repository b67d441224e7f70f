import type { EditorState } from "../../editor/editor.ts";
import { setSmoothing } from "../../editor/fit/fit-edits.ts";
import type { ChartPoint } from "../../kernel/fit/outcome.ts";
import { h, setText, svg } from "../controls/dom.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

/** Knots and error over the smoothing: bars and a line, filled while the page has time. A press goes there. */

const [width, height, columns] = [252, 72, 21];
const step = width / columns;

export function chartSection(shell: Shell): Section {
  const { editor } = shell;
  const bars = svg("g", { class: "chart-bars" });
  const line = svg("path", { class: "chart-line" });
  const cursor = svg("path", { class: "chart-cursor" });
  const picture = svg("svg", { class: "fit-chart", viewBox: `0 0 ${width} ${height}`, "data-testid": "fit-chart", role: "img" }, bars, line, cursor);
  const caption = h("p", { class: "field-note chart-caption num" });
  const words = h("p", { class: "quiet chart-key" }, h("span", { class: "chart-key-bar" }, "knots"), h("span", { class: "chart-key-line" }, "rms error"));
  const go = (event: PointerEvent): void => {
    const box = picture.getBoundingClientRect();
    const column = Math.max(0, Math.min(columns - 1, Math.floor(((event.clientX - box.left) / Math.max(1, box.width)) * columns)));
    setSmoothing(editor, 5 * column);
  };
  picture.addEventListener("click", go);
  picture.addEventListener("pointermove", (event) => {
    const box = picture.getBoundingClientRect();
    const column = Math.floor(((event.clientX - box.left) / Math.max(1, box.width)) * columns);
    const point = editor.state.value.fitRun.chart.find(({ smoothing }) => smoothing === 5 * column);
    setText(caption, point === undefined ? "" : `at ${point.smoothing}: ${point.knots} knots, rms ${point.rms.toPrecision(2)}`);
  });
  picture.addEventListener("pointerleave", () => setText(caption, ""));
  let drawn: readonly ChartPoint[] | null = null;
  return {
    element: h("div", { class: "chart" }, picture, words, caption),
    update({ fit, fitRun }: EditorState) {
      cursor.setAttribute("d", `M${((fit.smoothing / 5 + 0.5) * step).toFixed(1)} 0V${height}`);
      if (drawn === fitRun.chart) return;
      drawn = fitRun.chart;
      const { chart } = fitRun;
      const mostKnots = Math.max(1, ...chart.map(({ knots }) => knots));
      // Points of a curve that the fit finds have no error but roundings, which are no more than nothing.
      const mostRms = Math.max(1e-12, 1e-9 * (fitRun.outcome?.diagonal ?? 0), ...chart.map(({ rms }) => rms));
      // A logarithm of the knots: what matters is whether there are twice as many.
      const high = (knots: number): number => (Math.log1p(knots) / Math.log1p(mostKnots)) * (height - 4);
      bars.replaceChildren(...chart.map(({ smoothing, knots }) =>
        svg("rect", { x: ((smoothing / 5) * step + 1).toFixed(1), width: (step - 2).toFixed(1), y: (height - high(knots)).toFixed(1), height: high(knots).toFixed(1) })));
      line.setAttribute("d", chart.map(({ smoothing, rms }, i) =>
        `${i === 0 ? "M" : "L"}${((smoothing / 5 + 0.5) * step).toFixed(1)} ${(height - 2 - (rms / mostRms) * (height - 6)).toFixed(1)}`).join(""));
      picture.setAttribute(
        "aria-label",
        `Knots and error against smoothing. ${chart.filter(({ smoothing }) => smoothing % 20 === 0).map(({ smoothing, knots, rms }) => `At ${smoothing}: ${knots} knots, rms ${rms.toPrecision(2)}`).join(". ")}`,
      );
    },
  };
}
