/** More points, one at a time or many, and the same curve. */
import { HermiteCurve } from "expline";

import { type Mount, button, controls, drawing, line, marks, placeOf, slider, words } from "./stage.ts";

// shown
const shape = HermiteCurve.through([[-110, 30], [-40, -70], [20, 20], [110, -40], [60, 80]]);
let curve = shape;

const insertAt = (t: number) => (curve = curve.insert(t)); // one more point at t
const refineBy = (arity: number) => (curve = shape.refine(arity)); // each segment in so many parts

/** How far the curve is from what it was: as far as a double can tell. */
const moved = () => {
  const found = shape.nearestAll(curve.sample(500)); // t, x, y and the distance of each
  return Math.max(...found.filter((_, i) => i % 4 === 3));
};
// end of shown

export const mount: Mount = (stage, text) => {
  const svg = drawing(stage, text, [-150, -110, 300, 220]);
  const outline = line(svg, "filled");
  const points = marks(svg);
  const row = controls(stage);
  const place = slider(row, "Place", { min: 0, max: 4.99, step: 0.01, value: 1.5 }, () => draw(), (value) => `t = ${value.toFixed(2)}`);
  button(row, "Insert", () => {
    insertAt(place());
    draw();
  });
  const arity = slider(row, "Refine", { min: 1, max: 6, step: 1, value: 1 }, () => {
    refineBy(arity());
    draw();
  }, (value) => `× ${value}`);
  const say = words(row);
  // A click on the curve is the quicker way to say where.
  svg.addEventListener("pointerdown", (event) => {
    const { t, distance } = curve.nearest(...placeOf(svg, event));
    if (distance < 12) insertAt(t);
    draw();
  });
  const draw = (): void => {
    const places = curve.points;
    const [x = 0, y = 0] = curve.evaluate(place());
    outline(curve.toPathD().d);
    const on = Array.from({ length: places.length / 2 }, (_, i) => ({ at: [places[2 * i] ?? 0, places[2 * i + 1] ?? 0] as const, kind: "point" }));
    points([...on, { at: [x, y], kind: "cubic" }]);
    say(`${on.length} points. The curve has moved by ${moved().toExponential(0)}.`);
  };
  draw();
};
