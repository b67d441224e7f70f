/** A curve that its points lie on, and the finer points that write the same curve. */
import { InterpolatingCurve } from "expline";

import { type Mount, type Place, controls, drawing, grip, line, marks, polyline, slider, words } from "./stage.ts";

// shown
const curve = new InterpolatingCurve({
  points: [[-110, 20], [-70, -60], [0, -30], [60, -75], [115, 0], [60, 70], [-10, 40], [-70, 80]],
});

/** The curve follows, on three segments to each side and nowhere else. */
const dragged = (i: number, x: number, y: number) => curve.setPoint(i, x, y);

/** The same curve with 2, 4, 8 … times the points, which lie beside it. */
const finer = (level: number) => curve.refine(level).points;
// end of shown

export const mount: Mount = (stage, text) => {
  const svg = drawing(stage, text, [-150, -115, 300, 230]);
  const [before, outline, net] = [line(svg, "ghost"), line(svg, "filled"), line(svg, "net")];
  const vertices = marks(svg);
  const row = controls(stage);
  const level = slider(row, "Level", { min: 0, max: 3, step: 1, value: 0 }, () => draw());
  const say = words(row);
  const count = curve.points.length / 2;
  const grips = Array.from({ length: count }, (_, i) =>
    grip(svg, "point", `Point ${i + 1} of ${count}`, ([x, y]) => {
      dragged(i, Math.max(-140, Math.min(140, x)), Math.max(-105, Math.min(105, y)));
      draw();
    }),
  );
  before(curve.toPathD().d);
  const draw = (): void => {
    const places = curve.points;
    outline(curve.toPathD().d);
    grips.forEach((each, i) => each.put([places[2 * i] ?? 0, places[2 * i + 1] ?? 0]));
    const fine = level() === 0 ? new Float64Array() : finer(level());
    net(polyline(fine, true));
    vertices(Array.from({ length: fine.length / 2 }, (_, i) => ({ at: [fine[2 * i] ?? 0, fine[2 * i + 1] ?? 0] satisfies Place, kind: "vertex" })));
    say(`${count} points, all on the curve${fine.length > 0 ? `; ${fine.length / 2} finer ones write the same curve` : ""}. Dotted: as it was.`);
  };
  draw();
};
