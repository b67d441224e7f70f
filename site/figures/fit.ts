/** A stroke that the reader draws, and the curve with few knots through it. */
import { type SparseFit, SparseFitter } from "expline";

import { type Mount, type Place, button, controls, drawing, line, marks, placeOf, polyline, slider, words } from "./stage.ts";

// shown
let fitter: SparseFitter | undefined;

/** A stroke was drawn: the fitter keeps what it computes, for the slider. */
const drawn = (points: Place[]) => {
  fitter?.dispose();
  fitter = new SparseFitter(points, { closed: false });
};

/** 0 follows every tremor, 1 is nearly a line. */
const smoothed = (smoothing: number) => fitter?.solve({ smoothing });
// end of shown

const FEWEST = 5;
/** How much a hand trembles, and a stroke to begin with: the same at every visit. */
const TREMOR = 4;
const tremor = (i: number): number => TREMOR * (Math.sin(i * 12.9898) + Math.sin(i * 78.233)) * 0.5;
const STROKE: Place[] = Array.from({ length: 160 }, (_, i) => {
  const s = i / 159;
  const y = s < 0.55 ? -60 * Math.sin(s * 9) : 50 - (s - 0.55) * 240 + (s > 0.75 ? (s - 0.75) * 420 : 0);
  return [-125 + 250 * s + tremor(i), y + tremor(i + 1000)];
});

/** The strokes that fitting takes: moves of a pointer that hardly moved say nothing. */
function listen(svg: SVGSVGElement, points: (place: Place, isFirst: boolean) => void, ended: () => void): void {
  let last: Place | undefined;
  svg.addEventListener("pointerdown", (event) => {
    svg.setPointerCapture(event.pointerId);
    last = placeOf(svg, event);
    points(last, true);
  });
  svg.addEventListener("pointermove", (event) => {
    if (last === undefined) return;
    const next = placeOf(svg, event);
    if (Math.hypot(next[0] - last[0], next[1] - last[1]) < 1) return;
    last = next;
    points(next, false);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    svg.addEventListener(end, () => {
      if (last !== undefined) ended();
      last = undefined;
    });
  }
}

export const mount: Mount = (stage, text) => {
  const svg = drawing(stage, text, [-150, -110, 300, 220]);
  svg.classList.add("drawable");
  const [data, outline] = [line(svg, "ghost"), line(svg, "ink")];
  const knots = marks(svg);
  const row = controls(stage);
  const smoothing = slider(row, "Smoothing", { min: 0.05, max: 0.95, step: 0.01, value: 0.4 }, () => draw(), (value) => value.toFixed(2));
  button(row, "The first stroke", () => take(STROKE));
  const say = words(row);
  let stroke = STROKE;
  const show = (fit: SparseFit): void => {
    outline(fit.curve.toPathD().d);
    knots(fit.knots.map(({ x, y, degree }) => ({ at: [x, y], kind: degree === 1 ? "linear" : "cubic" })));
    say(`${stroke.length} points, ${fit.knots.length} knots, at most ${fit.maxError.toFixed(1)} off. Draw a stroke of yours.`);
  };
  const draw = (): void => {
    data(polyline(stroke.flat()));
    const fit = smoothed(smoothing());
    if (fit !== undefined) show(fit);
  };
  const take = (points: Place[]): void => {
    if (points.length < FEWEST) return;
    stroke = points;
    drawn(stroke);
    draw();
  };
  let drawnSoFar: Place[] = [];
  listen(svg, (place, isFirst) => {
    drawnSoFar = isFirst ? [place] : [...drawnSoFar, place];
    data(polyline(drawnSoFar.flat()));
    if (isFirst) outline("");
    if (isFirst) knots([]);
  }, () => (drawnSoFar.length < FEWEST ? draw() : take(drawnSoFar)));
  take(STROKE);
};
