import { isJoined, strokesOf } from "../../document/fit/fit.ts";
import type { EditorState } from "../../editor/editor.ts";
import { unitIn } from "../../document/unit.ts";
import { boxOf } from "../../editor/fit/fit-edits.ts";
import { degreeOf } from "../../editor/fit/fit-question.ts";

/** The program that makes the present fit: the bridge from the page to an integration. */

/** More points than this would hide the program. */
const mostListed = 120;

/** The name stands in a text that is shown; it is no import of the page. */
const library = JSON.stringify("expline");

/** What was found for a number of knots lies between the steps of the slider. */
function smoothingOf({ fit, fitRun: { outcome } }: EditorState): number {
  const found = fit.target === "knots" ? outcome?.smoothing : undefined;
  return Number(((found ?? fit.smoothing) / 100).toPrecision(12));
}

export function fitProgram(state: EditorState): string {
  const { fit } = state;
  const [stroke, ...others] = strokesOf(fit);
  if (stroke === undefined) return "// Draw a line, or open a sample.";
  const points = fit.data.slice(stroke.from, stroke.to);
  const listed = points.length <= mostListed;
  const rows = points.map(([x, y]) => `${x}, ${y}`);
  const lines = Array.from({ length: Math.ceil(rows.length / 6) }, (_, i) => `  ${rows.slice(6 * i, 6 * i + 6).join(", ")},`);
  const data = listed
    ? `const points = Float64Array.of(\n${lines.join("\n")}\n);`
    : `// ${points.length} points, x and y in turn; this page's JSON file has them under "fit".\nconst points = Float64Array.from(await (await fetch("points.json")).json());`;
  const strength = fit.target === "error" ? `tolerance: ${fit.targetError}` : `smoothing: ${smoothingOf(state)}`;
  const degree = JSON.stringify(degreeOf(fit)).replace(",", ", ");
  const first = others.length === 0 ? "" : `// The first of ${others.length + 1} strokes: each is fitted by itself.\n`;
  const mix = degree.startsWith("[") && fit.mix !== 50 ? `\n  mix: ${fit.mix / 100},` : "";
  const corners = fit.corners ? "" : "\n  corners: false,";
  const unit = unitIn(boxOf(fit.data));
  const upright = fit.up === true ? "// In SVG y points down.\nconst { d } = fit.curve.transform([1, 0, 0, -1, 0, 0])" : "const { d } = fit.curve";
  return `import { fitSparse } from ${library};

${first}${data}

const fit = fitSparse(points, {
  degree: ${degree},
  ${strength},${mix}${corners}
  closed: ${isJoined(fit, stroke)},
});

console.log(fit.knots.length, "knots, no point farther than", fit.maxError, "certified gap", fit.gap);
${upright}.toPathD({ tolerance: ${Number((0.02 * unit).toPrecision(6))} });
document.querySelector("path")?.setAttribute("d", d);

// For a slider, keep what was computed: each step starts where the last one ended.
// const fitter = new SparseFitter(points, { degree: ${degree}, closed: ${isJoined(fit, stroke)} });
// slider.oninput = () => show(fitter.solve({ smoothing: slider.valueAsNumber / 100 }));
`;
}
