import "../../styles/plot.css";
import { omegaOf, type Contour } from "../../document/document.ts";
import type { EditorState } from "../../editor/editor.ts";
import { generatorsOf, type Generators } from "../../kernel/curve/generator.ts";
import { h, setText, svg } from "../controls/dom.ts";
import type { Section } from "../mode/panel-parts.ts";

/**
 * The functions that the curve is made of, drawn as the papers draw them: each control point weighs one copy, centred
 * at its own place.
 */
export function generatorPlot(): Section {
  const picture = svg("svg", { class: "plot", viewBox: "0 0 272 132", role: "img", "data-testid": "generator-plot" });
  const roots = h("p", { class: "field-note plot-note num" });
  const note = h("p", { class: "quiet plot-note" });
  const element = h("div", { class: "plot-box" }, picture, roots, note);
  let shown: Contour | undefined;
  let space: string | null = null;
  return {
    element,
    update(state: EditorState) {
      const index = state.selection.points[0]?.contour ?? 0;
      const contour = state.curve.contours[index];
      const key = contour === undefined
        ? ""
        : `${contour.family} ${contour.order ?? 3} ${contour.grid?.step ?? 0} ${contour.space ?? state.curve.space} ${omegaOf(state.curve, contour, 0)}`;
      if (contour === undefined || contour.points.length < 2 || (shown !== undefined && key === space)) return;
      shown = contour;
      space = key;
      const generators = generatorsOf(state.curve, contour);
      draw(picture, generators);
      setText(roots, described(generators));
      setText(note, explained(contour, generators));
    },
  };
}

const [left, right, top, bottom] = [8, 264, 10, 116];

function draw(picture: SVGSVGElement, { functions, reach }: Generators): void {
  const values = functions.flatMap(({ y }) => Array.from(y));
  const [least, most] = [Math.min(0, ...values), Math.max(1, ...values)];
  const across = (x: number): number => left + ((x + reach) / (2 * reach)) * (right - left);
  const up = (y: number): number => bottom - ((y - least) / (most - least)) * (bottom - top);
  const line = (name: string, x1: number, y1: number, x2: number, y2: number): SVGLineElement =>
    svg("line", { class: name, x1: x1.toFixed(1), y1: y1.toFixed(1), x2: x2.toFixed(1), y2: y2.toFixed(1) });
  const parts: Node[] = [line("plot-axis", left, up(0), right, up(0))];
  const whole = Math.floor(reach + 1e-9);
  for (let k = -whole; k <= whole; k += 1) {
    const label = svg("text", { class: "plot-label", x: across(k).toFixed(1), y: 129, "text-anchor": "middle" });
    label.textContent = String(k);
    parts.push(line("plot-tick", across(k), up(0) - 3, across(k), up(0) + 3), label);
  }
  functions.forEach(({ name, x, y }, i) => {
    const d = Array.from(x, (at, k) => `${k === 0 ? "M" : "L"}${across(at).toFixed(1)} ${up(y[k] ?? 0).toFixed(1)}`).join("");
    parts.push(svg("path", { class: `plot-line plot-line-${i}`, d }));
    const legend = svg("text", { class: `plot-name plot-name-${i}`, x: right - 4, y: top + 8 + 15 * i, "text-anchor": "end" });
    legend.textContent = name;
    parts.push(legend);
  });
  // The interpolator is 1 at its own place and 0 at every other.
  const [first] = functions;
  if (first !== undefined && first.name === "φ") {
    for (let k = -whole; k <= whole; k += 1) parts.push(svg("circle", { class: "plot-dot", cx: across(k).toFixed(1), cy: up(k === 0 ? 1 : 0).toFixed(1), r: 2.5 }));
  }
  picture.replaceChildren(...parts);
  picture.setAttribute("aria-label", `${functions.map(({ name }) => name).join(" and ")} from −${reach} to ${reach}`);
}

function described({ roots, lambda }: Generators): string {
  if (roots === null) return "";
  const short = (value: number): string => String(Number(value.toPrecision(4)));
  const list = roots.filter(({ re, im }) => re > 0 || im > 0 || (re === 0 && im === 0)).map(({ re, im }) => (re === 0 && im === 0
    ? "0"
    : im === 0 ? `±${short(re)}` : re === 0 ? `±${short(im)}i` : `±${short(re)}±${short(im)}i`));
  const weights = lambda.length === 0 ? "" : `  ·  λ ${lambda.map(short).join(", ")}`;
  return `Roots ${list.join(", ")}${weights}`;
}

function explained({ family, grid }: Contour, { reach }: Generators): string {
  if (family === "hermite") return "φ₁ weighs a point, φ₂ its tangent. Both end at the neighbours, so nothing beyond them moves.";
  if (grid !== undefined) return "On a refined grid β weighs a point. It ends half as many steps away as there are roots.";
  return `φ weighs a point: 1 at the point and 0 at all others, so the curve passes through it; 0 beyond ${reach} segments, so the rest stays put. φ is a sum of copies of β, half a step apart, weighted by λ.`;
}
