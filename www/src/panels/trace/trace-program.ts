import { defaultTolerance, toleranceOf } from "../../document/trace/trace.ts";
import type { EditorState } from "../../editor/editor.ts";
import { howOf } from "../../editor/trace/trace-question.ts";

/** The program that makes the present trace: the bridge from the page to an integration. */

/** The name stands in a text that is shown; it is no import of the page. */
const library = JSON.stringify("expline");

export function traceProgram({ trace, traceRun }: EditorState): string {
  const { settings } = trace;
  const name = trace.picture?.name ?? `${trace.sample ?? "picture"}.png`;
  const tolerance = toleranceOf(settings.detail);
  const [columns = 0] = traceRun.picture?.analysed ?? [];
  const scaled = traceRun.picture !== null && columns !== traceRun.picture.width;
  // Beside colours there is no ink to be told from paper: what the panel hides then is not in the program, either.
  const ink = [
    settings.mode === "brightness" ? "" : `source: "${settings.mode}",`,
    settings.threshold === "auto" ? "" : `threshold: ${settings.threshold},`,
    settings.invert ? "invert: true," : "",
  ];
  const options = [
    ...(settings.colors === 0 ? ink : [`colors: ${settings.colors},`]),
    settings.blur === "auto" ? "" : `blur: ${settings.blur},`,
    `speckle: ${settings.speckle},`,
    `corner: ${Math.round((howOf(trace).corner * 180) / Math.PI)} * Math.PI / 180,`,
    tolerance === defaultTolerance ? "" : `tolerance: ${Number(tolerance.toPrecision(3))},`,
    "onProgress: ({ stage, done, total }) => console.log(stage, done, \"of\", total),",
  ].filter((line) => line !== "");
  return `import { traceImageAsync } from ${library};

const picture = await createImageBitmap(await (await fetch(${JSON.stringify(name)})).blob());${scaled ? `\n// This page looks at ${columns} pixels across; the whole picture is traced here.` : ""}
const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
context.drawImage(picture, 0, 0);

const trace = await traceImageAsync(context.getImageData(0, 0, picture.width, picture.height), {
  ${options.join("\n  ")}
});

for (const { curve, cusps, metrics } of trace.contours) {
  console.log(curve.points.length / 2, "points,", cusps.length, "corners, none farther than", metrics.max, "px");
}
document.body.innerHTML = trace.toSvg({ tolerance: 0.02, decimals: 3 });
`;
}
