/** A torus and its net, turned and pulled. */
import { TensorSurface } from "expline";

import { type Mount, controls, drawing, line, slider, words } from "./stage.ts";

// shown
const torus = TensorSurface.torus(3, 1.2); // 8 × 6 points that lie on it; exact
const net = torus.net;

/** One point of the net goes outwards; the surface follows, and stays smooth. */
const pulled = (factor: number) => {
  const [x = 0, y = 0, z = 0] = net;
  torus.setPoint(0, 0, factor * x, factor * y, factor * z);
};

/** Lines of the surface: points at pairs of parameters, x, y and z in turn. */
const lineOfU = (v: number, us: Float64Array) => torus.evaluate(us, us.map(() => v));
const lineOfV = (u: number, vs: Float64Array) => torus.evaluate(vs.map(() => u), vs);
// end of shown

const [ROWS, COLUMNS] = [8, 6];
/** Steps of a line between two points of the net, and lines. */
const FINE = 8;
const range = (end: number, steps: number): Float64Array => Float64Array.from({ length: end * steps + 1 }, (_, i) => i / steps);
const SCALE = 26;

type View = (points: ArrayLike<number>) => { seen: string; hidden: string };

/** Points in space on paper, those that are farther away than the middle apart. */
function seenFrom(turn: number, tilt: number): View {
  const [c, s, ct, st] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
  return (points) => {
    let [seen, hidden] = ["", ""];
    let isOpen: boolean | undefined;
    for (let i = 0; i < points.length; i += 3) {
      const [x = 0, y = 0, z = 0] = [points[i], points[i + 1], points[i + 2]];
      const [across, away] = [x * c - y * s, x * s + y * c];
      const place = `${(SCALE * across).toFixed(2)} ${(-SCALE * (z * ct - away * st)).toFixed(2)}`;
      const isNear = away * ct + z * st < 0.4;
      if (isOpen !== undefined) {
        if (isOpen) seen += `L${place}`;
        else hidden += `L${place}`;
      }
      if (isOpen !== isNear) {
        if (isNear) seen += `M${place}`;
        else hidden += `M${place}`;
      }
      isOpen = isNear;
    }
    return { seen, hidden };
  };
}

function lines(view: View): { seen: string; hidden: string } {
  const [us, vs] = [range(ROWS, FINE), range(COLUMNS, FINE)];
  const all = [...range(COLUMNS, 3).subarray(1)].map((v) => view(lineOfU(v, us)));
  all.push(...[...range(ROWS, 3).subarray(1)].map((u) => view(lineOfV(u, vs))));
  return { seen: all.map(({ seen }) => seen).join(""), hidden: all.map(({ hidden }) => hidden).join("") };
}

/** The polygons of the net, which are closed. */
function netLines(view: View): string {
  const now = torus.net;
  const at = (i: number, j: number): number[] => [...now.subarray(3 * ((i % ROWS) * COLUMNS + (j % COLUMNS)), 3 * ((i % ROWS) * COLUMNS + (j % COLUMNS)) + 3)];
  const ring = (count: number, place: (k: number) => number[]): number[] => Array.from({ length: count + 1 }, (_, k) => place(k)).flat();
  const rings = [
    ...Array.from({ length: COLUMNS }, (_, j) => ring(ROWS, (i) => at(i, j))),
    ...Array.from({ length: ROWS }, (_, i) => ring(COLUMNS, (j) => at(i, j))),
  ];
  return rings.map(view).map(({ seen, hidden }) => seen + hidden).join("");
}

export const mount: Mount = (stage, text) => {
  const svg = drawing(stage, text, [-170, -115, 340, 230]);
  svg.classList.add("turned");
  svg.setAttribute("tabindex", "0");
  svg.setAttribute("aria-label", `${text} Arrow keys turn it.`);
  const [hidden, netLine, seen] = [line(svg, "wire behind"), line(svg, "net"), line(svg, "wire")];
  const row = controls(stage);
  const pull = slider(row, "Pull a point", { min: 0.8, max: 2, step: 0.01, value: 1.4 }, () => draw(), (value) => `× ${value.toFixed(2)}`);
  const say = words(row);
  let [turn, tilt] = [-2.2, -0.55];
  const draw = (): void => {
    pulled(pull());
    const view = seenFrom(turn, tilt);
    const drawn = lines(view);
    hidden(drawn.hidden);
    seen(drawn.seen);
    netLine(netLines(view));
    say(`${ROWS} × ${COLUMNS} points${pull() === 1 ? ": a torus, exact" : ", one of them moved"}. Dashed: the net.`);
  };
  const turnBy = (x: number, y: number): void => {
    turn += x;
    tilt = Math.max(-1.5, Math.min(1.5, tilt + y));
    draw();
  };
  const KEYS: Readonly<Record<string, readonly [number, number]>> = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
  svg.addEventListener("keydown", (event) => {
    const way = KEYS[event.key];
    if (way === undefined) return;
    turnBy(...way);
    event.preventDefault();
  });
  svg.addEventListener("pointerdown", (event) => svg.setPointerCapture(event.pointerId));
  svg.addEventListener("pointermove", (event) => svg.hasPointerCapture(event.pointerId) && turnBy(event.movementX / 120, event.movementY / 120));
  draw();
};
