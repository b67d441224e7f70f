/** What the playground begins with: one example for each kind of work. */

export interface Example {
  readonly name: string;
  readonly code: string;
}

export const EXAMPLES: readonly Example[] = [
  {
    name: "A circle from two points",
    code: `import { HermiteCurve } from "expline";

const r = 100;
const circle = HermiteCurve.ellipse({ center: [0, 0], radii: [r, r], count: 2 });
console.log("area / πr²:", circle.area() / (Math.PI * r * r));
console.log(circle.toPathD().d);

export default [circle, circle.points]; // what is drawn
`,
  },
  {
    name: "Edit a path",
    code: `import { jointOf, moveHandle, parsePath } from "expline";

const logoPath = "M10 10h80v40a20 20 0 0 1-20 20H40q-30 0-30-30z";
const [logo] = parsePath(logoPath);
const { curve, maxError } = logo.remove(4); // the neighbours are fitted again
console.log("one point less changes the shape by at most", maxError);

moveHandle(curve, 0, "out", 40, -20, jointOf(curve, 0));
const { d } = curve.toPathD({ tolerance: 0.01 });
console.log(d);

export default [logoPath, d, curve.points];
`,
  },
  {
    name: "Points on the curve",
    code: `import { InterpolatingCurve } from "expline";

const points = [[0, 0], [90, 20], [100, 110], [20, 90]];
const blob = new InterpolatingCurve({ points });
blob.setPoint(1, 95, 10);
const fine = blob.refine(2); // the same curve with four times the points
console.log(fine.points.length / 2, "points write the same curve");

export default [blob, blob.points];
`,
  },
  {
    name: "A noisy stroke",
    code: `import { fitSparse } from "expline";

const noise = () => 6 * (Math.random() - 0.5);
const bend = (i) => 60 * Math.sin(i / 40) + Math.max(0, i - 200);
const points = Array.from({ length: 300 }, (_, i) => [i + noise(), bend(i) + noise()]);
const fit = fitSparse(points, { closed: false });
console.log(fit.knots.length, "knots, noise of", fit.sigma.toFixed(2));

export default [points, fit];
`,
  },
  {
    name: "Trace a picture",
    code: `import { traceImage } from "expline";

// 64 × 64 shades of a ring; yours come from a canvas: context.getImageData(…)
const shade = (i) => {
  const r = Math.hypot((i % 64) - 31.5, (i >> 6) - 31.5);
  return 255 * Math.min(1, Math.max(0, r - 25, 15 - r));
};
const data = Uint8Array.from({ length: 64 * 64 }, (_, i) => shade(i));
const trace = traceImage({ width: 64, height: 64, data });
console.log(trace.toSvg());

export default trace;
`,
  },
  {
    name: "A surface",
    code: `import { TensorSurface } from "expline";

const torus = TensorSurface.torus(3, 1);
torus.setPoint(2, 0, 0, 5, 0); // still smooth, changed only around that point
const { positions, indices } = torus.mesh(128, 96);
console.log(positions.length / 3, "vertices,", indices.length / 3, "triangles");

export default torus;
`,
  },
];
