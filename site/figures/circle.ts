/** A circle from two points beside the best four-arc Bézier, whose error is drawn larger. */
import { HermiteCurve, handlesOf, parsePath } from "expline";

import { type Mount, controls, drawing, line, marks, polyline, slider, words } from "./stage.ts";

// shown
const circle = HermiteCurve.ellipse({ center: [0, 0], radii: [100, 100], count: 2 });

const h = 55.1915; // the handles of the best four cubic Béziers
const arcs = `C100 ${h} ${h} 100 0 100S-100 ${h} -100 0 -${h} -100 0 -100 100 -${h} 100 0`;
const [bezier] = parsePath(`M100 0${arcs}Z`);

/** How far a curve is from the circle, in parts of its radius. */
const error = (curve: HermiteCurve) => {
  const points = curve.sample(720);
  const off = (_: unknown, i: number) => Math.abs(Math.hypot(points[2 * i]!, points[2 * i + 1]!) / 100 - 1);
  return Math.max(...Array.from({ length: 720 }, off));
};
// end of shown

/** Points whose distance from the circle is so many times as large. */
function exaggerated(curve: HermiteCurve, times: number): Float64Array {
  const points = curve.sample(720);
  for (let i = 0; i < points.length; i += 2) {
    const [x = 0, y = 0] = points.subarray(i, i + 2);
    const radius = Math.hypot(x, y);
    const factor = (100 + (radius - 100) * times) / radius;
    points.set([x * factor, y * factor], i);
  }
  return points;
}

export const mount: Mount = (stage, text) => {
  if (bezier === undefined) throw new Error("a path is a curve");
  const svg = drawing(stage, text, [-150, -130, 300, 260]);
  const [ours, theirs, stems] = [line(svg, "filled"), line(svg, "warning"), line(svg, "stem")];
  const points = marks(svg);
  const row = controls(stage);
  const times = slider(row, "Errors drawn", { min: 1, max: 1000, step: 1, value: 500 }, () => draw(), (value) => `${value} ×`);
  const say = words(row);
  const draw = (): void => {
    ours(circle.toPathD().d);
    theirs(polyline(exaggerated(bezier, times()), true));
    const ends = [0, 1].flatMap((i) => Object.values(handlesOf(circle, i)));
    stems(ends.map(([x, y]) => `M${x} 0V${y}`).join(""));
    points([...[100, -100].map((x) => ({ at: [x, 0] as const, kind: "point" })), ...ends.map((at) => ({ at, kind: "handle" }))]);
    say(`Two points: off by ${error(circle).toExponential(0)} of the radius. Four Béziers, dashed: ${error(bezier).toExponential(0)}.`);
  };
  draw();
};
