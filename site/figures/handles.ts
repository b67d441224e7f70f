/** Points and tangent handles that are dragged: smooth, mirrored or corners. */
import { HermiteCurve, type Joint, handlesOf, moveHandle, movePoint } from "expline";

import { type Grip, type Mount, type Place, choice, controls, drawing, grip, line, words } from "./stage.ts";

// shown
const curve = HermiteCurve.through([[-90, 10], [0, -60], [90, 10], [0, 75]]);

/** A point goes to a place, and its handles with it. */
const pointDragged = (i: number, x: number, y: number) => movePoint(curve, i, x, y);

/** A handle's end goes to a place; `joint` says what the other one does. */
const handleDragged = (i: number, side: "in" | "out", x: number, y: number, joint: Joint) =>
  moveHandle(curve, i, side, x, y, joint);

const path = () => curve.toPathD({ tolerance: 0.01 }).d;
// end of shown

const COUNT = 4;
const SIDES = ["in", "out"] as const;
const MARGIN: Place = [145, 118];

/** A grip that left the drawing could not be taken back. */
const within = ([x, y]: Place): Place => [Math.max(-MARGIN[0], Math.min(MARGIN[0], x)), Math.max(-MARGIN[1], Math.min(MARGIN[1], y))];

export const mount: Mount = (stage, text) => {
  const svg = drawing(stage, text, [-150, -124, 300, 248]);
  const [outline, stems] = [line(svg, "filled"), line(svg, "stem")];
  const row = controls(stage);
  const joint = choice(row, "Handles are", ["smooth", "symmetric", "cusp"] satisfies Joint[]);
  const say = words(row);
  const points: Grip[] = [];
  const handles: { at: (side: "in" | "out") => Place; side: "in" | "out"; grip: Grip }[] = [];
  for (let i = 0; i < COUNT; i += 1) {
    const at = (side: "in" | "out"): Place => handlesOf(curve, i)[side] ?? [0, 0];
    for (const side of SIDES) {
      const moved = (place: Place): void => {
        handleDragged(i, side, ...within(place), joint());
        draw();
      };
      handles.push({ at, side, grip: grip(svg, "handle", `Handle of point ${i + 1}, ${side === "in" ? "arriving" : "leaving"}`, moved) });
    }
    const moved = (place: Place): void => {
      pointDragged(i, ...within(place));
      draw();
    };
    points.push(grip(svg, "point", `Point ${i + 1}`, moved));
  }
  const draw = (): void => {
    const places = curve.points;
    outline(path());
    points.forEach((point, i) => point.put([places[2 * i] ?? 0, places[2 * i + 1] ?? 0]));
    handles.forEach(({ at, side, grip: each }) => each.put(at(side)));
    stems(handles.map(({ at, side }, i) => `M${places[2 * (i >> 1)]} ${places[2 * (i >> 1) + 1]}L${at(side).join(" ")}`).join(""));
    say(`Length ${curve.length().toFixed(1)}, area ${Math.abs(curve.area()).toFixed(0)}.`);
  };
  draw();
};
